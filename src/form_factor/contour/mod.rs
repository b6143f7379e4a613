//! The double contour integral over both outlines.
//!
//! ```text
//!   A F = (1/2π) ∮∮ ln r dx·dy = (1/2π) Σ_ab (u_a·u_b) ∫_a ∫_b ln r        (u: edge directions)
//! ```
//!
//! An edge apart from all of the other polygon's takes one Gauss rule for all of them. Of the other
//! pairs of edges each has a rule of its own, [graded panels](mod@self::panels) or a
//! [closed form](mod@self::coplanar). Cancellation limits the route: the terms are of the size of
//! perimeter × perimeter, and the sum falls like 1/distance².
//!
//! In units of u = ε/2, beside the [potential's](self::potential) own error:
//!
//! ```text
//!   coefficients w e_a·u_b      8 u of |w e_a| |U_b|: 3 u for w e_a, 2 u for u_b, 3 u for their
//!                               product
//!   length of u_b               5 u of U_b + L_b: common to all its coordinates
//!   sums                        u of |w e_a| |U_b| for each addition, 3 u across a vector, 2 u for
//!                               product and quotient
//!   nodes displaced by δ        δ L_a |∇U_b|,  δ ≤ u (2 max |x| + 1.75 L_a),  |∇U_b| ≤ L_b/r,
//!                               |∇U_b|² ≤ π² + ln²(1 + L_b/r) ≤ (π + ln²(1 + L_b/r)/2π)²
//!   u_a·u_b lost in rounding    28 u L_a max |U_b|, in place of the pair
//! ```
//!
//! (the gradient's component along b is the logarithm of the ends' distances' ratio, that across it
//! the angle.)
//!
//! Edges with their errors are in `edge`, the inner integral over one of them in `potential`;
//! `double_double` repeats the whole with 106 bits where this file's sum cancels.
//!
//! **Not covered**: polygons that reach behind each other's plane; they are clipped before.
//!
//! Reference: Sparrow, "A new and simpler formulation for radiative angle factors", *J. Heat
//! Transfer* 85 (1963), 81–87.

pub(crate) mod coplanar;
pub(crate) mod double_double;
pub(crate) mod edge;
pub(crate) mod panels;
pub(crate) mod potential;

use super::ExchangeArea;
use super::clipped_pair::widening;
use crate::form_factor::clipped_pair::shape::Shape;
use crate::geometry::Vector;
use crate::numeric::functions::elementary::{ROUGH_LN_ERROR, rough_ln};
use crate::numeric::{DoubleDouble, GaussLegendre, LANES, Lanes, real};
use coplanar::{Coplanar, Relation, Rounding, coplanar, relation};
use edge::{Columns, Edge, Precision};
use glam::DVec3;
use panels::{ellipse, gauss_error, panels, points_for};
use potential::{Batch, EdgeWithError, Nodes, Sums};
use smallvec::SmallVec;
use std::f64::consts::{LN_2, PI, TAU};

/// Edges at least this far from each other, as a sum of half-axes, take a Gauss rule in one piece.
const ONE_PIECE_DISTANCE: f64 = 1.1;
/// The number of points that such a rule has at most, roughly.
const MOST_EDGE_POINTS: f64 = 40.0;
/// Cosines up to this, in ε, are those of a right angle.
const RIGHT_ANGLE: f64 = 8.0;

/// Room for the work on a pair.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    nodes: Nodes,
    batch: Batch,
    columns: Columns,
    /// Half-axes by edge of the outer polygon and vector of edges of the inner one.
    outside: Vec<Lanes>,
}

type Edges = SmallVec<[Edge<f64>; 4]>;

/// Puts the edges of a shape from a new origin in `edges`, and says whether they have the same
/// places there exactly.
fn placed(shape: &Shape, origin: DVec3, edges: &mut Edges) -> bool {
    let origin = Vector(origin.to_array());
    let mut is_exact = true;
    for edge in &shape.edges {
        let ends = [edge.ends[0].minus(origin), edge.ends[1].minus(origin)];
        for k in 0..3 {
            let difference = DoubleDouble::difference(edge.ends[0].0[k], origin.0[k]);
            is_exact &= difference.low() == 0.0;
        }
        edges.push(Edge { ends, ..*edge });
    }
    is_exact
}

/// The contour integral in `f64`; distances are from `gap` to `reach`, `wanted` is the absolute
/// error that truncation may have. `None` if edges come too near to each other to be resolved.
pub(crate) fn contour(
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
    // coordinates are taken from a corner if that moves nothing, or if they are far larger than the
    // distances
    let farthest = outer.largest.max(inner.largest);
    let mut origin = outer.corners[0];
    let (mut a_edges, mut b_edges) = (Edges::new(), Edges::new());
    let exact = placed(outer, origin, &mut a_edges);
    let also = placed(inner, origin, &mut b_edges);
    let mut moved = 0.0;
    if !(exact && also) {
        if farthest > 4.0 * reach {
            moved = f64::EPSILON * reach * 2.0 * (outer.perimeter + inner.perimeter);
        } else {
            origin = DVec3::ZERO;
            (a_edges, b_edges) = (outer.edges.clone(), inner.edges.clone());
        }
    }
    let Scratch {
        nodes,
        batch,
        columns,
        outside,
    } = scratch;
    // long before they are read, which would have to wait for them
    columns.fill(&b_edges);
    let squares = a_edges.iter().map(|edge| edge.ends[0].dot(edge.ends[0]));
    let largest = squares.fold(0.0, f64::max).sqrt();
    let precision = Precision::new(gap, reach, 1.0, f64::EPSILON);
    let per_length = wanted * TAU / (outer.perimeter * inner.perimeter);
    let middle = Vector((outer.centre - origin).to_array());
    let mut seen: SmallVec<[EdgeWithError; 8]> = SmallVec::with_capacity(b_edges.len());
    for b in &b_edges {
        let [start, end] = b.ends.map(|end| end.minus(middle).dot(b.direction).abs());
        let projected = start.max(end) + outer.radius;
        let error = precision.of_potential(projected, b.length, widening(b.length, gap));
        seen.push((*b, error + 2.5 * f64::EPSILON * b.length));
    }
    let mut sum = EdgeSum {
        precision,
        per_length,
        log_per_length: rough_ln(per_length),
        largest,
        error: 0.0,
        sums: Sums::default(),
    };
    nodes.clear();
    let apart = apart_from(sum.log_per_length);
    let mut near: SmallVec<[usize; 8]> = SmallVec::new();
    outside.clear();
    for (i, a) in a_edges.iter().enumerate() {
        let square = columns.distances_from(a, outside);
        let nearest = 2.0 * square.sqrt() / a.length;
        if nearest >= apart {
            sum.rule(a, [inner.perimeter, 1.0], nearest, nodes, &seen);
        } else {
            near.push(i);
        }
    }
    nodes.sum(&seen, precision.inverse_square, &mut sum.sums);
    if !near.is_empty() {
        let rounding = Rounding::new(f64::EPSILON, 16.0, reach + farthest.min(4.0 * reach));
        let mut in_a_plane: SmallVec<[(usize, usize, Coplanar<f64>); 8]> = SmallVec::new();
        let blocks = b_edges.len().div_ceil(LANES);
        batch.clear();
        for (j, b) in b_edges.iter().enumerate() {
            let only = &seen[j..=j];
            for i in near.iter().copied() {
                let a = &a_edges[i];
                let cosine = a.direction.dot(b.direction);
                if cosine.abs() <= RIGHT_ANGLE * f64::EPSILON {
                    sum.error +=
                        14.0 * f64::EPSILON * a.length * precision.largest_potential(b.length);
                    continue;
                }
                let outside = outside[i * blocks + j / LANES][j % LANES];
                if outside >= apart {
                    let length = [b.length, cosine.abs()];
                    sum.rule(a, length, outside, nodes, only);
                    continue;
                }
                match relation([a, b], rounding) {
                    Relation::Coplanar(relation) => {
                        ask_ends(batch, [a, b], &relation);
                        in_a_plane.push((i, j, relation));
                    }
                    Relation::Skew => sum.panels([a, b], cosine.abs(), nodes, only)?,
                }
            }
            nodes.sum(only, precision.inverse_square, &mut sum.sums);
        }
        batch.answer(precision.inverse_square);
        let mut asked = batch.values.iter();
        for (i, j, relation) in in_a_plane {
            let (a, b) = (&a_edges[i], &b_edges[j]);
            let (mut at_a, mut at_b) = ([0.0; 2], [0.0; 2]);
            if let Coplanar::Meeting { s, t, .. } = relation {
                for end in 0..2 {
                    for (at, weight) in [(&mut at_a, s[end]), (&mut at_b, t[end])] {
                        if weight.abs() > 0.0 {
                            at[end] = asked.next().copied().unwrap_or(f64::NAN);
                        }
                    }
                }
            }
            let cosine = a.direction.dot(b.direction);
            let pair = coplanar([a, b], relation, at_a, at_b, precision);
            sum.sums.value += cosine * pair.value;
            sum.error += cosine.abs() * pair.error + 8.0 * f64::EPSILON * pair.value.abs();
            sum.sums.size += pair.value.abs();
            sum.sums.sums += 1;
        }
    }
    let Sums {
        value,
        size,
        error,
        depth,
        sums,
    } = sum.sums;
    let rounding = (13.0 + real(depth + sums)) * 0.5 * f64::EPSILON * size;
    Some(ExchangeArea {
        value: value / TAU,
        error: (sum.error + error + rounding) / TAU + moved,
    })
}

/// Asks for the potentials of each of two edges on lines that meet at the other's ends; not at the
/// meeting point, where they have no weight.
fn ask_ends(batch: &mut Batch, [a, b]: [&Edge<f64>; 2], relation: &Coplanar<f64>) {
    if let Coplanar::Meeting { s, t, .. } = relation {
        for end in 0..2 {
            if s[end].abs() > 0.0 {
                batch.ask(b, a.ends[end]);
            }
            if t[end].abs() > 0.0 {
                batch.ask(a, b.ends[end]);
            }
        }
    }
}

/// The distance from a rule's edge that others must keep, as a sum of half-axes:
/// [`ONE_PIECE_DISTANCE`], or the distance at which the largest rule is accurate enough.
fn apart_from(log_per_length: f64) -> f64 {
    let log_rho = -(log_per_length + LN_2) / (2.0 * MOST_EDGE_POINTS);
    if log_rho <= 0.44 {
        // ln ρ of ONE_PIECE_DISTANCE is 0.444
        ONE_PIECE_DISTANCE
    } else {
        // near cosh ln ρ: a point more or less does not matter
        let square = log_rho * log_rho;
        1.0 + square * (0.5 + square * (1.0 / 24.0 + square / 720.0))
    }
}

/// A bound on the gradient of the potential of an edge so many times as long as it is far.
fn gradient(ratio: f64) -> f64 {
    let along = rough_ln(1.0 + ratio) + ROUGH_LN_ERROR;
    PI + along * along * (0.5 / PI)
}

/// The sum over pairs of edges, as far as it has come.
struct EdgeSum {
    precision: Precision<f64>,
    /// The error that truncation may have per length of both edges.
    per_length: f64,
    log_per_length: f64,
    /// The largest distance of a node from the origin.
    largest: f64,
    error: f64,
    sums: Sums,
}

impl EdgeSum {
    /// Bounds the displacement of a node on an edge.
    fn displaced(&self, a: &Edge<f64>) -> f64 {
        f64::EPSILON * (self.largest + 0.875 * a.length)
    }

    /// One rule on an edge for others, at least so far away as a sum of half-axes, with their
    /// length together and the largest cosine.
    fn rule(
        &mut self,
        a: &Edge<f64>,
        [length, cosine]: [f64; 2],
        sum: f64,
        nodes: &mut Nodes,
        seen: &[EdgeWithError],
    ) {
        let rho = ellipse(sum);
        let points = points_for(self.log_per_length + LN_2, rho);
        // the nearest point of the edge is this far from the others
        let distance = 0.5 * (sum - 1.0) * a.length;
        let truncation = 0.5 * length * gauss_error(points, rho);
        let gradient = real(seen.len()) * gradient(length / distance);
        let gradient = cosine * gradient.min(length / distance);
        self.error += a.length * (truncation + self.displaced(a) * gradient);
        self.add(a, [0.5, 0.5], points, nodes, seen);
    }

    /// Graded panels on the first of two skew edges; `None` if there are too many.
    fn panels(
        &mut self,
        [a, b]: [&Edge<f64>; 2],
        cosine: f64,
        nodes: &mut Nodes,
        only: &[EdgeWithError],
    ) -> Option<()> {
        let displaced = cosine * self.displaced(a);
        panels(
            a,
            b,
            self.per_length,
            f64::EPSILON,
            ONE_PIECE_DISTANCE,
            |panel| {
                let clearance = (ONE_PIECE_DISTANCE - 1.0) * panel.half * a.length;
                let gradient = gradient(b.length / clearance);
                let truncation = b.length * panel.error;
                self.error += a.length * (truncation + 2.0 * panel.half * displaced * gradient);
                self.add(a, [panel.middle, panel.half], panel.points, nodes, only);
            },
        )
    }

    fn add(
        &mut self,
        a: &Edge<f64>,
        part: [f64; 2],
        points: usize,
        nodes: &mut Nodes,
        seen: &[EdgeWithError],
    ) {
        let rule = GaussLegendre::with(points);
        if !nodes.has_room_for(rule) {
            nodes.sum(seen, self.precision.inverse_square, &mut self.sums);
        }
        nodes.add(a, part, rule);
    }
}
