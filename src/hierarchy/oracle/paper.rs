//! The three steps that §5 proposes, with a ranking in the place of the first threshold.
//!
//! ```text
//!   step 1   potential B_i B_j A_i F_ij of a pair                ranked, where §5 has ε₁
//!   step 2   of a pair, the one of larger W = A B H is cut
//!   step 3   only if its form factors to the other vary          largest − smallest > ε₂ · mean
//!   priority = Σ_j potential of the pairs that steps 2 and 3 leave
//! ```
//!
//! The form factors of step 3 are those between points, from the centres of the parts to that of
//! the other element. Where the other element is cut, W is the mean of its leaves. Lights take
//! part: they are cut, too. Where a plate stands between two of the points their form factor is 0.

use super::weights::{GeneralisedAreas, Pair};
use super::{HierarchyError, Oracle, View, of_each};
use crate::geometry::centroid;

/// The variation ε₂ that step 3 asks for; §5 has no value.
const VARIATION: f64 = 0.1;

/// The oracle of §5.
#[derive(Debug, Clone, Copy)]
pub(super) struct Paper;

impl Oracle for Paper {
    fn priorities(&self, view: &View<'_>, leaves: &[usize]) -> Result<Vec<f64>, HierarchyError> {
        let areas = GeneralisedAreas::of(view);
        of_each(leaves, &|leaf| {
            let own = areas.of_leaf(leaf);
            let mut pairs = areas.pairs(leaf);
            pairs.retain(|pair| own >= areas.of_leaf(pair.other));
            let variations = variations(view, leaf, &pairs)?;
            let varying = pairs.iter().zip(variations);
            let varying = varying.filter(|(_, variation)| *variation > VARIATION);
            let potentials = varying.map(|(pair, _)| view.radiosity(pair.other) * pair.exchange);
            Ok(view.radiosity(leaf) * potentials.sum::<f64>())
        })
    }

    fn cuts_lights(&self) -> bool {
        true
    }
}

/// The variation of the form factors of each pair over the leaf: largest less smallest, over the
/// mean, between centres.
pub(super) fn variations(
    view: &View<'_>,
    leaf: usize,
    pairs: &[Pair<'_>],
) -> Result<Vec<f64>, HierarchyError> {
    let parts = view.quarters(leaf)?;
    let normal = view.element(leaf).shape().normal();
    view.count_points(parts.len() * pairs.len());
    let of_pair = |pair: &Pair<'_>| {
        let other = view.element(pair.other);
        let to = [other.centre(), other.shape().normal()];
        let (mut low, mut high, mut sum) = (f64::INFINITY, 0.0_f64, 0.0);
        for part in &parts {
            let kernel = view
                .factors
                .kernel([[centroid(part), normal], to], pair.sight)?;
            let weighted = part.area() / view.element(leaf).shape().area() * kernel;
            (low, high, sum) = (low.min(kernel), high.max(kernel), sum + weighted);
        }
        Ok(if sum > 0.0 { (high - low) / sum } else { 0.0 })
    };
    pairs.iter().map(of_pair).collect()
}
