//! Gauss rules along an edge for the [potential](super::potential) of another one.
//!
//! Skew edges near to each other are cut into panels, graded towards the other one, until a [Gauss rule](gauss_error) is
//! certain on each.
//!
//! Edges that run beside each other need fewer panels than their distance suggests: as a function of a complex t along the
//! outer line, the potential of the inner edge is singular only at its ends (r = 0 there), and where the distance of the
//! lines' points h² = miss² + sin²θ (t − t*)² vanishes, `t* ± i miss/sin θ`. On an ellipse inside all of them its terms are bounded
//! by 60 times the largest distance, in units of it.

#![allow(
    clippy::inline_always,
    reason = "the machine code is made where it is called"
)]

use super::edge::Edge;
use crate::numeric::elementary::ln;
use crate::numeric::{MOST_POINTS, Scalar};
use smallvec::SmallVec;

/// A bound on the error of a Gauss rule with `points` on an edge, per half its length and per length of the other edge, if
/// no point of the other one is nearer to it than the ellipse `ρ`: half the logarithm of r² has the Chebyshev
/// coefficients `ρ^(−k)/k` of its two singular points, the rule is exact below `2n` and within 2.05 beyond.
#[allow(clippy::cast_precision_loss, reason = "some points")]
pub(super) fn gauss_error(points: usize, rho: f64) -> f64 {
    let n = points as f64;
    2.05 / n * rho.powi(-2 * i32::try_from(points).unwrap_or(i32::MAX)) / (1.0 - rho.powi(-2))
}

/// The ellipse through a point whose distances from the ends of an edge are `sum` edge lengths together.
pub(super) fn ellipse(sum: f64) -> f64 {
    sum + (sum * sum - 1.0).max(0.0).sqrt()
}

/// The number of points for which [`gauss_error`] is below `error`.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "small"
)]
pub(super) fn points_for(error: f64, rho: f64) -> usize {
    let points = (-ln(error) / (2.0 * ln(rho))).clamp(1.0, 200.0) as usize + 1;
    if points > 2 && gauss_error(points - 1, rho) <= error {
        points - 1
    } else {
        points
    }
}

/// A piece of an edge, relative to it, with a rule that is certain there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Panel<S> {
    pub middle: S,
    pub half: f64,
    pub points: usize,
    /// The truncation error, per length of both edges.
    pub error: f64,
}

/// Panels of `outer`, graded towards `inner`; `None` if there are too many. `wanted` is per length of both edges.
#[inline(always)]
pub(super) fn panels<S: Scalar + Copy>(
    outer: &Edge<S>,
    inner: &Edge<S>,
    wanted: f64,
    epsilon: f64,
) -> Option<SmallVec<[Panel<S>; 16]>> {
    const MOST_PANELS: usize = 600;
    /// All points of the other edge are outside the ellipse with this sum of half-axes.
    const SUM: f64 = 1.7;
    let length = outer.length.to_f64();
    let (along, aside, unsure) = pinch(outer, inner, epsilon);
    let number = |x: f64| outer.length.constant(x);
    let mut open: SmallVec<[(S, S); 64]> = SmallVec::new();
    open.push((number(0.0), number(1.0)));
    let mut panels = SmallVec::new();
    while let Some((from, to)) = open.pop() {
        let middle = (from + to) * number(0.5);
        let half = 0.5 * (to - from).to_f64();
        // short panels may have a larger share of what is wanted than their length is of the whole
        let share = wanted / half.max(1e-3).sqrt();
        let sum = inner.distance(outer.at(middle)) / (half * length);
        if sum >= SUM {
            let rho = ellipse(sum);
            let points = points_for(share, rho).min(MOST_POINTS);
            let error = gauss_error(points, rho) * half;
            panels.push(Panel {
                middle,
                half,
                points,
                error,
            });
            continue;
        }
        // beside the other edge, but apart from what is singular
        let (mut to_ends, mut to_pinch) = ([0.0; 2], -2.0 * unsure);
        for t in [from, to] {
            let x = outer.at(t);
            for (sum, end) in to_ends.iter_mut().zip(inner.ends) {
                *sum += end.minus(x).length().to_f64();
            }
            let from_pinch = (along - t * outer.length).to_f64();
            to_pinch += (from_pinch * from_pinch + aside * aside).sqrt();
        }
        let sum = to_ends[0].min(to_ends[1]).min(to_pinch) / (2.0 * half * length);
        if sum >= SUM {
            let rho = 1.0 + 0.85 * (ellipse(sum) - 1.0);
            let reach =
                (to_ends[0].max(to_ends[1]) + 2.0 * inner.length.to_f64()) / inner.length.to_f64();
            let largest = 64.0 / 15.0 * 60.0 * reach / (1.0 - rho.powi(-2));
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "small"
            )]
            let points = (ln(largest / share) / (2.0 * ln(rho)))
                .ceil()
                .clamp(2.0, MOST_POINTS as f64) as usize;
            let error = half * largest * rho.powi(-2 * i32::try_from(points).unwrap_or(i32::MAX));
            panels.push(Panel {
                middle,
                half,
                points,
                error,
            });
            continue;
        }
        if panels.len() + open.len() > MOST_PANELS || half < 1e-34 {
            return None;
        }
        open.push((from, middle));
        open.push((middle, to));
    }
    Some(panels)
}

/// Where the lines' distance vanishes: how far along the outer line from its start, how far beside it, and how uncertain both
/// are.
#[inline(always)]
fn pinch<S: Scalar + Copy>(outer: &Edge<S>, inner: &Edge<S>, epsilon: f64) -> (S, f64, f64) {
    let across = outer.direction.cross(inner.direction);
    let square = across.dot(across);
    let w = outer.ends[0].minus(inner.ends[0]);
    let along = -w.cross(inner.direction).dot(across) / square;
    let aside = w.dot(across) / square;
    let aside = aside.to_f64().abs();
    let sine = square.to_f64().sqrt();
    let unsure = 8.0 * epsilon * (w.length().to_f64() + along.to_f64().abs() + aside) / sine;
    // lines too nearly parallel for these numbers: nothing is certain
    if unsure.is_finite() {
        (along, aside, unsure)
    } else {
        (outer.length.zero(), 0.0, f64::INFINITY)
    }
}
