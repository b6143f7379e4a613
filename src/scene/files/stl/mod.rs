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
//! those that point to the back are counted in a note. Attributes (some programs keep colours there)
//! are read over; patches are black.
//!
//! The numbers of a text are decimals and are kept as such in 64 bits; those of a binary file have
//! 24 bits, so that each coordinate may be off by 2⁻²⁴ of itself.
//!
//! The reader is our own, since the crates for STL (`stl_io` 0.11, `mesh-loader` 0.1, `nom_stl` 0.2)
//! round the decimals of a text to 32 bits, by which a wall of two facets is no longer planar, and
//! name neither line nor facet when they refuse; `stl_io`, otherwise the best kept, also stops after
//! the first solid and takes a binary file that begins with `solid` for a text. It judges this
//! reader in the tests.
//!
//! **Not covered**: facets of more than three corners, which are refused.
//!
//! # Source
//! 3D Systems, *StereoLithography Interface Specification* (1988); Burns, *Automated Fabrication*
//! (1993), §6.5.

mod binary;
mod text;
pub(crate) mod writer;

use super::error::{Fault, FileError, excerpt};
use super::faces::patches_of_face;
use super::source::Source;
use super::{LoadedScene, NonPlanarFaces};
use crate::scene::{NamedPatch, Scene};
use glam::DVec3;
use std::collections::HashMap;
use std::path::Path;

/// The scene in an STL file of either kind.
///
/// # Errors
/// A [`FileError`] at the first fault.
pub fn read_stl(
    file: &Path,
    bytes: Vec<u8>,
    faces: NonPlanarFaces,
) -> Result<LoadedScene, FileError> {
    let mut reader = Reader {
        faces,
        numbers: HashMap::new(),
        patches: Vec::new(),
        turned: 0,
        notes: Vec::new(),
    };
    let mend = if binary::is_binary(&bytes) {
        binary::read(file, &bytes, &mut reader)?;
        "its head counts no facets, so export the shape again"
    } else {
        text::read(&Source::from_bytes(file, bytes)?, &mut reader)?;
        "a facet begins with \"facet normal x y z\""
    };
    reader.finish(file, mend)
}

/// A triangle as a file gives it.
struct Facet {
    corners: Vec<DVec3>,
    /// None if it is not a direction.
    normal: Option<DVec3>,
}

/// The patches so far.
struct Reader {
    faces: NonPlanarFaces,
    /// The number of facets of each name.
    numbers: HashMap<String, usize>,
    patches: Vec<NamedPatch>,
    /// The number of facets whose normal points to the back.
    turned: usize,
    notes: Vec<String>,
}

impl Reader {
    /// Adds a facet of a solid; `at` makes an error of a fault of the patch of this name.
    fn facet(
        &mut self,
        solid: &str,
        facet: Facet,
        at: impl Fn(String, Fault) -> FileError,
    ) -> Result<(), FileError> {
        let solid = if solid.is_empty() { "facet" } else { solid };
        let number = match self.numbers.get_mut(solid) {
            Some(number) => {
                *number += 1;
                *number
            }
            None => *self.numbers.entry(solid.to_owned()).or_default(),
        };
        let name = format!("{solid} {number}");
        let index = self.patches.len();
        let shapes = patches_of_face(facet.corners, self.faces).map_err(|source| {
            let patch = format!("{index} ({})", excerpt(&name));
            at(patch, Fault::Geometry { source })
        })?;
        for shape in shapes {
            let points_back = |normal: DVec3| normal.dot(shape.normal()) < 0.0;
            self.turned += usize::from(facet.normal.is_some_and(points_back));
            self.patches.push(NamedPatch::new(name.clone(), shape));
        }
        Ok(())
    }

    fn finish(mut self, file: &Path, mend: &'static str) -> Result<LoadedScene, FileError> {
        if self.turned > 0 {
            let all = self.patches.len();
            self.notes.push(format!(
                "{}: {} of {all} normals point to the back of their facets and are ignored: the \
                 order of the corners says which side is the front",
                file.display(),
                self.turned
            ));
        }
        let scene = Scene::try_new(self.patches)
            .map_err(|_| FileError::of_file(file, Fault::NoPatch { mend }))?;
        Ok(LoadedScene {
            scene,
            notes: self.notes,
        })
    }
}
