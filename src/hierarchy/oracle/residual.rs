//! The residual of the radiosity, at one point towards each corner.
//!
//! ```text
//!   r(x) = E + R H(x) − B,    priority² = (A/n) Σ r(x)²          n points
//! ```
//!
//! The points are those of [`Element::gauss_points`]: 2 × 2 Gauss points in a rectangle.
//!
//! [`Element::gauss_points`]: crate::hierarchy::Element::gauss_points

use super::{HierarchyError, Indicator, View};
use crate::numeric::real;

/// The oracle of the residual.
#[derive(Debug, Clone, Copy)]
pub(super) struct Residual;

impl Indicator for Residual {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let element = view.element(leaf);
        let reflected = view.radiosity(leaf) - view.emittance(leaf);
        let (mut sum, mut points) = (0.0, 0_usize);
        for point in element.gauss_points() {
            let residual = view.reflectance(leaf) * view.received_at(leaf, point)? - reflected;
            sum += residual * residual;
            points += 1;
        }
        Ok((element.shape().area() * sum / real(points)).sqrt())
    }
}
