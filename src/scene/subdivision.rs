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
    /// patch's with their number. Each part is a row, unless its patch is summed with others.
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
                let part = NamedPatch::new(name, shape).with_material(patch.material.clone());
                patches.push(part.with_wholes(Arc::clone(&wholes)));
                parents.push(index);
            }
        }
        // of a row that is one patch, each part becomes a row
        let mut patches_of = vec![0; self.group_count()];
        for group in &self.groups {
            patches_of[*group] += 1;
        }
        let mut rows_of = vec![0; self.group_count()];
        let mut labels = Vec::with_capacity(parents.len());
        for (part, parent) in parents.iter().enumerate() {
            let row = self.group_of(*parent);
            let is_summed = patches_of[row] > 1;
            labels.push((row, if is_summed { 0 } else { part }));
            rows_of[row] = if is_summed { 1 } else { rows_of[row] + 1 };
        }
        let mut scene = Self::try_new(patches)?.with_obstructions(self.obstructions.clone());
        if self.first_summed().is_some() {
            scene = scene.with_groups(&labels)?;
        }
        let mut empty_rows = self.empty_rows.clone();
        let (mut before, mut place) = (0, 0);
        for (earlier, empty) in empty_rows.iter_mut().enumerate() {
            before += rows_of[place..empty.row].iter().sum::<usize>();
            place = empty.row;
            empty.row = before + earlier;
        }
        Ok((scene.with_empty_rows(empty_rows)?, parents))
    }
}
