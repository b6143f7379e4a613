//! The exchange between a line of points in one plane and a polygon: the rate at which an exchange
//! area grows as a cut moves.
//!
//! ```text
//!   ∂(A F)/∂t = breadth · ∫ F_x ds       over the cut line, x on it (Leibniz);
//!                                        F_x by Lambert's formula
//! ```
//!
//! The polygon is clipped once at the plane, the line at the polygon's plane; then F_x is analytic
//! in s up to the zeros of r² (a corner c of the polygon) and of h² (the line of its edge u) in the
//! complex plane,
//!
//! ```text
//!   |c − x(s)|² = 0,     |(c − x(s)) × u|² = 0
//! ```
//!
//! and the line is halved until each piece of half-length l lies inside ellipses with
//! `|z − m + l| + |z − m − l| ≥ 3 l` for all of them, ρ ≥ 2.6: 20 Gauss points leave 2.6^(−40) =
//! 2e-17 of the largest |F|.
//!
//! **Not covered**: a bound on the error; measured, a few ε of the line's length.

use super::lambert::integral;
use super::points::Block;
use crate::form_factor::Polygon;
use crate::form_factor::contour::edge::Edge;
use crate::geometry::{Vector, clipped};
use crate::numeric::{GaussLegendre, LANES};
use glam::DVec3;

/// Gauss points per piece.
const POINTS: usize = 20;

/// Pieces shorter than this share of the line are not halved again: what Gauss misses of them
/// counts less than ε, and their middles are still apart from their ends.
const SHORTEST_PIECE: f64 = 1.0 / (1_u64 << 46) as f64;

impl Polygon {
    /// `∫ F_x ds`: what the points of a segment in the plane of `self` send to `other`, per width
    /// of the segment.
    ///
    /// **Arguments** `segment`: its ends, in the plane of `self`.
    /// **Returns** a length ≥ 0.
    /// **Accuracy** a few ε of the segment's length, measured by
    /// `strips_are_derivatives_of_exchange_areas`.
    #[must_use]
    pub fn segment_exchange(&self, segment: [DVec3; 2], other: &Self) -> f64 {
        let visible = self.in_front(other);
        let heights = segment.map(|end| other.height(end));
        let Some([start, end]) = in_front(segment, heights) else {
            return 0.0;
        };
        if visible.len() < 3 {
            return 0.0;
        }
        let corners: Vec<DVec3> = visible.iter().map(|corner| *corner - start).collect();
        let length = start.distance(end);
        let direction = (end - start) / length;
        let zeros = complex_zeros(&corners, direction);
        let (mut blocks, mut count) = (Vec::new(), 0);
        let nodes = GaussLegendre::with(POINTS);
        let mut open = vec![[0.0, length]];
        while let Some([from, to]) = open.pop() {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            let near = |[s, height]: &[f64; 2]| {
                (s - middle - half).hypot(*height) + (s - middle + half).hypot(*height) < 3.0 * half
            };
            if half > SHORTEST_PIECE * length && zeros.iter().any(near) {
                open.extend([[middle, to], [from, middle]]);
                continue;
            }
            for (node, weight) in nodes.nodes.iter().zip(&nodes.weights) {
                let lane = count % LANES;
                if lane == 0 {
                    blocks.push(Block::default());
                }
                if let Some(block) = blocks.last_mut() {
                    let point = direction * (middle + half * node);
                    for (column, x) in block.points.iter_mut().zip(point.to_array()) {
                        column[lane] = x;
                    }
                    block.weights[lane] = half * weight;
                }
                count += 1;
            }
        }
        let n = corners.len();
        let at = |i: usize| Vector(corners[i % n].to_array());
        let edges: Vec<_> = (0..n).map(|i| Edge::new(at(i), at(i + 1))).collect();
        integral(&blocks, self.normal, &edges, DVec3::ZERO).max(0.0)
    }

    /// The corners of what of `other` lies in front of this plane.
    fn in_front(&self, other: &Self) -> Vec<DVec3> {
        let corners = &other.shape.corners;
        let heights: Vec<f64> = corners.iter().map(|corner| self.height(*corner)).collect();
        let mut visible = clipped(corners, &heights, |from, to, share| {
            from + (to - from) * share
        });
        visible.dedup();
        if visible.len() > 1 && visible.first() == visible.last() {
            visible.pop();
        }
        visible
    }
}

/// The part of a segment with positive heights.
fn in_front([start, end]: [DVec3; 2], [from, to]: [f64; 2]) -> Option<[DVec3; 2]> {
    let crossing = || start + (end - start) * (from / (from - to));
    let left = match (from > 0.0, to > 0.0) {
        (true, true) => [start, end],
        (true, false) => [start, crossing()],
        (false, true) => [crossing(), end],
        (false, false) => return None,
    };
    (left[0].distance(left[1]) > 0.0).then_some(left)
}

/// Zeros `s ± i h` of the squared distances to corners and to the lines of edges, along a line
/// through 0.
fn complex_zeros(corners: &[DVec3], direction: DVec3) -> Vec<[f64; 2]> {
    let n = corners.len();
    let mut zeros = Vec::with_capacity(2 * n);
    for (i, corner) in corners.iter().enumerate() {
        let along = corner.dot(direction);
        zeros.push([along, (*corner - direction * along).length()]);
        let edge = (corners[(i + 1) % n] - *corner).normalize();
        let (here, change) = (corner.cross(edge), direction.cross(edge));
        let square = change.length_squared();
        if square > f64::MIN_POSITIVE {
            let along = here.dot(change) / square;
            zeros.push([along, (here - change * along).length() / square.sqrt()]);
        }
    }
    zeros
}
