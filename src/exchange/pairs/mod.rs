//! One pair of rows: its polygons, what they see of each other, and values that pairs share.
//!
//! `row_pair` sums over `polygon_pair`; `sights` tells what stands between two polygons,
//! `shared_values` has the values of congruent pairs, `configurations` those past screens.

pub(crate) mod configurations;
pub(crate) mod polygon_pair;
pub(crate) mod row_pair;
pub(crate) mod shared_values;
pub(crate) mod sights;
