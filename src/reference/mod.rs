//! Slow roads that judge the fast ones.
//!
//! Nothing of the library uses them: studies, tests and benches compare with them.

pub mod exchange;
mod gain;
mod truth;
pub mod wide;

pub use gain::exact_gain;
pub use truth::Truth;
