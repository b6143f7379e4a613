//! One exchange of light through links: up the tree, along the links, down the tree.
//!
//! ```text
//!   pull     B_i = Σ_c A_c B_c/A_i                              children c of i
//!   gather   H_i = Σ_j F_ij B_j,   G_i = Σ_j ∇F_ij B_j          links (i, j)
//!   push     H_c += H_i + G_i·(c_c − c_i),   G_c += G_i
//! ```
//!
//! Exact means are pushed as they are, `H_c += H_i`: row and column sums of what they describe are
//! equal then, so that no energy is lost.

use super::link::Links;
use super::linking::Factors;
use super::tree::Tree;
use crate::numeric::parallel_map;
use glam::DVec3;

/// Elements whose links are summed in one go.
const BLOCK: usize = 512;

/// What elements receive: the irradiance at their centres, and its gradient in their planes.
#[derive(Debug, Clone, Default)]
pub struct Received {
    /// The irradiance at the centre of each element.
    pub irradiance: Vec<f64>,
    /// Its gradient, per unit of length.
    pub gradient: Vec<DVec3>,
}

/// Gives elements that are cut the means of their children.
pub(super) fn pull(tree: &Tree, values: &mut [f64]) {
    for (index, element) in tree.elements().iter().enumerate().rev() {
        if element.is_leaf() {
            continue;
        }
        let children = element.children();
        let sum: f64 = children
            .map(|child| tree.elements()[child].shape().area() * values[child])
            .sum();
        values[index] = sum / element.shape().area();
    }
}

/// The standard deviation of each element's leaves from their mean.
pub(super) fn deviations(tree: &Tree, values: &[f64]) -> Vec<f64> {
    let mut squares = vec![0.0; values.len()];
    for (index, element) in tree.elements().iter().enumerate().rev() {
        for child in element.children() {
            let share = tree.elements()[child].shape().area() / element.shape().area();
            let off = values[child] - values[index];
            squares[index] += share * (squares[child] + off * off);
        }
    }
    squares.iter().map(|square| square.sqrt()).collect()
}

/// What all elements receive from elements with these means.
pub(super) fn received(tree: &Tree, links: &Links, factors: Factors, means: &[f64]) -> Received {
    let count = tree.elements().len();
    let blocks = parallel_map(count.div_ceil(BLOCK), &|block| {
        let elements = block * BLOCK..(block * BLOCK + BLOCK).min(count);
        elements
            .map(|element| gathered(links, element, means))
            .collect::<Vec<_>>()
    });
    let (mut irradiance, mut gradient): (Vec<f64>, Vec<DVec3>) =
        blocks.into_iter().flatten().unzip();
    for (index, element) in tree.elements().iter().enumerate() {
        let (above, slope) = (irradiance[index], gradient[index]);
        for child in element.children() {
            let offset = tree.elements()[child].centre() - element.centre();
            irradiance[child] += above;
            if factors == Factors::OfPoints {
                irradiance[child] += slope.dot(offset);
            }
            gradient[child] += slope;
        }
    }
    Received {
        irradiance,
        gradient,
    }
}

fn gathered(links: &Links, element: usize, means: &[f64]) -> (f64, DVec3) {
    let (mut sum, mut slope) = (0.0, DVec3::ZERO);
    for link in links.of(element) {
        let mean = means[link.source as usize];
        sum += link.value * mean;
        slope += link.gradient.as_dvec3() * mean;
    }
    (sum, slope)
}
