//! The search for surfaces that stand between two patches.
//!
//! Exchange areas are computed as if nothing were in the way. Until occlusion is, a scene in which
//! something may be in the way is refused, with the pair and the blocker named.
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
//! **Not covered**: how much is blocked.

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
#[derive(Debug)]
pub struct Blockers<'a> {
    scene: &'a Scene,
    planes: &'a ScenePlanes,
    /// None if nothing can block.
    surfaces: Option<Search<'a>>,
    /// Indices of the planes with patches on both sides: what lies in another one blocks nothing.
    /// None if these are not known.
    splitting: Option<Vec<usize>>,
    /// The outermost patch that each patch lies in: its root. Patches of one root lie in
    /// one plane and do not block each other.
    roots: Vec<usize>,
}

impl<'a> Blockers<'a> {
    /// Makes the search ready for many pairs.
    #[must_use]
    pub fn of(scene: &'a Scene) -> Self {
        let splits = scene.splits();
        let splitting: Vec<usize> = (0..splits.len()).filter(|plane| splits[*plane]).collect();
        Self {
            surfaces: (!splitting.is_empty()).then(|| Search::Indexed(scene.outlined())),
            splitting: Some(splitting),
            ..Self::for_few(scene)
        }
    }

    /// Makes the search ready for few pairs: each looks at every surface.
    #[must_use]
    pub fn for_few(scene: &'a Scene) -> Self {
        let roots = (0..scene.patches().len()).map(|patch| scene.root_of(patch));
        Self {
            scene,
            planes: scene.planes(),
            surfaces: Some(Search::Scanned(scene)),
            splitting: None,
            roots: roots.collect(),
        }
    }

    /// The first blocked pair in the order of its indices, and the first surface that blocks it;
    /// the same for any number of threads.
    #[must_use]
    pub fn first(&self) -> Option<Blocker> {
        let patches = self.roots.len();
        (0..patches)
            .into_par_iter()
            .find_map_first(|first| self.first_of_row(first, first + 1..patches))
    }

    /// The first patch that one patch is blocked from, and the first surface that blocks the two.
    #[must_use]
    pub fn of_row(&self, first: usize) -> Option<Blocker> {
        self.first_of_row(first, 0..self.roots.len())
    }

    /// The first surface that blocks a pair.
    #[must_use]
    pub fn of_pair(&self, first: usize, second: usize) -> Option<Blocker> {
        self.first_of_row(first, second..second + 1)
    }

    /// All surfaces that block a pair: patches, then obstructions, in the order of their indices.
    pub fn obstacles(&self, first: usize, second: usize) -> impl Iterator<Item = Obstacle> {
        let reaches = self.reaches(first);
        let surfaces = self.in_the_way(first, second, &reaches);
        surfaces.map(|surface| self.obstacle(surface))
    }

    fn first_of_row(&self, first: usize, mut seconds: Range<usize>) -> Option<Blocker> {
        self.surfaces?;
        let reaches = self.reaches(first);
        seconds.find_map(|second| {
            let surface = self.in_the_way(first, second, &reaches).next()?;
            Some(Blocker {
                first,
                second,
                obstacle: self.obstacle(surface),
                name: self.scene.surface(surface).name().to_owned(),
            })
        })
    }

    fn obstacle(&self, surface: usize) -> Obstacle {
        match surface.checked_sub(self.roots.len()) {
            None => Obstacle::Patch(surface),
            Some(obstruction) => Obstacle::Obstruction(obstruction),
        }
    }

    /// The heights of a patch over every splitting plane.
    fn reaches(&self, patch: usize) -> Vec<[f64; 2]> {
        let corners = self.planes.corners(self.scene.surface(patch));
        let range = |plane: &usize| self.planes.planes()[*plane].range(corners.clone());
        self.splitting.iter().flatten().map(range).collect()
    }

    /// The surfaces that enter the shaft between two patches, in order.
    fn in_the_way<'s>(
        &'s self,
        first: usize,
        second: usize,
        reaches: &[[f64; 2]],
    ) -> impl Iterator<Item = usize> + use<'s, 'a> {
        let shaft = self.shaft(first, second, reaches);
        let found = shaft.zip(self.surfaces).map(|(shaft, surfaces)| {
            let root = |surface: usize| self.roots.get(surface);
            let ends = [first, second].map(root);
            let corners = |patch| self.planes.corners(self.scene.surface(patch));
            let corners = corners(first).chain(corners(second));
            let mut near = surfaces.candidates_near(shaft.bounds(), corners);
            near.retain(|surface| !ends.contains(&root(*surface)));
            near.sort_unstable();
            let enters = move |surface: &usize| shaft.is_entered_by(&surfaces.outline(*surface));
            near.into_iter().filter(enters)
        });
        found.into_iter().flatten()
    }

    /// The shaft between two patches that see each other, if a plane of candidates is between them.
    fn shaft(&self, first: usize, second: usize, reaches: &[[f64; 2]]) -> Option<Shaft> {
        let surfaces = self.surfaces.filter(|_| first != second)?;
        let [one, other] = [first.min(second), first.max(second)].map(|p| surfaces.outline(p));
        let (one, other) = (&*one, &*other);
        // cheapest first: do they see each other, is a plane of candidates between them at all?
        let noise = self.planes.noise();
        let rises = one.rises_above(other.plane(), noise) && other.rises_above(one.plane(), noise);
        let crossed = || {
            let corners = self.planes.corners(self.scene.surface(second));
            let Some(splitting) = &self.splitting else {
                return true;
            };
            let mut planes = splitting.iter().zip(reaches);
            planes.any(|(plane, [low, high])| {
                let shared = &self.planes.planes()[*plane];
                let [least, most] = shared.range(corners.clone());
                shared.is_crossed_by([low.min(least), high.max(most)], noise)
            })
        };
        if rises && crossed() {
            Shaft::between(one, other, noise)
        } else {
            None
        }
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
