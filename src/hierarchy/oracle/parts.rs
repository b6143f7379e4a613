//! The exchange of an element's parts with the sources of its links, as information asks for it.

use super::{HierarchyError, View};
use crate::geometry::centroid;
use crate::information::relative_entropy;

/// The parts of an element with the form factors from their centres.
pub(super) struct Parts {
    pub(super) areas: Vec<f64>,
    /// The form factors of each part to the sources of the element's links, in their order.
    pub(super) factors: Vec<Vec<f64>>,
}

impl Parts {
    /// The quarters of a leaf.
    pub(super) fn of(view: &View<'_>, leaf: usize) -> Result<Self, HierarchyError> {
        let quarters = view.quarters(leaf)?;
        let factors = quarters
            .iter()
            .map(|quarter| view.factors_at(leaf, centroid(quarter)));
        Ok(Self {
            factors: factors.collect::<Result<_, _>>()?,
            areas: quarters.iter().map(|quarter| quarter.area()).collect(),
        })
    }

    /// The information that is gained about one source, in units of flux: `Σ_k J_k log2(J_k/w_k) −
    /// J log2(J/w)` for the fluxes `J_k = b_k A_k F_k` of parts with these brightnesses b and
    /// weights w.
    pub(super) fn gain(&self, link: usize, brightness: &[f64], weights: &[f64]) -> f64 {
        let flux = |k: usize| brightness[k] * self.areas[k] * self.factors[k][link];
        let parts: Vec<[f64; 2]> = (0..self.areas.len())
            .map(|k| [flux(k), weights[k]])
            .collect();
        let [flux, weight] = [0, 1].map(|i| parts.iter().map(|part| part[i]).sum::<f64>());
        let is_lit = flux > 0.0 && parts.iter().all(|part| part[1] > 0.0);
        if is_lit {
            relative_entropy(&flux, &weight, &parts)
        } else {
            0.0
        }
    }
}
