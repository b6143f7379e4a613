//! A plane through a line of the receiver, with coordinates in it.
//!
//! ```text
//!   point = origin + s along + t up        t = 0 on the receiver's plane, t > 0 in front of it
//! ```

use super::ranges::Ranges;
use crate::geometry::{Patch, clipped, convex_pieces};
use glam::{DVec2, DVec3};

/// The least sine of the angle between a plane and the receiver's that meet in a line.
const SMALLEST_ANGLE: f64 = 1e-9;

/// A plane that meets the receiver's.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section {
    pub origin: DVec3,
    /// The unit direction of the line in which the planes meet.
    pub along: DVec3,
    up: DVec3,
    normal: DVec3,
}

impl Section {
    /// The plane through a point with this normal, of any length; `None` if it is parallel to the
    /// receiver's.
    pub(super) fn through(receiver: &Patch, normal: DVec3, point: DVec3) -> Option<Self> {
        let normal = normal.try_normalize()?;
        let own = receiver.normal();
        let along = normal.cross(own);
        if along.length() < SMALLEST_ANGLE {
            return None;
        }
        let along = along.normalize();
        let up = own - own.dot(normal) * normal;
        let up = up.try_normalize()?;
        // down along the plane to the receiver's, then to the foot of its first corner
        let height = (point - receiver.corners()[0]).dot(own);
        let foot = point - up * (height / up.dot(own));
        let origin = foot + along * (receiver.corners()[0] - foot).dot(along);
        Some(Self {
            origin,
            along,
            up,
            normal,
        })
    }

    /// The coordinates of a point, as it is seen along the normal.
    pub(super) fn flat(&self, point: DVec3) -> DVec2 {
        let from = point - self.origin;
        DVec2::new(from.dot(self.along), from.dot(self.up))
    }

    /// The point of the receiver's plane at a place.
    pub(super) fn point(&self, place: f64) -> DVec3 {
        self.origin + place * self.along
    }

    /// The point at coordinates.
    pub(super) fn lifted(&self, at: DVec2) -> DVec3 {
        self.origin + at.x * self.along + at.y * self.up
    }

    /// The distance of a point from the plane, with the sign of its side.
    pub(super) fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal)
    }

    /// The segments in which a polygon crosses the plane, those of neighbouring pieces apart; none
    /// if it lies in it.
    pub(super) fn crossed(&self, polygon: &Patch, noise: f64) -> Vec<[DVec2; 2]> {
        let mut found = Vec::new();
        for piece in convex_pieces(polygon.corners(), polygon.normal()) {
            let heights = snapped(&piece, |corner| self.height(corner), noise);
            if heights.iter().all(|height| height.abs() <= 0.0) {
                continue;
            }
            // what is above and below has the crossing in common
            let above = clipped(&piece, &heights, |a: DVec3, b, share| a.lerp(b, share));
            let on: Vec<DVec2> = above
                .iter()
                .filter(|corner| self.height(**corner).abs() <= noise)
                .map(|corner| self.flat(*corner))
                .collect();
            let apart = on
                .iter()
                .flat_map(|a| on.iter().map(move |b| [*a, *b]))
                .max_by(|a, b| a[0].distance(a[1]).total_cmp(&b[0].distance(b[1])));
            found.extend(apart.filter(|[a, b]| a.distance(*b) > noise));
        }
        found
    }

    /// The ranges of the line inside the receiver.
    pub(super) fn chord(&self, receiver: &Patch, noise: f64) -> Ranges {
        let segments = self.crossed(receiver, noise).into_iter();
        Ranges::union(segments.map(|[a, b]| ordered(a.x, b.x)).collect(), noise)
    }
}

/// The heights of corners, those within `noise` as 0.
pub(super) fn snapped(corners: &[DVec3], height: impl Fn(DVec3) -> f64, noise: f64) -> Vec<f64> {
    let heights = corners.iter().map(|corner| height(*corner));
    heights
        .map(|height| if height.abs() <= noise { 0.0 } else { height })
        .collect()
}

pub(super) fn ordered(a: f64, b: f64) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

/// The edges of a polygon, in order.
pub(super) fn edges(polygon: &Patch) -> impl Iterator<Item = [DVec3; 2]> + '_ {
    let corners = polygon.corners();
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| [*a, *b])
}
