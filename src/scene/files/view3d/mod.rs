//! View3D `.vs3`: vertices, triangles and quadrilaterals, obstructions, parts and combinations.
//!
//! ```text
//!   T title            C key=value …                 F 3
//!   V n x y z          S n v1 v2 v3 v4 base cmb emit name          v4 = 0: a triangle
//!   O n v1 v2 v3 v4    (anything after is skipped)    End of data
//! ```
//!
//! The front is the side from which the corners run counter-clockwise; the reflectance is 1 − emit.
//! A surface with a base lies in that one, which counts without it ([`Scene::with_base`]); one with
//! `cmb` is summed into a row with the surface of that number and all others that name it
//! ([`Scene::with_groups`]), and the row has the name of the first of them. As in View3D, a part of
//! a base is separated from it before rows are summed, and `cmb` does not chain. `!` and `/` begin
//! a comment, letters are of any case. Patches are the surfaces `S` in the order of the file,
//! whatever their numbers.
//!
//! The keys of `C` control computations of View3D and change nothing here, whatever they are: they
//! are noted as ignored. So is what follows `End of data`; a file without that line may be cut
//! short and is refused.
//!
//! **Not covered**, and refused by name: masks and null surfaces (`M`, `N`), coordinate
//! transformations (`X`), formats other than `F 3`.
//!
//! # Source
//! Walton, *Calculation of Obstructed View Factors by Adaptive Integration*, NISTIR 6925, and the
//! View3D 3.3 manual, §4 and §5.2.

pub(crate) mod surfaces;
pub(crate) mod writer;

use super::decimal::complement;
use super::error::{FileError, FileErrors, excerpt};
use super::fault::Fault;
use super::last_place::LastPlaces;
use super::remarks::Remarks;
use super::source::{Source, number};
use super::unknown_materials::notes_on_unknown_materials;
use super::{LoadedScene, Reading, remark};
use crate::scene::{Material, MaterialError};
use glam::DVec3;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use surfaces::{Surface, assemble};

const FORMAT: &str = "\"F 3\"";
const VERTEX: &str = "\"V n x y z\"";
const SURFACE: &str = "\"S n v1 v2 v3 v4 base cmb emit name\"";

/// The scene in a View3D file.
///
/// # Errors
/// All faults of the file.
pub fn read_view3d(
    source: &Source,
    reading: impl Into<Reading>,
) -> Result<LoadedScene, FileErrors> {
    let reading = reading.into();
    let mut faults = FileErrors::default();
    let mut reader = Reader {
        remarks: Remarks::of(source),
        ..Reader::default()
    };
    let mut has_end = false;
    for (line, text) in source.lines() {
        let words: Vec<&str> = uncommented(text).split_whitespace().collect();
        let at = |fault| source.fault(line, fault);
        let read = faults.keep(reader.statement(line, &words).map_err(at));
        if let Some(Statement::End) = read {
            has_end = true;
            break;
        }
    }
    if !has_end {
        let last = "End of data";
        faults.push(FileError::of_file(source.file(), Fault::NoEnd { last }));
    }
    let scene = assemble(source, &mut reader, reading, faults)?;
    let mut notes = reader.remarks.into_notes(source.file());
    notes.append(&mut notes_on_unknown_materials(scene.patches()));
    notes.extend(remark(source, &scene));
    Ok(LoadedScene { scene, notes })
}

/// The line up to a `!`, or to a `/` that begins a word.
fn uncommented(text: &str) -> &str {
    let text = text.split('!').next().unwrap_or_default();
    let slash = text.match_indices('/').map(|(place, _)| place);
    let begins = |place: &usize| {
        text[..*place]
            .chars()
            .next_back()
            .is_none_or(char::is_whitespace)
    };
    slash
        .into_iter()
        .find(begins)
        .map_or(text, |place| &text[..place])
}

enum Statement {
    Read,
    End,
}

#[derive(Debug, Default)]
pub(crate) struct Reader {
    /// The line of each vertex and its place; one that is at fault keeps its number, and is not
    /// finite.
    vertices: HashMap<usize, (usize, DVec3)>,
    surfaces: Vec<Surface>,
    surface_lines: HashMap<usize, usize>,
    places: LastPlaces,
    remarks: Remarks,
}

impl Reader {
    fn statement(&mut self, line: usize, words: &[&str]) -> Result<Statement, Fault> {
        let Some((keyword, values)) = words.split_first() else {
            return Ok(Statement::Read);
        };
        match keyword.to_ascii_uppercase().as_str() {
            "T" => {}
            "C" => self.control(line, values),
            "F" => format_of(values)?,
            "V" => self.vertex(line, values)?,
            "S" => self.surface(line, values, false)?,
            "O" => self.surface(line, values, true)?,
            "E" | "END" | "*" => return Ok(Statement::End),
            "M" | "N" => {
                return Err(Fault::NotSupported {
                    what: format!("a masking or null surface (\"{keyword}\") is not supported"),
                    mend: "cut the covered part out of its base",
                });
            }
            "X" => {
                return Err(Fault::NotSupported {
                    what: "a coordinate transformation (\"X\") is not supported".to_owned(),
                    mend: "write the vertices as they come out",
                });
            }
            _ => {
                return Err(Fault::UnknownKeyword {
                    format: "View3D",
                    keyword: excerpt(keyword),
                });
            }
        }
        Ok(Statement::Read)
    }

    /// Keys, each with a value or without.
    fn control(&mut self, line: usize, values: &[&str]) {
        let words = values.join(" ").replace(',', " ").replace('=', " = ");
        let mut words = words.split_whitespace().peekable();
        while let Some(key) = words.next() {
            let has_sign = words.next_if_eq(&"=").is_some();
            words.next_if(|value| has_sign || value.parse::<f64>().is_ok());
            self.remarks.ignore(&format!("C {key}"), line);
        }
    }

    fn vertex(&mut self, line: usize, values: &[&str]) -> Result<(), Fault> {
        let index = positive(values.first(), "the number of the vertex", VERTEX)?;
        for word in values.iter().skip(1).take(3) {
            self.places.note(word, word.parse().unwrap_or(0.0));
        }
        let vertex = coordinates(values);
        let place = vertex.as_ref().map_or(DVec3::NAN, |vertex| *vertex);
        match self.vertices.entry(index) {
            Entry::Vacant(entry) => {
                entry.insert((line, place));
                vertex.map(|_| ())
            }
            Entry::Occupied(entry) => Err(Fault::DefinedTwice {
                what: "vertex",
                number: index,
                line: entry.get().0,
            }),
        }
    }

    fn surface(&mut self, line: usize, values: &[&str], obstructs: bool) -> Result<(), Fault> {
        let number = positive(values.first(), "the number of the surface", SURFACE)?;
        if let Some(line) = self.surface_lines.get(&number).copied() {
            return Err(Fault::DefinedTwice {
                what: "surface",
                number,
                line,
            });
        }
        self.surface_lines.insert(number, line);
        let mut vertices = Vec::with_capacity(4);
        for place in 1..=3 {
            vertices.push(positive(values.get(place), "a vertex", SURFACE)?);
        }
        match whole(values.get(4), "the fourth vertex", SURFACE)? {
            0 => {}
            vertex => vertices.push(vertex),
        }
        let mut surface = Surface {
            line,
            number,
            vertices,
            obstructs,
            base: 0,
            combined: 0,
            material: Ok(Material::BLACK),
            name: String::new(),
        };
        if !obstructs {
            surface.base = whole(values.get(5), "the base", SURFACE)?;
            surface.combined = whole(values.get(6), "the surface to combine with", SURFACE)?;
            surface.material = material(values.get(7).copied());
        }
        surface.name = values.get(8..).unwrap_or_default().join(" ");
        if surface.name.is_empty() {
            surface.name = format!("surface {number}");
        }
        self.surfaces.push(surface);
        Ok(())
    }
}

fn coordinates(values: &[&str]) -> Result<DVec3, Fault> {
    let coordinate = |place: usize, what| number(values.get(place).copied(), what, VERTEX);
    let vertex = DVec3::new(
        coordinate(1, "x")?,
        coordinate(2, "y")?,
        coordinate(3, "z")?,
    );
    match values.get(4) {
        None => Ok(vertex),
        Some(given) => Err(Fault::TooMany {
            given: excerpt(given),
            form: VERTEX,
        }),
    }
}

fn format_of(values: &[&str]) -> Result<(), Fault> {
    match values {
        [] => Err(Fault::Missing {
            what: "the format",
            form: FORMAT,
        }),
        ["3"] => Ok(()),
        other => Err(Fault::NotSupported {
            what: format!(
                "the format \"F {}\" is not supported",
                excerpt(&other.join(" "))
            ),
            mend: "export the scene with vertices and surfaces as \"F 3\"",
        }),
    }
}

/// Reflects what it does not emit: 1 − emit, without a rounding in between. With an emissivity of 0
/// it is adiabatic.
fn material(emit: Option<&str>) -> Result<Material, Fault> {
    let emissivity = number(emit, "emit", SURFACE)?;
    let reflectance = match emit.and_then(complement) {
        Some(decimal) => number(Some(&decimal), "emit", SURFACE)?,
        None => 1.0 - emissivity,
    };
    let mantissa = emit.and_then(|emit| emit.split(['e', 'E']).next());
    let is_none = mantissa.is_none_or(|mantissa| !mantissa.contains(|c| ('1'..='9').contains(&c)));
    let material = if reflectance >= 1.0 && emissivity >= 0.0 && !is_none {
        // the little that it absorbs would be lost
        Err(MaterialError::EmissivityTooSmall { emissivity })
    } else {
        Material::try_new(reflectance, 0.0)
            .map_err(|_| MaterialError::EmissivityOutOfRange { emissivity })
    };
    material.map_err(|source| Fault::Material { source })
}

fn whole(given: Option<&&str>, what: &'static str, form: &'static str) -> Result<usize, Fault> {
    let given = given.ok_or(Fault::Missing { what, form })?;
    given.parse().map_err(|_| Fault::NotANumber {
        what,
        given: excerpt(given),
        form,
    })
}

fn positive(given: Option<&&str>, what: &'static str, form: &'static str) -> Result<usize, Fault> {
    match whole(given, what, form)? {
        0 => Err(Fault::Undefined {
            what: "vertex or surface",
            given: "0".to_owned(),
        }),
        number => Ok(number),
    }
}
