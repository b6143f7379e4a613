//! On which side of a plane a point lies, decided exactly.
//!
//! ```text
//!             | b − a |
//!   sign  det | c − a |   > 0  in front: there a, b, c run counter-clockwise
//!             | p − a |
//! ```
//!
//! The determinant is computed in `f64` with a bound on its error, and in ever longer expansions only while the
//! bound does not decide (the crate `robust`).
//!
//! The four points are first divided by one power of two, so that the largest coordinate is near 2²⁵⁶ and nothing
//! overflows. The answer is exact if every coordinate that is not 0 is at least 2⁻⁵⁶⁰ (1e-168) times the largest one;
//! below that its last bits may leave the range of `f64`.
//!
//! **Not covered**: noise. A corner that was rotated, or read from decimals, is a little off its plane, and this
//! predicate says so; what counts as touching is decided in [`Shaft`](super::Shaft).
//!
//! Reference: Shewchuk, "Adaptive precision floating-point arithmetic", *Discrete & Computational Geometry* 18 (1997),
//! 305–363.

use glam::DVec3;
use robust::{Coord3D, orient3d};

/// A side of an oriented plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// Where the three points run counter-clockwise.
    Front,
    /// In the plane; every point if the three are collinear.
    On,
    /// Where they run clockwise.
    Behind,
}

/// Side of the plane through three points on which a fourth one lies.
///
/// **Arguments** finite points.
/// **Accuracy** exact for coordinates within 1e-168 … 1 of the largest one, or 0.
///
/// # Examples
/// ```
/// use infoscene::geometry::{Side, side_of_plane};
/// use glam::DVec3;
/// let floor = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// assert_eq!(side_of_plane(floor, DVec3::new(0.3, 0.3, 1e-100)), Side::Front);
/// ```
///
/// # Source
/// Shewchuk 1997, §4.
#[must_use]
pub fn side_of_plane(plane: [DVec3; 3], point: DVec3) -> Side {
    let [a, b, c] = plane;
    let largest = [a, b, c, point]
        .into_iter()
        .map(|p| p.abs().max_element())
        .fold(0.0, f64::max);
    let unit = power_of_two_below(largest);
    let scaled = |p: DVec3| {
        let p = p / unit * NEAR_LARGEST;
        Coord3D {
            x: p.x,
            y: p.y,
            z: p.z,
        }
    };
    // `orient3d` is positive for a point from which a, b, c run clockwise
    let behind = orient3d(scaled(a), scaled(b), scaled(c), scaled(point));
    if behind < 0.0 {
        Side::Front
    } else if behind > 0.0 {
        Side::Behind
    } else {
        Side::On
    }
}

/// 2²⁵⁶: the product of three sums of such numbers stays finite.
const NEAR_LARGEST: f64 = f64::from_bits((1023 + 256) << 52);

/// The power of two at or just below a number; 1 for 0.
pub(crate) fn power_of_two_below(number: f64) -> f64 {
    if number.is_normal() {
        // the significand's bits cleared
        f64::from_bits(number.abs().to_bits() & !((1 << 52) - 1))
    } else if number.abs() > 0.0 {
        f64::MIN_POSITIVE
    } else {
        1.0
    }
}
