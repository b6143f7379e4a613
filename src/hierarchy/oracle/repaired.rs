//! The steps of §5, repaired where they mislead.
//!
//! ```text
//!   step 1   R_i B_j A_i F_ij          what i reflects of j, the power oracle: no B_i
//!   step 2   as in §5, but a light never takes a pair from the other element
//!   step 3   the variation of the form factors is a factor, no threshold
//!   priority = Σ_j R_i B_j A_i F_ij · variation of F_ij
//! ```

use super::paper::variations;
use super::weights::GeneralisedAreas;
use super::{HierarchyError, Oracle, View, of_each};

/// The oracle of §5, repaired.
#[derive(Debug, Clone, Copy)]
pub(super) struct Repaired;

impl Oracle for Repaired {
    fn priorities(&self, view: &View<'_>, leaves: &[usize]) -> Result<Vec<f64>, HierarchyError> {
        let areas = GeneralisedAreas::of(view);
        of_each(leaves, &|leaf| {
            let own = areas.of_leaf(leaf);
            let mut pairs = areas.pairs(leaf);
            pairs.retain(|pair| {
                view.emittance(pair.other) > 0.0 || own >= areas.of_leaf(pair.other)
            });
            let variations = variations(view, leaf, &pairs)?;
            let terms = pairs
                .iter()
                .zip(variations)
                .map(|(pair, variation)| view.radiosity(pair.other) * pair.exchange * variation);
            Ok(view.reflectance(leaf) * terms.sum::<f64>())
        })
    }
}
