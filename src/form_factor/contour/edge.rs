//! Edges, with bounds on the errors of the quantities computed from them.

use crate::geometry::Vector;
use crate::numeric::functions::elementary::{ROUGH_LN_ERROR, rough_ln};
use crate::numeric::{LANES, Lanes, Scalar, vectorised};
use std::f64::consts::FRAC_PI_2;

/// An edge, from start to end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Edge<S> {
    pub ends: [Vector<S>; 2],
    pub direction: Vector<S>,
    pub length: S,
}

impl<S: Scalar + Copy> Edge<S> {
    #[inline(always)]
    pub(crate) fn new(start: Vector<S>, end: Vector<S>) -> Self {
        let along = end.minus(start);
        let length = along.length();
        Self {
            ends: [start, end],
            direction: along.times(length.constant(1.0) / length),
            length,
        }
    }

    #[inline(always)]
    pub(crate) fn at(&self, t: S) -> Vector<S> {
        self.ends[0].plus(self.direction, t * self.length)
    }

    /// A lower bound on the squared distance of a point.
    #[inline(always)]
    pub(crate) fn squared_distance(&self, point: Vector<S>) -> f64 {
        let from_start = point.minus(self.ends[0]);
        let along = from_start.dot(self.direction).to_f64();
        let nearest = along.max(0.0).min(self.length.to_f64());
        let beside = from_start.plus(self.direction, self.length.constant(-nearest));
        beside.dot(beside).to_f64() * (1.0 - 16.0 * f64::EPSILON)
    }
}

/// A lower bound on the sum of half-axes of ellipses about a line that leave an edge outside, from
/// the squared distances of its start, middle and end from the edge: for a point y of that,
/// `(|y − start| + |y − end|)² = 2 |y − middle|² + length²/2 + 2 |y − start| |y − end|`.
#[inline(always)]
pub(crate) fn half_axes([from_start, from_middle, from_end]: [f64; 3], length: f64) -> f64 {
    let to_ends = (from_start * from_end).sqrt();
    let square = 2.0 * from_middle + 0.5 * length * length + 2.0 * to_ends;
    square.max(4.0 * from_middle).sqrt() / length * (1.0 - 8.0 * f64::EPSILON)
}

/// Edges side by side, as vectors take them.
#[derive(Debug, Default)]
pub(crate) struct Columns(Vec<[Lanes; 7]>);

impl Columns {
    /// Puts edges in place of those before; what is left of the last vector repeats them.
    pub(crate) fn fill(&mut self, edges: &[Edge<f64>]) {
        self.0
            .resize(edges.len().div_ceil(LANES), [[0.0; LANES]; 7]);
        for (block, edges) in self.0.iter_mut().zip(edges.chunks(LANES)) {
            for lane in 0..LANES {
                let edge = &edges[lane % edges.len()];
                let ([[x, y, z], [u, v, w]], length) =
                    ([edge.ends[0].0, edge.direction.0], edge.length);
                for (column, number) in block.iter_mut().zip([x, y, z, u, v, w, length]) {
                    column[lane] = number;
                }
            }
        }
    }

    /// A line's middle's least squared distance; at the end of `outside`, the [`half_axes`] that
    /// leave each edge outside.
    pub(crate) fn distances_from(&self, line: &Edge<f64>, outside: &mut Vec<Lanes>) -> f64 {
        let points = [line.ends[0], line.at(0.5), line.ends[1]];
        let length = line.length;
        let before = outside.len();
        outside.resize(before + self.0.len(), [0.0; LANES]);
        let mut nearest = [f64::INFINITY; LANES];
        let (columns, out) = (self.0.as_slice(), (&mut outside[before..], &mut nearest));
        vectorised(
            #[inline(always)]
            move || {
                for (block, outside) in columns.iter().zip(out.0) {
                    let (block, mut least, mut bounds) = (*block, *out.1, [0.0; LANES]);
                    for l in 0..LANES {
                        let vector =
                            |k: usize| Vector([block[k][l], block[k + 1][l], block[k + 2][l]]);
                        let edge = Edge {
                            ends: [vector(0); 2],
                            direction: vector(3),
                            length: block[6][l],
                        };
                        let squares = points.map(|point| edge.squared_distance(point));
                        least[l] = least[l].min(squares[1]);
                        bounds[l] = half_axes(squares, length);
                    }
                    (*outside, *out.1) = (bounds, least);
                }
            },
        );
        nearest.into_iter().fold(f64::INFINITY, f64::min)
    }
}

/// An integral over two edges, and a bound on its error.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PairIntegral<S> {
    pub value: S,
    pub error: f64,
}

/// The unit of lengths under the logarithm, and the accuracy of numbers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Precision<S> {
    /// One over the unit of length squared.
    pub inverse_square: S,
    /// `max r |ln(r/unit)|` over all distances.
    pub largest_log: f64,
    /// The largest `|ln(r/unit)|`, infinite if they touch.
    largest_ratio: f64,
    reach: f64,
    pub epsilon: f64,
}

impl<S: Scalar + Copy> Precision<S> {
    /// The precision for distances from `gap` (0 if they touch) to `reach`.
    ///
    /// `r |ln(r/unit)|` is at most `reach ln(reach/unit)` beyond the unit, and `unit/e` below it,
    /// or what it is at the gap. The two are equal for `ln(reach/unit) = 0.2785`, or where the gap
    /// is larger than that leaves open, `gap/(gap + reach)` times the logarithm of their ratio.
    pub(crate) fn new(gap: f64, reach: f64, like: S, epsilon: f64) -> Self {
        const BALANCE: f64 = 0.2785;
        let above = if gap > BALANCE * reach {
            gap / (gap + reach) * rough_ln(reach / gap)
        } else {
            BALANCE
        };
        // near e^−above; what it is exactly does not matter
        let unit = reach / (1.0 + above * (1.0 + 0.5 * above));
        let log = |ratio: f64| {
            if ratio < f64::INFINITY {
                rough_ln(ratio) + ROUGH_LN_ERROR
            } else {
                ratio
            }
        };
        let (beyond, below) = (log(reach / unit), log(unit / gap));
        let lowest = if below < 1.0 {
            gap * below
        } else {
            0.368 * unit
        };
        Self {
            inverse_square: like.constant(1.0 / (unit * unit)),
            largest_log: f64::max(reach * beyond, lowest),
            largest_ratio: f64::max(beyond, below),
            reach,
            epsilon,
        }
    }

    /// The error of the potential of an edge whose ends are within `projected` along it, and
    /// subtend at most so much that `θ/sin θ` is `widening`.
    pub(crate) fn of_potential(&self, projected: f64, length: f64, widening: f64) -> f64 {
        let logs = 5.0 * projected + 18.0 * self.largest_log;
        0.5 * self.epsilon * (logs + (12.0 + 12.0 * widening.min(FRAC_PI_2)) * length)
    }

    /// The largest magnitude of the potential of an edge: with the largest distance for a unit it
    /// is greatest for a point in the middle of an edge twice as long, `∫ ln(unit/r) = 2 unit`.
    pub(crate) fn largest_potential(&self, length: f64) -> f64 {
        (length * self.largest_ratio).min(2.0 * self.reach)
    }

    /// The error of the potential of an edge at any point, for distances up to `reach`.
    pub(crate) fn of_any_potential(&self, reach: f64, length: f64) -> f64 {
        self.of_potential(reach, length, FRAC_PI_2)
    }
}
