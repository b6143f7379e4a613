//! The faces of a room that is convex inside, however they are divided into patches.
//!
//! ```text
//!   inside is convex   ⇔   no corner lies behind the plane of any patch
//!   a face             =   the convex hull of the corners in one plane, if the patches cover it
//! ```
//!
//! Then nothing stands between two points of the walls, and a walk has its continuous form: what
//! does not depend on the division is computed from the faces.
//!
//! **Not covered**: whether the faces close up (their exchange areas say so).

use super::planes::ScenePlanes;
use super::{Scene, SceneError};
use crate::geometry::Patch;
use crate::numeric::{compensated_sum, tolerance};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

impl Scene {
    /// The faces of the convex room that the patches are the walls of, in the order of their first
    /// patches, and for each patch its face.
    ///
    /// # Errors
    /// [`SceneError::NotConvex`] if a corner lies behind a wall; [`SceneError::FaceNotCovered`] if
    /// the patches of a plane leave part of its hull open; [`SceneError::Patch`] if a face has no
    /// area to speak of.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let (faces, face_of) = Scene::built_in("cube:3")?.convex_room()?;
    /// assert_eq!((faces.len(), face_of[9], faces[0].corners().len()), (6, 1, 4));
    /// assert!(Scene::built_in("cornell-box")?.convex_room().is_ok());
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn convex_room(&self) -> Result<(Vec<Patch>, Vec<usize>), SceneError> {
        let planes = self.planes();
        let (members, face_of) = self.patches_of_faces(planes);
        self.require_convex(planes, &members)?;
        let noise = planes.noise_length();
        let faces = members.iter().map(|patches| self.face(patches, noise));
        Ok((faces.collect::<Result<_, _>>()?, face_of))
    }

    /// The patches of each face, parts of others left out, and the face of each patch.
    fn patches_of_faces(&self, planes: &ScenePlanes) -> (Vec<Vec<usize>>, Vec<usize>) {
        let mut faces_of = HashMap::new();
        let mut members: Vec<Vec<usize>> = Vec::new();
        let face_of = (0..self.patches.len()).map(|patch| {
            let root = self.root_of(patch);
            let face = *faces_of.entry(planes.plane_of(root)).or_insert_with(|| {
                members.push(Vec::new());
                members.len() - 1
            });
            if root == patch {
                members[face].push(patch);
            }
            face
        });
        let face_of = face_of.collect();
        (members, face_of)
    }

    /// The largest of these patches of a plane: heights over it are the surest.
    fn wall(&self, patches: &[usize]) -> &Patch {
        let shapes = patches.iter().map(|patch| &self.patches[*patch].shape);
        shapes.fold(&self.patches[patches[0]].shape, |best, next| {
            if next.area() > best.area() {
                next
            } else {
                best
            }
        })
    }

    /// Refuses a room one of whose corners lies behind the plane of a face.
    fn require_convex(&self, planes: &ScenePlanes, faces: &[Vec<usize>]) -> Result<(), SceneError> {
        let corners = self.surfaces().flat_map(|surface| surface.shape.corners());
        let corners: Vec<DVec3> = corners.copied().collect();
        for patches in faces {
            let (index, wall) = (patches[0], self.wall(patches));
            let shared = planes.facing(self.root_of(index));
            let height = |corner: &DVec3| {
                if self.resolution > 0.0 {
                    planes.unit() * shared.sure_height(*corner / planes.unit())
                } else {
                    wall.normal().dot(*corner - wall.corners()[0])
                }
            };
            let depths = corners.iter().map(|corner| -height(corner));
            let depth = depths.fold(0.0, f64::max);
            // a wall's own plane is as good as its corners are planar
            if depth > planes.noise_length() + tolerance::PLANARITY * wall.area().sqrt() {
                let name = self.patches[index].name.clone();
                return Err(SceneError::NotConvex { index, name, depth });
            }
        }
        Ok(())
    }

    /// The face that these patches of a plane cover, corners nearer than `noise` to a line left
    /// out.
    fn face(&self, patches: &[usize], noise: f64) -> Result<Patch, SceneError> {
        let index = patches[0];
        let shapes = || patches.iter().map(|patch| &self.patches[*patch].shape);
        let own = shapes().flat_map(Patch::corners).copied().collect();
        let hull = hull(own, self.wall(patches).normal(), noise);
        let face = Patch::within(hull, self.resolution);
        let face = face.map_err(|source| self.refused(index, source))?;
        let missing = face.area() - compensated_sum(shapes().map(Patch::area));
        // neighbours leave a seam open, or cover it twice
        let seams = self.resolution * compensated_sum(shapes().map(Patch::perimeter));
        let allowed = tolerance::COVERED * face.area() + tolerance::RESOLVED_NOISE * seams;
        if missing.abs() > allowed {
            return Err(SceneError::FaceNotCovered {
                index,
                name: self.patches[index].name.clone(),
                relative: missing / face.area(),
            });
        }
        Ok(face)
    }
}

/// The corners of the convex hull of points in a plane, counter-clockwise about the normal; those
/// nearer than `flat` to the line through their neighbours left out.
fn hull(mut points: Vec<DVec3>, normal: DVec3, flat: f64) -> Vec<DVec3> {
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    let place = |point: &DVec3| DVec2::new(across.dot(*point), up.dot(*point));
    points.sort_by(|a, b| {
        let (a, b) = (place(a), place(b));
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    });
    let chain = |points: &mut dyn Iterator<Item = &DVec3>| {
        let mut kept: Vec<DVec3> = Vec::new();
        for point in points {
            while let [.., before, last] = kept.as_slice() {
                let (start, turn) = (place(before), place(last));
                let end = place(point);
                let length = (end - start).length();
                if (end - start).perp_dot(turn - start) <= -flat * length {
                    break;
                }
                kept.pop();
            }
            kept.push(*point);
        }
        kept
    };
    let mut lower = chain(&mut points.iter());
    let mut upper = chain(&mut points.iter().rev());
    lower.pop();
    upper.pop();
    lower.append(&mut upper);
    lower
}
