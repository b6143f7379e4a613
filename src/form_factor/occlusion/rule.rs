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
use super::bound::{BoundarySide, Outline};
use super::corner::Corner;
use super::share::Share;
use super::sight::Sight;
use crate::numeric::functions::elementary::angles;
use crate::numeric::{GaussLegendre, LANES, Lanes, across, real, vector_value};
use glam::DVec2;
use smallvec::{SmallVec, smallvec};
use std::sync::LazyLock;

/// A boundary on a panel.
#[derive(Debug)]
pub(super) struct Panel<'a> {
    sight: &'a Sight<'a>,
    middle: f64,
    half: f64,
    corners: Vec<Corner>,
    /// Their places at the middle.
    places: Vec<DVec2>,
    sides: Vec<BoundarySide>,
}

impl<'a> Panel<'a> {
    pub(super) fn new(
        sight: &'a Sight<'a>,
        arrangement: &Arrangement,
        [from, to]: [f64; 2],
    ) -> Self {
        let middle = 0.5 * (from + to);
        let most = 2 * arrangement.segments.len();
        let mut panel = Self {
            sight,
            middle,
            half: 0.5 * (to - from),
            corners: Vec::with_capacity(most),
            places: Vec::with_capacity(most),
            sides: Vec::with_capacity(most),
        };
        let height = panel.height();
        let mut named: SmallVec<[[usize; 2]; 16]> = SmallVec::new();
        for Segment { line, from, to } in &arrangement.segments {
            let corners = [*from, *to].map(|other| {
                let pair = [*line.min(&other), *line.max(&other)];
                let known = named.iter().position(|known| *known == pair);
                known.unwrap_or_else(|| {
                    named.push(pair);
                    let corner = Corner::at_crossing(sight, pair, middle);
                    panel.places.push(corner.at(0.0, height));
                    panel.corners.push(corner);
                    named.len() - 1
                })
            });
            panel.sides.push(BoundarySide {
                corners,
                // an edge in P's plane is a line of its own
                is_through: sight.is_level && sight.traces[*line].edge.is_none(),
            });
        }
        panel
    }

    /// Whether the sides go round.
    pub(super) fn is_closed(&self) -> bool {
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

    /// The height at the middle.
    fn height(&self) -> f64 {
        self.sight.start.z + self.middle * self.sight.along.z
    }

    /// The integral over the panel; none if no rule is certain enough.
    pub(super) fn integral(&self, wanted: f64) -> Option<Share> {
        if self.sides.is_empty() {
            return Some(Share::default());
        }
        let outline = &Outline::new(
            (&self.corners, &self.places),
            &self.sides,
            self.sight.along.truncate(),
            [self.height(), self.sight.along.z],
            self.sight.is_level,
        );
        let reach = RATIOS.map(|ratio| ratio * self.half);
        let largest = vector_value!([f64::INFINITY; LANES], outline.largest(&reach));
        let (blocks, truncation) = rule(largest, self.half, wanted)?;
        let [value, size] = self.sums(GaussLegendre::with(blocks * LANES), outline.unit);
        let noise = outline.noise(&self.corners) + outline.gap(self.gap());
        Some(Share {
            value: self.half * value,
            truncation,
            rounding: self.half * (8.0 * f64::EPSILON * size + 2.0 * noise),
        })
    }

    /// The rule's sums of W and of the magnitudes of its terms.
    fn sums(&self, rule: &GaussLegendre, unit: f64) -> [f64; 2] {
        let (corners, sides) = (self.corners.as_slice(), self.sides.as_slice());
        let (start, rise) = (self.height(), self.sight.along.z);
        let v = self.sight.along.truncate();
        let inverse = 1.0 / (unit * unit);
        let (half, lanes) = (self.half, rule.lanes.as_slice());
        let mut places = vec![[[0.0; LANES]; 3]; corners.len()];
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

/// Radii of discs, in halves of a panel.
const RATIOS: Lanes = [1.15, 1.3, 1.7, 2.4, 3.5, 5.0, 8.0, 14.0];

/// Most blocks of nodes of a rule.
const MOST: usize = 3;
