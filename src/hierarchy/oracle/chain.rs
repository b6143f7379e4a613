//! The exact gain of eq. (5) in the brightness chain of §3.4, whose states are the elements.
//!
//! ```text
//!   J_kj = B_k A_k F_kj B_j,   w_k = Σ_j J_kj = A_k B_k H_k,   B_k = E + R H_k
//!   priority = 2 Σ_j (Σ_k J_kj log2(J_kj/w_k) − J_ij log2(J_ij/w_i))          ≥ 0
//! ```
//!
//! over the four parts k of the element, with form factors from their centres. A part is
//! weighed by what it receives, so that a change which all sources share is no gain: the sum judges
//! from where light comes, not how much comes.

use super::parts::Parts;
use super::{HierarchyError, Indicator, View};

/// The oracle of the brightness chain.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chain;

impl Indicator for Chain {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let parts = Parts::of(view, leaf)?;
        let received = parts.factors.iter().map(|row| view.gathered(leaf, row));
        let received: Vec<f64> = received.collect();
        let (emitted, reflectance) = (view.emittance(leaf), view.reflectance(leaf));
        let brightness = received.iter().map(|h| emitted + reflectance * h);
        let brightness: Vec<f64> = brightness.collect();
        let weights = (0..parts.areas.len()).map(|k| parts.areas[k] * brightness[k] * received[k]);
        let weights: Vec<f64> = weights.collect();
        let gains = view.links_of(leaf).enumerate().map(|(position, link)| {
            let gain = parts.gain(position, &brightness, &weights);
            view.radiosity(link.source as usize) * gain
        });
        Ok(2.0 * gains.sum::<f64>())
    }
}
