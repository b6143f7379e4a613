//! Scenes whose patches are cut into smaller ones.
//!
//! ```text
//!   n patches of 3 or 4 corners, cut k times   →   4ᵏ n patches, each with the index of its parent
//!   a patch of more corners than allowed       →   its triangles
//! ```
//!
//! **Not covered**: patches that others lie in, which are refused.

use super::{NamedPatch, Scene, SceneError};
use crate::geometry::{quartered, triangles_of};

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
            for (number, shape) in shapes.into_iter().enumerate() {
                let name = if times == 0 {
                    patch.name.clone()
                } else {
                    format!("{}/{number}", patch.name)
                };
                patches.push(NamedPatch::new(name, shape).with_material(patch.material));
                parents.push(index);
            }
        }
        let obstructions = self.obstructions.clone();
        let scene = self.with_parts(patches, &parents)?;
        Ok((scene.with_obstructions(obstructions), parents))
    }

    /// The scene in which patches and obstructions of more corners than these are cut into
    /// triangles, as formats need it that hold no more. Each triangle is a row, unless its patch is
    /// summed with others.
    ///
    /// # Errors
    /// [`SceneError::CutThroughPart`] if a patch lies in one that would be cut;
    /// [`SceneError::Patch`] if triangles are too small for `f64`.
    pub fn with_corners_up_to(&self, most: usize) -> Result<Self, SceneError> {
        let cut = |index: usize, patch: &NamedPatch| {
            if patch.shape.corners().len() <= most {
                return Ok(vec![patch.clone()]);
            }
            if let Some(part) = self.parts_of(index).next() {
                return Err(SceneError::CutThroughPart { base: index, part });
            }
            let shapes = triangles_of(&patch.shape).map_err(|source| SceneError::Patch {
                index,
                name: patch.name.clone(),
                source,
            })?;
            let part = |(number, shape)| NamedPatch {
                name: format!("{} (triangle {number})", patch.name),
                shape,
                ..patch.clone()
            };
            Ok(shapes.into_iter().enumerate().map(part).collect())
        };
        let (mut patches, mut parents) = (Vec::new(), Vec::new());
        for (index, patch) in self.patches.iter().enumerate() {
            let parts = cut(index, patch)?;
            parents.extend(parts.iter().map(|_| index));
            patches.extend(parts);
        }
        // no patch lies in an obstruction
        let obstructions = self.obstructions.iter();
        let obstructions = obstructions.map(|patch| cut(usize::MAX, patch));
        let obstructions: Vec<Vec<NamedPatch>> = obstructions.collect::<Result<_, _>>()?;
        let mut scene = self.with_parts(patches, &parents)?;
        for (part, parent) in parents.iter().enumerate() {
            if let Some(base) = self.bases[*parent] {
                // a base is not cut
                scene.lay(part, parents.partition_point(|parent| *parent < base))?;
            }
        }
        Ok(scene.with_obstructions(obstructions.concat()))
    }

    /// The scene of parts of its patches, with its rows. Of a row that is one patch each part
    /// becomes a row.
    ///
    /// **Arguments** `parents`: for each part, in their order, the index of its patch.
    fn with_parts(&self, parts: Vec<NamedPatch>, parents: &[usize]) -> Result<Self, SceneError> {
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
        let mut empty_rows = self.empty_rows.clone();
        let (mut before, mut place) = (0, 0);
        for (earlier, empty) in empty_rows.iter_mut().enumerate() {
            before += rows_of[place..empty.row].iter().sum::<usize>();
            place = empty.row;
            empty.row = before + earlier;
        }
        let scene = Self::try_new(parts)?.with_groups(&labels)?;
        scene.with_empty_rows(empty_rows)
    }
}
