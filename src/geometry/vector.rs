//! Vectors over any fast number type.

use crate::numeric::Scalar;
use glam::DVec3;

/// Three coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Vector<S>(pub [S; 3]);

impl<S: Scalar + Copy> Vector<S> {
    /// `self − other`.
    #[inline(always)]
    #[must_use]
    pub(crate) fn minus(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a - x, b - y, c - z])
    }

    /// `self + other·factor`.
    #[inline(always)]
    #[must_use]
    pub(crate) fn plus(self, other: Self, factor: S) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x * factor, b + y * factor, c + z * factor])
    }

    /// Times a number.
    #[inline(always)]
    #[must_use]
    pub(crate) fn times(self, factor: S) -> Self {
        let [x, y, z] = self.0;
        Self([x * factor, y * factor, z * factor])
    }

    /// Scalar product.
    #[inline(always)]
    #[must_use]
    pub(crate) fn dot(self, other: Self) -> S {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    /// Vector product.
    #[inline(always)]
    #[must_use]
    pub(crate) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// Length.
    #[inline(always)]
    #[must_use]
    pub(crate) fn length(self) -> S {
        self.dot(self).sqrt()
    }

    /// A point in the number type of `like`, exactly.
    #[must_use]
    #[inline(always)]
    pub(crate) fn lifted(point: DVec3, like: S) -> Self {
        Self([
            like.constant(point.x),
            like.constant(point.y),
            like.constant(point.z),
        ])
    }

    /// Rounded to doubles.
    #[must_use]
    #[inline(always)]
    pub(crate) fn to_doubles(self) -> DVec3 {
        let [x, y, z] = self.0;
        DVec3::new(x.to_f64(), y.to_f64(), z.to_f64())
    }
}
