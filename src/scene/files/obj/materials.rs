//! The materials of the faces of an OBJ file: the libraries it names, and the names it uses.
//!
//! All libraries are read before the first face, wherever they are named. A name is that of a
//! material if it is the same text; if there is none, then but for the length of blanks, or for a
//! comment ` # …` after one of the two. Materials of one name that differ make what differs
//! unknown.
//!
//! Whatever is missing makes the material of the faces concerned unknown, and nothing else.

use super::library::{is_as_written, libraries};
use super::mtl::{Definition, Library};
use crate::scene::files::error::{FileError, excerpt};
use crate::scene::files::fault::Fault;
use crate::scene::files::source::Source;
use crate::scene::material::{MaterialFault, PatchMaterial, Property};
use std::collections::{HashMap, HashSet};

/// Missing libraries that are told.
const MOST_MISSING: usize = 8;

/// The function that finds a library by its name.
type Open<'a> = &'a dyn Fn(&str) -> Result<Source, FileError>;

/// The materials of a file.
pub(crate) struct Materials<'a> {
    source: &'a Source,
    /// The materials, each with the line that names its library.
    definitions: Vec<(usize, Definition)>,
    names: Names,
    /// Libraries that could not be read.
    missing: Vec<String>,
    /// The materials of names that were used.
    used: HashMap<String, PatchMaterial>,
    notes: Vec<String>,
}

impl<'a> Materials<'a> {
    /// The materials of the libraries that lines name.
    pub(crate) fn of<'t>(
        source: &'a Source,
        lines: impl Iterator<Item = (usize, &'t str)>,
        open: Open<'_>,
    ) -> Self {
        let mut materials = Self {
            source,
            definitions: Vec::new(),
            names: Names::default(),
            missing: Vec::new(),
            used: HashMap::new(),
            notes: Vec::new(),
        };
        let (mut lines_read, mut files_read) = (HashSet::new(), HashSet::new());
        for (line, names) in lines {
            // many exporters name one library before every object
            if !lines_read.insert(names) {
                continue;
            }
            if names.trim().is_empty() {
                let (what, form) = ("the name of the material file", "\"mtllib file.mtl\"");
                let fault = source.fault(line, Fault::Missing { what, form });
                materials.notes.push(fault.to_string());
            }
            for (name, library) in libraries(names, open) {
                match library {
                    Err(error) => materials.miss(line, error),
                    Ok(library) if !files_read.insert(library.file().to_owned()) => {}
                    Ok(library) => materials.add(line, name, &library),
                }
            }
        }
        materials
    }

    fn miss(&mut self, line: usize, FileError { file, fault, .. }: FileError) {
        let missing = file.display().to_string();
        if self.missing.len() < MOST_MISSING && !self.missing.contains(&missing) {
            let source = Box::new(fault);
            let fault = self.source.fault(line, Fault::Library { file, source });
            self.notes.push(fault.to_string());
            self.missing.push(missing);
        }
    }

    fn add(&mut self, line: usize, name: &str, library: &Source) {
        let file = library.file();
        if !is_as_written(self.source.file(), name, file) {
            let (name, file) = (excerpt(name), file.display());
            let place = self.source.file().display();
            self.notes.push(format!(
                "{place}, line {line}: \"{name}\" is read from {file}"
            ));
        }
        let Library { definitions, notes } = Library::read(library);
        self.notes.extend(notes);
        for definition in definitions {
            self.names.add(&definition.name, self.definitions.len());
            self.definitions.push((line, definition));
        }
    }

    /// The material that a line `usemtl` names.
    pub(crate) fn named(&mut self, line: usize, name: &str) -> PatchMaterial {
        let name = name.trim();
        if let Some(material) = self.used.get(name) {
            return material.clone();
        }
        let material = self.material(line, name);
        self.used.insert(name.to_owned(), material.clone());
        material
    }

    fn material(&mut self, line: usize, name: &str) -> PatchMaterial {
        if name.is_empty() {
            let (what, form) = ("the name of the material", "\"usemtl name\"");
            let fault = self.source.fault(line, Fault::Missing { what, form });
            return PatchMaterial::unknown(MaterialFault::new(fault));
        }
        let found = self.names.meant(name).iter();
        let found: Vec<&(usize, Definition)> = found.map(|i| &self.definitions[*i]).collect();
        let Some((_, first)) = found.first() else {
            let (what, given) = ("material", excerpt(name));
            let fault = self.source.fault(line, Fault::Undefined { what, given });
            let missing = match self.missing.as_slice() {
                [] => String::new(),
                files => format!(" ({} cannot be read)", files.join(", ")),
            };
            return PatchMaterial::unknown(MaterialFault::new(format!("{fault}{missing}")));
        };
        let place = format!("{}, line {line}", self.source.file().display());
        let (given, meant) = (excerpt(name), excerpt(&first.name));
        if first.name != name {
            self.notes.push(format!(
                "{place}: \"{given}\" is taken for material {meant}"
            ));
        }
        let library = found.iter().map(|(library, _)| *library).min();
        if let Some(library) = library.filter(|library| *library > line) {
            self.notes.push(format!(
                "{place}: material {given} is used before \"mtllib\" in line {library}"
            ));
        }
        let agreed = |of: fn(&PatchMaterial) -> &Property| agreed(&place, &found, of);
        PatchMaterial {
            reflectance: agreed(|material| &material.reflectance),
            emittance: agreed(|material| &material.emittance),
        }
    }

    /// The notes on libraries and names.
    pub(crate) fn into_notes(self) -> Vec<String> {
        self.notes
    }
}

/// A property that several definitions have, if they have the same.
fn agreed(
    place: &str,
    found: &[&(usize, Definition)],
    of: fn(&PatchMaterial) -> &Property,
) -> Property {
    let mut known = None;
    for (_, definition) in found {
        let property = of(&definition.material).clone()?;
        let (first, value) = *known.get_or_insert((definition, property));
        if value != property {
            return Err(MaterialFault::new(format!(
                "{place}: material {} is defined twice and differently, in {} and in {}: give one \
                 of them another name",
                excerpt(&first.name),
                first.place,
                definition.place
            )));
        }
    }
    Ok(known.map_or_else(Default::default, |(_, value)| value))
}

/// The numbers of the materials by their names, as they are and shortened.
#[derive(Default)]
struct Names {
    exact: HashMap<String, Vec<usize>>,
    evened: HashMap<String, Vec<usize>>,
    uncommented: HashMap<String, Vec<usize>>,
}

impl Names {
    fn add(&mut self, name: &str, number: usize) {
        for (names, name) in [
            (&mut self.exact, name.to_owned()),
            (&mut self.evened, evened(name)),
            (&mut self.uncommented, uncommented(name)),
        ] {
            names.entry(name).or_default().push(number);
        }
    }

    /// The materials that a name means, all of one name or of one that is nearly theirs.
    fn meant(&self, name: &str) -> &[usize] {
        let (even, bare) = (evened(name), uncommented(name));
        let found = self.exact.get(name);
        let found = found.or_else(|| self.evened.get(&even));
        let found = found.or_else(|| self.evened.get(&bare));
        let found = found.or_else(|| self.uncommented.get(&even));
        found.map_or(&[], Vec::as_slice)
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
