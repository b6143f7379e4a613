//! Lambert's formula with its gradient: the form factor from a point to a polygon, and how it
//! changes as the point moves.
//!
//! ```text
//!   F  = −(1/2π) Σ_b q n·c              a, b: from x to the ends of an edge, d = b − a, c = a × b,
//!                                       q = θ/|c|,  θ: angle that the edge subtends at x
//!   ∇F = −(1/2π) Σ_b q n×d + (n·c) ∇q
//!   ∇q = (a + b)/ρ² + g c×d             ρ = |a| |b|,  g = (a·b/ρ² − q)/|c|²
//! ```
//!
//! by `dc = d × dx` (`edge` has q and g), over the edges of the part of the polygon above the
//! horizon n·(y − x) = 0, counter-clockwise seen from its own front. As the point moves, the
//! horizon moves, too; the integrand is 0 there, so that the gradient is that of the part as it is.
//!
//! **Not covered**: what stands in the way; a bound on rounding.
//!
//! Reference: Arvo, "The irradiance Jacobian for partially occluded polyhedral sources", SIGGRAPH
//! 1994, 343–350.

use super::edge::{Edge, above_horizon, edges};
use crate::form_factor::FormFactorError;
use crate::geometry::Patch;
use glam::DVec3;
use std::f64::consts::TAU;

/// A form factor from a point of a surface, and its gradient by the point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PointFactor {
    /// The fraction of what leaves the point that reaches the polygon.
    pub value: f64,
    /// The change per length by which the point moves, the normal kept; per unit of length.
    pub gradient: DVec3,
}

impl PointFactor {
    /// The factor that is 0 all around.
    pub const NOTHING: Self = Self {
        value: 0.0,
        gradient: DVec3::ZERO,
    };
}

/// The form factor from a point of a surface to a polygon, and its gradient as the point moves.
///
/// **Arguments** `normal`: unit normal of the surface at `point`; the polygon is clipped at its
/// horizon.
/// **Returns** nothing, and no slope, if the point is behind the polygon's plane or on it.
/// **Accuracy** some ε of the sum of the terms' magnitudes: the angles that the edges subtend, over
/// their distances for the gradient; `gradients_are_those_of_the_textbook_formula` measures it.
///
/// # Errors
/// [`FormFactorError::NotAUnitNormal`]; [`FormFactorError::NotAPoint`];
/// [`FormFactorError::OutOfRange`] if distances have no sixth powers in `f64`.
///
/// # Examples
/// ```
/// use glam::DVec3;
/// use infoscene::form_factor::point_form_factor_with_gradient;
/// use infoscene::geometry::Patch;
/// // a small square of area A far above: F = A/(π z²), so that a step up adds 2 A/(π z³)
/// let z = 100.0;
/// let corners = [[0.5, -0.5], [-0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]];
/// let square = Patch::try_new(corners.map(|[x, y]| DVec3::new(x, y, z)).to_vec())?;
/// let seen = point_form_factor_with_gradient(DVec3::ZERO, DVec3::Z, &square)?;
/// let slope = 2.0 / (std::f64::consts::PI * z.powi(3));
/// assert!((seen.gradient.z / slope - 1.0).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn point_form_factor_with_gradient(
    point: DVec3,
    normal: DVec3,
    polygon: &Patch,
) -> Result<PointFactor, FormFactorError> {
    let square = normal.length_squared();
    if square.is_nan() || (square - 1.0).abs() > 2e-9 {
        let length = square.sqrt();
        return Err(FormFactorError::NotAUnitNormal { length });
    }
    if !point.is_finite() {
        let DVec3 { x, y, z } = point;
        return Err(FormFactorError::NotAPoint { x, y, z });
    }
    let corners = polygon.corners();
    if (point - corners[0]).dot(polygon.normal()) <= 0.0 {
        return Ok(PointFactor::NOTHING);
    }
    let mut sum = Sum::default();
    edges(&above_horizon(point, normal, corners), |edge| {
        sum.add(edge, normal)
    });
    sum.finished()
}

/// `−2π F` and its gradient, edge by edge.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    value: f64,
    gradient: DVec3,
}

impl Sum {
    #[inline(always)]
    fn add(&mut self, edge: &Edge, normal: DVec3) {
        let up = normal.dot(edge.across);
        self.value += edge.angle_per_length * up;
        self.gradient += normal.cross(edge.along) * edge.angle_per_length + edge.slope() * up;
    }

    /// The factor, if it is a number.
    #[inline]
    fn finished(self) -> Result<PointFactor, FormFactorError> {
        let gradient = self.gradient / -TAU;
        // rounding may leave the ends of the range by a few ε
        let value = (self.value / -TAU).clamp(0.0, 1.0);
        if value.is_finite() && gradient.is_finite() {
            Ok(PointFactor { value, gradient })
        } else {
            Err(FormFactorError::OutOfRange { value })
        }
    }
}
