//! A product Gauss rule of a fixed order over the first polygon, from each point of which what is
//! visible of the second is known in closed form.
//!
//! ```text
//!   A_P F ≈ Σ_x w_x F(x)        F(x): form factor from the point x past the blockers
//! ```
//!
//! What an engine does that knows the closed form of a point and nothing more. No bound: F bends
//! where blockers begin to hide, and a rule across such a line converges slowly.

use crate::form_factor::{Occluders, Polygon, point_form_factor_past};
use crate::geometry::Patch;
use crate::study::form_factors::gauss_order::points;

/// The exchange area with `order × order` points on each triangle of the first polygon; `None` if a
/// point is refused.
pub(crate) fn exchange_area(
    [first, second]: &[Patch; 2],
    blockers: &[Polygon],
    order: usize,
) -> Option<f64> {
    let polygons: Vec<&Polygon> = blockers.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    let receiver = Polygon::new(second);
    let mut sum = 0.0;
    for (point, weight) in points(first, order) {
        let seen = point_form_factor_past(point, first.normal(), &receiver, &occluders).ok()?;
        sum += weight * seen.value;
    }
    Some(sum).filter(|sum| sum.is_finite())
}
