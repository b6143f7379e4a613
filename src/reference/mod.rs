//! Slow roads that judge the fast ones.
//!
//! Nothing of the library uses them: studies, tests and benches compare with them.

pub mod exchange;
pub mod fixed_float;
mod gain;
mod truth;

pub use gain::exact_gain;
pub use truth::Truth;
