//! The bound on what the rounding of sides' upper ends changes.

use super::second::{Second, other};
use crate::geometry::Span;
use crate::numeric::two_sum;
use std::f64::consts::PI;

/// A bound on the change of the exchange area by the rounding of upper ends, in units of the
/// frame.
///
/// ```text
///   an end that is off by δ adds or takes a strip of width δ, which exchanges with the other
///   rectangle, of area A at a distance r, at most  strip · min(1, A/(π r²))
/// ```
#[inline]
pub(super) fn rounding_of_ends(first: &[Span; 2], second: &Second<f64>) -> f64 {
    let [x, y] = first;
    let (sides, square) = match second {
        Second::Dark => return 0.0,
        Second::Parallel { spans, distance } => {
            let gaps = [gap(x, &spans[0]), gap(y, &spans[1]), *distance];
            ([&spans[0], &spans[1]], square_of(gaps))
        }
        Second::Perpendicular {
            across,
            plane,
            plate,
            ..
        } => {
            let beside = gap(&first[other(*across) as usize], plate.width());
            let along = &first[*across as usize];
            let depth = (along.lower() - plane).max(plane - along.upper());
            let gaps = [beside, depth.max(0.0), plate.depth().lower().max(0.0)];
            ([plate.width(), plate.depth()], square_of(gaps))
        }
    };
    let strip = |[one, two]: [&Span; 2]| off(one) * two.length() + off(two) * one.length();
    let displaced = [x, y, sides[0], sides[1]].map(off).iter().sum::<f64>();
    let distance = (square.sqrt() - displaced).max(0.0);
    let seen = |[one, two]: [&Span; 2]| {
        let share = one.length() * two.length() / (PI * distance * distance);
        // at distance 0 it is infinite or not a number
        if share < 1.0 { share } else { 1.0 }
    };
    // twice for the rounding of these lines
    2.0 * (strip([x, y]) * seen(sides) + strip(sides) * seen([x, y]))
}

/// The distance by which an upper end is off its lower end and length.
fn off(span: &Span) -> f64 {
    let (sum, lost) = two_sum(*span.lower(), *span.length());
    ((sum - span.upper()) + lost).abs()
}

/// The distance between two spans of one axis; 0 where they overlap.
fn gap(one: &Span, other: &Span) -> f64 {
    (one.lower() - other.upper())
        .max(other.lower() - one.upper())
        .max(0.0)
}

fn square_of(gaps: [f64; 3]) -> f64 {
    gaps.iter().map(|gap| gap * gap).sum()
}
