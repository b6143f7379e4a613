//! Wavefront OBJ: polygons, each one patch, and the materials they name.
//!
//! ```text
//!   v x y z                        a vertex
//!   f a b c …                      a face: a or a/vt/vn, from 1 in the order of the file; −1 is
//!                                  the last so far
//!   o name, g name                 the name of a face, before its number among those of that name,
//!                                  from 0
//!   mtllib file, usemtl name       reflectance and emittance (MTL); black without usemtl
//! ```
//!
//! The front of a face is the side from which it runs counter-clockwise. `#` begins a comment, but
//! belongs to a name, which is all of its line; a backslash at its end continues a line. Texture
//! coordinates, normals and smoothing groups are read over; points and lines, which have no area,
//! and statements that nobody knows are noted as left out.
//!
//! **Not covered**: curves and free-form surfaces, which are refused.

pub(crate) mod library;
pub(crate) mod materials;
pub(crate) mod mtl;
mod statements;
pub(crate) mod writer;

use super::error::{FileError, FileErrors, excerpt};
use super::faces::{Face, FaceRules, face_of};
use super::fault::Fault;
use super::last_place::LastPlaces;
use super::remarks::{Remark, Remarks};
use super::rows::Rows;
use super::source::{Source, number};
use super::unknown_materials::notes_on_unknown_materials;
use super::{LoadedScene, Reading, remark};
use crate::scene::{NamedPatch, PatchMaterial, Scene};
use glam::DVec3;
use materials::Materials;
use statements::{FREE_FORM, SILENT, logical_lines, split};
use std::collections::HashMap;
use std::sync::Arc;

const VERTEX: &str = "\"v x y z\"";
const FACE: &str = "\"f a b c\", with a vertex number for each corner";

/// Numbers that may follow the coordinates of a vertex: a weight, or a colour and its opacity.
const MOST_AFTER_COORDINATES: usize = 4;

/// The scene in an OBJ file; `library` finds a material file by the name that `mtllib` gives.
///
/// # Errors
/// The faults of this file; those of materials are notes.
pub fn read_obj(
    source: &Source,
    library: &dyn Fn(&str) -> Result<Source, FileError>,
    reading: impl Into<Reading>,
) -> Result<LoadedScene, FileErrors> {
    let reading = reading.into();
    let half_unit = last_places(source).half_unit();
    let lines: Vec<_> = logical_lines(source)
        .filter(|(_, text)| split(text).0 == "mtllib")
        .collect();
    let named = lines.iter().map(|(line, text)| (*line, split(text).1));
    let mut reader = Reader {
        source,
        rules: reading.rules(half_unit),
        vertices: Vec::new(),
        materials: Materials::of(source, named, library),
        material: PatchMaterial::BLACK,
        object: String::new(),
        group: String::new(),
        wholes: Arc::default(),
        faces: 0,
        faulty: 0,
        faces_named: HashMap::new(),
        patches: Vec::new(),
        rows: Rows::default(),
        remarks: Remarks::of(source),
    };
    // a list that grows takes its memory twice for a moment
    let may_be_face = |text: &str| text.starts_with('f') && text.len() >= "f 1 2 3".len();
    let faces = source.lines().filter(|(_, text)| may_be_face(text));
    reader.patches.reserve(faces.count());
    let mut faults = FileErrors::default();
    for (line, text) in logical_lines(source) {
        faults.keep(reader.statement(line, &text));
    }
    faults.none_or_refused()?;
    let mut notes = reader.remarks.into_notes(source.file());
    notes.append(&mut reader.materials.into_notes());
    notes.append(&mut notes_on_unknown_materials(&reader.patches));
    let mend = "a face with an area is a line \"f a b c\"";
    let whole = |fault| FileError::of_file(source.file(), fault);
    let scene = Scene::try_new(reader.patches).map_err(|_| whole(Fault::NoPatch { mend }))?;
    let refused = |error| {
        whole(Fault::Scene {
            source: Box::new(error),
        })
    };
    let scene = reading.resolved(scene, half_unit).map_err(refused)?;
    let scene = reader.rows.of(scene).map_err(refused)?;
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

struct Reader<'a> {
    source: &'a Source,
    rules: FaceRules,
    /// A vertex that is at fault keeps its number, and is not finite.
    vertices: Vec<DVec3>,
    materials: Materials<'a>,
    /// The material in use.
    material: PatchMaterial,
    object: String,
    group: String,
    /// The names of object and group, which those of their faces begin with.
    wholes: Arc<[String]>,
    /// The number of faces with patches so far.
    faces: usize,
    /// The number of faces that are at fault.
    faulty: usize,
    faces_named: HashMap<String, usize>,
    patches: Vec<NamedPatch>,
    rows: Rows,
    remarks: Remarks,
}

impl Reader<'_> {
    fn statement(&mut self, line: usize, text: &str) -> Result<(), FileError> {
        let at = |fault| self.source.fault(line, fault);
        let (keyword, rest) = split(text);
        let name = || rest.split_whitespace().collect::<Vec<_>>().join(" ");
        match keyword {
            "" => {}
            "v" | "V" => {
                let vertex = vertex(rest).map_err(at);
                let place = vertex.as_ref().map_or(DVec3::NAN, |(vertex, _)| *vertex);
                self.vertices.push(place);
                if !vertex?.1 {
                    self.remarks.count(Remark::AfterCoordinates, line);
                }
            }
            "f" | "F" | "fo" => self.face(line, rest)?,
            "o" => {
                self.object = self.remarks.short_name(line, name());
                self.wholes = self.wholes();
            }
            "g" => {
                let name = self.remarks.short_name(line, name());
                self.group = if name == "default" {
                    String::new()
                } else {
                    name
                };
                self.wholes = self.wholes();
            }
            "usemtl" => self.material = self.materials.named(line, rest),
            "mtllib" => {} // read before
            "p" => self.remarks.count(Remark::LeftOut("p"), line),
            "l" => self.remarks.count(Remark::LeftOut("l"), line),
            _ if SILENT.contains(&keyword) => {}
            _ if FREE_FORM.contains(&keyword) => {
                return Err(at(Fault::NotSupported {
                    what: format!("free-form geometry (\"{keyword}\") is not supported"),
                    mend: "export the surface as polygons",
                }));
            }
            _ => self.remarks.ignore(keyword, line),
        }
        Ok(())
    }

    fn face(&mut self, line: usize, rest: &str) -> Result<(), FileError> {
        let whole = self.wholes.last().map_or("face", String::as_str);
        let group = whole.to_owned();
        let number = self.faces_named.entry(group.clone()).or_insert(0);
        let name = format!("{group} {number}");
        *number += 1;
        let index = self.rows.len() + self.faulty;
        let face = self.corners(rest).and_then(|corners| {
            // the fault of a vertex is told already
            let is_known = corners.iter().all(|corner| corner.is_finite());
            let face = is_known.then(|| face_of(corners, self.rules)).transpose();
            face.map_err(|source| Fault::Geometry { source })
        });
        let Ok(Some(face)) = face else {
            self.faulty += 1;
            return face.map(|_| ()).map_err(|fault| {
                let patch = format!("{index} ({})", excerpt(&name));
                self.source.patch_fault(line, patch, fault)
            });
        };
        self.remarks.count_face(&face, line);
        self.add(name, face);
        Ok(())
    }

    fn add(&mut self, name: String, face: Face) {
        let Face {
            patches, is_split, ..
        } = face;
        if patches.is_empty() {
            self.rows.push_empty(name, self.material.clone());
            return;
        }
        self.rows.push(self.faces, patches.len(), is_split);
        self.faces += 1;
        let wholes = if is_split {
            let face = std::iter::once(&name);
            self.wholes.iter().chain(face).cloned().collect()
        } else {
            Arc::clone(&self.wholes)
        };
        for (part, shape) in patches.into_iter().enumerate() {
            let name = if is_split {
                format!("{name} (triangle {part})")
            } else {
                name.clone()
            };
            let patch = NamedPatch::new(name, shape).with_material(self.material.clone());
            self.patches.push(patch.with_wholes(Arc::clone(&wholes)));
        }
    }

    /// The names of object and group, and of both if there are both.
    fn wholes(&self) -> Arc<[String]> {
        let (object, group) = (self.object.as_str(), self.group.as_str());
        let both = format!("{object} {group}");
        let names: &[&str] = match (object, group) {
            ("", "") => &[],
            (one, "") | ("", one) => &[one],
            (object, group) => &[object, group, &both],
        };
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    fn corners(&self, rest: &str) -> Result<Vec<DVec3>, Fault> {
        let mut corners = rest.split_whitespace().peekable();
        if corners.peek().is_none() {
            let (what, form) = ("the first corner", FACE);
            return Err(Fault::Missing { what, form });
        }
        let place = |corner: &str| {
            let given = corner.split('/').next().unwrap_or_default();
            Ok(self.vertices[self.vertex_at(given)?])
        };
        corners.map(place).collect()
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
}

/// Three coordinates, and whether no more follows than a weight or a colour, which may be anything.
fn vertex(rest: &str) -> Result<(DVec3, bool), Fault> {
    let mut values = rest.split_whitespace();
    let mut coordinate = |what| number(values.next(), what, VERTEX);
    let vertex = DVec3::new(coordinate("x")?, coordinate("y")?, coordinate("z")?);
    let is_number = |value: &str| value.parse::<f64>().is_ok();
    let further: Vec<&str> = values.take(MOST_AFTER_COORDINATES + 1).collect();
    let is_known = further.len() <= MOST_AFTER_COORDINATES && further.into_iter().all(is_number);
    Ok((vertex, is_known))
}
