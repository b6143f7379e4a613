//! The double contour integral over both outlines.
//!
//! ```text
//!   A F = (1/2π) ∮∮ ln r dx·dy = (1/2π) Σ_ab (u_a·u_b) ∫_a ∫_b ln r        (u: edge directions)
//! ```
//!
//! Pairs of edges apart from each other take a Gauss rule on one of them, all in one pass over all points; the others
//! are [closed forms](super::edge_pair) or graded panels. What limits it is cancellation: the terms are of the size of
//! perimeter × perimeter, and the sum falls like 1/distance².
//!
//! Reference: Sparrow, "A new and simpler formulation for radiative angle factors", *J. Heat Transfer* 85 (1963), 81–87.

#![allow(
    clippy::inline_always,
    reason = "the machine code is made where it is called"
)]

use super::ExchangeArea;
use super::edge_pair::{
    Edge, Precision, Relation, Rounding, coplanar, ellipse, gauss_error, panels, points_for,
    relation, skew,
};
use super::potential::{Points, padded, potentials};
use super::shape::Shape;
use super::view::widening;
use crate::geometry::Vector;
use crate::numeric::{DoubleDouble, GaussLegendre, SQUARED_EPSILON, Scalar, vectorised};
use glam::DVec3;
use smallvec::SmallVec;
use std::f64::consts::TAU;
use std::ops::Range;

/// Edges at least this far from each other, as a sum of half-axes, take a Gauss rule in one piece.
const APART: f64 = 1.4;
/// And no more points than about this.
const MOST: u32 = 24;

/// Room for the work on a pair.
#[derive(Debug, Default)]
pub(super) struct Scratch {
    points: Points,
    weights: Vec<f64>,
    runs: Vec<Run>,
    logs: Vec<f64>,
    seen: Vec<f64>,
    seen_back: Vec<f64>,
}

/// The points of a rule on an edge: for one edge of the other polygon, or for all that are apart from it.
#[derive(Debug)]
struct Run {
    edge: usize,
    only: Option<usize>,
    points: Range<usize>,
}

type Edges<S> = SmallVec<[Edge<S>; 4]>;

#[inline(always)]
fn edges<S: Scalar + Copy>(corners: &[Vector<S>]) -> Edges<S> {
    let n = corners.len();
    (0..n)
        .map(|i| Edge::new(corners[i], corners[(i + 1) % n]))
        .collect()
}

/// In `f64`; distances are from `gap` to `reach`, `wanted` is the absolute error that truncation may have. `None` if edges come too near to each other
/// to be resolved.
pub(super) fn contour(
    first: &Shape,
    second: &Shape,
    [gap, reach]: [f64; 2],
    wanted: f64,
    scratch: &mut Scratch,
) -> Option<ExchangeArea> {
    // the outer polygon is the one with the shorter edges: fewer points
    let (outer, inner) = if first.longest_edge <= second.longest_edge {
        (first, second)
    } else {
        (second, first)
    };
    let farthest = outer.centre.abs().max_element() + inner.centre.abs().max_element();
    // far from the origin, coordinates are taken from a corner; each is then rounded once more
    let (shift, shifted) = if farthest > 4.0 * reach {
        let perimeters = outer.perimeter + inner.perimeter;
        (outer.corners[0], f64::EPSILON * reach * 2.0 * perimeters)
    } else {
        (DVec3::ZERO, 0.0)
    };
    let place = |shape: &Shape| -> SmallVec<[DVec3; 8]> {
        shape.corners.iter().map(|corner| *corner - shift).collect()
    };
    let (p, q) = (place(outer), place(inner));
    let lift = |corners: &[DVec3]| -> SmallVec<[Vector<f64>; 8]> {
        corners
            .iter()
            .map(|corner| Vector(corner.to_array()))
            .collect()
    };
    let (a_edges, b_edges) = (edges(&lift(&p)), edges(&lift(&q)));
    let precision = Precision::new(gap, reach, 1.0, f64::EPSILON);
    let per_length = wanted * TAU / (outer.perimeter * inner.perimeter);
    let rounding = Rounding::new(
        f64::EPSILON,
        16.0,
        reach + (farthest - shift.abs().max_element()).max(0.0),
    );

    let Scratch {
        points,
        weights,
        runs,
        logs,
        seen,
        seen_back,
    } = scratch;
    points.clear();
    weights.clear();
    runs.clear();
    let (m, k) = (p.len(), q.len());
    // the ellipse for which the largest rule does
    let narrowest = (-(2.0 * per_length).ln() / (2.0 * f64::from(MOST)))
        .exp()
        .max(ellipse(APART));
    let mut relations: SmallVec<[Option<Relation<f64>>; 16]> = SmallVec::with_capacity(m * k);
    let mut error = 0.0;
    let mut run = |i: usize, only: Option<usize>, (middle, half): (f64, f64), n: usize| {
        let (start, along) = (p[i], p[(i + 1) % m] - p[i]);
        let rule = GaussLegendre::with(n);
        let from = weights.len();
        for (x, weight) in rule.nodes.iter().zip(&rule.weights) {
            points.push(start + (middle + half * x) * along);
            weights.push(half * weight * a_edges[i].length);
        }
        runs.push(Run {
            edge: i,
            only,
            points: from..weights.len(),
        });
    };
    for (i, a) in a_edges.iter().enumerate() {
        let middle = Vector(((p[i] + p[(i + 1) % m]) * 0.5).to_array());
        let mut nearest = f64::INFINITY;
        for (j, b) in b_edges.iter().enumerate() {
            let sum = 2.0 * b.distance(middle) / a.length;
            if sum > 1.0 && ellipse(sum) >= narrowest {
                nearest = nearest.min(sum);
                relations.push(None);
                continue;
            }
            let near = relation([a, b], rounding);
            if matches!(near, Relation::Skew) {
                for panel in panels(a, b, per_length, f64::EPSILON)? {
                    run(i, Some(j), (panel.middle, panel.half), panel.points);
                    error += a.length * b.length * panel.error;
                }
            }
            relations.push(Some(near));
        }
        if nearest < f64::INFINITY {
            let rho = ellipse(nearest);
            let n = points_for(2.0 * per_length, rho);
            run(i, None, (0.5, 0.5), n);
            error += 0.5 * a.length * inner.perimeter * gauss_error(n, rho);
        }
    }
    let ruled = weights.len();
    let all_apart = relations.iter().all(Option::is_none);
    if !all_apart {
        p.iter().for_each(|corner| points.push(*corner));
    }
    points.pad();
    potentials(points, &q, precision.inverse_square, logs, seen);
    let stride = points.len();
    if !all_apart {
        points.clear();
        q.iter().for_each(|corner| points.push(*corner));
        points.pad();
        potentials(points, &p, precision.inverse_square, logs, seen_back);
    }
    let middle = Vector((outer.centre - shift).to_array());
    let mut sum = 0.0;
    for (j, b) in b_edges.iter().enumerate() {
        let row = &seen[j * stride..(j + 1) * stride];
        let projected = b.ends.map(|end| end.minus(middle).dot(b.direction).abs());
        let projected = projected[0].max(projected[1]) + outer.radius;
        let widening = widening(b.length, gap);
        let of_potential = precision.of_potential(projected, b.length, widening);
        for (i, a) in a_edges.iter().enumerate() {
            let cosine = a.direction.dot(b.direction);
            if let Some(Relation::Coplanar(relation)) = relations[i * k + j] {
                let at_a = [row[ruled + i], row[ruled + (i + 1) % m]];
                let back = &seen_back[i * padded(k)..(i + 1) * padded(k)];
                let at_b = [back[j], back[(j + 1) % k]];
                let pair = coplanar([a, b], relation, at_a, at_b, precision);
                sum += cosine * pair.value;
                error += cosine.abs() * pair.error + 4.0 * f64::EPSILON * pair.value.abs();
            } else {
                error += cosine.abs() * a.length * (of_potential + 4.0 * f64::EPSILON * b.length);
            }
        }
        for Run { edge, only, points } in runs.iter() {
            let serves = match only {
                Some(other) => *other == j,
                None => relations[edge * k + j].is_none(),
            };
            if serves {
                let potentials = weights[points.clone()].iter().zip(&row[points.clone()]);
                let integral: f64 = potentials
                    .map(|(weight, potential)| weight * potential)
                    .sum();
                sum += integral * a_edges[*edge].direction.dot(b.direction);
            }
        }
    }
    Some(ExchangeArea {
        value: sum / TAU,
        error_bound: error / TAU + shifted,
    })
}

/// To 106 bits, from corners known that well.
pub(super) fn precise_contour(
    outlines: [&[Vector<DoubleDouble>]; 2],
    wanted: f64,
) -> Option<ExchangeArea> {
    let mut exchange = None;
    vectorised(
        #[inline(always)]
        || exchange = precise_sum(outlines, wanted),
    );
    exchange
}

#[inline(always)]
fn precise_sum([p, q]: [&[Vector<DoubleDouble>]; 2], wanted: f64) -> Option<ExchangeArea> {
    let distances = p
        .iter()
        .flat_map(|x| q.iter().map(|y| x.minus(*y).length().to_f64()));
    let reach = distances.fold(0.0, f64::max);
    // functions are within 64 ε², where the double forms count on 2 ε
    let epsilon = 32.0 * SQUARED_EPSILON;
    let precision = Precision::new(0.0, reach, DoubleDouble::from(1.0), epsilon);
    let (a_edges, b_edges) = (edges(p), edges(q));
    let perimeter =
        |edges: &Edges<DoubleDouble>| edges.iter().map(|e| e.length.to_f64()).sum::<f64>();
    let per_length = wanted * TAU / (perimeter(&a_edges) * perimeter(&b_edges));
    // corners may come from a clip, and edges be short beside their coordinates
    let coordinates = [p, q]
        .into_iter()
        .flatten()
        .flat_map(|corner| corner.0.map(|x| x.to_f64().abs()));
    let rounding = Rounding::new(SQUARED_EPSILON, 1e6, coordinates.fold(reach, f64::max));
    let (mut sum, mut error) = (DoubleDouble::from(0.0), 0.0);
    for a in &a_edges {
        for b in &b_edges {
            let cosine = a.direction.dot(b.direction);
            let potential = |edge: &Edge<_>, point| edge.potential(point, precision.inverse_square);
            let pair = match relation([a, b], rounding) {
                Relation::Skew => skew([a, b], per_length, precision)?,
                Relation::Coplanar(relation) => {
                    let at_a = a.ends.map(|end| potential(b, end));
                    let at_b = b.ends.map(|end| potential(a, end));
                    coplanar([a, b], relation, at_a, at_b, precision)
                }
            };
            sum = sum + cosine * pair.value;
            error +=
                cosine.to_f64().abs() * pair.error + precision.epsilon * pair.value.to_f64().abs();
        }
    }
    Some(ExchangeArea {
        value: sum.to_f64() / TAU,
        error_bound: error / TAU + f64::EPSILON * sum.to_f64().abs(),
    })
}
