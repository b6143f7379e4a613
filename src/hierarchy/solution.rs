//! The equilibrium of light on a mesh with its links.
//!
//! ```text
//!   B_i = (E_i + R_i H_i)/(1 − R_i (1 − s_i))        s_i: the row sum of the links, 1 where open
//! ```
//!
//! The links of a leaf of a closed room do not sum to one exactly; what is missing, or too much,
//! counts as light of its own brightness, so that a furnace has `B = E/(1 − R)` to rounding.

use super::HierarchyError;
use super::exchange::{Received, deviations, pull, received};
use super::lighting::Lighting;
use super::link::Links;
use super::linking::Factors;
use super::tree::Tree;
use crate::numeric::gmres;
use glam::DVec3;

/// Products with the links that a solution may take.
const MOST_PRODUCTS: usize = 4000;

/// Radiosities on a mesh: a constant on each leaf, and the linear function about its centre.
#[derive(Debug, Clone)]
pub struct Solution {
    /// The mean radiosity of each element.
    pub radiosity: Vec<f64>,
    /// The standard deviation of the leaves of each element from its mean.
    pub deviation: Vec<f64>,
    /// What the elements receive.
    pub received: Received,
    /// Products with the links.
    pub products: usize,
}

impl Solution {
    /// The light of patches that receive none yet.
    pub(super) fn dark(lighting: &Lighting) -> Self {
        let patches = lighting.patches();
        Self {
            radiosity: (0..patches)
                .map(|patch| lighting.emittance(patch))
                .collect(),
            received: Received {
                irradiance: vec![0.0; patches],
                gradient: vec![DVec3::ZERO; patches],
            },
            deviation: vec![0.0; patches],
            products: 0,
        }
    }

    /// The gradient of the radiosity at the centre of a leaf.
    #[must_use]
    pub fn gradient(&self, tree: &Tree, lighting: &Lighting, leaf: usize) -> DVec3 {
        lighting.reflectance(tree.elements()[leaf].patch()) * self.received.gradient[leaf]
    }
}

/// What a system depends on beside mesh, links and materials.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Mode {
    pub(super) factors: Factors,
    /// Does nothing escape?
    pub(super) is_closed: bool,
}

/// The system of a mesh and its links.
pub(super) struct System<'s> {
    tree: &'s Tree,
    links: &'s Links,
    mode: Mode,
    leaves: Vec<usize>,
    /// `1 − s` of each leaf, 0 where open.
    missing: Vec<f64>,
    /// `R` and `E`, over `1 − R (1 − s)`, of each leaf.
    factors: Vec<f64>,
    sources: Vec<f64>,
}

impl<'s> System<'s> {
    /// The system of a mesh, its links and its materials.
    pub(super) fn new(tree: &'s Tree, links: &'s Links, lighting: &Lighting, mode: Mode) -> Self {
        let leaves: Vec<usize> = tree.leaves().collect();
        let missing: Vec<f64> = if mode.is_closed {
            let ones = vec![1.0; tree.elements().len()];
            let sums = received(tree, links, mode.factors, &ones).irradiance;
            leaves.iter().map(|leaf| 1.0 - sums[*leaf]).collect()
        } else {
            vec![0.0; leaves.len()]
        };
        let scaled = |value: &dyn Fn(usize) -> f64| -> Vec<f64> {
            let leaves = leaves.iter().zip(&missing);
            let scaled = leaves.map(|(leaf, missing)| {
                let patch = tree.elements()[*leaf].patch();
                value(patch) / (1.0 - lighting.reflectance(patch) * missing)
            });
            scaled.collect()
        };
        Self {
            factors: scaled(&|patch| lighting.reflectance(patch)),
            sources: scaled(&|patch| lighting.emittance(patch)),
            tree,
            links,
            mode,
            missing,
            leaves,
        }
    }

    /// The values of leaves as means of all elements.
    fn means(&self, values: &[f64]) -> Vec<f64> {
        let mut means = vec![0.0; self.tree.elements().len()];
        for (leaf, value) in self.leaves.iter().zip(values) {
            means[*leaf] = *value;
        }
        pull(self.tree, &mut means);
        means
    }

    /// Solves from a first guess of all elements, to a residual of `reduction` times the sources.
    pub(super) fn solve(&self, guess: &[f64], reduction: f64) -> Result<Solution, HierarchyError> {
        let weights = self.weights();
        let inverse: Vec<f64> = weights.iter().map(|weight| 1.0 / weight).collect();
        let times = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect();
        // in the norm of L2: values times the roots of areas
        let product = |scaled: &[f64]| -> Vec<f64> {
            let values: Vec<f64> = times(scaled, &inverse);
            let light = received(
                self.tree,
                self.links,
                self.mode.factors,
                &self.means(&values),
            );
            let leaves = self
                .leaves
                .iter()
                .zip(&values)
                .zip(&self.factors)
                .zip(&weights);
            leaves
                .map(|(((leaf, value), factor), weight)| {
                    weight * (value - factor * light.irradiance[*leaf])
                })
                .collect()
        };
        let right_side: Vec<f64> = times(&self.sources, &weights);
        let size = right_side.iter().map(|b| b * b).sum::<f64>().sqrt();
        let guess = self
            .leaves
            .iter()
            .zip(&weights)
            .map(|(leaf, w)| guess[*leaf] * w);
        let goal = reduction * size;
        let found = gmres(&product, &right_side, guess.collect(), goal, MOST_PRODUCTS);
        if found.residual > goal || found.residual.is_nan() {
            return Err(HierarchyError::NotConverged {
                iterations: found.products,
                residual: found.residual / size,
            });
        }
        let values: Vec<f64> = times(&found.solution, &inverse);
        let radiosity = self.means(&values);
        let mut light = received(self.tree, self.links, self.mode.factors, &radiosity);
        for ((leaf, value), missing) in self.leaves.iter().zip(&values).zip(&self.missing) {
            light.irradiance[*leaf] += missing * value;
        }
        Ok(Solution {
            deviation: deviations(self.tree, &radiosity),
            received: light,
            radiosity,
            products: found.products,
        })
    }

    /// The roots of the leaves' areas.
    fn weights(&self) -> Vec<f64> {
        let areas = self.leaves.iter();
        areas
            .map(|leaf| self.tree.elements()[*leaf].shape().area().sqrt())
            .collect()
    }
}
