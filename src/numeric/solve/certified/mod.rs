//! Roots and maxima that interval arithmetic proves.
//!
//! The search runs in `Interval<f64>`; what it finds is tightened at any precision. A result says
//! what is proved about it, and what is not.
//!
//! ```text
//!   certified_roots               all roots of a function on an interval
//!   certified_maximum             the global maximum on an open interval
//!   certified_stationary_point    a strict local maximum in several variables, the only one
//!                                 within 1e-12
//! ```
//!
//! `roots`, `maximum` and `stationary_point` hold one of them each, with the operator that decides.
//!
//! **Not covered**: double roots; global maxima in several variables.

pub(crate) mod maximum;
pub(crate) mod roots;
pub(crate) mod stationary_point;
