//! Aligned rectangles many sizes apart: the kernel by Gauss rules along their sides.
//!
//! ```text
//!   parallel, z apart:       A F = ∫∫∫∫ z² / (π (u² + v² + z²)²),        u = x − ξ, v = y − η
//!   perpendicular:           A F = ∫∫∫∫ x z / (π (x² + z² + v²)²)
//! ```
//!
//! r² is a sum of squares of single coordinates, so the rules need no points in space. Nothing cancels; the truncation
//! bound is that of [`gauss_points`](super::gauss_points).

use super::ExchangeArea;
use super::gauss_points;
use crate::geometry::Span;
use crate::numeric::{GaussLegendre, vectorised};
use std::f64::consts::PI;

/// Points per side beyond which other routes are cheaper.
const MOST: usize = 8;

/// Four sides, two of each rectangle: `[x, ξ]` and `[y, η]` for parallel ones, a depth each and `[y, η]` for perpendicular
/// ones; and the heights of one over the other's plane.
pub(super) enum Sides<'a> {
    Parallel {
        sides: [[&'a Span; 2]; 2],
        distance: f64,
    },
    Perpendicular {
        depths: [&'a Span; 2],
        widths: [&'a Span; 2],
    },
}

/// The exchange area in the spans' unit, if few points are certain to leave an error below `tolerance`, relative.
pub(super) fn exchange_area(sides: &Sides, tolerance: f64) -> Option<ExchangeArea> {
    let spans = match sides {
        Sides::Parallel {
            sides: [[x, xi], [y, eta]],
            ..
        } => [*x, *xi, *y, *eta],
        Sides::Perpendicular {
            depths: [x, z],
            widths: [y, eta],
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
    let (least, most, heights) = match sides {
        Sides::Parallel {
            sides: [[x, xi], [y, eta]],
            distance,
        } => {
            let (u, v, z2) = (apart(x, xi), apart(y, eta), distance * distance);
            (u[0] + v[0] + z2, u[1] + v[1] + z2, [[z2, z2]; 2])
        }
        Sides::Perpendicular {
            depths,
            widths: [y, eta],
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
    // a rule's bound is for two directions; there are four
    let error = |n: usize| {
        2.0 * gauss_points::error(n, 2.0 * gap / longest * (1.0 - 8.0 * f64::EPSILON)) * largest
    };
    let points = (2..=MOST).find(|n| error(*n) <= 0.3 * tolerance * smallest)?;
    let rule = GaussLegendre::with(points);
    let at = |span: &Span| {
        let half = 0.5 * span.length();
        let mut nodes = [0.0; MOST];
        for (node, x) in nodes.iter_mut().zip(&rule.nodes) {
            *node = span.lower() + half * (1.0 + x);
        }
        nodes
    };
    let [a, b, c, d] = spans.map(at);
    // the squares of the last two coordinates' difference, padded with points that weigh nothing
    let mut squares = [1.0; MOST * MOST];
    let mut weights = [0.0; MOST * MOST];
    for i in 0..points {
        for j in 0..points {
            let v = c[i] - d[j];
            squares[i * points + j] = v * v;
            weights[i * points + j] = rule.weights[i] * rule.weights[j];
        }
    }
    let used = (points * points).next_multiple_of(8);
    let mut outer = [[0.0; 2]; MOST * MOST];
    for i in 0..points {
        for j in 0..points {
            let weight = rule.weights[i] * rule.weights[j];
            outer[i * points + j] = match sides {
                Sides::Parallel { distance, .. } => {
                    let u = a[i] - b[j];
                    [u * u + distance * distance, weight * distance * distance]
                }
                Sides::Perpendicular { .. } => [a[i] * a[i] + b[j] * b[j], weight * a[i] * b[j]],
            };
        }
    }
    let sum = total(
        &outer[..points * points],
        &squares[..used],
        &weights[..used],
    );
    let value = sum * area / (16.0 * PI);
    #[allow(clippy::cast_precision_loss, reason = "at most 64")]
    let terms = (points * points) as f64;
    Some(ExchangeArea {
        value,
        error_bound: (32.0 + terms) * f64::EPSILON * value + error(points),
    })
}

/// `Σ_i f_i Σ_j w_j / (a_i + s_j)²`, two i sharing a division.
fn total(outer: &[[f64; 2]], squares: &[f64], weights: &[f64]) -> f64 {
    let mut sums = [0.0; MOST * MOST];
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
