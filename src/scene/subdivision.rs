//! Scenes whose patches are cut into smaller ones.
//!
//! ```text
//!   n patches of 3 or 4 corners, cut k times   →   4ᵏ n patches, each with the index of its parent
//! ```
//!
//! **Not covered**: patches that others lie in, which are refused.

use super::{NamedPatch, Scene, SceneError};
use crate::geometry::quartered;
use std::sync::Arc;

impl Scene {
    /// The scene with every patch [`quartered`](crate::geometry::quartered()) so many times, and
    /// for each new patch the one it is a part of. Parts keep the material; their names are the
    /// patch's with their number.
    ///
    /// # Errors
    /// [`SceneError::CutThroughPart`] if a patch lies in another; [`SceneError::Patch`] if parts
    /// are too small for `f64`.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let (scene, parents) = Scene::built_in("three-squares")?.subdivided(2)?;
    /// assert_eq!((scene.patches().len(), parents[17]), (48, 1));
    /// assert_eq!(scene.total_area(), 3.0);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn subdivided(&self, times: u32) -> Result<(Self, Vec<usize>), SceneError> {
        let mut patches = Vec::new();
        let mut parents = Vec::new();
        for (index, patch) in self.patches.iter().enumerate() {
            if let Some(part) = self.parts_of(index).next() {
                return Err(SceneError::CutThroughPart { base: index, part });
            }
            let mut shapes = vec![patch.shape.clone()];
            for _ in 0..times {
                let parts: Result<Vec<_>, _> = shapes.iter().map(quartered).collect();
                shapes = parts.map_err(|error| self.refused(index, error))?.concat();
            }
            let is_whole = times == 0;
            let wholes = if is_whole {
                Arc::clone(&patch.wholes)
            } else {
                let own = std::iter::once(&patch.name);
                patch.wholes.iter().chain(own).cloned().collect()
            };
            for (number, shape) in shapes.into_iter().enumerate() {
                let name = if is_whole {
                    patch.name.clone()
                } else {
                    format!("{}/{number}", patch.name)
                };
                let part = NamedPatch::new(name, shape).with_material(patch.material);
                patches.push(part.with_wholes(Arc::clone(&wholes)));
                parents.push(index);
            }
        }
        let labels: Vec<usize> = parents.iter().map(|index| self.group_of(*index)).collect();
        let scene = Self {
            resolution: self.resolution,
            ..Self::try_new(patches)?.with_obstructions(self.obstructions.clone())
        };
        let is_grouped = self.group_count() < self.patches.len();
        let scene = if is_grouped {
            scene.with_groups(&labels)?
        } else {
            scene
        };
        Ok((scene, parents))
    }
}
