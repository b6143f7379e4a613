//! Does anything stand between two patches?
//!
//! Exchange areas are computed as if nothing were in the way. Until occlusion is, a scene in which something may be in the
//! way is refused, with the pair and the blocker named.
//!
//! ```text
//!   k blocks (i, j)  ⇔  k meets the interior of the union of all segments from i⁺ to j⁺
//!   i⁺: the part of i in front of j's plane,  j⁺: the part of j in front of i's plane
//! ```
//!
//! A pair that exchanges nothing has no i⁺ or no j⁺. Every k counts from both sides. What is decided, and what noise
//! means: [`Shaft`]; how large it is: about 64 ε of the largest coordinate, plus eight times the largest
//! deviation of a corner from its patch's plane. So a blocker that enters the shaft by more than the noise is never missed; one
//! that touches it, up to the rounding of rotated or decimal corners, is never reported.
//!
//! **Cheap where nothing blocks.** What lies in a plane that has all patches on one side blocks nothing: a closed convex
//! room is settled by comparing every corner with every plane, each once. What is left is found by boxes, then by planes,
//! then by [`Shaft`].
//!
//! **Not covered**: how much is blocked.

use super::arrangement::Arrangement;
use super::{NamedPatch, Scene, SceneError};
use crate::geometry::{Outline, Shaft};
use rayon::prelude::*;
use rstar::primitives::{GeomWithData, Rectangle as Box3};
use rstar::{AABB, RTree};
use std::fmt;

/// What stands in the way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Obstacle {
    /// The patch with this index.
    Patch(usize),
    /// The obstruction with this index.
    Obstruction(usize),
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Patch(index) => write!(f, "patch {index}"),
            Self::Obstruction(index) => write!(f, "obstruction {index}"),
        }
    }
}

/// A pair of patches, and something that stands between parts of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Blocker {
    /// Index of one patch.
    pub first: usize,
    /// Index of the other.
    pub second: usize,
    /// What stands between: the first of all that do, patches before obstructions.
    pub obstacle: Obstacle,
    /// Its name.
    pub name: String,
}

impl From<Blocker> for SceneError {
    fn from(found: Blocker) -> Self {
        Self::MayBeBlocked {
            first: found.first,
            second: found.second,
            obstacle: found.obstacle,
            name: found.name,
        }
    }
}

/// The search for blockers among patches and obstructions, made ready.
#[derive(Debug)]
pub struct Blockers<'a> {
    arrangement: Arrangement<'a>,
    /// Nothing else can block: surfaces in planes with patches on both sides.
    suspects: Vec<Outline>,
    /// Their indices among all surfaces, by their boxes.
    boxes: RTree<GeomWithData<Box3<[f64; 3]>, usize>>,
    /// The suspects' places among `suspects`, by index of the surface.
    place_of: Vec<Option<usize>>,
    /// All patches; empty if there are no suspects.
    patches: Vec<Outline>,
    /// Indices of the planes with patches on both sides.
    planes: Vec<usize>,
    /// For each patch the one that it lies in and that lies in no other. Patches of one root lie in one plane.
    roots: Vec<usize>,
}

impl<'a> Blockers<'a> {
    /// Makes the search ready, among patches none of which lies in another.
    #[must_use]
    pub fn new(patches: &'a [NamedPatch], obstructions: &'a [NamedPatch]) -> Self {
        Self::with_roots(patches, obstructions, (0..patches.len()).collect())
    }

    /// Makes the search ready: a base and what lies in it do not block each other.
    #[must_use]
    pub fn of(scene: &'a Scene) -> Self {
        let roots = (0..scene.patches().len()).map(|patch| scene.root_of(patch));
        Self::with_roots(scene.patches(), scene.obstructions(), roots.collect())
    }

    fn with_roots(
        patches: &'a [NamedPatch],
        obstructions: &'a [NamedPatch],
        roots: Vec<usize>,
    ) -> Self {
        let arrangement = Arrangement::new(patches, obstructions);
        let splits = arrangement.splits();
        let suspected: Vec<usize> = (0..arrangement.surfaces.len())
            .filter(|surface| splits[arrangement.places[*surface].0])
            .collect();
        let outline = |surface: usize| arrangement.outline(surface);
        let suspects: Vec<Outline> = suspected.par_iter().map(|s| outline(*s)).collect();
        let boxed = suspected.iter().zip(&suspects).map(|(surface, outline)| {
            let [low, high] = outline.bounds().map(|corner| corner.to_array());
            GeomWithData::new(Box3::from_corners(low, high), *surface)
        });
        let boxes = RTree::bulk_load(boxed.collect());
        let mut place_of = vec![None; arrangement.surfaces.len()];
        for (place, surface) in suspected.iter().enumerate() {
            place_of[*surface] = Some(place);
        }
        let patches = if suspects.is_empty() {
            Vec::new()
        } else {
            (0..patches.len()).into_par_iter().map(outline).collect()
        };
        let planes = (0..splits.len()).filter(|plane| splits[*plane]).collect();
        Self {
            arrangement,
            suspects,
            boxes,
            place_of,
            patches,
            planes,
            roots,
        }
    }

    /// The first blocked pair in the order of its indices, and what blocks it first; the same for any number of threads.
    #[must_use]
    pub fn first(&self) -> Option<Blocker> {
        (0..self.patches.len())
            .into_par_iter()
            .find_map_first(|first| self.between(first, first + 1..self.patches.len()))
    }

    /// The first patch that one patch is blocked from, and what blocks the two first.
    #[must_use]
    pub fn of_row(&self, first: usize) -> Option<Blocker> {
        self.between(first, 0..self.patches.len())
    }

    /// What blocks a pair first.
    #[must_use]
    pub fn of_pair(&self, first: usize, second: usize) -> Option<Blocker> {
        self.between(first, second..second + 1)
    }

    fn between(&self, first: usize, seconds: std::ops::Range<usize>) -> Option<Blocker> {
        if self.suspects.is_empty() {
            return None;
        }
        let reaches = self.reaches(first);
        seconds
            .filter(|second| *second != first)
            .find_map(|second| {
                let surface = self.obstacle(first, second, &reaches)?;
                let patches = self.arrangement.patches;
                Some(Blocker {
                    first,
                    second,
                    obstacle: if surface < patches {
                        Obstacle::Patch(surface)
                    } else {
                        Obstacle::Obstruction(surface - patches)
                    },
                    name: self.arrangement.surfaces[surface].name.clone(),
                })
            })
    }

    /// The heights of a patch over every splitting plane.
    fn reaches(&self, patch: usize) -> Vec<[f64; 2]> {
        let range =
            |plane: &usize| self.arrangement.planes[*plane].range(self.arrangement.corners(patch));
        self.planes.iter().map(range).collect()
    }

    /// The first surface that blocks a pair.
    fn obstacle(&self, first: usize, second: usize, reaches: &[[f64; 2]]) -> Option<usize> {
        let (one, other) = (
            &self.patches[first.min(second)],
            &self.patches[first.max(second)],
        );
        let noise = self.arrangement.noise;
        // cheapest first: do they see each other, and is anything's plane between them at all?
        let rises = one.rises_above(other.plane(), noise) && other.rises_above(one.plane(), noise);
        let crossed = || {
            self.planes.iter().zip(reaches).any(|(plane, [low, high])| {
                let shared = &self.arrangement.planes[*plane];
                let [least, most] = shared.range(self.arrangement.corners(second));
                shared.is_crossed_by([low.min(least), high.max(most)], noise)
            })
        };
        if !rises || !crossed() {
            return None;
        }
        let shaft = Shaft::between(one, other, noise)?;
        let [low, high] = shaft.bounds().map(|corner| corner.to_array());
        let near = self
            .boxes
            .locate_in_envelope_intersecting(AABB::from_corners(low, high));
        let root = |surface: usize| self.roots.get(surface);
        let ends = [first, second].map(root);
        let mut near: Vec<usize> = near
            .map(|boxed| boxed.data)
            .filter(|surface| !ends.contains(&root(*surface)))
            .collect();
        near.sort_unstable();
        near.into_iter().find(|surface| {
            let place = self.place_of[*surface];
            place.is_some_and(|place| shaft.is_entered_by(&self.suspects[place]))
        })
    }
}

impl Scene {
    /// The first pair of patches that something may stand between, and what does; `None` if every pair sees each other
    /// fully, or exchanges nothing.
    ///
    /// **Accuracy** what enters the space between two patches by more than the noise of the coordinates is found, what
    /// touches it is not reported; see the module's text.
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
        self.blocker().map_or(Ok(()), |found| Err(found.into()))
    }
}
