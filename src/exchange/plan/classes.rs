//! The classes of congruent pairs that occur, found on all threads.

use super::congruence::Lattice;
use super::facing::{Facing, FacingPlanes};
use rayon::prelude::*;
use std::num::NonZeroU32;
use std::sync::atomic::{AtomicU64, Ordering};

/// The classes of congruent pairs that occur among some polygons.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Classes {
    pub(crate) lattice: Lattice,
    /// The number of each class that occurs, from 1, among the representatives.
    numbers: Vec<Option<NonZeroU32>>,
    /// The first pair of each class that occurs, by its places among the polygons.
    pub(crate) representatives: Vec<[usize; 2]>,
}

impl Classes {
    /// The classes of those pairs whose planes face each other: the same whatever the order in
    /// which threads come upon them.
    pub(crate) fn of(lattice: Lattice, facings: &FacingPlanes, polygons: &[usize]) -> Self {
        let first: Vec<FirstPair> = (0..lattice.classes()).map(|_| FirstPair::none()).collect();
        (0..polygons.len()).into_par_iter().for_each(|one| {
            for other in one + 1..polygons.len() {
                if facings.facing_of([polygons[one], polygons[other]]) != Facing::Visible {
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
    pub(crate) fn place(&self, first: usize, second: usize) -> Option<usize> {
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
