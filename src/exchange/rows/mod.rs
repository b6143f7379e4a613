//! Rows: which polygons make up each, and the planes that they lie in.

pub(crate) mod plane_sets;
pub(crate) mod terms;
