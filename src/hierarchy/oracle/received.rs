//! The range of the irradiance over the corners of an element.
//!
//! ```text
//!   priority = R √A (max H(v) − min H(v))          v: corners
//! ```
//!
//! Form factors jump where elements touch, so the points lie inside by a part in a million.
//!
//! **Not covered**: variation that the corners do not show.

use super::{HierarchyError, Indicator, View};

/// The share of the way from the corner to the centre.
const INSIDE: f64 = 1e-6;

/// The oracle of what corners receive.
#[derive(Debug, Clone, Copy)]
pub(super) struct ReceivedRange;

impl Indicator for ReceivedRange {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let element = view.element(leaf);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in element.shape().corners() {
            let point = corner.lerp(element.centre(), INSIDE);
            let received = view.received_at(leaf, point)?;
            (low, high) = (low.min(received), high.max(received));
        }
        Ok(view.reflectance(leaf) * element.shape().area().sqrt() * (high - low))
    }
}
