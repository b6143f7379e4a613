//! The library against independent values of 13 to 60 digits (`data/reference`).
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and compares what is exact"
)]

mod cube_grids;
mod enclosures;
mod form_factors;
mod polygon_splits;
mod section_4_2;
mod splits;
#[path = "../support/mod.rs"]
mod support;
