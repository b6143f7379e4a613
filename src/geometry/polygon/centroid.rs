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

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    /// An L of three unit squares, whose fan leaves it: the mean of the middles of the squares.
    #[test]
    fn the_centroid_of_an_l_is_that_of_its_squares() {
        let outline = [[0, 1], [0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
        let corners = outline.map(|[x, y]| DVec3::new(x.into(), y.into(), 5.0));
        // also from the corner at the far end, where the fan leaves the L
        for first in 0..corners.len() {
            let mut corners = corners.to_vec();
            corners.rotate_left(first);
            let found = centroid(&Patch::try_new(corners).unwrap());
            let exact = DVec3::new(2.5 / 3.0, 2.5 / 3.0, 5.0);
            // a few ε of the coordinates
            assert!((found - exact).length() <= 1e-14, "{first}: {found}");
        }
    }
}
