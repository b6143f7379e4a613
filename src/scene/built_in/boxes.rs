//! The insides of boxes, whole or with every face cut by one grid.
//!
//! Faces are numbered floor, ceiling, left, right, front, back; their cells face by face, each row
//! by row.

use super::rectangle_patch;
use crate::scene::{NamedPatch, Scene, SceneError};
use glam::DVec3;
use std::sync::Arc;

impl Scene {
    /// The inside of a box: six patches, the floor and the ceiling first.
    ///
    /// # Errors
    /// [`SceneError::Patch`] unless all edges are finite and > 0.
    pub fn inside_of_box(x: f64, y: f64, z: f64) -> Result<Self, SceneError> {
        let faces = box_faces(x * DVec3::X, y * DVec3::Y, z * DVec3::Z);
        let patches = faces.into_iter().enumerate();
        Self::try_new(
            patches
                .map(|(index, (name, origin, u, v))| rectangle_patch(index, name, origin, u, v))
                .collect::<Result<_, _>>()?,
        )
    }

    /// The inside of a box, each of its six faces cut by the same relative lines in both
    /// directions.
    ///
    /// **Arguments** `edges`: of the box. `lines`: increasing between 0 and 1, which are left out.
    ///
    /// # Errors
    /// [`SceneError::GridLine`] for the lines; [`SceneError::Patch`] unless edges and cells are
    /// finite and > 0.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let grid = Scene::gridded_box([1.0, 1.0, 2.0], &[0.25, 0.5])?;
    /// assert_eq!((grid.patches().len(), grid.total_area()), (6 * 9, 10.0));
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn gridded_box(edges: [f64; 3], lines: &[f64]) -> Result<Self, SceneError> {
        let ends = ends_of_cells(lines)?;
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let [x, y, z] = [0, 1, 2].map(|axis| edges[axis] * axes[axis]);
        let mut patches: Vec<NamedPatch> = Vec::with_capacity(6 * (lines.len() + 1).pow(2));
        for (face, origin, u, v) in box_faces(x, y, z) {
            let whole: Arc<[String]> = [face.to_owned()].into();
            for (row, across) in ends.windows(2).enumerate() {
                for (column, along) in ends.windows(2).enumerate() {
                    let index = patches.len();
                    // corners from the grid lines themselves, so that neighbours share them exactly
                    let corner = origin + u * along[0] + v * across[0];
                    let (du, dv) = (along[1] - along[0], across[1] - across[0]);
                    let name = format!("{face} {row},{column}");
                    let patch = rectangle_patch(index, &name, corner, u * du, v * dv)?;
                    patches.push(patch.with_wholes(Arc::clone(&whole)));
                }
            }
        }
        Self::try_new(patches)
    }
}

/// The lines with 0 and 1, if they increase.
pub(crate) fn ends_of_cells(lines: &[f64]) -> Result<Vec<f64>, SceneError> {
    let ends = [&[0.0], lines, &[1.0]].concat();
    // no comparison holds for NaN
    let increases =
        |index: &usize| ends[*index] < ends[index + 1] && ends[index + 1] < ends[index + 2];
    match (0..lines.len()).find(|index| !increases(index)) {
        Some(index) => Err(SceneError::GridLine {
            index,
            position: lines[index],
        }),
        None => Ok(ends),
    }
}

/// Name, corner and edges of the faces of a box, fronts inward.
pub(crate) fn box_faces(x: DVec3, y: DVec3, z: DVec3) -> [(&'static str, DVec3, DVec3, DVec3); 6] {
    [
        ("floor", DVec3::ZERO, x, y),
        ("ceiling", z, y, x),
        ("left", DVec3::ZERO, y, z),
        ("right", x, z, y),
        ("front", DVec3::ZERO, z, x),
        ("back", y, x, z),
    ]
}
