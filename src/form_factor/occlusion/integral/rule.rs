//! Gauss rules along a stretch on which the boundary keeps its shape, each with a bound.
//!
//! ```text
//!   W(t) = Σ (v·u) (s1 ln|X1| − s0 ln|X0| + d θ)     over the sides of the boundary, X = x − y
//! ```
//!
//! With a bound M on |W| for complex t up to R from a panel's middle (`reach`),
//! a rule with n points on a panel of half the length H errs by at most
//! `(64/15) M H ρ^(−2n)/(1 − ρ^(−2))` with `ρ + 1/ρ = 2 R/H`.
//!
//! On an edge in P's plane the sides on lines through y have `(v·X1) ln|X1| − (v·X0) ln|X0|`.

use super::bound::{BoundarySide, Outline};
use super::corner::Corner;
use super::share::Share;
use crate::form_factor::occlusion::shape::boundary::Arrangement;
use crate::form_factor::occlusion::shape::covers::Segment;
use crate::form_factor::occlusion::view::sight::Sight;
use crate::form_factor::occlusion::view::trace::Middle;
use crate::numeric::functions::elementary::angles;
use crate::numeric::{GaussLegendre, LANES, Lanes, across, real, vector_value};
use glam::DVec2;
use smallvec::{SmallVec, smallvec};
use std::sync::LazyLock;

/// A boundary on a panel, in memory that panels of a stretch use in turn.
#[derive(Debug)]
pub(crate) struct Panel<'a> {
    sight: &'a Sight<'a>,
    middle: Middle,
    corners: Vec<Corner>,
    /// The places of the corners at the middle.
    places: Vec<DVec2>,
    sides: Vec<BoundarySide>,
    outline: Outline,
    shifts: Vec<[f64; 2]>,
    /// The corners at the nodes of a block.
    lanes: Vec<[Lanes; 3]>,
}

impl<'a> Panel<'a> {
    /// A panel without a boundary.
    pub(crate) fn of(sight: &'a Sight<'a>) -> Self {
        Self {
            sight,
            middle: sight.middle(0.5, 0.5),
            corners: Vec::new(),
            places: Vec::new(),
            sides: Vec::new(),
            outline: Outline::along(sight.along, sight.is_level),
            shifts: Vec::new(),
            lanes: Vec::new(),
        }
    }

    pub(crate) fn new(sight: &'a Sight<'a>, arrangement: &Arrangement, range: [f64; 2]) -> Self {
        let mut panel = Self::of(sight);
        panel.set(arrangement, range);
        panel
    }

    /// Takes another boundary on another panel.
    pub(crate) fn set(&mut self, arrangement: &Arrangement, [from, to]: [f64; 2]) {
        let sight = self.sight;
        let middle = sight.middle(0.5 * (from + to), 0.5 * (to - from));
        let height = middle.height();
        self.middle = middle;
        self.corners.clear();
        self.places.clear();
        self.sides.clear();
        let mut named: SmallVec<[[usize; 2]; 16]> = SmallVec::new();
        for Segment { line, from, to } in &arrangement.segments {
            let corners = [*from, *to].map(|other| {
                let pair = [*line.min(&other), *line.max(&other)];
                let known = named.iter().position(|known| *known == pair);
                known.unwrap_or_else(|| {
                    named.push(pair);
                    let corner = Corner::at_crossing(sight, pair, &middle);
                    self.places.push(corner.at(0.0, height));
                    self.corners.push(corner);
                    named.len() - 1
                })
            });
            self.sides.push(BoundarySide {
                corners,
                // an edge in P's plane is a line of its own
                is_through: sight.is_level && sight.traces[*line].edge.is_none(),
            });
        }
    }

    /// Whether the sides go round.
    pub(crate) fn is_closed(&self) -> bool {
        let runs = self.sides.iter().map(|side| {
            let [from, to] = side.corners.map(|corner| self.places[corner]);
            from.distance(to)
        });
        let places = self.places.iter();
        let reach = places.map(|place| place.length()).fold(0.0, f64::max);
        self.gap() <= CLOSED * runs.sum::<f64>() + 64.0 * f64::EPSILON * reach
    }

    /// The width of the gap between the sides at the middle; none if each corner that ends a side
    /// begins another.
    fn gap(&self) -> f64 {
        let mut balance: SmallVec<[i32; 16]> = smallvec![0; self.corners.len()];
        let mut open = DVec2::ZERO;
        for side in &self.sides {
            let [from, to] = side.corners;
            balance[from] += 1;
            balance[to] -= 1;
            open += self.places[to] - self.places[from];
        }
        if balance.iter().all(|count| *count == 0) {
            0.0
        } else {
            open.length()
        }
    }

    /// The integral over the panel; none if no rule is certain enough.
    pub(crate) fn integral(&mut self, wanted: f64) -> Option<Share> {
        if self.sides.is_empty() {
            return Some(Share::default());
        }
        let half = self.middle.half;
        let (corners, places) = (self.corners.as_slice(), self.places.as_slice());
        let height = self.middle.height();
        self.outline.set((corners, places), &self.sides, height);
        let outline = &self.outline;
        let reach = RATIOS.map(|ratio| ratio * half);
        let largest = vector_value!([f64::INFINITY; LANES], outline.largest(&reach));
        let (blocks, truncation) = match rule(largest, half, wanted) {
            Some(found) if found.0 <= FEW => found,
            known => {
                let finer =
                    vector_value!([f64::INFINITY; LANES], outline.largest_with_slides(&reach));
                rule(finer, half, wanted).or(known)?
            }
        };
        let rest = outline.shifts(corners, half, &mut self.shifts);
        let noise = rest + outline.gap(self.gap());
        let [value, lost] = self.sums(GaussLegendre::with(blocks * LANES));
        let rounding = half * (UNIT * lost + 2.0 * noise);
        // of corners that nothing bounds smaller panels may tell more
        rounding.is_finite().then_some(Share {
            value: half * value,
            truncation,
            rounding,
        })
    }

    /// The rule's sums of W and of its rounding, in units of u.
    fn sums(&mut self, rule: &GaussLegendre) -> [f64; 2] {
        let (corners, sides) = (self.corners.as_slice(), self.sides.as_slice());
        let (shifts, unit) = (self.shifts.as_slice(), self.outline.unit);
        let (start, rise) = (self.middle.height(), self.sight.along.z);
        let v = self.sight.along.truncate();
        let inverse = 1.0 / (unit * unit);
        let (half, lanes) = (self.middle.half, rule.lanes.as_slice());
        self.lanes.resize(corners.len(), [[0.0; LANES]; 3]);
        let places = self.lanes.as_mut_slice();
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
                for (side, shift) in sides.iter().zip(shifts) {
                    let ends = side.corners.map(|corner| places[corner]);
                    let terms = potential(ends, &height, [v.x, v.y], *shift, side.is_through);
                    for l in 0..LANES {
                        sums[0][l] += weights[l] * terms[0][l];
                        sums[1][l] += weights[l] * terms[1][l] + sums[0][l].abs();
                    }
                }
            }
            sums
        });
        sums.map(across)
    }
}

/// The terms of W of one side, and their rounding in units of u, from its ends `[x, y, ln r]`.
///
/// With `s_i = X_i·u`, `l_i = s_i ln |X_i|` and `T = l_1 − l_0 + d θ`:
///
/// ```text
///   u is scaled by 4u and turned by 2u at most: 4u |l_1 − l_0|, 2u (length + |s_0| θ)
///   s is a sum of two products                  2u (|x u_x| + |y u_y|) |ln|
///   ln |X| of a square within 4u                u (2 |s| + 2 |l|), and u |l| for the product
///   d, in d θ and in sin θ                      4u (|x u_y| + |y u_x|) θ + 15u d θ with the angle
///   T, and its product with v·u                 10u |v| |T|
/// ```
///
/// A side whose corners are `moved`, and by `across` the side, sweeps over half of its length times
/// the latter.
#[inline(always)]
fn potential(
    [from, to]: [[Lanes; 3]; 2],
    height: &Lanes,
    v: [f64; 2],
    [moved, across]: [f64; 2],
    is_through: bool,
) -> [Lanes; 2] {
    let (mut beside, mut length) = ([0.0; LANES], [0.0; LANES]);
    let (mut aside, mut direction) = ([0.0; LANES], [[0.0; LANES]; 2]);
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
        let parts = [a[0] * direction[1][l], a[1] * direction[0][l]];
        let square = (parts[0] - parts[1]) * (parts[0] - parts[1]);
        aside[l] = parts[0].abs() + parts[1].abs();
        beside[l] = (square + height[l] * height[l]).sqrt();
        let along = a[0] * b[0] + a[1] * b[1] + height[l] * height[l];
        points[l] = [beside[l] * length[l], along];
    }
    let turns = angles(points);
    let speed = (v[0] * v[0] + v[1] * v[1]).sqrt();
    let (mut sum, mut lost) = ([0.0; LANES], [0.0; LANES]);
    for l in 0..LANES {
        let u = [direction[0][l], direction[1][l]];
        let [near, far] = [&from, &to].map(|end| [end[0][l] * u[0], end[1][l] * u[1]]);
        let places = [near[0] + near[1], far[0] + far[1]];
        let (start, end) = (places[0] * from[2][l], places[1] * to[2][l]);
        let angle = if is_through { 0.0 } else { turns[l] };
        let turn = beside[l] * angle;
        let total = end - start + turn;
        sum[l] = (v[0] * u[0] + v[1] * u[1]) * total;
        let summed = (near[0].abs() + near[1].abs()) * from[2][l].abs()
            + (far[0].abs() + far[1].abs()) * to[2][l].abs();
        let inner = if places[0] * places[1] > 0.0 {
            places[0].abs().min(places[1].abs())
        } else {
            0.0
        };
        // a side without length has no direction: it is as far away as its end
        let square = if length[l] > 0.0 {
            beside[l] * beside[l] + inner * inner
        } else {
            from[0][l] * from[0][l] + from[1][l] * from[1][l] + height[l] * height[l]
        };
        let nearest = square.sqrt() - moved;
        let swept = if across > 0.0 {
            (length[l] + moved) * across / nearest
        } else {
            0.0
        };
        lost[l] = speed
            * (10.0 * total.abs()
                + 4.0 * (end - start).abs()
                + 3.0 * (end.abs() + start.abs())
                + 2.0 * (summed + places[0].abs() + places[1].abs() + length[l])
                + 4.0 * (aside[l] + places[0].abs()) * angle
                + 15.0 * turn
                + swept / f64::EPSILON);
    }
    [sum, lost]
}

/// The gap that rounding may leave in a boundary, of its length.
const CLOSED: f64 = 1e-9;

/// The fewest blocks of nodes that are certain enough, and the error that is left; none if they are
/// many.
///
/// **Arguments** `largest`: bounds on the integrand in discs, by [`RATIOS`].
fn rule(largest: Lanes, half: f64, wanted: f64) -> Option<(usize, f64)> {
    static FACTORS: LazyLock<[Lanes; MOST]> = LazyLock::new(|| {
        std::array::from_fn(|blocks| {
            RATIOS.map(|ratio| {
                let root = ratio + (ratio * ratio - 1.0).sqrt();
                let nodes = real((blocks + 1) * LANES);
                64.0 / 15.0 * root.powf(-2.0 * nodes) / (1.0 - 1.0 / (root * root))
            })
        })
    });
    FACTORS.iter().enumerate().find_map(|(blocks, factors)| {
        let errors = largest.iter().zip(factors).map(|(m, factor)| m * factor);
        let error = half * errors.fold(f64::INFINITY, f64::min);
        (error <= wanted).then_some((blocks + 1, error))
    })
}

/// The error of one operation, relatively.
const UNIT: f64 = 0.5 * f64::EPSILON;

/// Radii of discs, in halves of a panel.
const RATIOS: Lanes = [1.06, 1.15, 1.35, 1.7, 2.4, 3.5, 6.0, 12.0];

/// Blocks of nodes for which no better bound is looked for.
const FEW: usize = 5;

/// Most blocks of nodes of a rule: as a panel takes as long as some blocks to be set up, two of
/// them with few nodes take longer than one with many.
const MOST: usize = 8;
