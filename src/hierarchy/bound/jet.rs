//! Quadratic functions on a plane: Taylor's polynomials of irradiance.
//!
//! ```text
//!   f(c + d) = v + g·d + ½ dᵀ H d
//! ```

use glam::DVec2;

/// A quadratic function about a centre, which its owner knows.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Jet {
    pub(super) value: f64,
    pub(super) gradient: DVec2,
    /// The second derivatives: along the first axis, mixed, along the second axis.
    pub(super) hessian: [f64; 3],
}

impl Jet {
    /// The function that is the same everywhere.
    pub(super) fn constant(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }

    /// The value at a point, relative to the centre.
    pub(super) fn at(&self, d: DVec2) -> f64 {
        let [pp, pq, qq] = self.hessian;
        let square = pp * d.x * d.x + 2.0 * pq * d.x * d.y + qq * d.y * d.y;
        self.value + self.gradient.dot(d) + 0.5 * square
    }

    /// The function about a centre that is moved by d.
    pub(super) fn moved(&self, d: DVec2) -> Self {
        let [pp, pq, qq] = self.hessian;
        let turn = DVec2::new(pp * d.x + pq * d.y, pq * d.x + qq * d.y);
        Self {
            value: self.at(d),
            gradient: self.gradient + turn,
            hessian: self.hessian,
        }
    }

    /// Adds a multiple of a function about the same centre.
    pub(super) fn add(&mut self, weight: f64, other: &Self) {
        self.value += weight * other.value;
        self.gradient += weight * other.gradient;
        for (entry, other) in self.hessian.iter_mut().zip(other.hessian) {
            *entry += weight * other;
        }
    }
}
