//! Passes over all pairs of a scene: sums of rows, rows one by one, the whole matrix.

pub(crate) mod matrix;
pub(crate) mod row_sums;
pub(crate) mod rows;
pub(crate) mod tiles;
