//! The deviation of the light that the parts of an element would gather.
//!
//! ```text
//!   priority² = R² Σ_k A_k (H_k − H)²          H_k: by form factors between whole polygons,
//!                                              H: their mean by areas
//! ```
//!
//! This is the square error that cutting takes away, for the light as it is.

use super::{HierarchyError, Indicator, View};

/// The oracle of one gather.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gather;

impl Indicator for Gather {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let parts = view.quarters(leaf)?;
        let mut gathered = Vec::with_capacity(parts.len());
        for part in &parts {
            let factors = view.mean_factors(leaf, part)?;
            gathered.push((part.area(), view.gathered(leaf, &factors)));
        }
        let area: f64 = gathered.iter().map(|(area, _)| area).sum();
        let mean = gathered.iter().map(|(area, h)| area * h).sum::<f64>() / area;
        let squares = gathered.iter().map(|(area, h)| area * (h - mean).powi(2));
        Ok(view.reflectance(leaf) * squares.sum::<f64>().sqrt())
    }
}
