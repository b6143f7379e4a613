//! The irradiance of patches that reflect nothing.
//!
//! ```text
//!   A_i H_i = Σ_j A_i F_ij B_j        links (j, i): the patch i as a source, turned round
//!           + Σ_l J_il B_l            lights l that reflect nothing either, to which no link leads
//! ```

use super::HierarchyError;
use super::lighting::Lighting;
use super::link::Links;
use super::link_factor::LinkFactors;
use super::tree::Tree;
use super::turned::turned_links;
use crate::form_factor::{DEFAULT_TOLERANCE, Polygon};

/// The irradiance of each patch that reflects nothing, 0 for the others.
pub(super) fn black_irradiance(
    tree: &Tree,
    links: &Links,
    lighting: &Lighting,
    factors: &LinkFactors<'_>,
    radiosity: &[f64],
) -> Result<Vec<f64>, HierarchyError> {
    let is_black = |patch: usize| lighting.reflectance(patch) <= 0.0;
    let mut power = vec![0.0; tree.patches()];
    for turned in turned_links(tree, links, lighting) {
        let patch = tree.elements()[turned.receiver].patch();
        power[patch] += turned.exchange * radiosity[turned.source];
    }
    let polygon = |patch: usize| Polygon::new(tree.elements()[patch].shape());
    let black = || (0..tree.patches()).filter(|patch| is_black(*patch));
    for light in black().filter(|light| lighting.is_light(*light)) {
        let from = polygon(light);
        for patch in black().filter(|patch| *patch != light) {
            let sight = factors.visibility(patch, light);
            let ends = [&polygon(patch), &from];
            let exchange = factors.exchange_area(ends, sight, DEFAULT_TOLERANCE)?;
            power[patch] += exchange.value * lighting.emittance(light);
        }
    }
    for (patch, power) in power.iter_mut().enumerate() {
        *power /= tree.elements()[patch].shape().area();
    }
    Ok(power)
}
