//! A scene's plan, made before any form factor is computed.
//!
//! ```text
//!   reciprocal   one value serves (i, j) and (j, i)
//!   untouched    planes that are the same, or of which one lies behind the other: their pairs are
//!                left out
//!   congruent    pairs equal up to a motion or reflection: the first of them is computed
//! ```
//!
//! Open `facing` for the planes that see each other, `congruence` for the classes of congruent
//! pairs (over `line_differences`), `perturbation` for the bound on the difference between
//! congruent pairs, `base_offsets` for parts that lie slightly off their base's plane, and `counts`
//! for the summary of plan and pass.
//!
//! **Not covered**: congruence of polygons that are not axis-parallel rectangles.

pub(crate) mod base_offsets;
pub(crate) mod congruence;
pub(crate) mod counts;
pub(crate) mod facing;
pub(crate) mod line_differences;
pub(crate) mod perturbation;

use crate::scene::NamedPatch;
use congruence::Lattice;
use facing::{Facing, FacingPlanes};
use rayon::prelude::*;
use std::num::NonZeroU32;
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

/// The pairs that are left out, and those that share values.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Plan {
    facings: FacingPlanes,
    classes: Option<Classes>,
}

impl Plan {
    /// The plan for polygons in these planes.
    pub(crate) fn of(
        patches: &[NamedPatch],
        facings: FacingPlanes,
        congruence: Congruence,
    ) -> Self {
        let lattice = match congruence {
            Congruence::Shared => Lattice::of(patches),
            Congruence::Ignored => None,
        };
        let classes = lattice.map(|lattice| Classes::of(lattice, &facings, patches.len()));
        Self { facings, classes }
    }

    /// The planes, and which of them face each other.
    pub(crate) const fn facings(&self) -> &FacingPlanes {
        &self.facings
    }

    /// Whether two polygons can exchange anything.
    pub(crate) fn facing(&self, first: usize, second: usize) -> Facing {
        facing(&self.facings, first, second)
    }

    /// The place of a pair's class among [`representatives`](Self::representatives).
    pub(crate) fn shared(&self, first: usize, second: usize) -> Option<usize> {
        self.classes.as_ref()?.place(first, second)
    }

    /// The first pair of each class.
    pub(crate) fn representatives(&self) -> &[[usize; 2]] {
        let classes = self.classes.as_ref();
        classes.map_or(&[], |classes| &classes.representatives)
    }

    /// The distance by which coordinates of congruent pairs may differ.
    pub(crate) fn spread(&self) -> f64 {
        let classes = self.classes.as_ref();
        classes.map_or(0.0, |classes| classes.lattice.spread())
    }
}

fn facing(facings: &FacingPlanes, first: usize, second: usize) -> Facing {
    facings.facing(facings.of_patch(first), facings.of_patch(second))
}

/// The classes of congruent pairs that occur.
#[derive(Debug, Clone, PartialEq)]
struct Classes {
    lattice: Lattice,
    /// The number of each class that occurs, from 1, among the representatives.
    numbers: Vec<Option<NonZeroU32>>,
    /// The first pair of each class that occurs.
    representatives: Vec<[usize; 2]>,
}

impl Classes {
    /// The classes of those pairs whose planes face each other: the same whatever the order in
    /// which threads come upon them.
    fn of(lattice: Lattice, facings: &FacingPlanes, patches: usize) -> Self {
        let first: Vec<FirstPair> = (0..lattice.classes()).map(|_| FirstPair::none()).collect();
        (0..patches).into_par_iter().for_each(|one| {
            for other in one + 1..patches {
                if facing(facings, one, other) != Facing::Visible {
                    continue;
                }
                if let Some(class) = lattice.class(one, other) {
                    first[class].offer([one, other]);
                }
            }
        });
        let mut representatives = Vec::new();
        let numbers = first.into_iter().map(|first| {
            representatives.push(first.pair()?);
            u32::try_from(representatives.len())
                .ok()
                .and_then(NonZeroU32::new)
        });
        Self {
            numbers: numbers.collect(),
            lattice,
            representatives,
        }
    }

    /// The place of a pair's class among the representatives.
    fn place(&self, first: usize, second: usize) -> Option<usize> {
        let number = self.numbers[self.lattice.class(first, second)?]?;
        Some(number.get() as usize - 1)
    }
}

/// The first of the pairs of a class that threads have come upon, `one · 2³² + other`.
struct FirstPair(AtomicU64);

impl FirstPair {
    const fn none() -> Self {
        Self(AtomicU64::new(u64::MAX))
    }

    fn offer(&self, [one, other]: [usize; 2]) {
        let pair = ((one as u64) << 32) | other as u64;
        // mostly an earlier pair is known already
        if self.0.load(Ordering::Relaxed) > pair {
            self.0.fetch_min(pair, Ordering::Relaxed);
        }
    }

    fn pair(self) -> Option<[usize; 2]> {
        let pair = self.0.into_inner();
        (pair != u64::MAX).then_some([(pair >> 32) as usize, (pair & 0xffff_ffff) as usize])
    }
}
