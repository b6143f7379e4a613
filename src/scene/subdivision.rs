//! Scenes whose patches are cut into smaller ones.
//!
//! ```text
//!   n patches of 3 or 4 corners, cut k times   →   4ᵏ n patches, each with the index of its parent
//!   a patch of m corners, triangulated         →   m − 2 patches
//! ```
//!
//! **Not covered**: cuts through patches that others lie in, which are refused.

use super::{NamedPatch, Scene, SceneError};
use crate::geometry::{GeometryError, Patch, quartered, triangles_of};
use std::sync::Arc;

/// The names and shapes of a patch's parts.
type Parts = Vec<(String, Patch)>;

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
        self.cut(|patch| {
            if times == 0 {
                return Ok(None);
            }
            let mut shapes = vec![patch.shape.clone()];
            for _ in 0..times {
                let parts: Result<Vec<_>, _> = shapes.iter().map(quartered).collect();
                shapes = parts?.concat();
            }
            let name = |number| format!("{}/{number}", patch.name);
            Ok(Some((0..).map(name).zip(shapes).collect()))
        })
    }

    /// The scene with every patch and every obstruction of more than `most` corners split into
    /// triangles, and for each new patch the one it is a part of. Parts keep the material; their
    /// names are those that the triangles of a file's faces have. Each is a row, unless its patch
    /// is summed with others.
    ///
    /// # Errors
    /// As [`subdivided`](Self::subdivided); patches that stay whole may have others in them.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let (scene, parents) = Scene::built_in("cube:1")?.triangulated(3)?;
    /// assert_eq!((scene.patches().len(), parents[11]), (12, 5));
    /// assert_eq!(scene.total_area(), 6.0);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn triangulated(&self, most: usize) -> Result<(Self, Vec<usize>), SceneError> {
        let split = |patch: &NamedPatch| {
            if patch.shape.corners().len() <= most {
                return Ok(None);
            }
            let name = |number| format!("{} (triangle {number})", patch.name);
            let shapes = triangles_of(&patch.shape)?;
            Ok(Some((0..).map(name).zip(shapes).collect()))
        };
        let (scene, parents) = self.cut(split)?;
        let obstructions = self.obstructions.iter().enumerate().map(|(index, patch)| {
            let index = self.patches.len() + index;
            let parts: Option<Parts> = split(patch).map_err(|error| self.refused(index, error))?;
            Ok(with_parts(patch, parts))
        });
        let obstructions: Result<Vec<_>, SceneError> = obstructions.collect();
        Ok((scene.with_obstructions(obstructions?.concat()), parents))
    }

    /// The scene with patches in parts, if there are any, and the index of the patch that each part
    /// is of.
    fn cut(
        &self,
        parts: impl Fn(&NamedPatch) -> Result<Option<Parts>, GeometryError>,
    ) -> Result<(Self, Vec<usize>), SceneError> {
        let mut patches = Vec::new();
        let mut parents = Vec::new();
        for (index, patch) in self.patches.iter().enumerate() {
            let parts = parts(patch).map_err(|error| self.refused(index, error))?;
            if let Some(part) = self.parts_of(index).next().filter(|_| parts.is_some()) {
                return Err(SceneError::CutThroughPart { base: index, part });
            }
            patches.extend(with_parts(patch, parts));
            parents.resize(patches.len(), index);
        }
        // a base is whole
        let place = |old: usize| parents.partition_point(|parent| *parent < old);
        let bases = parents.iter().map(|parent| self.bases[*parent].map(place));
        let bases = bases.collect();
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
        let scene = Self {
            resolution: self.resolution,
            bases,
            ..scene.with_empty_rows(empty_rows)?
        };
        Ok((scene, parents))
    }
}

/// A patch in parts of these names and shapes, or whole.
fn with_parts(patch: &NamedPatch, parts: Option<Parts>) -> Vec<NamedPatch> {
    let Some(parts) = parts else {
        return vec![patch.clone()];
    };
    let own = std::iter::once(&patch.name);
    let wholes: Arc<[String]> = patch.wholes.iter().chain(own).cloned().collect();
    let part = |(name, shape)| NamedPatch {
        name,
        shape,
        wholes: Arc::clone(&wholes),
        ..patch.clone()
    };
    parts.into_iter().map(part).collect()
}
