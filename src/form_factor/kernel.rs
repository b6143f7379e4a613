//! Gauss rules over both polygons: for pairs far from each other, where every other form cancels.
//!
//! ```text
//!   A F = ∫∫ h(y) g(x) / (π r⁴) dx dy ≈ Σ_i Σ_j w_i w_j g_i h_j / (π r_ij⁴)
//! ```
//!
//! All terms are positive, and heights are interpolated between the corners', so nothing cancels.

use super::gauss_points::Rule;
use super::potential::vectorised;
use std::f64::consts::PI;

/// The sum over all pairs of points.
pub(super) fn kernel(first: &Rule, second: &Rule, sums: &mut Vec<f64>) -> f64 {
    sums.clear();
    sums.resize(second.weights.len(), 0.0);
    let sums = sums.as_mut_slice();
    vectorised(
        #[inline(always)]
        || {
            let points = &first.points;
            let coordinates = points.x.iter().zip(&points.y).zip(&points.z);
            let weights = first.weights.iter().zip(&first.heights);
            for (((x, y), z), (weight, height)) in coordinates.zip(weights) {
                let flux = weight * height;
                let others = &second.points;
                let others = others.x.iter().zip(&others.y).zip(&others.z);
                for (sum, ((ox, oy), oz)) in sums.iter_mut().zip(others) {
                    let (dx, dy, dz) = (x - ox, y - oy, z - oz);
                    let square = dx * dx + dy * dy + dz * dz;
                    *sum += flux / (square * square);
                }
            }
        },
    );
    let weighted = sums.iter().zip(&second.weights).zip(&second.heights);
    weighted.map(|((sum, weight), height)| sum * weight * height).sum::<f64>() / PI
}
