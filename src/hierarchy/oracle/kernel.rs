//! The variation of the form factors of an element, source by source.
//!
//! ```text
//!   priority = R Σ_j B_j ‖∇F_j·(x − c)‖ over the element
//! ```
//!
//! Sources do not make up for each other: the sum bounds the priority of the gradient, and is above
//! 0 in the light of a furnace, too.
//!
//! Reference: Lischinski, Smits, Greenberg, *Bounds and error estimates for radiosity*, 1994, whose
//! bounds on the kernel are replaced by its gradient.

use super::{HierarchyError, Indicator, View};

/// The oracle of the kernel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kernel;

impl Indicator for Kernel {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let element = view.element(leaf);
        let variations = view.links_of(leaf).map(|link| {
            let variation = element.norm_of_linear(link.gradient.as_dvec3());
            view.radiosity(link.source as usize) * variation
        });
        Ok(view.reflectance(leaf) * variations.sum::<f64>())
    }
}
