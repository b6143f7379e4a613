//! `∫∫ ln|x − y| dx dy` over a pair of edges.
//!
//! Edges on lines that meet: with s, t measured from the meeting point, r² is homogeneous, so that
//!
//! ```text
//!   ∫∫ (2 ln r + 1) ds dt = s1 U(x(s1)) − s0 U(x(s0)) + t1 V(y(t1)) − t0 V(y(t0))
//!   s = (w×v)·(u×v)/|u×v|²,  t = (w×u)·(u×v)/|u×v|²        (w = A − B from the nearest ends A, B, where s and t are)
//! ```
//!
//! where U and V are the [potentials](super::potential) of the two edges. Parallel edges, h apart, p and q along them:
//!
//! ```text
//!   ∫∫ ½ ln((p−q)² + h²) = Σ ± G(p − q),   G(w) = ((w² − h²)/4) ln(w² + h²) + h w atan(w/h) − ¾ w²
//! ```
//!
//! Lines that miss each other by δ count as meeting if δ is lost in rounding: with true and computed r² apart by δ² at
//! most, `∫ ½ ln(1 + δ²/t²) dt = π δ` bounds what each potential is off by. Skew edges near to each other are cut into
//! panels, graded towards the other one, until a [Gauss rule](gauss_error) is certain on each.
//!
//! Edges that run beside each other need fewer panels than their distance suggests: as a function of a complex t along the
//! outer line, the potential of the inner edge is singular only at its ends (r = 0 there), and where the distance of the
//! lines' points h² = miss² + sin²θ (t − t*)² vanishes, `t* ± i miss/sin θ`. On an ellipse inside all of them its terms are bounded
//! by 60 times the largest distance, in units of it.

#![allow(
    clippy::inline_always,
    reason = "the machine code is made where it is called"
)]

use super::potential::{log_distance, potential};
use crate::geometry::Vector;
use crate::numeric::{GaussLegendre, MOST_POINTS, Scalar};
use smallvec::SmallVec;
use std::f64::consts::PI;

/// An edge, from start to end.
#[derive(Debug, Clone, Copy)]
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
    fn at(&self, t: S) -> Vector<S> {
        self.ends[0].plus(self.direction, t * self.length)
    }

    /// Its potential at a point.
    #[inline(always)]
    pub(super) fn potential(&self, point: Vector<S>, inverse_square: S) -> S {
        let [a, c] = self.ends.map(|end| end.minus(point));
        let logs = [a, c].map(|end| log_distance(end, inverse_square));
        potential(a, c, self.direction, self.length, logs)
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
    pub epsilon: f64,
}

impl<S: Scalar + Copy> Precision<S> {
    /// For distances from `gap` (0 if they touch) to `reach`: `x |ln x|` is at most 1/e below 1.
    pub(super) fn new(gap: f64, reach: f64, like: S, epsilon: f64) -> Self {
        const BELOW_ONE: f64 = 0.368;
        let half_range = if gap > 0.0 {
            0.5 * (reach / gap).ln()
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
            epsilon,
        }
    }

    /// The error of the potential of an edge whose ends are within `projected` along it, and subtend at most so much that
    /// `θ/sin θ` is `widening`.
    pub(super) fn of_potential(&self, projected: f64, length: f64, widening: f64) -> f64 {
        let logs = 5.0 * projected + 18.0 * self.largest_log;
        0.5 * self.epsilon * (logs + (12.0 + 12.0 * widening) * length)
    }

    /// The same wherever the point is, for distances up to `reach`.
    pub(super) fn of_any_potential(&self, reach: f64, length: f64) -> f64 {
        self.of_potential(reach, length, PI)
    }
}

/// How two edges lie to each other.
#[derive(Debug, Clone, Copy)]
pub(super) enum Relation<S> {
    /// On lines that meet, as far as rounding tells, or are parallel.
    Coplanar(Coplanar<S>),
    /// On lines that miss each other, or meet too far away.
    Skew,
}

/// Two edges in one plane.
#[derive(Debug, Clone, Copy)]
pub(super) enum Coplanar<S> {
    /// The coordinates of their ends from where their lines meet.
    Meeting {
        s: [S; 2],
        t: [S; 2],
        /// How far the lines miss each other.
        miss: f64,
        /// How far the meeting point may be off.
        shift: f64,
        reach: f64,
    },
    /// Parallel, this far apart; the sine is what is left of their angle.
    Parallel { apart: S, sine: f64 },
}

/// What is lost in rounding: the sine of an angle, and the distance of two lines. Edges within both are taken as coplanar, and
/// the error of that is bounded.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rounding {
    pub epsilon: f64,
    pub sine: f64,
    pub miss: f64,
}

impl Rounding {
    /// Of coordinates up to `largest`, `factor` roundings of `epsilon` each.
    pub(super) const fn new(epsilon: f64, factor: f64, largest: f64) -> Self {
        let sine = factor * epsilon;
        Self {
            epsilon,
            sine,
            miss: sine * largest,
        }
    }
}

/// How two edges lie to each other.
#[inline(always)]
pub(super) fn relation<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    Rounding {
        epsilon,
        sine: straight,
        miss: touching,
    }: Rounding,
) -> Relation<S> {
    let across = a.direction.cross(b.direction);
    let square = across.dot(across);
    let sine = square.sqrt().to_f64();
    let between = |i: usize, j: usize| a.ends[i].minus(b.ends[j]);
    let distances = [[0, 1], [2, 3]]
        .map(|row: [usize; 2]| row.map(|k| between(k / 2, k % 2).length().to_f64()));
    let reach = distances
        .as_flattened()
        .iter()
        .fold(0.0, |most: f64, r| most.max(*r));
    let (mut i, mut j) = (0, 0);
    for (k, l) in [(0, 1), (1, 0), (1, 1)] {
        if distances[k][l] < distances[i][j] {
            (i, j) = (k, l);
        }
    }
    let (w, near) = (between(i, j), distances[i][j]);
    if sine <= straight {
        let apart = if near > 0.0 {
            w.cross(a.direction).length()
        } else {
            a.length.zero()
        };
        return Relation::Coplanar(Coplanar::Parallel { apart, sine });
    }
    let miss = w.dot(across).to_f64().abs() / sine;
    if miss > touching {
        return Relation::Skew;
    }
    let s = w.cross(b.direction).dot(across) / square;
    let t = w.cross(a.direction).dot(across) / square;
    let nearest = s.to_f64().abs().max(t.to_f64().abs());
    if nearest > 4.0 * a.length.to_f64().max(b.length.to_f64()) {
        return Relation::Skew;
    }
    let shift = 4.0 * epsilon * (near + s.to_f64().abs() + t.to_f64().abs()) / sine;
    let ends = |near: S, k: usize, length: S| {
        if k == 0 {
            [near, near + length]
        } else {
            [near - length, near]
        }
    };
    let (s, t) = (ends(s, i, a.length), ends(t, j, b.length));
    Relation::Coplanar(Coplanar::Meeting {
        s,
        t,
        miss,
        shift,
        reach,
    })
}

/// The closed form of two edges in one plane, from the potentials of each at the other's ends.
#[inline(always)]
pub(super) fn coplanar<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    relation: Coplanar<S>,
    at_a: [S; 2],
    at_b: [S; 2],
    precision: Precision<S>,
) -> PairIntegral<S> {
    let (s, t, miss, shift, reach) = match relation {
        Coplanar::Parallel { apart, sine } => return parallel([a, b], apart, sine, precision),
        Coplanar::Meeting {
            s,
            t,
            miss,
            shift,
            reach,
        } => (s, t, miss, shift, reach),
    };
    let boundary = s[1] * at_a[1] - s[0] * at_a[0] + t[1] * at_b[1] - t[0] * at_b[0];
    let value = (boundary - a.length * b.length) * boundary.constant(0.5);
    let weights: f64 = [s, t].as_flattened().iter().map(|x| x.to_f64().abs()).sum();
    let potentials: f64 = [at_a, at_b]
        .as_flattened()
        .iter()
        .map(|u| u.to_f64().abs())
        .sum();
    let (a_length, b_length) = (a.length.to_f64(), b.length.to_f64());
    let longer = a_length.max(b_length);
    // s and t shift together by what the meeting point is off
    let error = 0.5 * weights * (precision.of_any_potential(reach, longer) + 2.0 * PI * miss)
        + 0.5 * shift * potentials
        + 2.0 * precision.epsilon * (weights * potentials / 4.0 + a_length * b_length);
    PairIntegral { value, error }
}

#[inline(always)]
fn parallel<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    apart: S,
    sine: f64,
    precision: Precision<S>,
) -> PairIntegral<S> {
    let number = |x: f64| a.length.constant(x);
    let along = a.direction.dot(b.direction).to_f64() > 0.0;
    let h2 = apart * apart;
    let mut sum = number(0.0);
    let mut size = 0.0;
    for (i, start) in a.ends.into_iter().enumerate() {
        for (j, end) in b.ends.into_iter().enumerate() {
            let p = start.minus(end).dot(a.direction);
            let p2 = p * p;
            let log = log_distance(Vector([p, apart, number(0.0)]), precision.inverse_square);
            let term =
                (p2 - h2) * number(0.5) * log + apart * p * p.atan2(&apart) - p2 * number(0.75);
            // + for the differences p1 − q_min and p0 − q_max
            let positive = (i == j) != along;
            sum = if positive { sum + term } else { sum - term };
            size += (p2 + h2).to_f64() * (log.to_f64().abs() + 4.0);
        }
    }
    // a turn by the sine moves a point of one by at most that times its length, against all of the other
    let turned = 2.0 * PI * sine * a.length.to_f64() * b.length.to_f64();
    PairIntegral {
        value: sum,
        error: 4.0 * precision.epsilon * size + turned,
    }
}

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
    let points = (-error.ln() / (2.0 * rho.ln())).ceil().clamp(2.0, 200.0) as usize;
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
        let ends = [from, to].map(|t| outer.at(t));
        let to_ends = inner.ends.map(|end| {
            ends.map(|x| end.minus(x).length().to_f64())
                .iter()
                .sum::<f64>()
        });
        let to_pinch = [from, to]
            .map(|t| (along - t * outer.length).to_f64().hypot(aside) - unsure)
            .iter()
            .sum::<f64>();
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
            let points = ((largest / share).ln() / (2.0 * rho.ln()))
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

/// Skew edges: Gauss rules on the panels of the shorter one; `None` if they do not settle.
#[inline(always)]
pub(super) fn skew<S: Scalar + Copy>(
    [a, b]: [&Edge<S>; 2],
    wanted: f64,
    precision: Precision<S>,
) -> Option<PairIntegral<S>> {
    let (outer, inner) = if a.length <= b.length { (a, b) } else { (b, a) };
    let number = |x: f64| a.length.constant(x);
    let (mut value, mut error) = (number(0.0), 0.0);
    for panel in panels(outer, inner, wanted, precision.epsilon)? {
        let half = number(panel.half);
        let mut sum = number(0.0);
        for [x, weight] in &GaussLegendre::with(panel.points).precise {
            let [t, weight] = [x, weight].map(|x| number(x.high()) + number(x.low()));
            let point = outer.at(panel.middle + half * t);
            sum = sum + weight * inner.potential(point, precision.inverse_square);
        }
        value = value + sum * half * outer.length;
        error += panel.error;
    }
    let reach = a
        .ends
        .iter()
        .flat_map(|x| b.ends.map(|y| x.minus(y).length().to_f64()))
        .fold(0.0, f64::max);
    let (outer, inner) = (outer.length.to_f64(), inner.length.to_f64());
    let error = outer * (error * inner + precision.of_any_potential(reach, inner));
    Some(PairIntegral { value, error })
}
