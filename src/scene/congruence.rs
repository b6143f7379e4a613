//! What the exchange area of a pair may change by when its corners move by little.
//!
//! ```text
//!   corners of Q move by at most δ:   |Δ(A F)| ≤ δ · perimeter(Q) · E_P,    E_P = min(1, A_P / (π r²))
//! ```
//!
//! `A F` is the flux that P (of exitance 1) sends through Q. Old and new Q and the walls between their boundaries
//! enclose a space without sources, so the fluxes differ by what passes the walls: at most their area times the
//! irradiance from P, on either side at most 1, and at most `A_P/(π r²)` at a distance r from P. The same holds with P and
//! Q exchanged. A motion of both together changes nothing, so that δ counts from where the pairs fit best.

use crate::geometry::Patch;
use glam::DVec3;
use std::f64::consts::PI;

/// Coordinates of two congruent pairs differ by twice the spread of the differences they were found by (an end of a
/// span is two differences away from where the pairs are put together); √3 of that in space, rounded up for the
/// curvature of the walls.
const MOTION: f64 = 4.0;

/// By how much the exchange areas of two pairs may differ whose differences of coordinates differ by `spread`.
pub(super) fn allowance(spread: f64, first: &Patch, second: &Patch) -> f64 {
    if spread <= 0.0 {
        return 0.0;
    }
    let motion = MOTION * spread;
    let distance = (gap(first, second) - 2.0 * motion).max(0.0);
    let irradiance = |from: &Patch| (from.area() / (PI * distance * distance)).min(1.0);
    motion * (perimeter(second) * irradiance(first) + perimeter(first) * irradiance(second))
}

fn perimeter(patch: &Patch) -> f64 {
    let corners = patch.corners();
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| a.distance(*b)).sum()
}

/// A lower bound on the distance of two patches: that of the boxes around them.
fn gap(first: &Patch, second: &Patch) -> f64 {
    let ends = |patch: &Patch| {
        let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        patch
            .corners()
            .iter()
            .fold(ends, |(lower, upper), c| (lower.min(*c), upper.max(*c)))
    };
    let ((lower, upper), (other_lower, other_upper)) = (ends(first), ends(second));
    (other_lower - upper)
        .max(lower - other_upper)
        .max(DVec3::ZERO)
        .length()
}
