//! §5's gain in mutual information, for a radiosity that is constant on the element.
//!
//! ```text
//!   priority = 2 Σ_j B_i B_j (Σ_k A_k F_kj log2 F_kj − A_i F_ij log2 F_ij)          ≥ 0
//! ```
//!
//! over the four parts k of the element, with form factors from their centres. It is above 0 in
//! uniform light, too: the parts know better from which side light comes.
//!
//! **Not covered**: the change of the radiosity over the parts; the reflectance.

use super::parts::Parts;
use super::{HierarchyError, Indicator, View};

/// The oracle of §5's information.
#[derive(Debug, Clone, Copy)]
pub(super) struct Information;

impl Indicator for Information {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let parts = Parts::of(view, leaf)?;
        let ones = vec![1.0; parts.areas.len()];
        let gains = view.links_of(leaf).enumerate().map(|(position, link)| {
            view.radiosity(link.source as usize) * parts.gain(position, &ones, &parts.areas)
        });
        Ok(2.0 * view.radiosity(leaf) * gains.sum::<f64>())
    }
}
