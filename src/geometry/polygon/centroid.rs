//! The centroid of a planar polygon.
//!
//! ```text
//!   x = v0 + Σ_k a_k (e_k + e_(k+1))/3 / Σ_k a_k,     e_k = v_k − v0,  a_k = (e_k × e_(k+1))·n
//! ```
//!
//! over the fan of triangles at the first corner; triangles of a polygon that is not convex count
//! with their sign.

use crate::geometry::Patch;
use glam::DVec3;

/// The centroid of a polygon.
///
/// **Accuracy** a few ε of the diameter over the smallest angle of the fan.
///
/// # Examples
/// ```
/// use glam::DVec3;
/// use infoscene::geometry::{Patch, centroid};
/// let triangle = Patch::try_new(vec![DVec3::ZERO, 3.0 * DVec3::X, 3.0 * DVec3::Y])?;
/// assert_eq!(centroid(&triangle), DVec3::new(1.0, 1.0, 0.0));
/// # Ok::<(), infoscene::geometry::GeometryError>(())
/// ```
#[must_use]
pub fn centroid(polygon: &Patch) -> DVec3 {
    let corners = polygon.corners();
    let origin = corners[0];
    let mut sum = DVec3::ZERO;
    let mut weight = 0.0;
    for edge in corners[1..].windows(2) {
        let (a, b) = (edge[0] - origin, edge[1] - origin);
        let area = a.cross(b).dot(polygon.normal());
        sum += area * (a + b) / 3.0;
        weight += area;
    }
    origin + sum / weight
}
