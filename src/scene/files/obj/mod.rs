//! Wavefront OBJ: polygons, each one patch, and the materials they name.
//!
//! ```text
//!   v x y z                        a vertex
//!   f a b c …                      a face: a or a/vt/vn, from 1 in the order of the file; −1 is
//!                                  the last so far
//!   o name, g name                 the name of a face, before its number among those of that name,
//!                                  from 0
//!   mtllib file, usemtl name       reflectance and emittance (MTL); black without
//! ```
//!
//! The front of a face is the side from which it runs counter-clockwise. `#` begins a comment, a
//! backslash at its end continues a line. Texture coordinates, normals and smoothing groups are
//! read over; points and lines, which have no area, are noted as left out.
//!
//! **Not covered**: curves and free-form surfaces, which are refused.

pub(crate) mod mtl;
pub(crate) mod writer;

use super::error::{Fault, FileError, excerpt};
use super::faces::patches_of_face;
use super::last_place::LastPlaces;
use super::source::{Source, number};
use super::{LoadedScene, NonPlanarFaces, Reading, remark};
use crate::scene::{Material, NamedPatch, Scene};
use glam::DVec3;
use mtl::read_mtl;
use std::borrow::Cow;
use std::collections::HashMap;

const VERTEX: &str = "\"v x y z\"";
const FACE: &str = "\"f a b c\", with a vertex number for each corner";

/// Statements without an effect on the shape of a face or on diffuse light.
const SILENT: [&str; 14] = [
    "vt",
    "vn",
    "vp",
    "s",
    "mg",
    "bevel",
    "lod",
    "maplib",
    "usemap",
    "shadow_obj",
    "trace_obj",
    "c_interp",
    "d_interp",
    "deg",
];

/// Free-form geometry.
const FREE_FORM: [&str; 17] = [
    "cstype", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end",
    "con", "ctech", "stech", "call", "csh",
];

/// The scene in an OBJ file; `library` finds a material file by the name that `mtllib` gives.
///
/// # Errors
/// A [`FileError`] at the first fault, in this file or in a material file.
pub fn read_obj(
    source: &Source,
    library: &dyn Fn(&str) -> Result<Source, FileError>,
    reading: impl Into<Reading>,
) -> Result<LoadedScene, FileError> {
    let reading = reading.into();
    let half_unit = last_places(source).half_unit();
    let mut reader = Reader {
        source,
        library,
        faces: reading.faces,
        resolution: reading.resolution.unwrap_or(half_unit),
        vertices: Vec::new(),
        materials: HashMap::new(),
        material: Material::BLACK,
        object: String::new(),
        group: String::new(),
        faces_named: HashMap::new(),
        patches: Vec::new(),
        notes: Vec::new(),
    };
    for (line, text) in logical_lines(source) {
        reader.statement(line, &text)?;
    }
    let Reader {
        patches, mut notes, ..
    } = reader;
    let mend = "a face is a line \"f a b c\"";
    let scene = Scene::try_new(patches)
        .map_err(|_| FileError::of_file(source.file(), Fault::NoPatch { mend }))?;
    let scene = reading.resolved(scene, half_unit).map_err(|error| {
        let error = Box::new(error);
        FileError::of_file(source.file(), Fault::Scene { source: error })
    })?;
    notes.extend(remark(source, &scene));
    Ok(LoadedScene { scene, notes })
}

/// The last places of all vertices, which faces are judged by from the first one on.
fn last_places(source: &Source) -> LastPlaces {
    let mut places = LastPlaces::default();
    for (_, text) in logical_lines(source) {
        let mut words = text.split_whitespace();
        if words.next() == Some("v") {
            for word in words.take(3) {
                places.note(word, word.parse().unwrap_or(0.0));
            }
        }
    }
    places
}

/// Lines without comments; those that end in a backslash are joined with the next.
fn logical_lines(source: &Source) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = source.lines();
    let bare = |text: &'_ str| text.split('#').next().map_or(0, str::len);
    std::iter::from_fn(move || {
        let (line, text) = lines.next()?;
        let text = &text[..bare(text)];
        let Some(start) = text.trim_end().strip_suffix('\\') else {
            return Some((line, Cow::Borrowed(text)));
        };
        let mut joined = start.to_owned();
        for (_, text) in lines.by_ref() {
            let text = text[..bare(text)].trim_end();
            joined.push(' ');
            joined.push_str(text.strip_suffix('\\').unwrap_or(text));
            if !text.ends_with('\\') {
                break;
            }
        }
        Some((line, Cow::Owned(joined)))
    })
}

struct Reader<'a> {
    source: &'a Source,
    library: &'a dyn Fn(&str) -> Result<Source, FileError>,
    faces: NonPlanarFaces,
    resolution: f64,
    vertices: Vec<DVec3>,
    materials: HashMap<String, Material>,
    material: Material,
    object: String,
    group: String,
    faces_named: HashMap<String, usize>,
    patches: Vec<NamedPatch>,
    notes: Vec<String>,
}

impl Reader<'_> {
    fn statement(&mut self, line: usize, text: &str) -> Result<(), FileError> {
        let at = |fault| self.source.fault(line, fault);
        let text = text.trim();
        let (keyword, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        let name = || rest.split_whitespace().collect::<Vec<_>>().join(" ");
        match keyword {
            "" => {}
            "v" => self.vertices.push(vertex(rest).map_err(at)?),
            "f" | "fo" => self.face(line, rest)?,
            "o" => self.object = name(),
            "g" => {
                let name = name();
                self.group = if name == "default" {
                    String::new()
                } else {
                    name
                };
            }
            "usemtl" => {
                let name = name();
                self.material = *self.materials.get(&name).ok_or_else(|| {
                    at(Fault::Undefined {
                        what: "material",
                        given: excerpt(&name),
                    })
                })?;
            }
            "mtllib" => self.materials_of(line, rest.trim())?,
            "p" | "l" => self.note(format!("\"{keyword}\" has no area and is left out")),
            _ if SILENT.contains(&keyword) => {}
            _ if FREE_FORM.contains(&keyword) => {
                return Err(at(Fault::NotSupported {
                    what: format!("free-form geometry (\"{keyword}\") is not supported"),
                    mend: "export the surface as polygons",
                }));
            }
            _ => {
                return Err(at(Fault::UnknownKeyword {
                    format: "Wavefront OBJ",
                    keyword: excerpt(keyword),
                }));
            }
        }
        Ok(())
    }

    /// One file, or, if there is none of that name, several files separated by spaces.
    fn materials_of(&mut self, line: usize, names: &str) -> Result<(), FileError> {
        if names.is_empty() {
            let (what, form) = ("the name of the material file", "\"mtllib file.mtl\"");
            return Err(self.source.fault(line, Fault::Missing { what, form }));
        }
        let libraries = match (self.library)(names) {
            Ok(library) => vec![library],
            Err(error) => {
                let several: Vec<&str> = names.split_whitespace().collect();
                let read = several.iter().map(|name| (self.library)(name));
                let read: Result<Vec<_>, _> = read.collect();
                let only_one = several.len() == 1;
                read.map_err(|other| if only_one { error } else { other })
                    .map_err(|error| match error {
                        // a line of the library itself is at fault
                        FileError { line: Some(_), .. } => error,
                        FileError { file, fault, .. } => {
                            let source = Box::new(fault);
                            self.source.fault(line, Fault::Library { file, source })
                        }
                    })?
            }
        };
        for library in &libraries {
            read_mtl(library, &mut self.materials, &mut self.notes)?;
        }
        Ok(())
    }

    fn face(&mut self, line: usize, rest: &str) -> Result<(), FileError> {
        let named: Vec<&str> = [self.object.as_str(), self.group.as_str()]
            .into_iter()
            .filter(|name| !name.is_empty())
            .collect();
        let group = if named.is_empty() {
            "face".to_owned()
        } else {
            named.join(" ")
        };
        let number = self.faces_named.entry(group.clone()).or_insert(0);
        let name = format!("{group} {number}");
        *number += 1;
        let index = self.patches.len();
        let at = |fault| {
            let patch = format!("{index} ({})", excerpt(&name));
            self.source.patch_fault(line, patch, fault)
        };
        let corners = self.corners(rest).map_err(at)?;
        let patches = patches_of_face(corners, self.faces, self.resolution)
            .map_err(|source| at(Fault::Geometry { source }))?;
        let parts = patches.len();
        for (part, shape) in patches.into_iter().enumerate() {
            let name = if parts == 1 {
                name.clone()
            } else {
                format!("{name} (triangle {part})")
            };
            let patch = NamedPatch::new(name, shape).with_material(self.material);
            self.patches.push(patch);
        }
        Ok(())
    }

    fn corners(&self, rest: &str) -> Result<Vec<DVec3>, Fault> {
        let mut named = HashMap::new();
        let corners = rest.split_whitespace().map(|corner| {
            let given = corner.split('/').next().unwrap_or_default();
            let vertex = self.vertex_at(given)?;
            match named.insert(vertex, ()) {
                None => Ok(self.vertices[vertex]),
                Some(()) => Err(Fault::RepeatedCorner {
                    vertex: excerpt(given),
                }),
            }
        });
        corners.collect()
    }

    fn vertex_at(&self, given: &str) -> Result<usize, Fault> {
        let defined = self.vertices.len();
        let is_number = given.strip_prefix('-').unwrap_or(given).parse::<u128>();
        if is_number.is_err() {
            return Err(Fault::NotANumber {
                what: "a corner",
                given: excerpt(given),
                form: FACE,
            });
        }
        let index: Option<i64> = given.parse().ok();
        let place = index.and_then(|index| match usize::try_from(index) {
            Ok(0) => None,
            Ok(index) => Some(index - 1),
            Err(_) => defined.checked_sub(usize::try_from(index.checked_neg()?).ok()?),
        });
        place
            .filter(|place| *place < defined)
            .ok_or_else(|| Fault::NoSuchVertex {
                index: excerpt(given),
                defined,
            })
    }

    fn note(&mut self, text: String) {
        let note = format!("{}: {text}", self.source.file().display());
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }
}

/// Three coordinates; a weight or a colour may follow.
fn vertex(rest: &str) -> Result<DVec3, Fault> {
    let mut values = rest.split_whitespace();
    let mut coordinate = |what| number(values.next(), what, VERTEX);
    let vertex = DVec3::new(coordinate("x")?, coordinate("y")?, coordinate("z")?);
    let mut further = 0;
    for value in values {
        number(Some(value), "what follows the coordinates", VERTEX)?;
        further += 1;
        if further > 4 {
            return Err(Fault::TooMany {
                given: excerpt(value),
                form: VERTEX,
            });
        }
    }
    Ok(vertex)
}
