//! Roots and maxima that interval arithmetic proves.
//!
//! The search runs in `Interval<f64>`; what it finds is tightened at any precision. A result says what is proved
//! about it, and what is not.
//!
//! ```text
//!   certified_roots               all roots of a function on an interval
//!   certified_maximum             the global maximum on an open interval
//!   certified_stationary_point    a strict local maximum in several variables, the only one within 1e-12
//! ```
//!
//! **Not covered**: double roots; global maxima in several variables.

mod maximum;
mod roots;
mod stationary_point;

pub use maximum::{Certificate, CertifiedMaximum, EndPoint, Maximand, certified_maximum};
pub use roots::{CertifiedRoot, CertifiedRoots, IntervalFunction, certified_roots};
pub use stationary_point::{VectorFunction, certified_stationary_point};
