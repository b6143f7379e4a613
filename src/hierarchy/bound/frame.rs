//! Coordinates in a plane, with the height above it as the third.

use crate::geometry::Patch;
use glam::{DVec2, DVec3};

/// Coordinates in the plane of a patch.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    origin: DVec3,
    axes: [DVec3; 3],
}

impl Frame {
    /// The plane of a patch, its front above.
    pub(super) fn of(patch: &Patch) -> Self {
        let (corners, normal) = (patch.corners(), patch.normal());
        let along = (corners[1] - corners[0]).reject_from(normal).normalize();
        Self {
            origin: corners[0],
            axes: [along, normal.cross(along), normal],
        }
    }

    /// The coordinates of a point, with its height above the plane.
    pub(super) fn place(&self, point: DVec3) -> DVec3 {
        self.turned(point - self.origin)
    }

    /// The coordinates of a direction.
    pub(super) fn turned(&self, direction: DVec3) -> DVec3 {
        DVec3::from_array(self.axes.map(|axis| axis.dot(direction)))
    }

    /// The coordinates of a point of the plane.
    pub(super) fn flat(&self, point: DVec3) -> DVec2 {
        self.place(point).truncate()
    }

    /// The point with these coordinates in the plane.
    pub(super) fn lifted(&self, point: DVec2) -> DVec3 {
        self.origin + point.x * self.axes[0] + point.y * self.axes[1]
    }

    /// The direction upwards.
    pub(super) const fn normal(&self) -> DVec3 {
        self.axes[2]
    }
}
