//! Stability of the gain of a refinement, and fuzzing of Theorem 1.
//!
//! [`stability`] shows the digits that naive forms of the gain lose, and that the sum of
//! non-negative terms keeps. `fuzz` (feature `proptest`) runs millions of random refinements on all
//! cores, keeps histograms of them, and shrinks the first that breaks a promise.

#[cfg(feature = "proptest")]
pub mod fuzz;
pub mod stability;
