//! Bounds and means of points.

use crate::numeric::real;
use glam::DVec3;

/// The smallest and the largest coordinates of points; infinite, the larger first, if there is
/// none.
#[inline]
pub(crate) fn bounds(points: impl IntoIterator<Item = DVec3>) -> [DVec3; 2] {
    let none = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let points = points.into_iter();
    points.fold(none, |[low, high], point| [low.min(point), high.max(point)])
}

/// The mean of points, of which there is one at least.
#[inline]
pub(crate) fn mean(points: &[DVec3]) -> DVec3 {
    debug_assert!(!points.is_empty(), "no points have no mean");
    points.iter().sum::<DVec3>() / real(points.len())
}
