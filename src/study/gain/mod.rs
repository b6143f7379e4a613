//! Stability of the gain of a refinement, and fuzzing of Theorem 1.

#[cfg(feature = "proptest")]
pub mod fuzz;
pub mod stability;
