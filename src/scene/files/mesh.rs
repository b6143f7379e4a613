//! Meshes in arrays, as other programs hand them over.
//!
//! ```text
//!   vertices   x y z, x y z, …
//!   corners    the vertices of face 0, then those of face 1, …
//!   offsets    0, the number of corners of face 0, of faces 0 and 1 together, …, of all faces
//! ```
//!
//! Each face is one row of its number, whatever becomes of it: triangles of a face that is not
//! planar are summed, and a face without area keeps its number and exchanges nothing. Its front is
//! the side from which the corners run counter-clockwise. All faults are told, each with its face.
//!
//! **Not covered**: materials, which questions take beside the scene.

use super::error::{FileError, FileErrors};
use super::faces::{Face, face_of};
use super::fault::Fault;
use super::remarks::Remarks;
use super::rows::Rows;
use super::{LoadedScene, Reading, last_place};
use crate::geometry::GeometryError;
use crate::scene::{NamedPatch, PatchMaterial, Scene};
use glam::DVec3;
use std::path::Path;

/// A mesh of polygons in arrays.
///
/// # Examples
/// ```
/// use infoscene::scene::files::{MeshArrays, Reading};
/// // a square and a triangle that share an edge
/// let mesh = MeshArrays {
///     vertices: vec![[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [0., 0., 2.]],
///     corners: vec![0, 1, 2, 3, 0, 3, 4],
///     offsets: vec![0, 4, 7],
///     is_single: false,
/// };
/// let loaded = mesh.scene(&[], Reading::default())?;
/// assert_eq!(loaded.scene.row_areas(), [1.0, 1.0]);
/// # Ok::<(), infoscene::scene::files::FileErrors>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshArrays {
    /// The coordinates of the vertices.
    pub vertices: Vec<[f64; 3]>,
    /// The vertices of all faces, counted from 0, face after face.
    pub corners: Vec<i64>,
    /// The number of corners before each face, and that of all.
    pub offsets: Vec<i64>,
    /// Whether the coordinates come from 32-bit floats: then each may be off by their last place,
    /// as those of a binary STL file ([`Scene::resolution`]).
    pub is_single: bool,
}

impl MeshArrays {
    /// The scene of the faces, named `face 0`, `face 1`, …, among meshes that only obstruct.
    ///
    /// # Errors
    /// All faults of the faces; [`Fault::NoPatch`] if none has an area; [`Fault::Scene`] if a
    /// resolution is refused.
    pub fn scene(
        &self,
        obstacles: &[Self],
        reading: impl Into<Reading>,
    ) -> Result<LoadedScene, FileErrors> {
        let (file, reading) = (Path::new("mesh"), reading.into());
        let obstructions = Self::obstructions(obstacles, reading)?;
        let errors = obstacles.iter().map(Self::error);
        let error = errors.fold(self.error(), f64::max);
        let (mut rows, mut remarks) = (Rows::default(), Remarks::of_faces());
        let mut patches = Vec::with_capacity(self.offsets.len());
        for (number, face) in self.faces(file, reading)?.into_iter().enumerate() {
            remarks.count_face(&face, number);
            let name = format!("face {number}");
            if face.patches.is_empty() {
                rows.push_empty(name, PatchMaterial::BLACK);
                continue;
            }
            rows.push(number, face.patches.len(), false);
            let named = face.patches.into_iter();
            patches.extend(named.map(|shape| NamedPatch::new(name.clone(), shape)));
        }
        let whole = |fault| FileError::of_file(file, fault);
        let mend = "give a face that has an area";
        let scene = Scene::try_new(patches).map_err(|_| whole(Fault::NoPatch { mend }))?;
        let refused = |error| {
            whole(Fault::Scene {
                source: Box::new(error),
            })
        };
        let scene = scene.with_obstructions(obstructions);
        let scene = reading.resolved(scene, error).map_err(refused)?;
        let scene = rows.of(scene).map_err(refused)?;
        let notes = remarks.into_notes(file);
        Ok(LoadedScene { scene, notes })
    }

    /// The faces of some meshes as polygons that only obstruct, named `obstacle 0 face 0`, ….
    ///
    /// # Errors
    /// All faults of the faces of the first mesh that has some.
    pub fn obstructions(
        meshes: &[Self],
        reading: impl Into<Reading>,
    ) -> Result<Vec<NamedPatch>, FileErrors> {
        let reading = reading.into();
        let mut named = Vec::new();
        for (number, mesh) in meshes.iter().enumerate() {
            let name = format!("obstacle {number}");
            let faces = mesh.faces(Path::new(&name), reading)?;
            for (number, face) in faces.into_iter().enumerate() {
                let shapes = face.patches.into_iter();
                let name = format!("{name} face {number}");
                named.extend(shapes.map(|shape| NamedPatch::new(name.clone(), shape)));
            }
        }
        Ok(named)
    }

    /// The length by which each coordinate may be off.
    fn error(&self) -> f64 {
        if !self.is_single {
            return 0.0;
        }
        let sizes = self.vertices.iter().flatten().map(|number| number.abs());
        last_place::error_of_floats(sizes.fold(0.0, f64::max))
    }

    /// The faces as patches; all faults come with the numbers of their faces.
    fn faces(&self, file: &Path, reading: Reading) -> Result<Vec<Face>, FileErrors> {
        let rules = reading.rules(self.error());
        let whole = |fault| FileErrors::from(FileError::of_file(file, fault));
        let ends = self.ends().map_err(whole)?;
        // wrong numbers of vertices make wrong shapes, too
        let outlines = all_or_faults(file, ends.windows(2), |ends| self.outline(ends))?;
        all_or_faults(file, outlines.into_iter(), |corners| {
            face_of(corners, rules).map_err(|source| Fault::Geometry { source })
        })
    }

    /// The corners of the face between two offsets.
    fn outline(&self, ends: &[usize]) -> Result<Vec<DVec3>, Fault> {
        let corners = &self.corners[ends[0]..ends[1]];
        if corners.len() < 3 {
            let corners = corners.len();
            let source = GeometryError::TooFewCorners { corners };
            return Err(Fault::Geometry { source });
        }
        let corners = corners.iter().enumerate().map(|(corner, vertex)| {
            let place = usize::try_from(*vertex).ok();
            let found = place.and_then(|place| self.vertices.get(place));
            found.map_or(Err((corner, *vertex)), |at| Ok(DVec3::from_array(*at)))
        });
        let corners: Result<_, _> = corners.collect();
        corners.map_err(|(corner, vertex)| Fault::NotAVertex {
            corner,
            vertex,
            vertices: self.vertices.len(),
        })
    }

    /// The offsets, which divide the corners.
    fn ends(&self) -> Result<Vec<usize>, Fault> {
        let corners = self.corners.len();
        let refused = |place, offset| Fault::NotAnOffset {
            place,
            offset,
            corners,
        };
        let mut ends = Vec::with_capacity(self.offsets.len());
        let mut least = 0;
        for (place, offset) in self.offsets.iter().enumerate() {
            let end = usize::try_from(*offset).map_err(|_| refused(place, *offset))?;
            if end < least || end > corners || (place == 0 && end > 0) {
                return Err(refused(place, *offset));
            }
            ends.push(end);
            least = end;
        }
        if least < corners {
            let last = self.offsets.len().saturating_sub(1);
            return Err(refused(last, self.offsets.last().copied().unwrap_or(0)));
        }
        Ok(ends)
    }
}

/// Something of each face, or all faults, each with the number of its face.
fn all_or_faults<F, T>(
    file: &Path,
    faces: impl Iterator<Item = F>,
    of: impl Fn(F) -> Result<T, Fault>,
) -> Result<Vec<T>, FileErrors> {
    let mut faults = FileErrors::default();
    let found = faces.enumerate().filter_map(|(number, face)| {
        faults.keep(of(face).map_err(|fault| FileError {
            patch: Some(format!("{number} (face {number})")),
            ..FileError::of_file(file, fault)
        }))
    });
    let found = found.collect();
    faults.none_or_refused()?;
    Ok(found)
}
