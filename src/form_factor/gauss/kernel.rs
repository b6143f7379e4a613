//! Gauss rules over both polygons: for pairs far from each other, where every other form cancels.
//!
//! ```text
//!   A F = ∫∫ h(y) g(x) / (π r⁴) dx dy ≈ Σ_i Σ_j w_i w_j g_i h_j / (π r_ij⁴)
//! ```
//!
//! All terms are positive, and heights are interpolated between the corners', so nothing cancels.

use super::points::{Block, fill};
use crate::form_factor::ExchangeArea;
use crate::form_factor::clipped_pair::ClippedPair;
use crate::form_factor::clipped_pair::horizon::Heights;
use crate::numeric::{LANES, Lanes, across, real, vector_value};
use std::f64::consts::PI;

impl ClippedPair<'_> {
    /// Gauss rules with `points` each way over both shapes.
    pub(crate) fn kernel(&self, points: [usize; 2], blocks: &mut [Vec<Block>; 2]) -> ExchangeArea {
        let origin = self.shapes[0].centre;
        let [(first_rules, first_blocks), (second_rules, second_blocks)] =
            [0, 1].map(|k| self.rules(k, points[k]));
        let [first_heights, second_heights] = [0, 1].map(|k| self.precise_heights(k));
        let (first_heights, second_heights) = (first_heights.as_slice(), second_heights.as_slice());
        let [first, second] = blocks;
        first.resize(first_blocks, Block::default());
        second.resize(second_blocks, Block::default());
        let [first, second] = [first.as_mut_slice(), second.as_mut_slice()];
        let (unit, shapes) = (self.reach, self.shapes);
        let sums = vector_value!([0.0; LANES], {
            fill(first, first_rules, shapes[0], first_heights, origin);
            fill(second, second_rules, shapes[1], second_heights, origin);
            sum(first, second, unit)
        });
        self.kernel_exchange(across(sums), points, [first_blocks, second_blocks])
    }

    /// The exchange area from the sum over rules with `points` each way, which take so many
    /// vectors.
    pub(crate) fn kernel_exchange(
        &self,
        sum: f64,
        points: [usize; 2],
        blocks: [usize; 2],
    ) -> ExchangeArea {
        let unit = self.reach;
        let value = sum / (unit * unit * unit * unit * PI);
        let terms = 4.0 * real(blocks[0] + blocks[1]);
        let heights = self.plain_heights().unwrap_or(2.0 * HEIGHT_ERROR);
        let rounding = ((24.0 + terms) * f64::EPSILON + heights) * value;
        let rules = [(0, points[0]), (1, points[1])];
        ExchangeArea {
            value,
            error: rounding + self.truncation(&rules, value + rounding),
        }
    }

    /// The heights of a shape's corners, each within [`HEIGHT_ERROR`] of itself; 0 where a clip put
    /// them on the plane.
    fn precise_heights(&self, k: usize) -> Heights {
        let mut precise = Heights::from_slice(self.heights[k]);
        self.with_precise_heights(k, |i, height| precise[i] = height);
        precise
    }

    /// The relative change of the value by the rounding of heights, if that is little of the
    /// tolerance: a product is within 3 ε of the distance.
    fn plain_heights(&self) -> Option<f64> {
        let least = |heights: &[f64]| {
            let positive = heights.iter().filter(|height| **height > 0.0);
            positive.fold(f64::INFINITY, |least, height| least.min(*height))
        };
        let [first, second] = self.heights.map(least);
        let error = 3.0 * f64::EPSILON * self.reach * (1.0 / first + 1.0 / second);
        (error <= NEGLIGIBLE * self.tolerance).then_some(error)
    }

    /// Calls `replace` with those heights of a shape's corners that are not within
    /// [`HEIGHT_ERROR`] of themselves, taken again.
    pub(crate) fn with_precise_heights(&self, k: usize, mut replace: impl FnMut(usize, f64)) {
        if self.plain_heights().is_some() {
            return;
        }
        let heights = self.heights[k].iter().enumerate();
        for ((i, height), corner) in heights.zip(&self.shapes[k].corners) {
            if *height > 0.0 && *height < self.reach / 16.0 {
                replace(i, self.polygons[1 - k].height(*corner));
            }
        }
    }
}

/// The part of a tolerance that the rounding of heights may take.
const NEGLIGIBLE: f64 = 1.0 / 64.0;

/// The relative error of a precise height: a product is within 3 ε of the distance, and taken again
/// to 106 bits where it is smaller than that by 16.
const HEIGHT_ERROR: f64 = 48.0 * f64::EPSILON;

/// The sum over all pairs of points times `π unit⁴`, lane by lane; `unit` is a length near the
/// distances.
///
/// Four points of the first rule share one division: `f1/q1 + f2/q2 = (f1 q2 + f2 q1)/(q1 q2)`,
/// twice over, with q = r⁴ in units in which four of them stay in range.
#[inline(always)]
fn sum(first: &[Block], second: &[Block], unit: f64) -> Lanes {
    let inverse_square = 1.0 / (unit * unit);
    let mut total = [0.0; LANES];
    for block in second {
        let Block {
            points: [x, y, z],
            weights,
            heights,
        } = *block;
        let mut sums = [0.0; LANES];
        for other in first {
            for k in [0, LANES / 2] {
                let flux = |i: usize| other.weights[k + i] * other.heights[k + i];
                let fluxes = [flux(0), flux(1), flux(2), flux(3)];
                // what only fills the last vector
                if fluxes.iter().all(|flux| flux.abs() <= 0.0) {
                    continue;
                }
                let [px, py, pz] = &other.points;
                for l in 0..LANES {
                    let fourth_power = |i: usize| {
                        let (dx, dy, dz) = (px[k + i] - x[l], py[k + i] - y[l], pz[k + i] - z[l]);
                        let square = (dx * dx + dy * dy + dz * dz) * inverse_square;
                        square * square
                    };
                    let (qa, qb) = (fourth_power(0), fourth_power(1));
                    let (qc, qd) = (fourth_power(2), fourth_power(3));
                    let (ab, cd) = (qa * qb, qc * qd);
                    let numerator = (fluxes[0] * qb + fluxes[1] * qa) * cd
                        + (fluxes[2] * qd + fluxes[3] * qc) * ab;
                    sums[l] += numerator / (ab * cd);
                }
            }
        }
        for l in 0..LANES {
            total[l] += sums[l] * weights[l] * heights[l];
        }
    }
    total
}
