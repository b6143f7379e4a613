//! The leaves of a tree, as sources of light.

use crate::form_factor::Polygon;
use crate::geometry::Patch;
use glam::DVec3;

/// A leaf of the tree.
#[derive(Debug, Clone)]
pub(super) struct Leaf {
    pub(super) shape: Patch,
    pub(super) polygon: Polygon,
    /// The corners, and those of neighbours on its edges.
    pub(super) outline: Vec<DVec3>,
    /// The parts that it is cut into where it is seen in part; none if nothing can be hidden.
    pub(super) parts: Vec<Patch>,
    pub(super) centre: DVec3,
    pub(super) patch: usize,
}
