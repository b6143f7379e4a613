//! Random reversible chains and refinements: seeded, from bytes, or as proptest strategies.
//!
//! [`families`] defines the chains and the divisions of their states, valid by construction; two
//! thirds of them are at hard spots of floating point: sparse, nearly decomposable, with weights
//! down to 1e-300, from rooms, divided lopsidedly, nearly or exactly in proportion. [`seeded`]
//! draws them from a seed, for campaigns (`infoscene fuzz`) and benches. `strategies` (feature
//! `proptest`, on by default) draws them in property tests.
//!
//! # Fuzz your own chains
//!
//! The strategies that fuzz this crate are public. Failures shrink to a few states and print as
//! Rust source.
//!
//! ```
//! # #[cfg(feature = "proptest")] {
//! use infoscene::chain::random::strategies::refinement;
//! use infoscene::information::refinement_gain;
//! use proptest::prelude::*;
//!
//! proptest!(|(refinement in refinement(12))| {
//!     let refinement = refinement?;
//!     prop_assert!(refinement_gain(&refinement) >= 0.0); // Theorem 1
//! });
//! # }
//! ```
//!
//! `PROPTEST_CASES=30000 cargo test --release --test library` is the long campaign on all laws.
//!
//! **Not covered**: chains that are not reversible.

pub mod families;
pub mod seeded;
#[cfg(feature = "proptest")]
pub mod strategies;
