//! The mutual information of the light on a mesh, as its links describe it.
//!
//! ```text
//!   p(x, y) = F_ij/A_j · A_x B_x A_y B_y / S      x, y: leaves under i, j;  link (i, j)
//!   I = Σ p(x, y) log2 [p(x, y)/(p(x) p(y))]      S: the sum over all x, y
//! ```
//!
//! This is the chain of radiosity (§3.4) with states that are leaves: a link's form factor is
//! shared among the leaves of its source by their areas, and holds at all leaves of its receiver.
//! Any two leaves are connected by one link at most, so that a link is a block of constant density
//! `k = F_ij/A_j`, and with `a = A B` the sum needs no pairs of leaves:
//!
//! ```text
//!   S·I = S log2 S + Σ_ij a_i a_j k log2 k − Σ_x a_x h_x log2 h_x − Σ_y a_y g_y log2 g_y
//!   h_x = Σ_j k a_j,   g_y = Σ_i k a_i            links at x or y, and at elements around them
//! ```
//!
//! A patch that reflects nothing receives through no link, unless factors are exact; as a receiver
//! it has the links by which it is a source, turned round.
//!
//! **Not covered**: the gradients of links; light that goes from one patch without reflection to
//! another. The value is that of the links' own chain: no bound on that of the scene.

use super::lighting::Lighting;
use super::link::Links;
use super::tree::Tree;
use super::turned::{reflected_links, turned_links};
use crate::numeric::functions::elementary::log2;
use crate::numeric::x_log2_x;

/// The mutual information of the chain of radiosity on the leaves of a mesh, in bits, for the mean
/// radiosities of its elements; none if no link carries light.
#[must_use]
pub fn link_information(
    tree: &Tree,
    links: &Links,
    lighting: &Lighting,
    radiosity: &[f64],
) -> Option<f64> {
    let power = shares_of_power(tree, radiosity);
    let (mut received, mut given) = (vec![0.0; power.len()], vec![0.0; power.len()]);
    let (mut sum, mut joint) = (0.0, 0.0);
    for (receiver, source, density) in blocks(tree, links, lighting) {
        let product = power[receiver] * power[source];
        sum += density * product;
        joint += x_log2_x(density) * product;
        received[receiver] += density * power[source];
        given[source] += density * power[receiver];
    }
    let marginals = [received, given].map(|sums| {
        let sums = pushed_down(tree, sums);
        let leaves = tree.leaves();
        leaves
            .map(|leaf| power[leaf] * x_log2_x(sums[leaf]))
            .sum::<f64>()
    });
    let information = log2(sum) + (joint - marginals[0] - marginals[1]) / sum;
    (sum > 0.0 && information.is_finite()).then_some(information)
}

/// Receiver, source and density of each block.
fn blocks<'l>(
    tree: &'l Tree,
    links: &'l Links,
    lighting: &'l Lighting,
) -> impl Iterator<Item = (usize, usize, f64)> {
    let area = |element: usize| tree.elements()[element].shape().area();
    let reflected = reflected_links(tree, links, lighting).map(move |(link, _)| {
        let (receiver, source) = (link.receiver as usize, link.source as usize);
        (receiver, source, link.value / area(source))
    });
    let turned = turned_links(tree, links, lighting).map(move |turned| {
        let (receiver, source) = (turned.receiver, turned.source);
        let density = turned.exchange / (area(source) * area(receiver));
        (receiver, source, density)
    });
    reflected.chain(turned)
}

/// The power of each element as a share of the whole, which keeps products in range.
fn shares_of_power(tree: &Tree, radiosity: &[f64]) -> Vec<f64> {
    let elements = tree.elements().iter().zip(radiosity);
    let power: Vec<f64> = elements
        .map(|(element, radiosity)| element.shape().area() * radiosity)
        .collect();
    let whole: f64 = power[..tree.patches()].iter().sum();
    power.iter().map(|power| power / whole).collect()
}

/// The sums of each element and all that are around it.
fn pushed_down(tree: &Tree, mut sums: Vec<f64>) -> Vec<f64> {
    for (index, element) in tree.elements().iter().enumerate() {
        let above = sums[index];
        for child in element.children() {
            sums[child] += above;
        }
    }
    sums
}
