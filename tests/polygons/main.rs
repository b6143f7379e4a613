//! Form factors of any two polygons: against 30-digit values, against the slow reference, and against the laws.
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and compares what is exact"
)]

mod agreement;
mod far_rectangles;
mod invariance;
mod outlines;
mod slow_reference;
#[path = "../support/mod.rs"]
mod support;
