//! The frame of P, into which corners are put from 106 bits, and planes in it that cut polygons
//! off.

use crate::form_factor::Polygon;
use crate::geometry::{Vector, clipped};
use crate::numeric::{DoubleDouble, Scalar};
use glam::DVec3;

/// A corner, and how far it is from its exact place at most.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Set {
    pub place: DVec3,
    pub displaced: f64,
}

/// The frame of a polygon: its first corner, two directions in its plane, its normal.
pub(crate) struct Frame {
    origin: Vector<DoubleDouble>,
    axes: [Vector<DoubleDouble>; 3],
}

impl Frame {
    pub(crate) fn of(polygon: &Polygon) -> Self {
        let zero = DoubleDouble::from(0.0);
        let one = zero.constant(1.0);
        let unit = |vector: Vector<DoubleDouble>| vector.times(one / vector.length());
        let corners = &polygon.shape.corners;
        let normal = polygon.precise_normal;
        let origin = Vector::lifted(corners[0], zero);
        let flat = polygon.normal.abs();
        let along = if flat.max_element() >= 1.0 {
            // the plane of two coordinates: they stay as they are
            let axis = if flat.x >= 1.0 { DVec3::Y } else { DVec3::X };
            Vector::lifted(axis, zero)
        } else {
            let along = Vector::lifted(corners[1], zero).minus(origin);
            unit(along.minus(normal.times(along.dot(normal))))
        };
        Self {
            origin,
            axes: [along, normal.cross(along), normal],
        }
    }

    /// A point, in the frame and some unit: a power of two.
    pub(crate) fn place(&self, point: DVec3) -> Vector<DoubleDouble> {
        let from_origin = Vector::lifted(point, DoubleDouble::from(0.0)).minus(self.origin);
        self.turned(from_origin)
    }

    pub(crate) fn turned(&self, vector: Vector<DoubleDouble>) -> Vector<DoubleDouble> {
        Vector(self.axes.map(|axis| vector.dot(axis)))
    }
}

/// The points over which `normal·x ≥ offset`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    pub normal: DVec3,
    pub offset: f64,
}

impl Plane {
    fn height(&self, place: DVec3) -> f64 {
        self.normal.dot(place) - self.offset
    }

    /// The largest height over the plane that counts as none.
    pub(crate) fn nearest(&self, piece: &[Set], touching: f64) -> f64 {
        let heights = piece.iter().map(|corner| self.height(corner.place).abs());
        let near = heights.filter(|height| *height <= touching);
        near.fold(0.0, f64::max)
    }

    /// The part of a convex polygon in front of the plane; none if it does not rise above it.
    ///
    /// Corners that count as level are put into P's plane exactly. A corner between two others is
    /// as far from its place as these are, and as the rounding of three products and a sum.
    pub(crate) fn front_of(&self, piece: &[Set], touching: f64) -> Option<Vec<Set>> {
        let height = |corner: &Set| {
            let height = self.height(corner.place);
            if height.abs() <= touching {
                0.0
            } else {
                height
            }
        };
        let heights: Vec<f64> = piece.iter().map(height).collect();
        if heights.iter().all(|height| *height <= 0.0) {
            return None;
        }
        let level = piece.iter().zip(&heights).map(|(corner, height)| {
            let mut corner = *corner;
            if *height == 0.0 {
                corner.displaced += self.height(corner.place).abs();
                if self.normal == DVec3::Z {
                    corner.place.z = 0.0;
                }
            }
            corner
        });
        let level: Vec<Set> = level.collect();
        if heights.iter().all(|height| *height >= 0.0) {
            return Some(level);
        }
        let between = |from: Set, to: Set, share: f64| {
            let reach = from.place.length().max(to.place.length());
            let displaced = from.displaced.max(to.displaced) + 3.0 * f64::EPSILON * reach;
            let place = from.place.lerp(to.place, share);
            let mut corner = Set { place, displaced };
            if self.normal == DVec3::Z {
                // moved along the edge, but for rounding
                corner.place.z = 0.0;
            }
            corner
        };
        Some(clipped(&level, &heights, between))
    }
}
