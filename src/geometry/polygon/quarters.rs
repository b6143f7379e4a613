//! A polygon cut into parts that keep its kind, so that cutting again nests.
//!
//! ```text
//!   triangle               4 triangles half its size: its corners and the middles of its edges
//!   convex quadrilateral   4 quadrilaterals, along the lines through the middles of opposite edges
//!   convex polygon         n quadrilaterals: a corner, the middles of its edges, the mean of all
//!                          corners
//!   concave polygon        its triangles
//! ```
//!
//! Parts of a parallelogram are parallelograms of half its size. Neighbours that share an edge
//! share the middle of it, to the last bit.

use super::convexity::is_convex;
use super::triangulation::triangles_of;
use crate::geometry::{GeometryError, Patch};
use crate::numeric::real;
use glam::DVec3;

/// The largest sine of a bend that counts as none.
const STRAIGHT: f64 = 1e-12;

/// The parts of a polygon, fronts on the same side; the same area in all.
///
/// # Errors
/// [`GeometryError`] if a part is too small for `f64`.
///
/// # Examples
/// ```
/// use glam::DVec3;
/// use infoscene::geometry::{Patch, quartered};
/// let triangle = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::Y])?;
/// let parts = quartered(&triangle)?;
/// assert!(parts.len() == 4 && parts.iter().all(|part| part.area() == 0.125));
/// # Ok::<(), infoscene::geometry::GeometryError>(())
/// ```
pub fn quartered(patch: &Patch) -> Result<Vec<Patch>, GeometryError> {
    let corners = patch.corners();
    let n = corners.len();
    let middle = |a: DVec3, b: DVec3| 0.5 * a + 0.5 * b;
    let middles: Vec<DVec3> = (0..n)
        .map(|i| middle(corners[i], corners[(i + 1) % n]))
        .collect();
    let parts: Vec<Vec<DVec3>> = if n == 3 {
        let at_corner = |i: usize| vec![corners[i], middles[i], middles[(i + 2) % 3]];
        let mut parts: Vec<_> = (0..3).map(at_corner).collect();
        parts.push(middles);
        parts
    } else if is_convex(corners, patch.normal(), STRAIGHT) {
        let centre = if n == 4 {
            middle(middles[0], middles[2])
        } else {
            let share = 1.0 / real(n);
            corners.iter().map(|corner| *corner * share).sum()
        };
        let at_corner = |i: usize| vec![corners[i], middles[i], centre, middles[(i + n - 1) % n]];
        (0..n).map(at_corner).collect()
    } else {
        return triangles_of(patch);
    };
    let part = |corners| Patch::within(corners, patch.resolution());
    parts.into_iter().map(part).collect()
}
