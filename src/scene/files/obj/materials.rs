//! The materials of the faces of an OBJ file: the libraries it names, and the names it uses.
//!
//! Names are looked up when the whole file is read. A name is that of a material if it is the same
//! text; if there is none, then but for the length of blanks, or for a comment after one of the two
//! ` # …`. Materials of one name that differ make what differs unknown.
//!
//! Whatever is missing makes the material of the faces concerned unknown, and nothing else.

use super::library::{is_as_written, libraries};
use super::mtl::{Definition, Library};
use crate::scene::NamedPatch;
use crate::scene::files::error::{Fault, FileError, excerpt};
use crate::scene::files::source::Source;
use crate::scene::material::{MaterialFault, PatchMaterial, Property};
use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

/// Missing libraries that are told.
const MOST_MISSING: usize = 8;

/// The libraries read so far, and the names used so far.
pub(crate) struct Materials<'a> {
    source: &'a Source,
    open: &'a dyn Fn(&str) -> Result<Source, FileError>,
    files: HashSet<PathBuf>,
    /// The materials, each with the line of its library.
    definitions: Vec<(usize, Definition)>,
    /// Libraries that could not be read.
    missing: Vec<String>,
    /// Names and the lines of their first uses.
    uses: Vec<(usize, String)>,
    numbers: HashMap<String, usize>,
    notes: Vec<String>,
}

/// The number of a name that is used.
pub(crate) type Use = usize;

impl<'a> Materials<'a> {
    /// No materials; `open` finds a library by its name.
    pub(crate) fn new(
        source: &'a Source,
        open: &'a dyn Fn(&str) -> Result<Source, FileError>,
    ) -> Self {
        Self {
            source,
            open,
            files: HashSet::new(),
            definitions: Vec::new(),
            missing: Vec::new(),
            uses: Vec::new(),
            numbers: HashMap::new(),
            notes: Vec::new(),
        }
    }

    /// Reads the libraries that a line `mtllib` names.
    pub(crate) fn read(&mut self, line: usize, names: &str) {
        if names.trim().is_empty() {
            let (what, form) = ("the name of the material file", "\"mtllib file.mtl\"");
            let fault = self.source.fault(line, Fault::Missing { what, form });
            self.notes.push(fault.to_string());
        }
        for (name, library) in libraries(names, self.open) {
            match library {
                Ok(library) => self.add(line, name, &library),
                Err(FileError { file, fault, .. }) => {
                    let missing = file.display().to_string();
                    if self.missing.len() < MOST_MISSING && !self.missing.contains(&missing) {
                        let source = Box::new(fault);
                        let fault = self.source.fault(line, Fault::Library { file, source });
                        self.notes.push(fault.to_string());
                        self.missing.push(missing);
                    }
                }
            }
        }
    }

    fn add(&mut self, line: usize, name: &str, library: &Source) {
        let file = library.file();
        // many exporters name one library before every object
        if !self.files.insert(file.to_owned()) {
            return;
        }
        if !is_as_written(self.source.file(), name, file) {
            let (name, file) = (excerpt(name), file.display());
            let place = self.source.file().display();
            self.notes.push(format!(
                "{place}, line {line}: \"{name}\" is read from {file}"
            ));
        }
        let Library {
            definitions, notes, ..
        } = Library::read(library);
        self.notes.extend(notes);
        self.definitions
            .extend(definitions.into_iter().map(|definition| (line, definition)));
    }

    /// The number of the name that a line `usemtl` uses.
    pub(crate) fn named(&mut self, line: usize, name: &str) -> Use {
        let next = self.uses.len();
        let number = *self.numbers.entry(name.trim().to_owned()).or_insert(next);
        if number == next {
            self.uses.push((line, name.trim().to_owned()));
        }
        number
    }

    /// The patches with their materials, each of the name that it uses, and what there is to say.
    pub(crate) fn given(
        mut self,
        patches: Vec<NamedPatch>,
        uses: &[Option<Use>],
    ) -> (Vec<NamedPatch>, Vec<String>) {
        let used: HashSet<Use> = uses.iter().flatten().copied().collect();
        let mut numbers: Vec<Use> = used.into_iter().collect();
        numbers.sort_unstable();
        let mut notes = std::mem::take(&mut self.notes);
        let names = Names::of(&self.definitions);
        let materials: HashMap<Use, PatchMaterial> = numbers
            .into_iter()
            .map(|number| (number, self.material(number, &names, &mut notes)))
            .collect();
        let with = |(patch, number): (NamedPatch, &Option<Use>)| {
            let material = number.and_then(|number| materials.get(&number));
            match material {
                Some(material) => patch.with_material(material.clone()),
                None => patch,
            }
        };
        let patches = patches.into_iter().zip(uses).map(with).collect();
        (patches, notes)
    }

    /// The material of a name.
    fn material(&self, number: Use, names: &Names<'_>, notes: &mut Vec<String>) -> PatchMaterial {
        let (line, name) = &self.uses[number];
        let place = format!("{}, line {line}", self.source.file().display());
        if name.is_empty() {
            let (what, form) = ("the name of the material", "\"usemtl name\"");
            let fault = self.source.fault(*line, Fault::Missing { what, form });
            return PatchMaterial::unknown(MaterialFault::new(fault));
        }
        let found = names.meant(name);
        let Some((_, first)) = found.first() else {
            let (what, given) = ("material", excerpt(name));
            let fault = self.source.fault(*line, Fault::Undefined { what, given });
            let missing = match self.missing.as_slice() {
                [] => String::new(),
                files => format!(" ({} cannot be read)", files.join(", ")),
            };
            return PatchMaterial::unknown(MaterialFault::new(format!("{fault}{missing}")));
        };
        if first.name != *name {
            let (name, meant) = (excerpt(name), excerpt(&first.name));
            notes.push(format!("{place}: \"{name}\" is taken for material {meant}"));
        }
        if let Some(library) = found.iter().map(|(library, _)| library).min()
            && library > line
        {
            let name = excerpt(name);
            notes.push(format!(
                "{place}: material {name} is used before \"mtllib\" in line {library}"
            ));
        }
        let agreed = |of: fn(&PatchMaterial) -> &Property| agreed(&place, &found, of);
        PatchMaterial {
            reflectance: agreed(|material| &material.reflectance),
            emittance: agreed(|material| &material.emittance),
        }
    }
}

/// A property that several definitions have, if they have the same.
fn agreed(
    place: &str,
    found: &[&(usize, Definition)],
    of: fn(&PatchMaterial) -> &Property,
) -> Property {
    let mut known: Option<(&Definition, Property)> = None;
    for (_, definition) in found {
        let property = of(&definition.material).clone()?;
        let (first, value) = known.get_or_insert_with(|| (definition, Ok(property)));
        if *value != Ok(property) {
            return Err(MaterialFault::new(format!(
                "{place}: material {} is defined twice and differently, in {} and in {}: give one \
                 of them another name",
                excerpt(&first.name),
                first.place,
                definition.place
            )));
        }
    }
    known.map_or_else(|| Ok(Default::default()), |(_, property)| property)
}

/// The materials by their names, as they are and shortened.
struct Names<'d> {
    exact: HashMap<&'d str, Vec<&'d (usize, Definition)>>,
    evened: HashMap<String, Vec<&'d (usize, Definition)>>,
    uncommented: HashMap<String, Vec<&'d (usize, Definition)>>,
}

impl<'d> Names<'d> {
    fn of(definitions: &'d [(usize, Definition)]) -> Self {
        let mut names = Self {
            exact: HashMap::new(),
            evened: HashMap::new(),
            uncommented: HashMap::new(),
        };
        for definition in definitions {
            let name = definition.1.name.as_str();
            let (even, bare) = (evened(name), uncommented(name));
            names.exact.entry(name).or_default().push(definition);
            names.evened.entry(even).or_default().push(definition);
            names.uncommented.entry(bare).or_default().push(definition);
        }
        names
    }

    /// The materials that a name means, all of one name.
    fn meant(&self, name: &str) -> Vec<&'d (usize, Definition)> {
        let (even, bare) = (evened(name), uncommented(name));
        let found = self.exact.get(name);
        let found = found.or_else(|| self.evened.get(&even));
        let found = found.or_else(|| self.evened.get(&bare));
        let found = found.or_else(|| self.uncommented.get(&even));
        found.cloned().unwrap_or_default()
    }
}

/// A name with single blanks.
fn evened(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A name without what may be a comment.
fn uncommented(name: &str) -> String {
    let even = evened(name);
    even.split(" #").next().unwrap_or_default().to_owned()
}
