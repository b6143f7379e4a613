//! Pairs of rectangles that are parallel or perpendicular: closed forms, their derivatives, and the
//! ladder of routes.

pub(crate) mod corner_sum;
pub(crate) mod derivatives;
pub(crate) mod far;
pub(crate) mod ladder;
pub(crate) mod layout;
pub(crate) mod pair;
pub mod parallel;
pub mod perpendicular;
