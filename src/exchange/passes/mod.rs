//! Passes over all pairs of a scene: sums of rows, rows one by one, the whole matrix.
//!
//! Open `tiles` first: it has the one walk over pairs that all passes share. `row_sums` holds
//! nothing but sums of functions of the pairs, `rows` yields one row (or single entries) at a time,
//! and `matrix` holds everything as a packed symmetric matrix, `shared_out` the same over ranks;
//! `lower_pairs` sums what is held.

pub(crate) mod lower_pairs;
pub(crate) mod matrix;
pub(crate) mod row_sums;
pub(crate) mod rows;
pub(crate) mod shared_out;
pub(crate) mod tiles;
