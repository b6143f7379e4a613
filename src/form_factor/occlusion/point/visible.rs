//! The form factor of what a point sees of one cone past others.
//!
//! ```text
//!   F = (1/2π) Σ_b ℓ_b n·N_b     b: sides of the receiver, less what lies in a blocker
//!                                b: sides of blockers, what of them lies in the receiver and in no
//!                                   other blocker, with −N_b
//! ```
//!
//! A side that lies along a side of another cone is looked at from its visible side only, and
//! counts with the first of the two: sides of blockers that meet cancel by themselves.

use super::cone::{Cone, Side};
use super::crossings::{Span, side_of, span, subtended};
use crate::form_factor::ExchangeArea;
use crate::geometry::Vector;
use crate::numeric::functions::elementary::ANGLE_ERROR;
use crate::numeric::{CompensatedSum, DoubleDouble, Scalar};
use smallvec::SmallVec;
use std::f64::consts::TAU;

/// The relative error of an angle along a side.
const ALONG: f64 = ANGLE_ERROR + f64::EPSILON;

/// A length with a bound on its error.
#[derive(Debug, Clone, Copy, Default)]
struct Length {
    value: f64,
    error: f64,
}

/// The form factor of the part of a cone that lies in no other, before it is put into [0, 1].
pub(super) fn visible(
    receiver: &Cone,
    blockers: &[&Cone],
    normal: Vector<DoubleDouble>,
) -> ExchangeArea {
    let blockers: SmallVec<[&Cone; 16]> = blockers
        .iter()
        .copied()
        .filter(|blocker| !are_apart(receiver, blocker) && !are_apart(blocker, receiver))
        .collect();
    if blockers.iter().any(|blocker| covers(blocker, receiver)) {
        return ExchangeArea::NOTHING;
    }
    let mut sum = Sum::new(normal);
    for side in &receiver.sides {
        let hidden = blockers.iter().filter_map(|blocker| span(side, blocker));
        let hidden = hidden.filter(|span| span.beside[0]).collect();
        sum.add(side, 1.0, left((0.0, subtended(side)), hidden));
    }
    for (own, blocker) in blockers.iter().enumerate() {
        for side in &blocker.sides {
            let Some(within) = span(side, receiver).filter(|span| !span.is_along()) else {
                continue;
            };
            let others = blockers.iter().enumerate().filter(|(k, _)| *k != own);
            let hidden = others.filter_map(|(k, other)| {
                let span = span(side, other)?;
                (span.beside[1] || k < own).then_some(span)
            });
            let seen = left((within.start, within.end), hidden.collect());
            sum.add(side, -1.0, seen);
        }
    }
    sum.total()
}

/// Do all rays of the second cone lie outside one side of the first?
fn are_apart(cone: &Cone, other: &Cone) -> bool {
    let outside = |side: &Side| other.rays().all(|ray| side_of(ray, side).is_le());
    cone.sides.iter().any(outside)
}

/// Do all rays of the second cone lie in the first?
fn covers(cone: &Cone, other: &Cone) -> bool {
    let inside = |side: &Side| other.rays().all(|ray| side_of(ray, side).is_ge());
    cone.sides.iter().all(inside)
}

/// The rest of a part of a side that spans leave.
///
/// The length is a 1-Lipschitz function of each end that bounds a gap, or that meets another within
/// the errors of both; a gap that is no wider than these is none.
fn left((start, end): (f64, f64), mut hidden: SmallVec<[Span; 8]>) -> Length {
    hidden.sort_unstable_by(|a, b| a.start.total_cmp(&b.start));
    let mut seen = Length::default();
    let mut reached = start;
    let mut step = |reached: f64, next: f64| {
        let uncertain = ALONG * (reached + next.max(0.0));
        let gap = next - reached;
        if gap > uncertain {
            seen.value += gap;
        }
        if gap >= -uncertain {
            seen.error += uncertain + if gap > uncertain { 0.0 } else { uncertain };
        }
    };
    for span in hidden {
        if span.start >= end {
            break;
        }
        step(reached, span.start);
        reached = reached.max(span.end);
    }
    step(reached, end);
    seen
}

/// A sum of sides' terms.
struct Sum {
    normal: Vector<DoubleDouble>,
    value: CompensatedSum,
    error: f64,
}

impl Sum {
    fn new(normal: Vector<DoubleDouble>) -> Self {
        Self {
            normal,
            value: CompensatedSum::default(),
            error: 0.0,
        }
    }

    /// Adds the term of a seen part of a side.
    fn add(&mut self, side: &Side, sign: f64, seen: Length) {
        if seen.error <= 0.0 {
            return;
        }
        let [length, ..] = side.products;
        let along = side.normal.dot(self.normal);
        let cosine = (along / length).to_f64();
        self.value.add(sign * cosine * seen.value);
        // differences of angles and their sum, a quotient of 106 bits, a product
        let rounding = 4.0 * f64::EPSILON * seen.value;
        self.error += cosine.abs() * (seen.error + rounding);
    }

    fn total(&self) -> ExchangeArea {
        let value = self.value.total() / TAU;
        ExchangeArea {
            value,
            error: self.error / TAU + f64::EPSILON * value.abs(),
        }
    }
}
