//! The power that an element reflects.
//!
//! ```text
//!   priority = A R H
//! ```
//!
//! **Not covered**: whether the light varies.
//!
//! Reference: Hanrahan, Salzman, Aupperle, *A rapid hierarchical radiosity algorithm*, 1991, whose
//! criterion `B_j R_i A_j F_ji` this is, summed over the links of i.

use super::{HierarchyError, Indicator, View};

/// The oracle of the power.
#[derive(Debug, Clone, Copy)]
pub(super) struct Power;

impl Indicator for Power {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let received = view.solution.received.irradiance[leaf].max(0.0);
        Ok(view.reflectance(leaf) * view.element(leaf).shape().area() * received)
    }
}
