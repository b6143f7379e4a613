//! Gauss rules along a stretch on which the boundary keeps its shape, each with a bound.
//!
//! ```text
//!   W(t) = Σ (v·u) (s1 ln|X1| − s0 ln|X0| + d θ)     over the sides of the boundary, X = x − y
//! ```
//!
//! The corners X are rational functions of t, of degree at most 2. Where they stay within δ of
//! their places at a panel's middle as t takes complex values up to R from it, and r is the least
//! distance of a side from y,
//!
//! ```text
//!   |∫ ½ ln q ds| ≤ max |ln r| + ½ |ln(1 − κ)|,     κ = 2 δ/r + (δ/r)² < 1,   q = X·X on the side
//!   |W| ≤ M = Σ (|v·ΔX| + 2 |v| δ) (max |ln r| + ½ |ln(1 − κ)|)
//! ```
//!
//! so that a rule with n points on a panel of half the length H errs by at most
//! `(64/15) M H ρ^(−2n)/(1 − ρ^(−2))` with `ρ + 1/ρ = 2 R/H`. As ∮dX = 0, distances may be taken in
//! any unit, and in units of h(t), too: then nothing is singular as y comes down to P.
//!
//! On an edge in P's plane the sides on lines through y have `(v·X1) ln|X1| − (v·X0) ln|X0|`.

use super::arrangement::{Arrangement, Segment};
use super::corner::Corner;
use super::share::Share;
use super::sight::Sight;
use crate::numeric::functions::elementary::{angle, ln};
use crate::numeric::{GaussLegendre, real};
use glam::DVec2;

/// A side of the boundary: its corners, and whether its line goes through y.
#[derive(Debug, Clone, Copy)]
struct BoundarySide {
    corners: [usize; 2],
    is_through: bool,
}

/// A boundary on a panel.
#[derive(Debug)]
pub(super) struct Panel<'a> {
    sight: &'a Sight,
    middle: f64,
    half: f64,
    corners: Vec<Corner>,
    sides: Vec<BoundarySide>,
    /// The unit of distances.
    unit: f64,
}

impl<'a> Panel<'a> {
    pub(super) fn new(sight: &'a Sight, arrangement: &Arrangement, [from, to]: [f64; 2]) -> Self {
        let middle = 0.5 * (from + to);
        let mut panel = Self {
            sight,
            middle,
            half: 0.5 * (to - from),
            corners: Vec::new(),
            sides: Vec::new(),
            unit: 1.0,
        };
        let mut named: Vec<[usize; 2]> = Vec::new();
        for Segment { line, from, to } in &arrangement.segments {
            let corners = [*from, *to].map(|other| {
                let pair = [*line.min(&other), *line.max(&other)];
                named
                    .iter()
                    .position(|known| *known == pair)
                    .unwrap_or_else(|| {
                        named.push(pair);
                        panel.corners.push(Corner::at_crossing(sight, pair, middle));
                        named.len() - 1
                    })
            });
            panel.sides.push(BoundarySide {
                corners,
                is_through: panel.is_through(*line),
            });
        }
        panel.unit = panel.mean_distance();
        panel
    }

    /// Whether the sides go round.
    pub(super) fn is_closed(&self) -> bool {
        let height = self.height(self.middle);
        let places: Vec<DVec2> = self.corners.iter().map(|c| c.at(0.0, height)).collect();
        let runs = self.sides.iter().map(|side| {
            let [from, to] = side.corners.map(|corner| places[corner]);
            to - from
        });
        let (open, length) = runs.fold((DVec2::ZERO, 0.0), |(sum, length), run| {
            (sum + run, length + run.length())
        });
        let reach = places
            .iter()
            .map(|place| place.length())
            .fold(0.0, f64::max);
        open.length() <= CLOSED * length + 64.0 * f64::EPSILON * reach
    }

    /// Whether a line goes through y all along.
    fn is_through(&self, line: usize) -> bool {
        self.sight.is_level && self.sight.traces[line].edge.is_none()
    }

    fn height(&self, t: f64) -> f64 {
        self.sight.start.z + t * self.sight.along.z
    }

    /// A geometric mean of the distances of sides and corners from y.
    fn mean_distance(&self) -> f64 {
        let height = self.height(self.middle);
        let places: Vec<DVec2> = self.corners.iter().map(|c| c.at(0.0, height)).collect();
        let (mut least, mut most) = (f64::INFINITY, 0.0f64);
        for side in &self.sides {
            let ends = side.corners.map(|corner| places[corner]);
            if !side.is_through {
                least = least.min(distance(ends, height));
            }
            for end in ends {
                let length = end.length().hypot(height);
                most = most.max(length);
                if length > 0.0 {
                    least = least.min(length);
                }
            }
        }
        let mean = (least * most).sqrt();
        if mean.is_finite() && mean > 0.0 {
            mean
        } else {
            1.0
        }
    }

    /// A bound on |W| for complex t up to `reach` from the middle.
    fn largest(&self, reach: f64) -> f64 {
        let by_distance = self.largest_in(reach, false);
        if self.sight.is_level {
            return by_distance;
        }
        by_distance.min(self.largest_in(reach, true))
    }

    fn largest_in(&self, reach: f64, is_per_height: bool) -> f64 {
        let (v, rise) = (
            self.sight.along.truncate(),
            self.sight.along.z.abs() * reach,
        );
        let height = self.height(self.middle).abs();
        let least_height = height - rise;
        if is_per_height && least_height <= 0.0 {
            return f64::INFINITY;
        }
        let places = self.corners.iter().map(|corner| {
            let place = corner.per_denominator();
            let moved = corner.displacement(place, reach);
            match (corner.is_per_height, is_per_height) {
                (true, false) => (
                    height * place,
                    (height + rise) * moved + place.length() * rise,
                ),
                (false, true) => {
                    let place = place / height;
                    (place, (moved + place.length() * rise) / least_height)
                }
                _ => (place, moved),
            }
        });
        let places: Vec<(DVec2, f64)> = places.collect();
        let (level, tilt, unit) = if is_per_height {
            (1.0, 0.0, self.unit / height)
        } else {
            (height, rise, self.unit)
        };
        let mut sum = 0.0;
        for side in &self.sides {
            let [(from, from_moved), (to, to_moved)] = side.corners.map(|corner| places[corner]);
            if side.is_through {
                for (end, moved) in [(from, from_moved), (to, to_moved)] {
                    let distance = end.length();
                    if distance > 0.0 {
                        sum += (v.dot(end).abs() + v.length() * moved)
                            * log_bound([distance; 2], moved, unit);
                    }
                }
                continue;
            }
            let moved = from_moved.max(to_moved).hypot(tilt);
            let nearest = distance([from, to], level);
            let farthest = from.length().max(to.length()).hypot(level);
            let along = v.dot(to - from).abs() + v.length() * (from_moved + to_moved);
            sum += along * log_bound([nearest, farthest], moved, unit);
        }
        if is_per_height {
            (height + rise) * sum
        } else {
            sum
        }
    }

    /// The integral over the panel; none if no rule is certain enough.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "small"
    )]
    pub(super) fn integral(&self, wanted: f64) -> Option<Share> {
        if self.sides.is_empty() {
            return Some(Share::default());
        }
        let mut best: Option<(usize, f64)> = None;
        for ratio in RATIOS {
            let largest = self.largest(ratio * self.half);
            if !largest.is_finite() {
                break;
            }
            let rho = ratio + (ratio * ratio - 1.0).sqrt();
            let scale = 64.0 / 15.0 * largest * self.half / (1.0 - 1.0 / (rho * rho));
            let points = ((scale / wanted).ln() / (2.0 * rho.ln())).ceil().max(1.0);
            if points <= MOST && best.is_none_or(|(known, _)| points < real(known)) {
                let points = points as usize;
                let error = scale * (-2.0 * real(points) * rho.ln()).exp();
                best = Some((points, error));
            }
        }
        let (points, truncation) = best?;
        let rule = GaussLegendre::with(points);
        let [mut value, mut size] = [0.0; 2];
        for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
            let [own, magnitude] = self.potential(self.half * node);
            value += weight * own;
            size += weight * magnitude;
        }
        Some(Share {
            value: self.half * value,
            truncation,
            rounding: self.half * (8.0 * f64::EPSILON * size + 2.0 * self.crossing_noise()),
        })
    }

    /// What rounded corners change of W.
    fn crossing_noise(&self) -> f64 {
        let height = self.height(self.middle).abs();
        let speed = self.sight.along.truncate().length();
        let places: Vec<DVec2> = self.corners.iter().map(|c| c.at(0.0, height)).collect();
        let noise = |corner: usize| {
            let corner = &self.corners[corner];
            corner.noise * if corner.is_per_height { height } else { 1.0 }
        };
        let sides = self.sides.iter().map(|side| {
            let ends = side.corners.map(|corner| places[corner]);
            let moved: f64 = side.corners.iter().map(|corner| noise(*corner)).sum();
            if side.is_through {
                return moved * (1.0 + (ends[0].length() / self.unit).max(1e-300).ln().abs());
            }
            let nearest = distance(ends, height);
            moved
                * (ends[0].distance(ends[1]) / nearest).min(1.0 + (self.unit / nearest).ln().abs())
        });
        speed * sides.sum::<f64>()
    }

    /// W at a place relative to the middle, and the sum of its terms' magnitudes.
    fn potential(&self, tau: f64) -> [f64; 2] {
        let height = self.height(self.middle + tau);
        let v = self.sight.along.truncate();
        let places: Vec<DVec2> = self.corners.iter().map(|c| c.at(tau, height)).collect();
        let inverse = 1.0 / (self.unit * self.unit);
        let log = |place: DVec2| {
            0.5 * ln((place.length_squared() + height * height) * inverse + f64::MIN_POSITIVE)
        };
        let [mut sum, mut size] = [0.0; 2];
        for side in &self.sides {
            let [from, to] = side.corners.map(|corner| places[corner]);
            let run = to - from;
            let length = run.length();
            if length <= 0.0 {
                continue;
            }
            let u = run / length;
            let (s0, s1) = (from.dot(u), to.dot(u));
            let (start, end) = (s0 * log(from), s1 * log(to));
            let turn = if side.is_through {
                0.0
            } else {
                let beside = from.perp_dot(u).hypot(height);
                beside * angle(beside * length, from.dot(to) + height * height)
            };
            let along = v.dot(u);
            sum += along * (end - start + turn);
            size += along.abs() * (end.abs() + start.abs() + turn + length);
        }
        [sum, size]
    }
}

/// The gap that rounding may leave in a boundary, of its length.
const CLOSED: f64 = 1e-9;

/// Radii of discs, in halves of a panel.
const RATIOS: [f64; 7] = [1.3, 1.7, 2.4, 3.5, 5.0, 8.0, 14.0];

/// Most points of a rule.
const MOST: f64 = 24.0;

/// The least distance of y from a side that is `height` below it.
fn distance([from, to]: [DVec2; 2], height: f64) -> f64 {
    let run = to - from;
    let square = run.length_squared();
    let share = if square > 0.0 {
        (-from.dot(run) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from + share * run).length().hypot(height)
}

/// A bound on |ln(r/unit)| between two distances that may be displaced.
fn log_bound([nearest, farthest]: [f64; 2], moved: f64, unit: f64) -> f64 {
    let share = moved / nearest;
    let kappa = share * (2.0 + share);
    if kappa.is_nan() || kappa >= 0.95 {
        return f64::INFINITY;
    }
    let log = (nearest / unit)
        .ln()
        .abs()
        .max((farthest / unit).ln().abs());
    log - 0.5 * (1.0 - kappa).ln()
}
