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
//! pairs (over `line_differences`), `turned` for those along turned axes, which `frames` finds,
//! `perturbation` and `model_offset` for the bounds on the difference
//! between congruent pairs, `base_offsets` for parts that lie slightly off their base's plane, and `counts`
//! for the summary of plan and pass.
//!
//! **Not covered**: congruence of polygons that are not rectangles.

pub(crate) mod base_offsets;
pub(crate) mod congruence;
pub(crate) mod counts;
pub(crate) mod facing;
mod frames;
pub(crate) mod line_differences;
pub(crate) mod model_offset;
pub(crate) mod perturbation;
mod turned;

use crate::geometry::FlatBox;
use crate::scene::NamedPatch;
use congruence::Lattice;
use facing::{Facing, FacingPlanes};
use rayon::prelude::*;
use std::num::NonZeroU32;
use std::sync::atomic::{AtomicU64, Ordering};
use turned::TurnedFrame;

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
    straight: Option<Classes>,
    turned: Option<TurnedClasses>,
}

/// The pair that a class takes its value from.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Representative {
    /// The first pair of the class.
    pub(crate) pair: [usize; 2],
    /// The models of the pair along the axes of their frame, if it is turned.
    pub(crate) models: Option<[FlatBox; 2]>,
    /// The distance by which coordinates of congruent pairs may differ, or corners be off those of
    /// the models.
    pub(crate) spread: f64,
}

impl Plan {
    /// The plan for polygons in these planes.
    pub(crate) fn of(
        patches: &[NamedPatch],
        facings: FacingPlanes,
        congruence: Congruence,
    ) -> Self {
        let (straight, turned) = match congruence {
            Congruence::Shared => {
                let all: Vec<usize> = (0..patches.len()).collect();
                let lattice = Lattice::of(patches);
                let straight = lattice.map(|lattice| Classes::of(lattice, &facings, &all));
                (straight, TurnedClasses::of(patches, &facings))
            }
            Congruence::Ignored => (None, None),
        };
        Self {
            facings,
            straight,
            turned,
        }
    }

    /// The planes, and which of them face each other.
    pub(crate) const fn facings(&self) -> &FacingPlanes {
        &self.facings
    }

    /// Whether two polygons can exchange anything.
    pub(crate) fn facing(&self, first: usize, second: usize) -> Facing {
        facing(&self.facings, first, second)
    }

    /// Number of classes of congruent pairs that occur.
    pub(crate) fn classes(&self) -> usize {
        let turned = self.turned.as_ref();
        self.straight_count() + turned.map_or(0, |turned| turned.count)
    }

    fn straight_count(&self) -> usize {
        let straight = self.straight.as_ref();
        straight.map_or(0, |classes| classes.representatives.len())
    }

    /// The place of a pair's class among all of them.
    #[inline]
    pub(crate) fn shared(&self, first: usize, second: usize) -> Option<usize> {
        let straight = self.straight.as_ref();
        let place = straight.and_then(|classes| classes.place(first, second));
        match (place, &self.turned) {
            (None, Some(turned)) => Some(self.straight_count() + turned.place(first, second)?),
            _ => place,
        }
    }

    /// What a class takes its value from; none if there is no such class, or no value.
    pub(crate) fn representative(&self, class: usize) -> Option<Representative> {
        if let Some(classes) = &self.straight
            && let Some(pair) = classes.representatives.get(class)
        {
            return Some(Representative {
                pair: *pair,
                models: None,
                spread: classes.lattice.spread(),
            });
        }
        let place = class.checked_sub(self.straight_count())?;
        self.turned.as_ref()?.representative(place)
    }
}

fn facing(facings: &FacingPlanes, first: usize, second: usize) -> Facing {
    facings.facing(facings.of_patch(first), facings.of_patch(second))
}

/// The classes of congruent pairs that occur among some polygons.
#[derive(Debug, Clone, PartialEq)]
struct Classes {
    lattice: Lattice,
    /// The number of each class that occurs, from 1, among the representatives.
    numbers: Vec<Option<NonZeroU32>>,
    /// The first pair of each class that occurs, by its places among the polygons.
    representatives: Vec<[usize; 2]>,
}

impl Classes {
    /// The classes of those pairs whose planes face each other: the same whatever the order in
    /// which threads come upon them.
    fn of(lattice: Lattice, facings: &FacingPlanes, polygons: &[usize]) -> Self {
        let first: Vec<FirstPair> = (0..lattice.classes()).map(|_| FirstPair::none()).collect();
        (0..polygons.len()).into_par_iter().for_each(|one| {
            for other in one + 1..polygons.len() {
                if facing(facings, polygons[one], polygons[other]) != Facing::Visible {
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

/// The classes of congruent pairs in turned frames.
#[derive(Debug, Clone, PartialEq)]
struct TurnedClasses {
    frames: Vec<(TurnedFrame, Classes)>,
    /// The number of classes before those of each frame.
    starts: Vec<usize>,
    /// Number of classes of all frames.
    count: usize,
    /// The frame of each polygon, and its place there.
    places: Vec<Option<[u32; 2]>>,
}

impl TurnedClasses {
    /// The classes of all frames; none without frames.
    fn of(patches: &[NamedPatch], facings: &FacingPlanes) -> Option<Self> {
        let mut places = vec![None; patches.len()];
        let (mut frames, mut starts, mut count) = (Vec::new(), Vec::new(), 0);
        for (frame, lattice) in TurnedFrame::all_of(patches) {
            let number = u32::try_from(frames.len()).ok()?;
            for (place, polygon) in (0u32..).zip(&frame.members) {
                places[*polygon] = Some([number, place]);
            }
            let classes = Classes::of(lattice, facings, &frame.members);
            starts.push(count);
            count += classes.representatives.len();
            frames.push((frame, classes));
        }
        (count > 0).then_some(Self {
            frames,
            starts,
            count,
            places,
        })
    }

    /// The place of a pair's class among those of all frames.
    fn place(&self, first: usize, second: usize) -> Option<usize> {
        let [[frame, one], [other_frame, other]] = [self.places[first]?, self.places[second]?];
        if frame != other_frame {
            return None;
        }
        let frame = frame as usize;
        let place = self.frames[frame].1.place(one as usize, other as usize)?;
        Some(self.starts[frame] + place)
    }

    fn representative(&self, class: usize) -> Option<Representative> {
        let frame = self.starts.partition_point(|start| *start <= class) - 1;
        let (turned, classes) = self.frames.get(frame)?;
        let places = *classes.representatives.get(class - self.starts[frame])?;
        Some(Representative {
            pair: places.map(|place| turned.members[place]),
            models: Some(places.map(|place| turned.models[place])),
            spread: turned.offset + classes.lattice.spread(),
        })
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
