//! Containment of one polygon in another, in one plane and facing the same way.
//!
//! ```text
//!   inner ⊂ outer   ⇔   no corner and no middle of an edge of inner is outside of outer,
//!                       no edge of inner crosses an edge of outer, and
//!                       no corner of outer is inside of inner
//! ```
//!
//! Distances up to [`tolerance::PLANARITY`] of the outer polygon's diameter count as zero, or up to
//! the noise of the coordinates, if that is more.

use crate::geometry::Patch;
use crate::numeric::tolerance;
use glam::{DVec2, DVec3};

/// The first condition of containment that fails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum NotContained {
    /// A corner lies off the outer polygon's plane.
    OffPlane {
        /// Largest distance of a corner from the plane.
        deviation: f64,
        /// The distance that would be accepted.
        allowed: f64,
    },
    /// The inner polygon's front is at the outer one's back.
    FacesAway,
    /// The inner polygon reaches over the outline of the outer one.
    ReachesOut,
}

/// Refuses a polygon that does not lie in another one, facing the same way.
///
/// # Errors
/// [`NotContained`].
pub(crate) fn check_contained(
    inner: &Patch,
    outer: &Patch,
    noise: f64,
) -> Result<(), NotContained> {
    let origin = outer.corners()[0];
    let diameter = outer
        .corners()
        .iter()
        .map(|corner| corner.distance(origin))
        .fold(0.0, f64::max);
    let allowed = (tolerance::PLANARITY * diameter).max(noise);
    let normal = outer.normal();
    let deviation = distance_from_plane(inner, outer);
    if deviation > allowed {
        return Err(NotContained::OffPlane { deviation, allowed });
    }
    if inner.normal().dot(normal) < 0.0 {
        return Err(NotContained::FacesAway);
    }
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    // in units of the diameter, so that products stay in range
    let flat = |patch: &Patch| -> Vec<DVec2> {
        let corners = patch.corners().iter();
        let corners = corners.map(|corner| (*corner - origin) / diameter);
        corners
            .map(|c| DVec2::new(c.dot(across), c.dot(up)))
            .collect()
    };
    let allowed = tolerance::PLANARITY.max(noise / diameter);
    let (inner, outer) = (flat(inner), flat(outer));
    let leaves = edges(&inner).any(|(a, b)| {
        [a, 0.5 * (a + b)]
            .into_iter()
            .any(|point| depth(point, &outer) < -allowed)
            || edges(&outer).any(|(c, d)| cross_properly((a, b), (c, d), allowed))
    });
    let swallows = outer.iter().any(|corner| depth(*corner, &inner) > allowed);
    if leaves || swallows {
        return Err(NotContained::ReachesOut);
    }
    Ok(())
}

/// The largest distance of a corner of the first polygon from the plane of the second.
pub(crate) fn distance_from_plane(inner: &Patch, outer: &Patch) -> f64 {
    let heights = inner.corners().iter();
    heights
        .map(|corner| (*corner - outer.corners()[0]).dot(outer.normal()).abs())
        .fold(0.0, f64::max)
}

/// Is a point of a polygon's plane inside the outline?
pub(crate) fn is_inside(point: DVec3, polygon: &Patch) -> bool {
    depth_in_plane(point, polygon) > 0.0
}

/// The distance of a point from a polygon.
pub(crate) fn distance_from_patch(point: DVec3, polygon: &Patch) -> f64 {
    let height = (point - polygon.corners()[0]).dot(polygon.normal());
    height.hypot((-depth_in_plane(point, polygon)).max(0.0))
}

/// The distance of a point's projection from the outline, > 0 inside and < 0 outside.
fn depth_in_plane(point: DVec3, polygon: &Patch) -> f64 {
    let across = polygon.normal().any_orthonormal_vector();
    let up = polygon.normal().cross(across);
    let flat = |corner: DVec3| DVec2::new((corner - point).dot(across), (corner - point).dot(up));
    let corners: Vec<DVec2> = polygon.corners().iter().map(|c| flat(*c)).collect();
    depth(DVec2::ZERO, &corners)
}

fn edges(polygon: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2)> {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

/// The distance of a point from the outline, > 0 inside and < 0 outside.
fn depth(point: DVec2, polygon: &[DVec2]) -> f64 {
    let distance = edges(polygon).map(|(a, b)| {
        let along = b - a;
        let t = ((point - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        point.distance(a + along * t)
    });
    let distance = distance.fold(f64::INFINITY, f64::min);
    // a ray to the right crosses the outline of a polygon that holds the point an odd number of
    // times
    let crossings = edges(polygon)
        .filter(|(a, b)| (a.y > point.y) != (b.y > point.y))
        .filter(|(a, b)| point.x < a.x + (point.y - a.y) * (b.x - a.x) / (b.y - a.y))
        .count();
    if crossings % 2 == 1 {
        distance
    } else {
        -distance
    }
}

/// Tells whether two segments cross, each with both ends farther than `allowed` from the line of
/// the other.
fn cross_properly((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2), allowed: f64) -> bool {
    let height = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p) / (q - p).length();
    let parts = |s: f64, t: f64| s.abs() > allowed && t.abs() > allowed && (s > 0.0) != (t > 0.0);
    parts(height(a, b, c), height(a, b, d)) && parts(height(c, d, a), height(c, d, b))
}
