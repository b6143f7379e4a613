//! The logarithmic potential of an edge, `∫ ln|x − y| dy`, in closed form.
//!
//! ```text
//!   edge from C to D, L = |D − C|, a = C − x, c = D − x
//!   e = (D − C)/L:   s0 = a·e, s1 = c·e, h = |a×e|, θ = angle between a and c
//!   ∫ ln|x − y| dy = s1 ln|c| − s0 ln|a| + h θ − L
//! ```
//!
//! In units of u = ε/2: a and c are within u of themselves, the directions within 3 u, s and h
//! within 6 u r, the logarithm of r² (5 u before it is halved) within 2.5 u + 3 u |ln r|; θ within
//! 5 u sin θ from its cosine, 6 u L/min(|a|,|c|) from its sine and 5 u θ from its function. With r
//! = min(|a|,|c|), r sin θ ≤ L, and r θ ≤ t L where t = θ/sin θ, or π/2 if that is less (the
//! isosceles triangle has the longest r for an angle and L: r θ ≤ L θ/(2 sin θ/2)),
//!
//! ```text
//!   error ≤ u [ 2.5 (|s0| + |s1|) + 18 max r |ln r| + (12 + 12 t) L ]
//! ```

use super::edge::Edge;
use crate::geometry::Vector;
use crate::numeric::functions::elementary::{angles, logarithms};
use crate::numeric::{
    GaussLegendre, LANES, Lanes, MOST_POINTS, Scalar, across, vector_value, vectorised,
};

/// The potential of an edge at a point, from the vectors `a`, `c` to its ends, its direction and
/// length, `ln|a|` and `ln|c|`, and h and θ.
#[inline(always)]
pub(crate) fn potential<S: Scalar + Copy>(
    [a, c]: [Vector<S>; 2],
    direction: Vector<S>,
    length: S,
    logs: [S; 2],
    [height, angle]: [S; 2],
) -> S {
    c.dot(direction) * logs[1] - a.dot(direction) * logs[0] + height * angle - length
}

impl<S: Scalar + Copy> Edge<S> {
    /// The edge's potential at a point.
    #[inline(always)]
    pub(crate) fn potential(&self, point: Vector<S>, inverse_square: S) -> S {
        let (a, c) = (self.ends[0].minus(point), self.ends[1].minus(point));
        let logs = [
            log_distance(a, inverse_square),
            log_distance(c, inverse_square),
        ];
        let height = a.cross(self.direction).length();
        let [angle] = S::angles([[&(height * self.length), &a.dot(c)]]);
        let turn = [height, angle];
        potential([a, c], self.direction, self.length, logs, turn)
    }
}

/// `ln(|a|/unit)` from `1/unit²`, kept finite where `a` is 0.
#[inline(always)]
pub(crate) fn log_distance<S: Scalar + Copy>(a: Vector<S>, inverse_square: S) -> S {
    let square = scaled_square(a, inverse_square);
    let [log] = S::logarithms([&square]);
    log * square.constant(0.5)
}

/// `|a|²/unit²`, kept above 0.
#[inline(always)]
fn scaled_square<S: Scalar + Copy>(a: Vector<S>, inverse_square: S) -> S {
    a.dot(a) * inverse_square + inverse_square.constant(f64::MIN_POSITIVE)
}

/// Points of rules along edges, so many at a time.
const ROOM: usize = 2 * MOST_POINTS + LANES;

/// Points along edges, each with its weight times the edge's direction.
#[derive(Debug)]
pub(crate) struct Nodes {
    len: usize,
    points: [[f64; ROOM]; 3],
    weights: [[f64; ROOM]; 3],
}

impl Default for Nodes {
    fn default() -> Self {
        Self {
            len: 0,
            points: [[0.0; ROOM]; 3],
            weights: [[0.0; ROOM]; 3],
        }
    }
}

/// Sums over nodes x with weights W and edges b, whose potentials are U with an error of e.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    /// `Σ (W·u) U`.
    pub value: f64,
    /// `Σ |W| |U|`, what the rounding of coefficients and of the sum is relative to.
    pub size: f64,
    /// `Σ |W·u| e`.
    pub error: f64,
    /// Most additions that a term went through before its vector was summed, and how many such sums
    /// there are.
    pub depth: usize,
    pub sums: usize,
}

/// An edge, and a bound on the error of its potential.
pub(crate) type EdgeWithError = (Edge<f64>, f64);

impl Nodes {
    pub(crate) const fn clear(&mut self) {
        self.len = 0;
    }

    pub(crate) const fn has_room_for(&self, rule: &GaussLegendre) -> bool {
        self.len + rule.nodes.len() <= ROOM - LANES
    }

    /// A rule on the part of an edge with this middle and half length, both relative to it.
    pub(crate) fn add(&mut self, edge: &Edge<f64>, [middle, half]: [f64; 2], rule: &GaussLegendre) {
        let (start, end) = (edge.ends[0].0, edge.ends[1].0);
        let len = self.len;
        self.len += rule.nodes.len();
        let (points, weights, lanes) = (&mut self.points, &mut self.weights, &*rule.lanes);
        vectorised(
            #[inline(always)]
            move || {
                for k in 0..3 {
                    let along = end[k] - start[k];
                    let (centre, radius) = (start[k] + middle * along, half * along);
                    let blocks = points[k][len..].chunks_exact_mut(LANES);
                    let weights = weights[k][len..].chunks_exact_mut(LANES);
                    for ((x, w), [nodes, rule]) in blocks.zip(weights).zip(lanes) {
                        for l in 0..LANES {
                            x[l] = centre + radius * nodes[l];
                            w[l] = radius * rule[l];
                        }
                    }
                }
            },
        );
    }

    /// Sums over all nodes and a chain of edges, each of which starts where the one before ends;
    /// afterwards there are no nodes.
    pub(crate) fn sum(&mut self, edges: &[EdgeWithError], inverse_square: f64, sums: &mut Sums) {
        if self.len == 0 {
            return;
        }
        let blocks = self.len.div_ceil(LANES);
        for k in 0..3 {
            // what is left of the last vector
            let rest = self.len..self.len + LANES;
            let first = self.points[k][0];
            self.points[k][rest.clone()].copy_from_slice(&[first; LANES]);
            self.weights[k][rest].copy_from_slice(&[0.0; LANES]);
        }
        let (points, weights) = (&self.points, &self.weights);
        let total = vector_value!([[0.0; LANES]; 3], {
            let mut sums = [[0.0; LANES]; 3];
            for pair in 0..blocks / 2 {
                let at = 2 * pair * LANES;
                let x = [lanes(points, at), lanes(points, at + LANES)];
                let w = [lanes(weights, at), lanes(weights, at + LANES)];
                add_blocks(&mut sums, x, w, edges, inverse_square);
            }
            if blocks % 2 == 1 {
                let at = (blocks - 1) * LANES;
                let (x, w) = ([lanes(points, at)], [lanes(weights, at)]);
                add_blocks(&mut sums, x, w, edges, inverse_square);
            }
            sums
        });
        let [value, size, error] = total.map(across);
        sums.value += value;
        sums.size += size;
        sums.error += error;
        sums.depth = sums.depth.max(blocks * edges.len());
        sums.sums += 1;
        self.len = 0;
    }
}

#[inline(always)]
fn lanes([x, y, z]: &[[f64; ROOM]; 3], at: usize) -> [Lanes; 3] {
    let mut lanes = [[0.0; LANES]; 3];
    lanes[0].copy_from_slice(&x[at..at + LANES]);
    lanes[1].copy_from_slice(&y[at..at + LANES]);
    lanes[2].copy_from_slice(&z[at..at + LANES]);
    lanes
}

/// Some blocks together, so that none waits for another.
#[inline(always)]
#[expect(
    clippy::needless_range_loop,
    reason = "vector code is made of loops over lanes"
)]
fn add_blocks<const N: usize>(
    [values, sizes, errors]: &mut [Lanes; 3],
    x: [[Lanes; 3]; N],
    w: [[Lanes; 3]; N],
    edges: &[EdgeWithError],
    inverse_square: f64,
) {
    let vector = |[x, y, z]: &[Lanes; 3], l: usize| Vector([x[l], y[l], z[l]]);
    let (mut before, mut lengths) = ([[0.0; LANES]; N], [[0.0; LANES]; N]);
    for n in 0..N {
        for l in 0..LANES {
            lengths[n][l] = vector(&w[n], l).length();
        }
    }
    if let Some((first, _)) = edges.first() {
        for n in 0..N {
            for l in 0..LANES {
                let a = first.ends[0].minus(vector(&x[n], l));
                before[n][l] = log_distance(a, inverse_square);
            }
        }
    }
    for (edge, error) in edges {
        let ([start, end], direction, length) = (edge.ends, edge.direction, edge.length);
        for l in 0..LANES {
            let (mut a, mut c) = ([start; N], [end; N]);
            let (mut heights, mut squares) = ([0.0; N], [0.0; N]);
            let mut points = [[0.0; 2]; N];
            for n in 0..N {
                let point = vector(&x[n], l);
                (a[n], c[n]) = (start.minus(point), end.minus(point));
                squares[n] = scaled_square(c[n], inverse_square);
                heights[n] = a[n].cross(direction).length();
                points[n] = [heights[n] * length, a[n].dot(c[n])];
            }
            let logs = logarithms(squares);
            let angles = angles(points);
            for n in 0..N {
                let after = 0.5 * logs[n];
                let (logs, turn) = ([before[n][l], after], [heights[n], angles[n]]);
                let potential = potential([a[n], c[n]], direction, length, logs, turn);
                let weight = vector(&w[n], l).dot(direction);
                values[l] += weight * potential;
                sizes[l] += lengths[n][l] * potential.abs();
                errors[l] += weight.abs() * error;
                before[n][l] = after;
            }
        }
    }
}

/// Potentials of single edges at single points, a vector of them at a time.
#[derive(Debug, Default)]
pub(crate) struct Batch {
    /// Points, ends, directions and lengths.
    blocks: Vec<[Lanes; 13]>,
    len: usize,
    /// The potentials, in the order in which they were asked for.
    pub values: Vec<f64>,
}

impl Batch {
    pub(crate) fn clear(&mut self) {
        self.blocks.clear();
        self.len = 0;
    }

    pub(crate) fn ask(&mut self, edge: &Edge<f64>, point: Vector<f64>) {
        let [[px, py, pz], [sx, sy, sz], [ex, ey, ez], [dx, dy, dz]] =
            [point.0, edge.ends[0].0, edge.ends[1].0, edge.direction.0];
        let numbers = [px, py, pz, sx, sy, sz, ex, ey, ez, dx, dy, dz, edge.length];
        let lane = self.len % LANES;
        if lane == 0 {
            self.blocks.push([[0.0; LANES]; 13]);
        }
        if let Some(block) = self.blocks.last_mut() {
            for (column, number) in block.iter_mut().zip(numbers) {
                column[lane] = number;
            }
        }
        self.len += 1;
    }

    /// Computes all that was asked for.
    pub(crate) fn answer(&mut self, inverse_square: f64) {
        self.values.resize(self.blocks.len() * LANES, 0.0);
        let (blocks, values) = (self.blocks.as_slice(), self.values.as_mut_slice());
        vectorised(
            #[inline(always)]
            move || {
                for (block, out) in blocks.iter().zip(values.chunks_exact_mut(LANES)) {
                    let block = *block;
                    let mut lanes = [0.0; LANES];
                    for l in 0..LANES {
                        let vector =
                            |k: usize| Vector([block[k][l], block[k + 1][l], block[k + 2][l]]);
                        let edge = Edge {
                            ends: [vector(3), vector(6)],
                            direction: vector(9),
                            length: block[12][l],
                        };
                        lanes[l] = edge.potential(vector(0), inverse_square);
                    }
                    out.copy_from_slice(&lanes);
                }
            },
        );
    }
}
