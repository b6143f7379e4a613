//! What may stand between two patches, and what a line meets first.

pub(crate) mod blockers;
pub(crate) mod grid_lines;
pub(crate) mod lines;
pub(crate) mod obstacle;
pub(crate) mod occlusion;
pub(crate) mod surfaces;
