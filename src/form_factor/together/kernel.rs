//! Gauss rules over both polygons of eight pairs, as [`gauss::kernel`](crate::form_factor::gauss)
//! has them for one.
//!
//! The points of one pair are in vectors there, and summed lane by lane; here each of those lanes
//! is a number per pair, so that every sum takes its terms in the same order.

use super::octet::{Octet, Side};
use crate::form_factor::clipped_pair::ClippedPair;
use crate::form_factor::gauss::points::{Nodes, PointLanes};
use crate::form_factor::workspace::Workspace;
use crate::numeric::{LANES, Lanes, across, vector_value};

/// The rules over both polygons of a pair.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rule {
    pub points: [usize; 2],
    nodes: [&'static Nodes; 2],
}

impl Rule {
    /// The rules with so many points a direction.
    pub(super) fn of(pair: &ClippedPair<'_>, points: [usize; 2]) -> Self {
        let nodes = [0, 1].map(|k| pair.nodes(k, points[k]));
        Self { points, nodes }
    }

    /// Whether so many pairs are done faster together than one by one, where vectors over the
    /// points of the second rule are filled in part.
    pub(super) fn pays(&self, pairs: usize) -> bool {
        let [_, blocks] = self.blocks();
        self.nodes[1].count() < pairs * blocks
    }

    /// A number by which pairs are put beside those that take the same points.
    pub(super) fn order(&self) -> u32 {
        let [first, second] = self.nodes.map(|nodes| u32::from(nodes.number()));
        first << 16 | second
    }

    /// The vectors that the points of one pair take.
    pub(super) fn blocks(&self) -> [usize; 2] {
        self.nodes.map(|nodes| nodes.blocks().len())
    }
}

/// The sums of [`ClippedPair::kernel`] for each pair, as if all took these rules.
///
/// **Arguments** `heights`: of corners, precise; `reach`: of each pair.
pub(super) fn kernel(
    octet: &Octet<'_>,
    heights: &[[Lanes; 4]; 2],
    reach: &Lanes,
    rule: &Rule,
    work: &mut Workspace,
) -> Lanes {
    let [first, second] = &mut work.together;
    for (points, nodes) in [&mut *first, &mut *second].into_iter().zip(rule.nodes) {
        points.resize(nodes.blocks().len() * LANES, PointLanes::default());
    }
    let (first, second) = (first.as_mut_slice(), second.as_mut_slice());
    let (sides, nodes) = (&octet.sides, rule.nodes);
    vector_value!([0.0; LANES], {
        fill(first, nodes[0], &sides[0], &heights[0], &sides[0].centre);
        fill(second, nodes[1], &sides[1], &heights[1], &sides[0].centre);
        sum(first, second, reach)
    })
}

/// The points of a rule on each polygon, from an origin of each pair.
#[inline(always)]
fn fill(
    out: &mut [PointLanes],
    nodes: &Nodes,
    side: &Side,
    corner_heights: &[Lanes; 4],
    origin: &[Lanes; 3],
) {
    let mut corners = [[[0.0; LANES]; 3]; 4];
    for (corner, from) in corners.iter_mut().zip(&side.corners) {
        for ((corner, from), origin) in corner.iter_mut().zip(from).zip(origin) {
            for l in 0..LANES {
                corner[l] = from[l] - origin[l];
            }
        }
    }
    let [first, second, third, fourth] = &corners;
    let [j, js, jt] = &side.jacobian;
    let nodes = nodes.blocks().iter().flat_map(|[s, t, weights]| {
        let at = |i: usize| [s[i], t[i], weights[i]];
        [at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)]
    });
    for ([s, t, weight], out) in nodes.zip(out) {
        let (a, b) = ((1.0 - s) * (1.0 - t), s * (1.0 - t));
        let (c, d) = (s * t, (1.0 - s) * t);
        for (axis, point) in out.point.iter_mut().enumerate() {
            let [p, q] = [&first[axis], &second[axis]];
            let [r, s] = [&third[axis], &fourth[axis]];
            for l in 0..LANES {
                point[l] = a * p[l] + b * q[l] + c * r[l] + d * s[l];
            }
        }
        for l in 0..LANES {
            let [ah, bh, ch, dh] = corner_heights;
            out.height[l] = a * ah[l] + b * bh[l] + c * ch[l] + d * dh[l];
            out.weight[l] = weight * (j[l] + js[l] * s + jt[l] * t);
        }
        out.is_empty = weight <= 0.0;
    }
}

/// The sum over all pairs of points times `π unit⁴`: the points of the second rule in eight sums,
/// and four of the first with one division, as for one pair.
#[inline(always)]
fn sum(first: &[PointLanes], second: &[PointLanes], unit: &Lanes) -> Lanes {
    let mut inverse_square = [0.0; LANES];
    for l in 0..LANES {
        inverse_square[l] = 1.0 / (unit[l] * unit[l]);
    }
    let mut totals = [[0.0; LANES]; LANES];
    for (m, point) in second.iter().enumerate() {
        // what only fills the last vector weighs nothing
        if point.is_empty {
            continue;
        }
        let mut sums = [0.0; LANES];
        for four in first.chunks_exact(4) {
            if four.iter().all(|point| point.is_empty) {
                continue;
            }
            add_four(four, point, &inverse_square, &mut sums);
        }
        let total = &mut totals[m % LANES];
        for l in 0..LANES {
            total[l] += sums[l] * point.weight[l] * point.height[l];
        }
    }
    let mut out = [0.0; LANES];
    for l in 0..LANES {
        let mut lanes = [0.0; LANES];
        for (lane, total) in lanes.iter_mut().zip(&totals) {
            *lane = total[l];
        }
        out[l] = across(lanes);
    }
    out
}

/// Adds what four points of the first rule exchange with one of the second.
#[inline(always)]
fn add_four(four: &[PointLanes], point: &PointLanes, inverse_square: &Lanes, sums: &mut Lanes) {
    let [x, y, z] = &point.point;
    for l in 0..LANES {
        let fourth_power = |i: usize| {
            let [px, py, pz] = &four[i].point;
            let (dx, dy, dz) = (px[l] - x[l], py[l] - y[l], pz[l] - z[l]);
            let square = (dx * dx + dy * dy + dz * dz) * inverse_square[l];
            square * square
        };
        let flux = |i: usize| four[i].weight[l] * four[i].height[l];
        let (qa, qb) = (fourth_power(0), fourth_power(1));
        let (qc, qd) = (fourth_power(2), fourth_power(3));
        let (ab, cd) = (qa * qb, qc * qd);
        let numerator = (flux(0) * qb + flux(1) * qa) * cd + (flux(2) * qd + flux(3) * qc) * ab;
        sums[l] += numerator / (ab * cd);
    }
}
