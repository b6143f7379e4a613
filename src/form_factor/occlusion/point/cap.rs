//! Circular cones around polygons: two that do not meet have nothing to do with each other.

use super::cone::Ray;
use glam::DVec3;

/// A circular cone around a polygon.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cap {
    axis: DVec3,
    cosine: f64,
    sine: f64,
}

impl Cap {
    /// All directions.
    pub(super) const EVERYWHERE: Self = Self {
        axis: DVec3::Z,
        cosine: -1.0,
        sine: 0.0,
    };

    /// The cap around these rays.
    pub(super) fn around(rays: &[Ray]) -> Self {
        let axis: DVec3 = rays.iter().map(|ray| ray.unit).sum();
        let axis = axis.normalize_or_zero();
        let cosines = rays.iter().map(|ray| ray.unit.dot(axis));
        let cosine = cosines.fold(1.0, f64::min) - 1e-9;
        if cosine <= 0.0 {
            return Self::EVERYWHERE;
        }
        Self {
            axis,
            cosine,
            sine: (1.0 - cosine * cosine).sqrt(),
        }
    }

    /// May the two have a direction in common?
    pub(super) fn meets(&self, other: &Self) -> bool {
        let is_everywhere = self.cosine <= 0.0 || other.cosine <= 0.0;
        let apart = self.cosine * other.cosine - self.sine * other.sine;
        is_everywhere || self.axis.dot(other.axis) >= apart - 1e-9
    }
}
