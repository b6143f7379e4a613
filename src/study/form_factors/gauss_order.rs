//! Product Gauss rules of a fixed order on triangles of both polygons: what an engine without error
//! control does.
//!
//! ```text
//!   x(s, t) = a + s (b − a) + s t (c − b),   dA = 2 A s ds dt
//!   A F ≈ Σ_x Σ_y w_x w_y cos⁺θ_x cos⁺θ_y / (π r²)
//! ```
//!
//! No clip, no bound: an *estimate*. It converges fast only for polygons apart and in front of each
//! other.

use crate::form_factor::point_kernel;
use crate::geometry::{Patch, triangulated};
use crate::numeric::GaussLegendre;
use glam::DVec3;

/// The exchange area with `order × order` points on each triangle; `None` if two points coincide or
/// the range of `f64` is left.
pub(crate) fn exchange_area([first, second]: &[Patch; 2], order: usize) -> Option<f64> {
    let [from, to] = [first, second].map(|patch| points(patch, order));
    let (n_x, n_y) = (first.normal(), second.normal());
    let mut sum = 0.0;
    for (x, w_x) in &from {
        for (y, w_y) in &to {
            sum += w_x * w_y * point_kernel([*x, n_x], [*y, n_y]).ok()?;
        }
    }
    Some(sum).filter(|sum| sum.is_finite())
}

/// The points of a rule over a polygon, with their weights.
pub(super) fn points(patch: &Patch, order: usize) -> Vec<(DVec3, f64)> {
    let rule = GaussLegendre::with(order);
    let on_unit = || rule.nodes.iter().map(|x| 0.5 + 0.5 * x).zip(&rule.weights);
    let corners = patch.corners();
    let mut points = Vec::new();
    for [a, b, c] in triangulated(corners, patch.normal()) {
        let (a, b, c) = (corners[a], corners[b], corners[c]);
        let doubled = (b - a).cross(c - a).length();
        for (s, w_s) in on_unit() {
            for (t, w_t) in on_unit() {
                let point = a + s * (b - a) + s * t * (c - b);
                points.push((point, 0.25 * w_s * w_t * doubled * s));
            }
        }
    }
    points
}
