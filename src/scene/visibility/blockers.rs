//! The search for surfaces that stand between two patches.
//!
//! The exchange area of two patches is computed past all surfaces that stand between them, and past
//! no others.
//!
//! ```text
//!   k blocks (i, j)  ⇔  k meets the interior of the union of all segments from i⁺ to j⁺
//!   i⁺: the part of i in front of j's plane,  j⁺: the part of j in front of i's plane
//! ```
//!
//! A pair that exchanges nothing has no i⁺ or no j⁺. Every k counts from both sides. [`Shaft`] says
//! what is decided and what noise means; it is that of the scene's planes, about 64 ε of the
//! largest coordinate plus eight times the largest deviation of a corner from its patch's plane, or
//! a multiple of the scene's [resolution](Scene::resolution). So a blocker that enters the shaft by
//! more than the noise is never missed; one that touches it, up to the rounding of rotated or
//! decimal corners, is never reported.
//!
//! **Cheap where nothing blocks.** What lies in a plane that has all patches on one side blocks
//! nothing: a closed convex room is settled by comparing every corner with every plane, each once.
//! What is left is found by boxes, then by planes, then by [`Shaft`].
//!
//! **Not covered**: how much is blocked ([`Polygon::exchange_area_past`]); pairs of which nothing
//! is left (`hiding`).
//!
//! [`Polygon::exchange_area_past`]: crate::form_factor::Polygon::exchange_area_past

use super::obstacle::Obstacle;
use super::surfaces::Search;
use crate::geometry::Shaft;
use crate::scene::planes::ScenePlanes;
use crate::scene::{Scene, SceneError};
use rayon::prelude::*;
use std::ops::Range;

/// A pair of patches, and something that stands between parts of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Blocker {
    /// Index of one patch.
    pub first: usize,
    /// Index of the other.
    pub second: usize,
    /// The first surface that stands between, patches before obstructions.
    pub obstacle: Obstacle,
    /// The name of that surface.
    pub name: String,
}

/// The search for blockers among patches and obstructions, made ready.
#[derive(Debug, Clone, Copy)]
pub struct Blockers<'a> {
    scene: &'a Scene,
    planes: &'a ScenePlanes,
    /// None if nothing can block.
    surfaces: Option<Search<'a>>,
    /// Indices of the planes with patches on both sides: what lies in another one blocks nothing.
    /// None if these are not known.
    splitting: Option<&'a [usize]>,
}

/// Most splitting planes that are looked at before the trees are asked, where no row keeps how far
/// its patch reaches over each.
const MOST_COMPARED: usize = 16;

impl<'a> Blockers<'a> {
    /// Makes the search ready for many pairs.
    #[must_use]
    pub fn of(scene: &'a Scene) -> Self {
        let splitting = scene.splitting_planes();
        Self {
            surfaces: (!splitting.is_empty()).then(|| Search::Indexed(scene.outlined())),
            splitting: Some(splitting),
            ..Self::for_few(scene)
        }
    }

    /// Makes the search ready for few pairs: each looks at every surface.
    #[must_use]
    pub fn for_few(scene: &'a Scene) -> Self {
        Self {
            scene,
            planes: scene.planes(),
            surfaces: Some(Search::Scanned(scene)),
            splitting: None,
        }
    }

    /// Tells whether anything can stand between two patches: never in a room that is convex inside.
    #[must_use]
    pub const fn can_block(&self) -> bool {
        self.surfaces.is_some()
    }

    /// The first blocked pair in the order of its indices, and the first surface that blocks it;
    /// the same for any number of threads.
    #[must_use]
    pub fn first(&self) -> Option<Blocker> {
        let patches = self.scene.patches().len();
        (0..patches)
            .into_par_iter()
            .find_map_first(|first| self.first_of_row(first, first + 1..patches))
    }

    /// The first patch that one patch is blocked from, and the first surface that blocks the two.
    #[must_use]
    pub fn of_row(&self, first: usize) -> Option<Blocker> {
        self.first_of_row(first, 0..self.scene.patches().len())
    }

    /// The first surface that blocks a pair.
    #[must_use]
    pub fn of_pair(&self, first: usize, second: usize) -> Option<Blocker> {
        self.first_of_row(first, second..second + 1)
    }

    /// All surfaces that block a pair: patches, then obstructions, in the order of their indices.
    pub fn obstacles(&self, first: usize, second: usize) -> impl Iterator<Item = Obstacle> {
        let surfaces = self.surfaces_between(first, second);
        surfaces.map(|surface| self.obstacle(surface))
    }

    /// The surfaces that block a pair, in order; obstructions are numbered after the patches. Of a
    /// base and its parts, which block no more than it does, only the base is among them.
    pub(crate) fn whole_surfaces_between(
        &self,
        first: usize,
        second: usize,
    ) -> impl Iterator<Item = usize> + use<'a> {
        let (scene, patches) = (self.scene, self.scene.patches().len());
        let is_whole =
            move |surface: &usize| *surface >= patches || scene.base_of(*surface).is_none();
        self.surfaces_between(first, second).filter(is_whole)
    }

    /// The surfaces that block a pair, in order.
    fn surfaces_between(
        &self,
        first: usize,
        second: usize,
    ) -> impl Iterator<Item = usize> + use<'a> {
        let few = self
            .splitting
            .filter(|planes| planes.len() <= MOST_COMPARED);
        let reaches = few.map(|_| self.reaches(first));
        self.in_the_way(first, second, reaches.as_deref())
    }

    fn first_of_row(&self, first: usize, mut seconds: Range<usize>) -> Option<Blocker> {
        self.surfaces?;
        let reaches = self.reaches(first);
        seconds.find_map(|second| {
            let surface = self.in_the_way(first, second, Some(&reaches)).next()?;
            Some(Blocker {
                first,
                second,
                obstacle: self.obstacle(surface),
                name: self.scene.surface(surface).name().to_owned(),
            })
        })
    }

    fn obstacle(&self, surface: usize) -> Obstacle {
        match surface.checked_sub(self.scene.patches().len()) {
            None => Obstacle::Patch(surface),
            Some(obstruction) => Obstacle::Obstruction(obstruction),
        }
    }

    /// The heights of a patch over every splitting plane.
    fn reaches(&self, patch: usize) -> Vec<[f64; 2]> {
        let corners = self.planes.corners(self.scene.surface(patch));
        let range = |plane: &usize| self.planes.planes()[*plane].range(corners.clone());
        self.splitting
            .unwrap_or_default()
            .iter()
            .map(range)
            .collect()
    }

    /// The surfaces that enter the shaft between two patches, in order.
    ///
    /// **Arguments** `reaches`: the heights of the first over all splitting planes, if known.
    fn in_the_way(
        &self,
        first: usize,
        second: usize,
        reaches: Option<&[[f64; 2]]>,
    ) -> impl Iterator<Item = usize> + use<'a> {
        let surfaces = self.surfaces.filter(|_| first != second);
        let surfaces = surfaces.filter(|_| self.may_be_crossed(second, reaches));
        let near = surfaces.map_or_else(Vec::new, |all| self.candidates(all, first, second));
        let shaft = match near.is_empty() {
            true => None,
            false => surfaces.and_then(|all| self.shaft(all, first, second)),
        };
        let found = shaft.zip(surfaces).map(|(shaft, surfaces)| {
            let enters = move |surface: &usize| shaft.is_entered_by(&surfaces.outline(*surface));
            near.into_iter().filter(enters)
        });
        found.into_iter().flatten()
    }

    /// The surfaces near the shaft between two patches that see each other whose planes cross it,
    /// in order.
    fn candidates(&self, surfaces: Search<'a>, first: usize, second: usize) -> Vec<usize> {
        let noise = self.planes.noise();
        let [one, other] = [first, second].map(|patch| surfaces.outline(patch));
        // cheapest first: do they see each other at all?
        if !(one.rises_above(other.plane(), noise) && other.rises_above(one.plane(), noise)) {
            return Vec::new();
        }
        let corners = |patch| self.planes.corners(self.scene.surface(patch));
        let corners = corners(first).chain(corners(second));
        let crosses = |surface: usize| {
            let shared = &self.planes.planes()[self.planes.plane_of(surface).plane];
            shared.is_crossed_by(shared.range(corners.clone()), noise)
        };
        let mut near = surfaces.candidates_between([one.bounds(), other.bounds()]);
        // patches of one root lie in one plane and do not block each other
        let root = |surface: usize| match surface < self.scene.patches().len() {
            true => self.scene.root_of(surface),
            false => surface,
        };
        let ends = [root(first), root(second)];
        near.retain(|surface| !ends.contains(&root(*surface)) && crosses(*surface));
        near.sort_unstable();
        near
    }

    /// Whether a splitting plane lies between two patches, as far as the heights of the first over
    /// all of them are known.
    fn may_be_crossed(&self, second: usize, reaches: Option<&[[f64; 2]]>) -> bool {
        let (Some(splitting), Some(reaches)) = (self.splitting, reaches) else {
            return true;
        };
        let corners = self.planes.corners(self.scene.surface(second));
        let mut planes = splitting.iter().zip(reaches);
        planes.any(|(plane, [low, high])| {
            let shared = &self.planes.planes()[*plane];
            let [least, most] = shared.range(corners.clone());
            shared.is_crossed_by([low.min(least), high.max(most)], self.planes.noise())
        })
    }

    /// The shaft between two patches, if they see each other.
    fn shaft(&self, surfaces: Search<'a>, first: usize, second: usize) -> Option<Shaft> {
        let [one, other] = [first.min(second), first.max(second)].map(|p| surfaces.outline(p));
        Shaft::between(&one, &other, self.planes.noise())
    }
}

impl Scene {
    /// The first pair of patches that something may stand between, and what does; `None` if every
    /// pair sees each other fully, or exchanges nothing.
    ///
    /// **Accuracy** what enters the space between two patches by more than the noise of the
    /// coordinates is found, what touches it is not reported; see the module's text.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// assert_eq!(Scene::built_in("cube:4")?.blocker(), None);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    #[must_use]
    pub fn blocker(&self) -> Option<Blocker> {
        Blockers::of(self).first()
    }

    /// Refuses the scene if something may stand between two of its patches.
    ///
    /// # Errors
    /// [`SceneError::MayBeBlocked`].
    pub fn check_unblocked(&self) -> Result<(), SceneError> {
        self.refuse_blocker(Self::blocker)
    }

    /// Refuses the scene with the blocker that is found.
    pub(crate) fn refuse_blocker(
        &self,
        find: impl Fn(&Self) -> Option<Blocker>,
    ) -> Result<(), SceneError> {
        find(self).map_or(Ok(()), |found| {
            Err(SceneError::MayBeBlocked {
                first: found.first,
                second: found.second,
                obstacle: found.obstacle,
                name: found.name,
                resolution: self.mending_resolution(|scene| find(scene).is_none()),
            })
        })
    }
}
