//! A plane that surfaces share, and how it is put through their corners.

use crate::geometry::Plane;
use crate::scene::NamedPatch;
use glam::DVec3;

/// A plane and the heights between which the corners in it lie.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SharedPlane {
    pub plane: Plane,
    pub low: f64,
    pub high: f64,
}

impl SharedPlane {
    /// Tells whether a surface in this plane can enter a body between these heights over it.
    pub(crate) fn is_crossed_by(&self, [low, high]: [f64; 2], noise: f64) -> bool {
        self.high - low > noise && high - self.low > noise
    }

    /// The least and the largest height over this plane.
    pub(crate) fn range(&self, points: impl IntoIterator<Item = DVec3>) -> [f64; 2] {
        let heights = points
            .into_iter()
            .map(|point| self.plane.sure_height(point));
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| {
            [low.min(height), high.max(height)]
        })
    }

    pub(crate) fn thickness(&self) -> f64 {
        self.high - self.low
    }
}

/// A surface's plane through the middle of its corners' heights.
pub(super) fn own_plane(surface: &NamedPatch, unit: f64) -> SharedPlane {
    let shape = surface.shape();
    let plane = Plane::new(shape.normal(), shape.corners()[0] / unit);
    centred(plane, || {
        shape.corners().iter().map(|corner| *corner / unit)
    })
}

/// The plane moved to the middle between the heights of corners.
pub(super) fn centred<C: Iterator<Item = DVec3>>(
    plane: Plane,
    corners: impl Fn() -> C,
) -> SharedPlane {
    let mut shared = SharedPlane {
        plane,
        low: 0.0,
        high: 0.0,
    };
    let [low, high] = shared.range(corners());
    let half = 0.5 * (high - low);
    shared.plane.origin += 0.5 * (low + high) * plane.normal;
    (shared.low, shared.high) = (-half, half);
    shared
}

/// The plane through a corner, the one farthest from it, and the one farthest from the line through
/// both.
pub(super) fn through_far_corners<C: Iterator<Item = DVec3>>(
    corners: impl Fn() -> C,
) -> Option<SharedPlane> {
    let farthest = |distance: &dyn Fn(DVec3) -> f64| {
        let mut best = (-1.0, DVec3::ZERO);
        for corner in corners() {
            let found = distance(corner);
            if found > best.0 {
                best = (found, corner);
            }
        }
        best.1
    };
    let origin = corners().next()?;
    let along = farthest(&|corner| corner.distance_squared(origin)) - origin;
    let aside = farthest(&|corner| (corner - origin).cross(along).length_squared()) - origin;
    let normal = along.cross(aside).try_normalize()?;
    Some(centred(Plane::new(normal, origin), corners))
}
