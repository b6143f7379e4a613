//! The gradient of the irradiance, which links deliver with it.
//!
//! ```text
//!   priority = R ‖∇H·(x − c)‖ over the element
//! ```
//!
//! This is the error of the mean of a radiosity that is linear on the element.

use super::{HierarchyError, Indicator, View};

/// The oracle of the gradient.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gradient;

impl Indicator for Gradient {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let gradient = view.solution.received.gradient[leaf];
        Ok(view.reflectance(leaf) * view.element(leaf).norm_of_linear(gradient))
    }
}
