//! Oracles: what is gained by cutting an element.
//!
//! An oracle ranks leaves; refinement cuts the first of the ranking ([`Refinement`]). Parts of an
//! element are expected to have its priority times their share of its area, until light is found
//! anew. Each oracle is a file of this folder, and a variant of [`OracleName`].
//!
//! The error of a mesh of 1000 elements over that of the true error's mesh, in `lit-cube`,
//! `lit-cube-edge` and `lit-hall` (`oracles_keep_their_order_on_fine_meshes`):
//!
//! | name | priority | asks for, per link | error |
//! |---|---|---|---|
//! | `paper` | the three steps of §5, ranked | 4 kernels | 1.52 1.65 1.98 |
//! | `paper-repaired` | the same without what misleads | 4 kernels | 1.19 1.26 1.33 |
//! | `information` | §5's ΔI, radiosity constant on the element | 4 point factors | 1.16 1.16 1.21 |
//! | `chain` | eq. (5) in the brightness chain | 4 point factors | 1.25 1.60 1.70 |
//! | `losses` | continuous less discrete information | 16 kernels | 1.21 1.79 1.95 |
//! | `power` | A R H | – | 1.44 1.65 1.58 |
//! | `kernel` | Σ B_j times the variation of F_ij | – | 1.11 1.15 1.11 |
//! | `received` | the range of H over the corners | 4 point factors | 1.01 1.02 1.01 |
//! | `gather` | the deviation of the parts' H | 4 pairs | 1.01 1.00 1.00 |
//! | `residual` | ‖E + R H − B‖ at Gauss points | 4 point factors | 1.01 1.00 1.00 |
//! | `gradient` | R ‖∇H·(x − c)‖ | – | 1.01 1.00 1.00 |
//! | `neighbours` | the same from the neighbours' B | – | 1.03 1.04 1.04 |
//! | `area` | A | – | 1.85 2.76 3.09 |
//! | `true` | the error against a reference | – | 1 |
//!
//! On coarse meshes `received` sees too little: at 100 elements it is at 1.29, 3.79 and 1.16.
//!
//! An oracle of your own is an [`Indicator`], if it judges each leaf for itself, or an [`Oracle`].
//!
//! [`Refinement`]: super::Refinement

mod area;
mod chain;
mod gather;
mod gradient;
mod importance;
mod information;
mod kernel;
mod losses;
mod name;
mod neighbours;
mod paper;
mod parts;
mod power;
mod received;
mod repaired;
mod residual;
mod true_error;
mod weights;

use super::HierarchyError;
use super::view::View;
use crate::numeric::try_parallel_map;

pub use importance::ImportanceDriven;
pub use name::OracleName;
pub use true_error::Reference;

/// A judge of a mesh.
pub trait Oracle: Sync {
    /// The priority of each of these leaves, in their order, at least 0: the larger, the sooner it
    /// is cut.
    ///
    /// # Errors
    /// [`HierarchyError`] if what it takes cannot be computed.
    fn priorities(&self, view: &View<'_>, leaves: &[usize]) -> Result<Vec<f64>, HierarchyError>;

    /// The factors by which the errors of links count, one for each element as their receiver; none
    /// if all light matters alike, as if they were 1.
    ///
    /// # Errors
    /// [`HierarchyError`] if what it takes cannot be computed.
    fn link_weights(&self, _: &View<'_>) -> Result<Option<Vec<f64>>, HierarchyError> {
        Ok(None)
    }

    /// Whether lights that reflect nothing are ranked, too.
    fn cuts_lights(&self) -> bool {
        false
    }
}

/// A judge of elements, each for itself.
pub trait Indicator: Sync {
    /// The priority of a leaf, as of [`Oracle::priorities`].
    ///
    /// # Errors
    /// [`HierarchyError`] if what it takes cannot be computed.
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError>;
}

impl<I: Indicator> Oracle for I {
    fn priorities(&self, view: &View<'_>, leaves: &[usize]) -> Result<Vec<f64>, HierarchyError> {
        of_each(leaves, &|leaf| self.priority(view, leaf))
    }
}

/// The answers for leaves, in their order.
fn of_each(
    leaves: &[usize],
    answer: &(dyn Fn(usize) -> Result<f64, HierarchyError> + Sync),
) -> Result<Vec<f64>, HierarchyError> {
    try_parallel_map(leaves.len(), &|k| answer(leaves[k]))
}
