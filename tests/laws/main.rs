//! One law per file, each with its negative control.
#![allow(
    clippy::unwrap_used,
    clippy::float_cmp,
    reason = "a test may panic, and compares what is exact"
)]

mod additivity;
mod agreement;
mod blockers;
mod certified_maxima;
mod certified_points;
mod certified_roots;
mod closure;
mod cuts;
mod divergence;
mod dual_numbers;
mod elementary;
mod error_bounds;
mod extremes;
mod gradient_limits;
mod independent_roads;
mod interval_ends;
mod intervals;
mod invariance;
mod negative_controls;
mod optimisers;
mod overlap;
mod plan;
mod polygon_cuts;
mod profile_cuts;
mod reciprocity;
mod refinement;
mod refusals;
mod sampling;
mod shafts;
mod sides;
mod soundness;
mod straight_cuts;
mod streaming;
#[path = "../support/mod.rs"]
mod support;
mod wide_numbers;
