//! What a scene needs, decided before any form factor is computed.
//!
//! ```text
//!   reciprocal   one value serves (i, j) and (j, i)
//!   untouched    planes that are the same, or of which one lies behind the other: none of their pairs is looked at
//!   congruent    pairs equal up to a motion or reflection: the first of them is computed
//! ```
//!
//! **Not covered**: congruence of polygons that are not axis-parallel rectangles.

use super::NamedPatch;
use super::facing::{FacingPlanes, Sight};
use super::lattice::Lattice;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Whether congruent pairs share a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Congruence {
    /// One of them is computed.
    #[default]
    Shared,
    /// Every pair is computed: a check, and a measure of what sharing saves.
    Ignored,
}

/// A class that no pair is in.
const NO_PAIR: u64 = u64::MAX;

/// What is left out and what is shared.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plan {
    pub(super) planes: FacingPlanes,
    lattice: Option<Lattice>,
    /// The place of each class among those that occur.
    places: Vec<u32>,
    /// The first pair of each class that occurs.
    representatives: Vec<[usize; 2]>,
}

impl Plan {
    /// The plan for polygons in these planes.
    pub(super) fn of(patches: &[NamedPatch], planes: FacingPlanes, congruence: Congruence) -> Self {
        let lattice = match congruence {
            Congruence::Shared => Lattice::of(patches),
            Congruence::Ignored => None,
        };
        let mut plan = Self {
            planes,
            lattice,
            places: Vec::new(),
            representatives: Vec::new(),
        };
        if let Some(lattice) = &plan.lattice {
            let first = plan.first_pairs(lattice, patches.len());
            let mut places = vec![u32::MAX; first.len()];
            let mut representatives = Vec::new();
            for (class, pair) in first.into_iter().enumerate() {
                if pair != NO_PAIR {
                    places[class] = u32::try_from(representatives.len()).unwrap_or(u32::MAX);
                    representatives.push([pair >> 32, pair & 0xffff_ffff].map(index));
                }
            }
            plan.places = places;
            plan.representatives = representatives;
        }
        plan
    }

    /// The first pair of each class: the same whatever the order in which threads come upon them.
    fn first_pairs(&self, lattice: &Lattice, patches: usize) -> Vec<u64> {
        let first: Vec<AtomicU64> = (0..lattice.classes())
            .map(|_| AtomicU64::new(NO_PAIR))
            .collect();
        (0..patches).into_par_iter().for_each(|one| {
            for other in one + 1..patches {
                if self.sight(one, other) != Sight::Open {
                    continue;
                }
                if let Some(class) = lattice.class(one, other) {
                    let pair = ((one as u64) << 32) | other as u64;
                    // mostly an earlier pair is known already
                    if first[class].load(Ordering::Relaxed) > pair {
                        first[class].fetch_min(pair, Ordering::Relaxed);
                    }
                }
            }
        });
        first.into_iter().map(AtomicU64::into_inner).collect()
    }

    pub(super) fn sight(&self, first: usize, second: usize) -> Sight {
        self.planes
            .sight(self.planes.of_patch(first), self.planes.of_patch(second))
    }

    /// The place of a pair's class among [`representatives`](Self::representatives).
    pub(super) fn shared(&self, first: usize, second: usize) -> Option<usize> {
        let class = self.lattice.as_ref()?.class(first, second)?;
        Some(self.places[class] as usize)
    }

    pub(super) fn representatives(&self) -> &[[usize; 2]] {
        &self.representatives
    }

    /// How far apart coordinates of congruent pairs may be.
    pub(super) fn spread(&self) -> f64 {
        self.lattice.as_ref().map_or(0.0, Lattice::spread)
    }
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "half of an u64, from an usize"
)]
const fn index(half: u64) -> usize {
    half as usize
}
