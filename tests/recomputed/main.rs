//! Recomputes every row of the reference files at 320 bits, without the library.
//!
//! Most reference values come from closed forms of rectangles; here none does. Form
//! factors are integrals over the contours of the polygons, evaluated by quadrature
//! at two levels, and optima are found by search or by Newton's method on numerical
//! differences. A row agrees when its digits are met to one unit of the last, at both
//! levels.
//!
//! Those that take at most two seconds run always. The others take about two minutes and
//! are ignored by default: `cargo test --release --test recomputed -- --include-ignored`.

#![expect(
    clippy::unwrap_used,
    reason = "a test fails by panicking, with the place it failed at"
)]
#![expect(
    unnameable_types,
    unreachable_pub,
    reason = "nothing is reached from outside: what other modules use is `pub`"
)]

mod contour;
mod coverage;
mod cube_cells;
mod cube_grids;
mod form_factors;
mod maximum;
mod parallel_edges;
mod precision;
mod quadrature;
mod reference;
mod section_4_2;
mod split_curves;
mod splits;
