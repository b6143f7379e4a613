//! Exchange areas past screens that congruent configurations share.
//!
//! ```text
//!   configuration   two rectangles and rectangular screens, all along the coordinate axes
//!   its form        the least of its images: reflected axes, exchanged axes, exchanged ends,
//!                   shifted so that the first end begins at 0
//! ```
//!
//! Two configurations with one form are congruent exactly: an axis is shifted only if no difference
//! on it is rounded. The value is computed of the form, so that it does not depend on which
//! configuration came first, and its bound holds for all of them.
//!
//! **Memory** forms of [`MOST_RECTANGLES`] rectangles together at most; others are computed and not
//! kept.
//!
//! **Not covered**: other polygons; configurations that agree up to rounding.

use crate::form_factor::{Answer, FormFactorError, Occluders, Polygon};
use crate::geometry::{FlatBox, Patch};
use crate::numeric::two_sum;
use crate::scene::{NamedPatch, Scene};
use glam::DVec3;
use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

/// Most rectangles of the forms whose values are kept, 56 bytes each.
const MOST_RECTANGLES: usize = 1 << 21;

/// Parts of the table, each with a lock of its own.
const SHARES: usize = 64;

/// The values of forms, found so far.
#[derive(Debug)]
pub(crate) struct Configurations {
    patches: Vec<Option<FlatBox>>,
    screens: Vec<Option<FlatBox>>,
    known: Vec<Mutex<Known>>,
}

/// A part of the table.
#[derive(Debug, Default)]
struct Known {
    answers: HashMap<Form, Answer>,
    /// Number of rectangles of all its forms.
    rectangles: usize,
}

/// A rectangle in words: its axis and side, then the bits of its ends.
type Words = [u64; 7];

/// A form: ends and screens, and the tolerance asked for.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Form {
    ends: [Words; 2],
    screens: Vec<Words>,
    tolerance: u64,
}

/// An image of a configuration: for each axis the one that it was, and whether it is reflected.
#[derive(Debug, Clone, Copy)]
struct Image {
    axes: [usize; 3],
    reflected: [bool; 3],
    exchanged: bool,
}

impl Configurations {
    pub(crate) fn of(scene: &Scene) -> Self {
        let flat = |surface: &NamedPatch| FlatBox::of(surface.shape());
        let screens = scene.screens();
        let screens = (0..screens.count()).map(|k| FlatBox::of(&screens.screen(k).shape));
        Self {
            patches: scene.patches().iter().map(flat).collect(),
            screens: screens.collect(),
            known: (0..SHARES).map(|_| Mutex::default()).collect(),
        }
    }

    /// The exchange area of two patches past some screens, if it can be shared.
    ///
    /// **Arguments** `touching`: as in [`Occluders`], the same for all.
    pub(crate) fn exchange(
        &self,
        patches: [usize; 2],
        screens: &[usize],
        tolerance: f64,
        touching: f64,
    ) -> Option<Result<Answer, FormFactorError>> {
        let [one, other] = patches.map(|patch| self.patches[patch].as_ref());
        let ends = [one?, other?];
        let screens: Option<Vec<FlatBox>> = screens.iter().map(|k| self.screens[*k]).collect();
        let screens = screens?;
        let form = form(ends.map(|end| *end), &screens, tolerance);
        let share = form.share();
        let lock = || {
            self.known[share]
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        let known = lock().answers.get(&form).copied();
        if let Some(answer) = known {
            return Some(Ok(answer));
        }
        let found = form.exchange(tolerance, touching)?;
        if let Ok(answer) = &found {
            let mut known = lock();
            let rectangles = known.rectangles + 2 + screens.len();
            if rectangles <= MOST_RECTANGLES / SHARES {
                known.rectangles = rectangles;
                known.answers.insert(form, *answer);
            }
        }
        Some(found)
    }
}

impl Form {
    /// The part of the table that it is in.
    fn share(&self) -> usize {
        let words = self.ends.iter().chain(&self.screens).flatten();
        let mixed = words.fold(0u64, |mixed, word| {
            (mixed ^ word)
                .wrapping_mul(0x9e37_79b9_7f4a_7c15)
                .rotate_left(29)
        });
        usize::try_from(mixed % SHARES as u64).unwrap_or(0)
    }

    /// The exchange area of the form; none if one of its rectangles is no polygon.
    fn exchange(&self, tolerance: f64, touching: f64) -> Option<Result<Answer, FormFactorError>> {
        let polygon = |words: &Words| Some(Polygon::new(&Patch::try_new(corners(words)).ok()?));
        let [one, other] = [polygon(&self.ends[0])?, polygon(&self.ends[1])?];
        let screens: Option<Vec<Polygon>> = self.screens.iter().map(polygon).collect();
        let screens = screens?;
        let polygons: Vec<&Polygon> = screens.iter().collect();
        let occluders = Occluders {
            polygons: &polygons,
            touching,
        };
        Some(one.exchange_area_past(&other, &occluders, tolerance))
    }
}

/// The form of a configuration.
fn form(ends: [FlatBox; 2], screens: &[FlatBox], tolerance: f64) -> Form {
    let may_be_shifted = [0, 1, 2].map(|axis| is_exact(axis, &ends, screens));
    let images = images(may_be_shifted);
    let of_ends = |image: &Image| {
        let [one, other] = image.ends(&ends);
        let shift = image.shift(one, may_be_shifted);
        [one, other].map(|end| image.words(end, shift, true))
    };
    let least = images.iter().map(of_ends).min().unwrap_or_default();
    // ends that look alike from several sides are told apart by their screens
    let screens = images
        .iter()
        .filter(|image| of_ends(image) == least)
        .map(|image| {
            let shift = image.shift(image.ends(&ends)[0], may_be_shifted);
            let mut words: Vec<Words> = screens
                .iter()
                .map(|s| image.words(s, shift, false))
                .collect();
            words.sort_unstable();
            words.dedup();
            words
        });
    Form {
        ends: least,
        screens: screens.min().unwrap_or_default(),
        tolerance: tolerance.to_bits(),
    }
}

/// Whether all differences to an end of the two rectangles are exact on an axis.
fn is_exact(axis: usize, ends: &[FlatBox; 2], screens: &[FlatBox]) -> bool {
    let places = |flat: &FlatBox| [flat.lower[axis], flat.upper[axis]];
    let mut origins = ends.iter().flat_map(places);
    origins.all(|origin| {
        let mut all = ends.iter().chain(screens).flat_map(places);
        all.all(|place| two_sum(place, -origin).1.abs() <= 0.0)
    })
}

/// All images; an axis that may not be shifted stays what it is.
fn images(may_be_shifted: [bool; 3]) -> Vec<Image> {
    let orders = [
        [0, 1, 2],
        [0, 2, 1],
        [1, 0, 2],
        [1, 2, 0],
        [2, 0, 1],
        [2, 1, 0],
    ];
    let mut found = Vec::with_capacity(96);
    for axes in orders {
        let stays = |axis: usize| may_be_shifted[axis] || axes[axis] == axis;
        if !(0..3).all(stays) {
            continue;
        }
        for bits in 0..8usize {
            let reflected = [0, 1, 2].map(|axis| bits >> axis & 1 == 1);
            if (0..3).any(|axis| reflected[axis] && !may_be_shifted[axes[axis]]) {
                continue;
            }
            for exchanged in [false, true] {
                found.push(Image {
                    axes,
                    reflected,
                    exchanged,
                });
            }
        }
    }
    found
}

impl Image {
    /// The ends in their order.
    const fn ends<'a>(&self, [one, other]: &'a [FlatBox; 2]) -> [&'a FlatBox; 2] {
        if self.exchanged {
            [other, one]
        } else {
            [one, other]
        }
    }

    /// The lower and the upper end of a rectangle along an axis of the image.
    fn span(&self, flat: &FlatBox, axis: usize) -> [f64; 2] {
        let own = self.axes[axis];
        if self.reflected[axis] {
            [-flat.upper[own], -flat.lower[own]]
        } else {
            [flat.lower[own], flat.upper[own]]
        }
    }

    /// The place of the first end, where axes may be shifted.
    fn shift(&self, first: &FlatBox, may_be_shifted: [bool; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| match may_be_shifted[self.axes[axis]] {
            true => self.span(first, axis)[0],
            false => 0.0,
        })
    }

    /// The words of a rectangle; one that is no end has no front.
    fn words(&self, flat: &FlatBox, shift: [f64; 3], is_end: bool) -> Words {
        let axis = (0..3)
            .find(|axis| self.axes[*axis] == flat.axis)
            .unwrap_or(0);
        let along = !is_end || flat.faces_along != self.reflected[axis];
        let mut words = [2 * axis as u64 + u64::from(along), 0, 0, 0, 0, 0, 0];
        for axis in 0..3 {
            let [low, high] = self.span(flat, axis).map(|end| end - shift[axis]);
            // −0 is 0
            words[1 + axis] = (low + 0.0).to_bits();
            words[4 + axis] = (high + 0.0).to_bits();
        }
        words
    }
}

/// The corners of a rectangle in words.
fn corners(words: &Words) -> Vec<DVec3> {
    let ends = |first: usize| [0, 1, 2].map(|axis| f64::from_bits(words[first + axis]));
    let flat = FlatBox {
        axis: usize::try_from(words[0] / 2).unwrap_or(0),
        faces_along: words[0] % 2 == 1,
        lower: ends(1),
        upper: ends(4),
    };
    flat.corners()
}
