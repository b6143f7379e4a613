//! Gauss rules over both polygons: for pairs far from each other, where every other form cancels.
//!
//! ```text
//!   A F = ∫∫ h(y) g(x) / (π r⁴) dx dy ≈ Σ_i Σ_j w_i w_j g_i h_j / (π r_ij⁴)
//! ```
//!
//! All terms are positive, and heights are interpolated between the corners', so nothing cancels.

use super::ExchangeArea;
use super::choice::Work;
use super::gauss_points::Rule;
use super::horizon::Heights;
use super::view::View;
use crate::numeric::{Scalar, vectorised};
use glam::DVec3;
use std::f64::consts::PI;

impl View<'_> {
    /// Gauss rules with `points` each way over both shapes.
    #[allow(clippy::cast_precision_loss, reason = "some points")]
    pub(super) fn kernel(&self, points: [usize; 2], work: &mut Work) -> ExchangeArea {
        let origin = self.shapes[0].centre;
        for (k, rule) in work.rules.iter_mut().enumerate() {
            rule.fill(self.shapes[k], &self.precise_heights(k), origin, points[k]);
        }
        let [first, second] = &work.rules;
        let value = sum(first, second, self.reach, &mut work.sums);
        let largest = self.largest();
        let truncation: f64 = (0..2).map(|k| self.truncation(k, points[k], largest)).sum();
        let terms = 0.5 * (first.weights.len() + second.weights.len()) as f64;
        let relative = (24.0 + terms) * f64::EPSILON + 2.0 * HEIGHT_ERROR;
        ExchangeArea {
            value,
            error_bound: relative * value + truncation,
        }
    }

    /// The heights of a shape's corners, each within [`HEIGHT_ERROR`] of itself; 0 where a clip put them on the plane.
    fn precise_heights(&self, k: usize) -> Heights {
        let precise = |(corner, height): (&DVec3, &f64)| {
            if *height > 0.0 && *height < self.reach / 16.0 {
                self.polygons[1 - k].precise_height(*corner).to_f64()
            } else {
                *height
            }
        };
        self.shapes[k]
            .corners
            .iter()
            .zip(self.heights[k])
            .map(precise)
            .collect()
    }
}

/// The relative error of a precise height: a product is within 3 ε of the distance, and taken again to 106 bits where it is smaller
/// than that by 16.
const HEIGHT_ERROR: f64 = 48.0 * f64::EPSILON;

/// The sum over all pairs of points; `unit` is a length near the distances.
///
/// Four points of the first rule share one division: `f1/q1 + f2/q2 = (f1 q2 + f2 q1)/(q1 q2)`, twice over, with q = r⁴ in
/// units in which four of them stay in range.
fn sum(first: &Rule, second: &Rule, unit: f64, sums: &mut Vec<f64>) -> f64 {
    let inverse_square = 1.0 / (unit * unit);
    sums.clear();
    sums.resize(second.weights.len(), 0.0);
    let sums = sums.as_mut_slice();
    vectorised(
        #[inline(always)]
        || {
            let fluxes = first.weights.iter().zip(&first.heights);
            let fluxes = fluxes.map(|(weight, height)| weight * height);
            let points = &first.points;
            let points = points.x.iter().zip(&points.y).zip(&points.z);
            let mut points = points.map(|((x, y), z)| [*x, *y, *z]).zip(fluxes);
            while let (Some(a), Some(b), Some(c), Some(d)) =
                (points.next(), points.next(), points.next(), points.next())
            {
                let others = &second.points;
                let others = others.x.iter().zip(&others.y).zip(&others.z);
                for (sum, ((x, y), z)) in sums.iter_mut().zip(others) {
                    let fourth_power = |[px, py, pz]: [f64; 3]| {
                        let (dx, dy, dz) = (px - x, py - y, pz - z);
                        let square = (dx * dx + dy * dy + dz * dz) * inverse_square;
                        square * square
                    };
                    let [qa, qb, qc, qd] = [a.0, b.0, c.0, d.0].map(fourth_power);
                    let (ab, cd) = (qa * qb, qc * qd);
                    let numerator = (a.1 * qb + b.1 * qa) * cd + (c.1 * qd + d.1 * qc) * ab;
                    *sum += numerator / (ab * cd);
                }
            }
        },
    );
    let weighted = sums.iter().zip(&second.weights).zip(&second.heights);
    let sum: f64 = weighted
        .map(|((sum, weight), height)| sum * weight * height)
        .sum();
    sum * inverse_square * inverse_square / PI
}
