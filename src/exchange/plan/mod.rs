//! A scene's plan, made before any form factor is computed.
//!
//! ```text
//!   reciprocal   one value serves (i, j) and (j, i)
//!   untouched    planes that are the same, or of which one lies behind the other: their pairs are
//!                left out
//!   congruent    pairs equal up to a motion or reflection: the first of them is computed
//! ```
//!
//! Open `facing` for the planes that see each other, `congruence` for the congruent pairs of
//! axis-parallel rectangles (over `line_differences`), `turned` for those of rectangles along
//! turned axes, which `frames` finds, `images` for those of any polygons that are translates or
//! mirror images, `classes` and `image_classes` for the classes of congruent pairs that occur,
//! `perturbation` and `model_offset` for the bounds on the difference between congruent pairs,
//! `base_offsets` for parts that lie slightly off their base's plane, and `counts` for the summary
//! of plan and pass.
//!
//! **Not covered**: pairs that are congruent by a rotation alone, other than one that exchanges the
//! axes of a frame.

pub(crate) mod base_offsets;
mod classes;
pub(crate) mod congruence;
pub(crate) mod counts;
pub(crate) mod facing;
mod frames;
mod image_classes;
mod images;
pub(crate) mod line_differences;
mod lines;
pub(crate) mod model_offset;
pub(crate) mod perturbation;
mod poses;
mod symmetry;
mod turned;

use crate::geometry::FlatBox;
use crate::scene::NamedPatch;
use classes::Classes;
use congruence::Lattice;
use facing::{Facing, FacingPlanes};
use frames::FEWEST_POLYGONS;
use glam::DVec3;
use image_classes::ImageClasses;
use turned::TurnedClasses;

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
    images: Option<ImageClasses>,
}

/// The pair that a class takes its value from.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Representative {
    /// The first pair of the class.
    pub(crate) pair: [usize; 2],
    /// The pair that the value is computed of.
    pub(crate) source: Source,
    /// The distance by which coordinates of congruent pairs may differ, or corners be off those of
    /// the models.
    pub(crate) spread: f64,
}

/// The pair that the value of a class is computed of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Source {
    /// The pair itself, along the coordinate axes.
    Straight,
    /// The models of the pair along the axes of a turned frame.
    Boxes([FlatBox; 2]),
    /// The pair itself, whose corners in a frame are these.
    Image([Vec<DVec3>; 2]),
}

impl Plan {
    /// The plan for polygons in these planes.
    pub(crate) fn of(
        patches: &[NamedPatch],
        facings: FacingPlanes,
        congruence: Congruence,
    ) -> Self {
        let mut plan = Self {
            facings,
            straight: None,
            turned: None,
            images: None,
        };
        if congruence == Congruence::Shared {
            let all: Vec<usize> = (0..patches.len()).collect();
            let lattice = Lattice::of(patches);
            plan.straight = lattice.map(|lattice| Classes::of(lattice, &plan.facings, &all));
            plan.turned = TurnedClasses::of(patches, &plan.facings);
            let turned = plan.turned.as_ref();
            let is_covered = |polygon: &usize| turned.is_some_and(|turned| turned.has(*polygon));
            let is_straight = |polygon: &usize| FlatBox::of(patches[*polygon].shape()).is_some();
            let others = all
                .into_iter()
                .filter(|k| !is_covered(k) && !is_straight(k));
            let others: Vec<usize> = others.collect();
            if others.len() >= FEWEST_POLYGONS {
                plan.images = ImageClasses::of(patches, &others, |one, other| {
                    plan.facing(one, other) == Facing::Visible && plan.shared(one, other).is_none()
                });
            }
        }
        plan
    }

    /// The planes, and which of them face each other.
    pub(crate) const fn facings(&self) -> &FacingPlanes {
        &self.facings
    }

    /// Whether two polygons can exchange anything.
    pub(crate) fn facing(&self, first: usize, second: usize) -> Facing {
        self.facings.facing_of([first, second])
    }

    /// Number of classes of congruent pairs that occur.
    pub(crate) fn classes(&self) -> usize {
        let images = self.images.as_ref();
        self.turned_end() + images.map_or(0, |images| images.representatives.len())
    }

    fn straight_count(&self) -> usize {
        let straight = self.straight.as_ref();
        straight.map_or(0, |classes| classes.representatives.len())
    }

    /// Number of straight and turned classes.
    fn turned_end(&self) -> usize {
        let turned = self.turned.as_ref();
        self.straight_count() + turned.map_or(0, |turned| turned.count)
    }

    /// The place of a pair's class among all of them.
    #[inline]
    pub(crate) fn shared(&self, first: usize, second: usize) -> Option<usize> {
        let straight = self.straight.as_ref();
        let place = straight.and_then(|classes| classes.place(first, second));
        if place.is_some() || (self.turned.is_none() && self.images.is_none()) {
            return place;
        }
        let turned = self.turned.as_ref();
        if let Some(place) = turned.and_then(|turned| turned.place(first, second)) {
            return Some(self.straight_count() + place);
        }
        let place = self.images.as_ref()?.place(first, second)?;
        Some(self.turned_end() + place)
    }

    /// The source of a class's value; none if there is no such class, or no value.
    pub(crate) fn representative(&self, class: usize) -> Option<Representative> {
        if let Some(classes) = &self.straight
            && let Some(pair) = classes.representatives.get(class)
        {
            return Some(Representative {
                pair: *pair,
                source: Source::Straight,
                spread: classes.lattice.spread(),
            });
        }
        match class.checked_sub(self.turned_end()) {
            Some(place) => self.images.as_ref()?.representative(place),
            None => {
                let place = class.checked_sub(self.straight_count())?;
                self.turned.as_ref()?.representative(place)
            }
        }
    }
}
