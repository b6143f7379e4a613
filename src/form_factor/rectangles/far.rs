//! Aligned rectangles many sizes apart: the kernel by Gauss rules along their sides.
//!
//! ```text
//!   parallel, z apart:       A F = ∫∫∫∫ z² / (π (u² + v² + z²)²),        u = x − ξ, v = y − η
//!   perpendicular:           A F = ∫∫∫∫ x z / (π (x² + z² + v²)²)
//! ```
//!
//! r² is a sum of squares of single coordinates, so the rules need no points in space; and of two
//! sides along one axis only the difference of their coordinates matters, with a weight that is
//! piecewise linear:
//!
//! ```text
//!   ∫∫ f(x − ξ) dx dξ = ∫ w(u) f(u) du
//!       w(u): length of the x in [x0, x1] with x − u in [ξ0, ξ1]
//! ```
//!
//! On each piece w stands where a polygon's Jacobian does in the truncation bound of
//! [`gauss_points`](crate::form_factor::gauss::points), at most twice its mean there, and no piece
//! is longer than the longer side. Nothing cancels.

use super::layout::Layout;
use crate::form_factor::ExchangeArea;
use crate::form_factor::gauss::points::Lines;
use crate::geometry::Span;
use crate::numeric::{GaussLegendre, vectorised};
use std::f64::consts::PI;

/// Points per side beyond which other routes are cheaper.
const MOST_PER_SIDE: usize = 8;
/// Points of a difference.
const MOST_NODES: usize = 3 * MOST_PER_SIDE;

/// The exchange area in the spans' unit, if few points are certain to leave an error below
/// `tolerance`, relative.
pub(crate) fn exchange_by_rules(layout: &Layout<f64>, tolerance: f64) -> Option<ExchangeArea> {
    let spans = match layout {
        Layout::Parallel {
            spans: [[x, xi], [y, eta]],
            ..
        } => [*x, *xi, *y, *eta],
        Layout::Perpendicular {
            depths: [x, z],
            widths: [y, eta],
            ..
        } => [*x, *z, *y, *eta],
    };
    let lengths = spans.map(|span| *span.length());
    let area: f64 = lengths.iter().product();
    // nearest and farthest in each coordinate
    let apart = |a: &Span, b: &Span| {
        let least = (b.lower() - a.upper()).max(a.lower() - b.upper()).max(0.0);
        let most = (b.upper() - a.lower()).max(a.upper() - b.lower());
        [least * least, most * most]
    };
    let (least, most, heights) = match layout {
        Layout::Parallel {
            spans: [[x, xi], [y, eta]],
            distance,
        } => {
            let (u, v, z2) = (apart(x, xi), apart(y, eta), *distance * *distance);
            (u[0] + v[0] + z2, u[1] + v[1] + z2, [[z2, z2]; 2])
        }
        Layout::Perpendicular {
            depths,
            widths: [y, eta],
            ..
        } => {
            let v = apart(y, eta);
            let squares =
                depths.map(|span| [span.lower() * span.lower(), span.upper() * span.upper()]);
            let [x, z] = squares;
            (x[0] + z[0] + v[0], x[1] + z[1] + v[1], squares)
        }
    };
    let gap = least.sqrt();
    let [low, high] = [0, 1].map(|end| (heights[0][end] * heights[1][end]).sqrt());
    let largest = area * high / (PI * least * least);
    let smallest = area * low.max(0.25 * high) / (PI * most * most);
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    // the weights of differences rise from 0 to twice their mean; a depth is itself a height
    let lines = |height: f64, jacobian: f64| Lines {
        gamma: 2.0 * gap / longest * (1.0 - 8.0 * f64::EPSILON),
        height,
        jacobian,
    };
    let directions = match layout {
        Layout::Parallel { .. } => [(4.0, lines(0.0, 0.5)), (0.0, lines(0.0, 0.0))],
        Layout::Perpendicular { depths: [x, z], .. } => {
            let slope = |depth: &Span| 0.5 * depth.length() / depth.upper();
            [
                (2.0, lines(0.0, 0.5)),
                (2.0, lines(slope(x).max(slope(z)), 0.0)),
            ]
        }
    };
    let error = |n: usize| {
        let errors = directions
            .iter()
            .map(|(peaks, lines)| peaks * lines.error(n));
        errors.sum::<f64>() * largest
    };
    let points = (2..=MOST_PER_SIDE).find(|n| error(*n) <= 0.3 * tolerance * smallest)?;
    let rule = GaussLegendre::with(points);
    let (mut squares, mut weights) = ([1.0; MOST_NODES], [0.0; MOST_NODES]);
    let mut used = 0;
    differences([spans[2], spans[3]], rule, |v, weight| {
        (squares[used], weights[used]) = (v * v, weight);
        used += 1;
    });
    let mut outer = [[0.0; 2]; MOST_PER_SIDE * MOST_PER_SIDE];
    let mut count = 0;
    let mut push = |square: f64, factor: f64| {
        outer[count] = [square, factor];
        count += 1;
    };
    match layout {
        Layout::Parallel { distance, .. } => {
            let z2 = *distance * *distance;
            differences([spans[0], spans[1]], rule, |u, weight| {
                push(u * u + z2, weight * z2)
            });
        }
        Layout::Perpendicular { .. } => {
            let (x, z) = (spans[0], spans[1]);
            for (s, ws) in rule.nodes.iter().zip(&rule.weights) {
                let x = x.lower() + 0.5 * x.length() * (1.0 + s);
                for (t, wt) in rule.nodes.iter().zip(&rule.weights) {
                    let z = z.lower() + 0.5 * z.length() * (1.0 + t);
                    push(
                        x * x + z * z,
                        0.25 * lengths[0] * lengths[1] * ws * wt * x * z,
                    );
                }
            }
        }
    }
    let terms = count + used;
    let used = used.next_multiple_of(8);
    let value = total(&outer[..count], &squares[..used], &weights[..used]) / PI;
    #[allow(clippy::cast_precision_loss, reason = "at most 88")]
    let rounding = (32.0 + terms as f64) * f64::EPSILON * value;
    Some(ExchangeArea {
        value,
        error: rounding + error(points),
    })
}

/// A rule for `∫∫ f(x − ξ) dx dξ` over two spans: each difference, with its weight.
fn differences([x, xi]: [&Span; 2], rule: &GaussLegendre, mut take: impl FnMut(f64, f64)) {
    let shorter = x.length().min(*xi.length());
    let even = (x.length() - xi.length()).abs();
    let (least, most) = (x.lower() - xi.upper(), x.upper() - xi.lower());
    // where the weight rises from 0, where it falls to 0, and where it stays
    let ramp = 0.5 * shorter;
    for (t, weight) in rule.nodes.iter().zip(&rule.weights) {
        let along = ramp * (1.0 + t);
        let weight = ramp * weight * along;
        take(least + along, weight);
        take(most - along, weight);
    }
    if even > 0.0 {
        for (t, weight) in rule.nodes.iter().zip(&rule.weights) {
            let along = 0.5 * even * (1.0 + t);
            take(least + shorter + along, 0.5 * even * weight * shorter);
        }
    }
}

/// `Σ_i f_i Σ_j w_j / (a_i + s_j)²`, two i sharing a division.
fn total(outer: &[[f64; 2]], squares: &[f64], weights: &[f64]) -> f64 {
    let mut sums = [0.0; MOST_NODES];
    let sums = &mut sums[..squares.len()];
    vectorised(
        #[inline(always)]
        || {
            let mut pairs = outer.chunks_exact(2);
            for pair in &mut pairs {
                let [[a, f], [b, g]] = [pair[0], pair[1]];
                for (sum, square) in sums.iter_mut().zip(squares) {
                    let (p, q) = (a + square, b + square);
                    let (p2, q2) = (p * p, q * q);
                    *sum += (f * q2 + g * p2) / (p2 * q2);
                }
            }
            if let [[a, f]] = pairs.remainder() {
                for (sum, square) in sums.iter_mut().zip(squares) {
                    let p = a + square;
                    *sum += f / (p * p);
                }
            }
        },
    );
    sums.iter()
        .zip(weights)
        .map(|(sum, weight)| sum * weight)
        .sum()
}
