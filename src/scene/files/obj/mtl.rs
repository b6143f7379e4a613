//! Wavefront MTL: of each material the diffuse reflectance `Kd` and the emittance `Ke`.
//!
//! ```text
//!   newmtl name      Kd r [g b]      Ke r [g b]        one value stands for all three channels
//! ```
//!
//! A name is all that follows on its line. A reflectance or emittance that cannot be read, or that
//! none can have, makes that property of the material unknown and nothing else. What says nothing
//! about diffuse light is read over; gloss, transparency, textures and words that nobody knows are
//! noted as left out.
//!
//! **Not covered**: spectral curves and CIEXYZ values, which leave the property unknown.

use crate::scene::channel::Channels;
use crate::scene::files::error::excerpt;
use crate::scene::files::fault::Fault;
use crate::scene::files::remarks::Remarks;
use crate::scene::files::source::{Source, number};
use crate::scene::material::{
    MaterialFault, PatchMaterial, Property, checked_emittance, checked_reflectance,
};

const COLOUR: &str = "three numbers (red, green, blue)";

/// Statements that have no effect on diffuse light.
const SILENT: [&str; 7] = ["ka", "ns", "ni", "sharpness", "illum", "km", "tr"];

/// Statements that would have an effect, and have none here.
const LEFT_OUT: [&str; 17] = [
    "ks", "tf", "d", "bump", "disp", "decal", "refl", "norm", "pr", "pm", "ps", "pc", "pcr",
    "aniso", "anisor", "map_kd", "map_ke",
];

/// Notes of a library that are told.
const MOST_NOTES: usize = 20;

/// A material as a library defines it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Definition {
    /// The name; empty if it is missing, so that nothing has it.
    pub name: String,
    /// The file and the line of the name.
    pub place: String,
    /// The reflectance and the emittance.
    pub material: PatchMaterial,
}

/// The materials that a library defines, in order, and what it has to say.
#[derive(Debug, Default)]
pub(crate) struct Library {
    /// The materials; of one name there may be several.
    pub definitions: Vec<Definition>,
    /// Statements without effect, a sentence each.
    pub notes: Vec<String>,
}

impl Library {
    /// The library with this text.
    pub(crate) fn read(source: &Source) -> Self {
        let mut library = Self::default();
        let mut remarks = Remarks::of(source);
        for (line, text) in source.lines() {
            if let Some(word) = library.statement(source, line, text.trim()) {
                remarks.ignore(word, line);
            }
        }
        if library.definitions.is_empty() {
            let file = source.file().display();
            library.notes = vec![format!("{file}: it defines no material")];
        } else {
            library.notes.extend(remarks.into_notes(source.file()));
        }
        library
    }

    /// Reads a line; if nobody knows its first word, that is returned.
    fn statement<'t>(&mut self, source: &Source, line: usize, text: &'t str) -> Option<&'t str> {
        let (keyword, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        match keyword.to_ascii_lowercase().as_str() {
            "" => {}
            key if key.starts_with('#') => {}
            "newmtl" => {
                if rest.trim().is_empty() {
                    let (what, form) = ("the name of the material", "\"newmtl name\"");
                    self.missing(source, line, what, form);
                }
                self.definitions.push(Definition {
                    name: rest.trim().to_owned(),
                    place: format!("{}, line {line}", source.file().display()),
                    material: PatchMaterial::BLACK,
                });
            }
            key @ ("kd" | "ke") => {
                let is_reflectance = key == "kd";
                let values = rest.split('#').next().unwrap_or_default();
                let property = channels(values, is_reflectance)
                    .map_err(|fault| MaterialFault::new(source.fault(line, fault)));
                self.set(source, line, is_reflectance, property);
            }
            key if SILENT.contains(&key) => {}
            key if LEFT_OUT.contains(&key) || key.starts_with("map_") => {
                let is_map = key.starts_with("map_");
                let keyword = if is_map { "map_…" } else { keyword };
                self.note(format!(
                    "{}: \"{keyword}\" is left out, materials are diffuse and even",
                    source.file().display()
                ));
            }
            _ => return Some(keyword),
        }
        None
    }

    /// Gives the material that is being defined a property.
    fn set(&mut self, source: &Source, line: usize, is_reflectance: bool, property: Property) {
        match self.definitions.last_mut() {
            Some(Definition { material, .. }) if is_reflectance => material.reflectance = property,
            Some(Definition { material, .. }) => material.emittance = property,
            None => {
                let what = "the material that this belongs to";
                let form = "\"newmtl name\" before it";
                self.missing(source, line, what, form);
            }
        }
    }

    fn missing(&mut self, source: &Source, line: usize, what: &'static str, form: &'static str) {
        let fault = source.fault(line, Fault::Missing { what, form });
        self.note(fault.to_string());
    }

    fn note(&mut self, note: String) {
        if self.notes.len() < MOST_NOTES && !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }
}

/// The three channels, each of them checked; one value stands for all three.
fn channels(values: &str, is_reflectance: bool) -> Result<Channels<f64>, Fault> {
    let values: Vec<&str> = values.split_whitespace().collect();
    if let Some(kind @ ("spectral" | "xyz")) = values.first().copied() {
        return Err(Fault::NotSupported {
            what: format!("a colour given as \"{kind}\" is not supported"),
            mend: "write red, green and blue",
        });
    }
    let first = number(values.first().copied(), "the first channel", COLOUR)?;
    let channels = match values.as_slice() {
        [_] => Channels::grey(first),
        _ => Channels {
            r: first,
            g: number(values.get(1).copied(), "the second channel", COLOUR)?,
            b: number(values.get(2).copied(), "the third channel", COLOUR)?,
        },
    };
    if let Some(given) = values.get(3) {
        return Err(Fault::TooMany {
            given: excerpt(given),
            form: COLOUR,
        });
    }
    let checked = if is_reflectance {
        checked_reflectance
    } else {
        checked_emittance
    };
    Channels::try_from_fn(|channel| checked(*channels.of(channel)))
        .map_err(|source| Fault::Material { source })
}
