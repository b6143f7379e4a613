//! Gauss rules along an edge for the [potential](super::potential) of another one.
//!
//! Skew edges near to each other are cut into panels, graded towards the other one, until a
//! [Gauss rule](gauss_error) is certain on each.
//!
//! Edges that run beside each other need fewer panels than their distance suggests: as a function
//! of a complex t along the outer line, the potential of the inner edge is singular only at its
//! ends (r = 0 there), and where the distance of the lines' points h² = miss² + sin²θ (t − t*)²
//! vanishes, `t* ± i miss/sin θ`. On an ellipse inside all of them its terms are bounded by 60
//! times the largest distance, in units of it.

use super::edge::{Edge, half_axes};
use crate::geometry::Vector;
use crate::numeric::functions::elementary::{
    ROUGH_EXP2_ERROR, ROUGH_LN_ERROR, rough_exp2, rough_ln,
};
use crate::numeric::{MOST_POINTS, Scalar, real};
use smallvec::SmallVec;
use std::f64::consts::LN_2;

/// A bound on the error of a Gauss rule with `points` on an edge, per half its length and per
/// length of the other edge, if no point of the other one is nearer to it than the ellipse `ρ`:
/// half the logarithm of r² has the Chebyshev coefficients `ρ^(−k)/k` of its two singular points,
/// the rule is exact below `2n` and within 2.05 beyond.
pub(crate) fn gauss_error(points: usize, rho: f64) -> f64 {
    let n = real(points);
    2.05 / n * power(rho, points) / (1.0 - 1.0 / (rho * rho))
}

/// The ellipse through a point whose distances from the ends of an edge are `sum` edge lengths
/// together.
pub(crate) fn ellipse(sum: f64) -> f64 {
    sum + (sum * sum - 1.0).max(0.0).sqrt()
}

/// The number of points for which [`gauss_error`] is near an error with this logarithm: its factor
/// is 1/5 for ten points.
#[inline(always)]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "small"
)]
pub(crate) fn points_for(log_error: f64, rho: f64) -> usize {
    let points = (-1.5 - log_error) / (2.0 * rough_ln(rho));
    points.clamp(1.0, real(MOST_POINTS) - 1.0) as usize + 1
}

/// A piece of an edge, relative to it, with a rule that is certain there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Panel<S> {
    pub middle: S,
    pub half: f64,
    pub points: usize,
    /// The truncation error, per length of both edges.
    pub error: f64,
}

/// A place along the outer edge, relative to it; where that is, and its squared distance from the
/// inner edge.
type Place<S> = (S, Vector<S>, f64);

/// Hands over panels of `outer`, graded towards `inner`; `None` if there are too many.
///
/// **Arguments** `wanted`: the error per length of both edges; `apart`: sum of half-axes of an
/// ellipse about each panel that holds nothing singular: more of it, fewer points per panel, and
/// more panels.
#[inline(always)]
pub(crate) fn panels<S: Scalar + Copy>(
    outer: &Edge<S>,
    inner: &Edge<S>,
    wanted: f64,
    epsilon: f64,
    apart: f64,
    mut take: impl FnMut(Panel<S>),
) -> Option<()> {
    const MOST_PANELS: usize = 600;
    let length = outer.length.to_f64();
    let number = |x: f64| outer.length.constant(x);
    let (log_wanted, mut near_pinch) = (rough_ln(wanted), None);
    let place = |t: S| {
        let point = outer.at(t);
        (t, point, inner.squared_distance(point))
    };
    let mut open: SmallVec<[[Place<S>; 2]; 8]> = SmallVec::new();
    open.push([place(number(0.0)), place(number(1.0))]);
    let mut count = 0;
    while let Some([start, end]) = open.pop() {
        let ((from, ..), (to, ..)) = (start, end);
        let halfway = place((from + to) * number(0.5));
        let half = 0.5 * (to - from).to_f64();
        // short panels may have a larger share of what is wanted than their length is of the whole
        let log_share = log_wanted - 0.5 * rough_ln(half.max(1e-3));
        let sum = half_axes([start.2, halfway.2, end.2], 2.0 * half * length);
        let rule = if sum >= apart {
            let rho = ellipse(sum);
            let points = points_for(log_share, rho);
            Some((points, gauss_error(points, rho)))
        } else {
            // beside the other edge, but apart from what is singular
            let pinch = match near_pinch {
                Some(pinch) => pinch,
                None => pinch(outer, inner, epsilon),
            };
            near_pinch = Some(pinch);
            let ends = [start.1, end.1];
            beside([outer, inner], [from, to], ends, pinch, [log_share, apart])
        };
        count += 1;
        if let Some((points, error)) = rule {
            let error = error * half;
            take(Panel {
                middle: halfway.0,
                half,
                points,
                error,
            });
        } else if count > 2 * MOST_PANELS || half < 1e-34 {
            return None;
        } else {
            open.push([start, halfway]);
            open.push([halfway, end]);
        }
    }
    Some(())
}

/// A rule for a panel beside the other edge, and its error; `None` if something singular is too
/// near.
#[inline(always)]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "small"
)]
fn beside<S: Scalar + Copy>(
    [outer, inner]: [&Edge<S>; 2],
    [from, to]: [S; 2],
    ends: [Vector<S>; 2],
    (along, aside, unsure): (S, f64, f64),
    [log_share, apart]: [f64; 2],
) -> Option<(usize, f64)> {
    let length = (to - from).to_f64() * outer.length.to_f64();
    let (mut to_ends, mut to_pinch) = ([0.0; 2], -2.0 * unsure);
    for (t, x) in [(from, ends[0]), (to, ends[1])] {
        for (sum, end) in to_ends.iter_mut().zip(inner.ends) {
            *sum += end.minus(x).length().to_f64();
        }
        let from_pinch = (along - t * outer.length).to_f64();
        to_pinch += (from_pinch * from_pinch + aside * aside).sqrt();
    }
    let sum = to_ends[0].min(to_ends[1]).min(to_pinch) / length;
    // no such comparison holds for what is not a number
    if sum.is_nan() || sum < apart {
        return None;
    }
    let rho = 1.0 + 0.85 * (ellipse(sum) - 1.0);
    let inner_length = inner.length.to_f64();
    let reach = (to_ends[0].max(to_ends[1]) + 2.0 * inner_length) / inner_length;
    let largest = 64.0 / 15.0 * 60.0 * reach / (1.0 - 1.0 / (rho * rho));
    let points = ((rough_ln(largest) - log_share) / (2.0 * rough_ln(rho)))
        .clamp(1.0, real(MOST_POINTS) - 1.0);
    let points = points as usize + 1;
    Some((points, largest * power(rho, points)))
}

/// A bound on `ρ^(−2n)`, near it.
#[inline(always)]
pub(crate) fn power(rho: f64, points: usize) -> f64 {
    let log = (ROUGH_LN_ERROR - rough_ln(rho)) * (2.0 / LN_2) * real(points);
    // what is not a number stays so
    let log = if log < -1000.0 { -1000.0 } else { log };
    rough_exp2(log) * (1.0 + 2.0 * ROUGH_EXP2_ERROR)
}

/// The complex place where the lines' distance vanishes: how far along the outer line from its
/// start, how far beside it, and how uncertain both are.
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
