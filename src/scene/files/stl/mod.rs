//! STL: triangles without materials, binary or as text; each facet is one patch.
//!
//! ```text
//!   binary   80 bytes of any kind | number of facets n, u32 |
//!            n × ( normal, three corners: 12 × f32 | attribute, u16 )      little-endian
//!   text     solid name
//!              facet normal nx ny nz
//!                outer loop
//!                  vertex x y z                                            three of them
//!                endloop
//!              endfacet
//!            endsolid name
//! ```
//!
//! A file is binary if it is `84 + 50 n` bytes long, whatever it begins with; else it is text if it
//! begins with `solid` and no byte of it is 0. Keywords are of any case, and a text may hold
//! several solids. A facet is named after its solid, with its number among those of that name, from
//! 0; `facet` where the solid has no name, as in every binary file.
//!
//! The front is the side from which the corners run counter-clockwise. Normals are not used, but
//! those that point to the back are counted in a note; a facet without area keeps its number.
//! Attributes (some programs keep colours there) are read over; patches are black.
//!
//! The numbers of a text are decimals and are kept as such in 64 bits; those of a binary file have
//! 24 bits, so that each coordinate may be off by 2⁻²⁴ of itself.
//!
//! The reader is our own, since the crates for STL (`stl_io` 0.11, `mesh-loader` 0.1) round the
//! decimals of a text to 32 bits, by which a wall of two facets is no longer planar. `stl_io`, the
//! best kept, also names no line when it refuses, stops after the first solid, and takes a binary
//! file that begins with `solid` for a text; it judges this reader in the tests.
//!
//! **Not covered**: facets of more than three corners, which are refused.
//!
//! # Source
//! 3D Systems, *StereoLithography Interface Specification* (1988); Burns, *Automated Fabrication*
//! (1993), §6.5.

mod binary;
mod text;
pub(crate) mod writer;

use super::error::{FileError, FileErrors, excerpt};
use super::faces::face_of;
use super::fault::Fault;
use super::last_place::error_of_floats;
use super::remarks::{Remark, Remarks};
use super::rows::Rows;
use super::source::Source;
use super::{LoadedScene, Reading};
use crate::scene::{NamedPatch, PatchMaterial, Scene};
use glam::DVec3;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

/// The scene in an STL file of either kind.
///
/// # Errors
/// All faults of the file.
pub fn read_stl(
    file: &Path,
    bytes: Vec<u8>,
    reading: impl Into<Reading>,
) -> Result<LoadedScene, FileErrors> {
    let reading = reading.into();
    if binary::is_binary(&bytes) {
        let mut reader = Reader::new(reading, Remarks::of_facets());
        let mend = "its head counts no facets that have an area, so export the shape again";
        binary::read(file, &bytes, &mut reader)?;
        return reader.finish(file, mend);
    }
    let source = Source::from_bytes(file, bytes)?;
    let mut reader = Reader::new(reading, Remarks::of(&source));
    text::read(&source, &mut reader)?;
    reader.finish(
        file,
        "a facet with an area begins with \"facet normal x y z\"",
    )
}

/// A triangle as a file gives it.
struct Facet {
    corners: Vec<DVec3>,
    /// None if it is not a direction.
    normal: Option<DVec3>,
    /// The line of the facet, or its number.
    place: usize,
}

/// The patches so far.
struct Reader {
    reading: Reading,
    /// The number of facets so far for each name of a solid, and what they are pieces of.
    solids: HashMap<String, (usize, Arc<[String]>)>,
    patches: Vec<NamedPatch>,
    rows: Rows,
    remarks: Remarks,
    /// Remarks on the file as a whole.
    notes: Vec<String>,
}

impl Reader {
    fn new(reading: Reading, remarks: Remarks) -> Self {
        Self {
            reading,
            solids: HashMap::new(),
            patches: Vec::new(),
            rows: Rows::default(),
            remarks,
            notes: Vec::new(),
        }
    }

    /// Adds a facet of a solid; a fault comes with the number and the name of the patch.
    fn facet(&mut self, solid: &str, facet: Facet) -> Result<(), (String, Fault)> {
        let whole = Some(solid).filter(|name| !name.is_empty());
        let solid = whole.unwrap_or("facet");
        if !self.solids.contains_key(solid) {
            let wholes = whole.map(str::to_owned).into_iter().collect();
            self.solids.insert(solid.to_owned(), (0, wholes));
        }
        let (next, wholes) = self.solids.entry(solid.to_owned()).or_default();
        let name = format!("{solid} {next}");
        *next += 1;
        let row = self.rows.len();
        let face = face_of(facet.corners, self.reading.rules(0.0)).map_err(|source| {
            let patch = format!("{row} ({})", excerpt(&name));
            (patch, Fault::Geometry { source })
        })?;
        self.remarks.count_face(&face, facet.place);
        if face.patches.is_empty() {
            self.rows.push_empty(name, PatchMaterial::BLACK);
            return Ok(());
        }
        self.rows.push(row, face.patches.len(), face.is_split);
        for shape in face.patches {
            let points_back = |normal: DVec3| normal.dot(shape.normal()) < 0.0;
            if facet.normal.is_some_and(points_back) {
                self.remarks.count(Remark::NormalToTheBack, facet.place);
            }
            let patch = NamedPatch::new(name.clone(), shape);
            self.patches.push(patch.with_wholes(Arc::clone(wholes)));
        }
        Ok(())
    }

    fn finish(mut self, file: &Path, mend: &'static str) -> Result<LoadedScene, FileErrors> {
        let whole = |fault| FileError::of_file(file, fault);
        let scene = Scene::try_new(self.patches).map_err(|_| whole(Fault::NoPatch { mend }))?;
        let refused = |error| {
            whole(Fault::Scene {
                source: Box::new(error),
            })
        };
        // coordinates are 32-bit floats
        let corners = scene
            .patches()
            .iter()
            .flat_map(|patch| patch.shape().corners());
        let largest = corners.map(|corner| corner.abs().max_element());
        let error = error_of_floats(largest.fold(0.0, f64::max));
        let scene = self.reading.resolved(scene, error).map_err(refused)?;
        let scene = self.rows.of(scene).map_err(refused)?;
        let mut notes = self.remarks.into_notes(file);
        notes.append(&mut self.notes);
        Ok(LoadedScene { scene, notes })
    }
}
