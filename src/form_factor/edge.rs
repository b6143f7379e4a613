//! Edges, and how well what is computed of them is known.

#![allow(
    clippy::inline_always,
    reason = "the machine code is made where it is called"
)]

use super::potential::{log_distance, potential};
use crate::geometry::Vector;
use crate::numeric::Scalar;
use crate::numeric::elementary::ln;
use std::f64::consts::PI;

/// An edge, from start to end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edge<S> {
    pub ends: [Vector<S>; 2],
    pub direction: Vector<S>,
    pub length: S,
}

impl<S: Scalar + Copy> Edge<S> {
    #[inline(always)]
    pub(super) fn new(start: Vector<S>, end: Vector<S>) -> Self {
        let along = end.minus(start);
        let length = along.length();
        Self {
            ends: [start, end],
            direction: along.times(length.constant(1.0) / length),
            length,
        }
    }

    #[inline(always)]
    pub(super) fn at(&self, t: S) -> Vector<S> {
        self.ends[0].plus(self.direction, t * self.length)
    }

    /// Its potential at a point.
    #[inline(always)]
    pub(super) fn potential(&self, point: Vector<S>, inverse_square: S) -> S {
        let (a, c) = (self.ends[0].minus(point), self.ends[1].minus(point));
        let logs = [
            log_distance(a, inverse_square),
            log_distance(c, inverse_square),
        ];
        potential(a, c, self.direction, self.length, logs)
    }

    /// A lower bound on the squared distance of a point.
    #[inline(always)]
    pub(super) fn squared_distance(&self, point: Vector<S>) -> f64 {
        let from_start = point.minus(self.ends[0]);
        let along = from_start.dot(self.direction).to_f64();
        let nearest = along.max(0.0).min(self.length.to_f64());
        let beside = from_start.plus(self.direction, self.length.constant(-nearest));
        beside.dot(beside).to_f64() * (1.0 - 16.0 * f64::EPSILON)
    }

    /// A lower bound on the distance of a point, as a double.
    #[inline(always)]
    pub(super) fn distance(&self, point: Vector<S>) -> f64 {
        let from_start = point.minus(self.ends[0]);
        let along = from_start.dot(self.direction).to_f64();
        let nearest = along.clamp(0.0, self.length.to_f64());
        let foot = self.ends[0].plus(self.direction, self.length.constant(nearest));
        point.minus(foot).length().to_f64() * (1.0 - 4.0 * f64::EPSILON)
    }
}

/// An integral over two edges, and a bound on its error.
#[derive(Debug, Clone, Copy)]
pub(super) struct PairIntegral<S> {
    pub value: S,
    pub error: f64,
}

/// What lengths are measured in under the logarithm, and how well numbers are known.
#[derive(Debug, Clone, Copy)]
pub(super) struct Precision<S> {
    /// One over the unit of length squared.
    pub inverse_square: S,
    /// `max r |ln(r/unit)|` over all distances.
    pub largest_log: f64,
    /// The largest `|ln(r/unit)|`, where it is known.
    largest_ratio: f64,
    reach: f64,
    pub epsilon: f64,
}

impl<S: Scalar + Copy> Precision<S> {
    /// For distances from `gap` (0 if they touch) to `reach`: `x |ln x|` is at most 1/e below 1.
    pub(super) fn new(gap: f64, reach: f64, like: S, epsilon: f64) -> Self {
        const BELOW_ONE: f64 = 0.368;
        let half_range = if gap > 0.0 {
            0.5 * ln(reach / gap)
        } else {
            f64::INFINITY
        };
        let (unit, log) = if half_range < BELOW_ONE {
            ((gap * reach).sqrt(), half_range)
        } else {
            (reach, BELOW_ONE)
        };
        Self {
            inverse_square: like.constant(1.0 / (unit * unit)),
            largest_log: reach * log,
            largest_ratio: if half_range < BELOW_ONE {
                half_range
            } else {
                f64::INFINITY
            },
            reach,
            epsilon,
        }
    }

    /// The error of the potential of an edge whose ends are within `projected` along it, and subtend at most so much that
    /// `θ/sin θ` is `widening`.
    pub(super) fn of_potential(&self, projected: f64, length: f64, widening: f64) -> f64 {
        let logs = 5.0 * projected + 18.0 * self.largest_log;
        0.5 * self.epsilon * (logs + (12.0 + 12.0 * widening) * length)
    }

    /// The largest magnitude of the potential of an edge: with the largest distance for a unit it is greatest for a point
    /// in the middle of an edge twice as long, `∫ ln(unit/r) = 2 unit`.
    pub(super) fn largest_potential(&self, length: f64) -> f64 {
        (length * self.largest_ratio).min(2.0 * self.reach)
    }

    /// The same wherever the point is, for distances up to `reach`.
    pub(super) fn of_any_potential(&self, reach: f64, length: f64) -> f64 {
        self.of_potential(reach, length, PI)
    }
}
