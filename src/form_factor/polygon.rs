//! A patch prepared for form factors: the quantities that every route needs of it, computed once.

use crate::form_factor::clipped_pair::shape::Shape;
use crate::geometry::{AlignedRectangle, Patch, Rectangle, Vector};
use crate::numeric::{DoubleDouble, Scalar, power_of_two_below, vector_value};
use glam::DVec3;
use std::f64::consts::PI;

/// A planar simple polygon, with its normal to 106 bits and all that does not depend on another
/// polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Polygon {
    pub(super) shape: Shape,
    pub(super) normal: DVec3,
    pub(super) precise_normal: Vector<DoubleDouble>,
    /// The largest distance of a corner from the plane, per distance along it.
    pub(super) tilt: f64,
    /// The polygon as a rectangle with edges along the coordinate axes, if it is one.
    pub(super) rectangle: Option<AlignedRectangle>,
}

impl Polygon {
    /// The polygon of a patch.
    #[must_use]
    pub fn new(patch: &Patch) -> Self {
        let mut polygon = Self::of(patch.corners(), Rectangle::try_from(patch).ok())
            .unwrap_or_else(|| unreachable!("a patch has an area, so three corners apart"));
        if patch.moved() > 0.0 {
            // the plane is meant, whose corners are rounded: far less than they were moved by
            polygon.tilt = 0.0;
        }
        polygon
    }

    /// `None` if no three corners are apart, or nothing is left of the area.
    fn of(corners: &[DVec3], rectangle: Option<Rectangle>) -> Option<Self> {
        let like = DoubleDouble::from(0.0);
        let points: Vec<Vector<DoubleDouble>> = corners
            .iter()
            .map(|corner| Vector::lifted(*corner, like))
            .collect();
        // in units of a power of two near its size, so that squares of areas stay in range
        let size = corners
            .iter()
            .map(|c| (*c - corners[0]).abs().max_element());
        let inverse_unit = 1.0 / power_of_two_below(size.fold(0.0, f64::max));
        let along = |i: usize| {
            points[i]
                .minus(points[0])
                .times(like.constant(inverse_unit))
        };
        let doubled = (1..points.len() - 1)
            .map(|i| along(i).cross(along(i + 1)))
            .fold(Vector([like; 3]), |sum, next| {
                sum.plus(next, like.constant(1.0))
            });
        let length = doubled.length();
        let precise_normal = doubled.times(like.constant(1.0) / length);
        let heights = (1..points.len()).map(|i| along(i).dot(precise_normal).to_f64().abs());
        let deviation = heights.fold(0.0, f64::max);
        let diameter = (1..points.len())
            .map(|i| along(i).length().to_f64())
            .fold(0.0, f64::max);
        // the polygon is at least 2 A/diameter wide: a deviation there turns the plane by so much
        // at most
        let tilt = 2.0 * deviation * diameter / length.to_f64();
        let shape = Shape::new(corners, precise_normal)?;
        let has_normal = precise_normal.to_doubles().is_finite();
        has_normal.then(|| Self {
            shape,
            normal: precise_normal.to_doubles(),
            precise_normal,
            tilt,
            rectangle: rectangle.and_then(|rectangle| rectangle.aligned()),
        })
    }

    /// Times a power of two; `None` if it is lost below the range of `f64`.
    pub(super) fn scaled(&self, factor: f64) -> Option<Self> {
        let corners: Vec<DVec3> = self.shape.corners.iter().map(|c| *c * factor).collect();
        Self::of(&corners, None)
    }

    /// Area, from 106 bits, in squared units of length.
    #[must_use]
    pub const fn area(&self) -> f64 {
        self.shape.area
    }

    /// Perimeter, in units of length.
    #[must_use]
    pub const fn perimeter(&self) -> f64 {
        self.shape.perimeter
    }

    /// A bound on the form factors between the two, > 0, from the areas and the distance of spheres
    /// around them; up to some roundings.
    pub(crate) fn largest_form_factor(&self, other: &Self) -> f64 {
        let (one, two) = (&self.shape, &other.shape);
        let gap = one.centre.distance(two.centre) - (one.radius + two.radius);
        if gap <= 0.0 {
            return 1.0;
        }
        (one.area.max(two.area) / (gap * gap) / PI).min(1.0)
    }

    /// The height of a point above the plane, to 106 bits; to be called where vector code is made,
    /// which has fused products.
    #[inline(always)]
    pub(super) fn precise_height(&self, point: DVec3) -> DoubleDouble {
        let zero = DoubleDouble::from(0.0);
        let origin = Vector::lifted(self.shape.corners[0], zero);
        Vector::lifted(point, zero)
            .minus(origin)
            .dot(self.precise_normal)
    }

    /// The height of a point above the plane, rounded from 106 bits.
    pub(super) fn height(&self, point: DVec3) -> f64 {
        vector_value!(0.0, self.precise_height(point).to_f64())
    }
}
