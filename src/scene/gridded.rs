//! The inside of a box whose faces all carry the same grid.

use super::{NamedPatch, Scene, SceneError, built_in};
use glam::DVec3;

impl Scene {
    /// The inside of a box, each of its six faces cut by the same relative lines in both directions.
    ///
    /// **Arguments** `edges`: of the box. `lines`: increasing between 0 and 1, which are left out.
    ///
    /// # Errors
    /// [`SceneError::Patch`] unless edges and cells are finite and > 0.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let grid = Scene::gridded_box([1.0, 1.0, 2.0], &[0.25, 0.5])?;
    /// assert_eq!((grid.patches().len(), grid.total_area()), (6 * 9, 10.0));
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn gridded_box(edges: [f64; 3], lines: &[f64]) -> Result<Self, SceneError> {
        let ends: Vec<f64> = [&[0.0], lines, &[1.0]].concat();
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        let [x, y, z] = [0, 1, 2].map(|axis| edges[axis] * axes[axis]);
        let mut patches: Vec<NamedPatch> = Vec::with_capacity(6 * (lines.len() + 1).pow(2));
        for (name, origin, u, v) in built_in::box_faces(x, y, z) {
            for (row, across) in ends.windows(2).enumerate() {
                for (column, along) in ends.windows(2).enumerate() {
                    let index = patches.len();
                    // corners from the grid lines themselves, so that neighbours share them exactly
                    let corner = origin + u * along[0] + v * across[0];
                    let (du, dv) = (along[1] - along[0], across[1] - across[0]);
                    let name = format!("{name} {row},{column}");
                    let patch = built_in::rectangle_patch(index, &name, corner, u * du, v * dv)?;
                    patches.push(patch);
                }
            }
        }
        Self::try_new(patches)
    }
}
