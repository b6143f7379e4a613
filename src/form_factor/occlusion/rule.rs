//! Gauss rules along a stretch on which the boundary keeps its shape, each with a bound.
//!
//! ```text
//!   W(t) = Σ (v·u) (s1 ln|X1| − s0 ln|X0| + d θ)     over the sides of the boundary, X = x − y
//! ```
//!
//! With a bound M on |W| for complex t up to R from a panel's middle ([`Outline`]),
//! a rule with n points on a panel of half the length H errs by at most
//! `(64/15) M H ρ^(−2n)/(1 − ρ^(−2))` with `ρ + 1/ρ = 2 R/H`.
//!
//! On an edge in P's plane the sides on lines through y have `(v·X1) ln|X1| − (v·X0) ln|X0|`.

use super::arrangement::{Arrangement, Segment};
use super::bound::{BoundarySide, Outline, distance};
use super::corner::Corner;
use super::share::Share;
use super::sight::Sight;
use crate::numeric::functions::elementary::angles;
use crate::numeric::{GaussLegendre, LANES, Lanes, across, real, vector_value};
use glam::DVec2;
use smallvec::{SmallVec, smallvec};

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
        let stretch = [self.height(self.middle).abs(), self.sight.along.z.abs()];
        let v = self.sight.along.truncate();
        let outlines = [false, true].map(|is_per_height| {
            // on an edge in P's plane no height is a unit
            let is_one = !(is_per_height && self.sight.is_level);
            let outline = || Outline::new(&self.corners, &self.sides, v, stretch, self.unit);
            is_one.then(|| {
                if is_per_height {
                    outline().per_height()
                } else {
                    outline()
                }
            })
        });
        for ratio in RATIOS {
            let bounds = outlines.iter().flatten();
            let bounds = bounds.map(|outline| outline.largest(ratio * self.half));
            let largest = bounds.fold(f64::INFINITY, f64::min);
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
        let [value, size] = self.sums(GaussLegendre::with(points));
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

    /// The rule's sums of W and of the magnitudes of its terms.
    fn sums(&self, rule: &GaussLegendre) -> [f64; 2] {
        let (corners, sides) = (self.corners.as_slice(), self.sides.as_slice());
        let (start, rise) = (self.height(self.middle), self.sight.along.z);
        let v = self.sight.along.truncate();
        let inverse = 1.0 / (self.unit * self.unit);
        let (half, lanes) = (self.half, rule.lanes.as_slice());
        let mut places: SmallVec<[[Lanes; 3]; 16]> = smallvec![[[0.0; LANES]; 3]; corners.len()];
        let places = places.as_mut_slice();
        let sums = vector_value!([[0.0; LANES]; 2], {
            let mut sums = [[0.0; LANES]; 2];
            for [nodes, weights] in lanes {
                let (mut tau, mut height) = ([0.0; LANES], [0.0; LANES]);
                for l in 0..LANES {
                    tau[l] = half * nodes[l];
                    height[l] = start + rise * tau[l];
                }
                for (place, corner) in places.iter_mut().zip(corners) {
                    *place = corner.lanes(&tau, &height, inverse);
                }
                for side in sides {
                    let ends = side.corners.map(|corner| places[corner]);
                    let terms = potential(ends, &height, [v.x, v.y], side.is_through);
                    for l in 0..LANES {
                        sums[0][l] += weights[l] * terms[0][l];
                        sums[1][l] += weights[l] * terms[1][l];
                    }
                }
            }
            sums
        });
        sums.map(across)
    }
}

/// The terms of W of one side, and their magnitudes, from its ends `[x, y, ln r]`.
#[inline(always)]
fn potential(
    [from, to]: [[Lanes; 3]; 2],
    height: &Lanes,
    v: [f64; 2],
    is_through: bool,
) -> [Lanes; 2] {
    let (mut beside, mut length) = ([0.0; LANES], [0.0; LANES]);
    let mut direction = [[0.0; LANES]; 2];
    let mut points = [[0.0; 2]; LANES];
    for l in 0..LANES {
        let (a, b) = ([from[0][l], from[1][l]], [to[0][l], to[1][l]]);
        let run = [b[0] - a[0], b[1] - a[1]];
        length[l] = (run[0] * run[0] + run[1] * run[1]).sqrt();
        // nothing is integrated over a side without length
        let inverse = if length[l] > 0.0 {
            1.0 / length[l]
        } else {
            0.0
        };
        direction[0][l] = run[0] * inverse;
        direction[1][l] = run[1] * inverse;
        let aside = a[0] * direction[1][l] - a[1] * direction[0][l];
        beside[l] = (aside * aside + height[l] * height[l]).sqrt();
        let along = a[0] * b[0] + a[1] * b[1] + height[l] * height[l];
        points[l] = [beside[l] * length[l], along];
    }
    let turns = angles(points);
    let (mut sum, mut size) = ([0.0; LANES], [0.0; LANES]);
    for l in 0..LANES {
        let u = [direction[0][l], direction[1][l]];
        let start = (from[0][l] * u[0] + from[1][l] * u[1]) * from[2][l];
        let end = (to[0][l] * u[0] + to[1][l] * u[1]) * to[2][l];
        let turn = if is_through {
            0.0
        } else {
            beside[l] * turns[l]
        };
        let along = v[0] * u[0] + v[1] * u[1];
        sum[l] = along * (end - start + turn);
        size[l] = along.abs() * (end.abs() + start.abs() + turn + length[l]);
    }
    [sum, size]
}

/// The gap that rounding may leave in a boundary, of its length.
const CLOSED: f64 = 1e-9;

/// Radii of discs, in halves of a panel.
const RATIOS: [f64; 7] = [1.3, 1.7, 2.4, 3.5, 5.0, 8.0, 14.0];

/// Most points of a rule.
const MOST: f64 = 24.0;
