//! Planes with a front, and heights over them.

use glam::DVec3;

/// A plane with a front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Unit normal, towards the front.
    pub normal: DVec3,
    /// A point of the plane.
    pub origin: DVec3,
    /// The slope over the exact plane that cannot be excluded; 0 where corners are exact.
    pub tilt: f64,
}

impl Plane {
    /// The plane through a point with this unit normal.
    #[must_use]
    pub const fn new(normal: DVec3, origin: DVec3) -> Self {
        Self {
            normal,
            origin,
            tilt: 0.0,
        }
    }

    /// Height of a point over the plane, positive in front.
    #[must_use]
    pub fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal)
    }

    /// Height of a point over the plane as far as it is sure: nearer to 0 by what the tilt leaves
    /// open.
    #[must_use]
    pub fn sure_height(&self, point: DVec3) -> f64 {
        let height = self.height(point);
        if self.tilt <= 0.0 {
            return height;
        }
        let open = self.tilt * point.distance(self.origin);
        height.signum() * (height.abs() - open).max(0.0)
    }

    /// The plane with its front on the other side.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            normal: -self.normal,
            ..*self
        }
    }
}
