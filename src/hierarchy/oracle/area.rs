//! The area of an element, which knows nothing of light: what others are compared with.

use super::{HierarchyError, Indicator, View};

/// The oracle of the area.
#[derive(Debug, Clone, Copy)]
pub(super) struct Area;

impl Indicator for Area {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        Ok(view.element(leaf).shape().area())
    }
}
