//! Patches that lie on each other.
//!
//! Two patches overlap if they lie in one plane, face the same way, and their interiors meet: what
//! falls on one would be counted twice. Two that face opposite ways are the two sides of a sheet,
//! and allowed.
//!
//! Within the noise of the coordinates (see [`blockers`](super::Blockers)) planes count as one, and
//! patches that reach over each other by no more than it count as touching: neighbours of a rotated
//! wall do not overlap. Patches that lie on each other at a distance above the noise are not found
//! here; the upper one blocks what the lower one sees.
//!
//! **Not covered**: obstructions, which may lie on patches.

use super::visibility::surfaces::Search;
use super::{Scene, SceneError};
use crate::geometry::{Outline, Plane};
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;

impl Scene {
    /// The first two patches, in the order of their indices, that lie on each other.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// assert_eq!(Scene::built_in("cube:4")?.overlap(), None);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    #[must_use]
    pub fn overlap(&self) -> Option<(usize, usize)> {
        let count = self.patches.len();
        let surfaces = Search::Indexed(self.outlined());
        let of_patch = |first| {
            let second = self.overlapping(surfaces, first, first + 1..count)?;
            Some((first, second))
        };
        (0..count).into_par_iter().find_map_first(of_patch)
    }

    /// The first of some patches that overlaps this one.
    fn overlapping(
        &self,
        surfaces: Search<'_>,
        first: usize,
        others: Range<usize>,
    ) -> Option<usize> {
        let noise = self.planes().noise();
        let own = surfaces.outline(first);
        let [low, high] = *own.bounds();
        surfaces
            .near([low - noise, high + noise])
            .into_iter()
            .filter(|second| others.contains(second) && *second != first)
            .filter(|second| !self.is_part(first, *second))
            .filter(|second| {
                let other = surfaces.outline(*second);
                lie_in_one_plane(&own, &other, noise) && own.overlaps(&other, noise)
            })
            .min()
    }

    /// Tells whether one of two patches lies in the other, which counts without it.
    fn is_part(&self, first: usize, second: usize) -> bool {
        let under = |part: usize, base: usize| {
            std::iter::successors(self.base_of(part), |part| self.base_of(*part))
                .any(|found| found == base)
        };
        under(first, second) || under(second, first)
    }

    /// Refuses the scene if two of its patches lie on each other; meant to be asked once, after
    /// reading.
    ///
    /// # Errors
    /// [`SceneError::Overlap`].
    pub fn check_overlap(&self) -> Result<(), SceneError> {
        self.refuse_overlap(self.overlap())
    }

    /// Refuses the scene if one of its patches lies on this one, or under it.
    ///
    /// # Errors
    /// [`SceneError::Overlap`].
    pub(crate) fn check_overlap_of(&self, patch: usize) -> Result<(), SceneError> {
        let found = self.overlapping(Search::Scanned(self), patch, 0..self.patches.len());
        self.refuse_overlap(found.map(|other| (patch.min(other), patch.max(other))))
    }

    fn refuse_overlap(&self, found: Option<(usize, usize)>) -> Result<(), SceneError> {
        found.map_or(Ok(()), |(first, second)| {
            let names = [first, second].map(|patch| self.patches[patch].name.clone());
            Err(SceneError::Overlap {
                first,
                second,
                names,
                resolution: self.mending_resolution(|scene| scene.overlap().is_none()),
            })
        })
    }
}

/// Tells whether two outlines face the same way and one of them lies in the other's plane.
fn lie_in_one_plane(one: &Outline, other: &Outline, noise: f64) -> bool {
    let within = |outline: &Outline, plane: &Plane| {
        let mut corners = outline.pieces().iter().flatten();
        corners.all(|corner: &DVec3| plane.height(*corner).abs() <= noise)
    };
    one.plane().normal.dot(other.plane().normal) > 0.0
        && (within(one, other.plane()) || within(other, one.plane()))
}
