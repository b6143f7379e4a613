//! Rows: the polygons that make up each, and the planes that these lie in.
//!
//! Open `terms` for the signed polygons of a row (parts of bases count negative), `polygons` for
//! these made ready, and `plane_sets` for the grouping of rows that see the same planes, by which a
//! pass leaves out whole blocks.

pub(crate) mod plane_sets;
pub(crate) mod polygons;
pub(crate) mod terms;
