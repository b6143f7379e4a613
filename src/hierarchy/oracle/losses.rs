//! The information that the links of an element lose: continuous less discrete.
//!
//! ```text
//!   priority = 2 Σ_j B_i B_j (∫∫ k log2 k − E_ij log2(E_ij/(A_i A_j))) ,   E_ij = ∫∫ k
//!            ≈ 2 Σ_j B_i B_j D({k(x, y)} ‖ 1) A_i A_j/(n n′)              ≥ 0
//! ```
//!
//! over one point x towards each of the n corners of the element and y towards each of the n′ of
//! the source ([`Element::gauss_points`]). What the source's size loses is in it, too. The closed
//! form ([`LogMeans`]) takes a hundred times as long.
//!
//! **Not covered**: the singularity of elements that touch, of which the points see a part; the
//! change of radiosity over elements.
//!
//! [`Element::gauss_points`]: crate::hierarchy::Element::gauss_points
//! [`LogMeans`]: crate::form_factor::LogMeans

use super::{HierarchyError, Indicator, View};
use crate::hierarchy::link_factor::Visibility;
use crate::hierarchy::tree::Element;
use crate::information::relative_entropy;
use crate::numeric::real;

/// The oracle of lost information.
#[derive(Debug, Clone, Copy)]
pub(super) struct Losses;

impl Indicator for Losses {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let mut sum = 0.0;
        for (link, sight) in view.sights_of(leaf) {
            let [element, source] = [leaf, link.source as usize].map(|end| view.element(end));
            let kernels = kernels(view, [element, source], sight)?;
            view.count_points(kernels.len());
            let areas = element.shape().area() * source.shape().area();
            let loss = areas * divergence_from_even(&kernels);
            sum += view.radiosity(link.source as usize) * loss;
        }
        Ok(2.0 * view.radiosity(leaf) * sum)
    }
}

/// The kernels between the points of two elements, past what stands between them.
fn kernels(
    view: &View<'_>,
    [element, source]: [&Element; 2],
    sight: &Visibility,
) -> Result<Vec<f64>, HierarchyError> {
    let [from, to] = [element, source].map(|end| end.shape().normal());
    let targets: Vec<_> = source.gauss_points().collect();
    let mut kernels = Vec::with_capacity(16);
    for x in element.gauss_points() {
        for y in &targets {
            kernels.push(view.factors.kernel([[x, from], [*y, to]], sight)?);
        }
    }
    Ok(kernels)
}

/// The mean of `k log2 k` less that of the mean, in bits.
fn divergence_from_even(kernels: &[f64]) -> f64 {
    let share = 1.0 / real(kernels.len());
    let parts: Vec<[f64; 2]> = kernels.iter().map(|k| [share * k, share]).collect();
    let flux: f64 = parts.iter().map(|part| part[0]).sum();
    if flux > 0.0 {
        relative_entropy(&flux, &1.0, &parts)
    } else {
        0.0
    }
}
