//! Pairs of rectangles with edges along common axes, parallel or perpendicular.
//!
//! `pair` chooses the form and clips what lies behind; [`parallel`] and [`perpendicular`] are the
//! two closed forms, as sums over sixteen corners (`corner_sum`), with their `derivatives`.
//! `layout` places rectangles given by their coordinates, `far` integrates the kernel where closed
//! forms cancel, and `ladder` climbs from the cheapest of these to the first whose bound is good
//! enough.
//!
//! **Not covered**: rectangles turned against each other; they are polygons
//! ([`Polygon`](super::Polygon)).

pub(crate) mod corner_sum;
pub(crate) mod derivatives;
pub(crate) mod far;
pub(crate) mod ladder;
pub(crate) mod layout;
pub(crate) mod pair;
pub mod parallel;
pub mod perpendicular;
mod rounded_ends;
mod second;
