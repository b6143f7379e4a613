//! Reversible Markov chains and the refinement of their states (Theorem 1).
//!
//! A chain is its symmetric joint matrix `J_ij = w_i P_ij`: the reciprocity relation
//! `w_i P_ij = w_j P_ji` holds by construction, the stationary distribution is the row sum. A
//! [`Refinement`] carries both chains and which state is a part of which.
//!
//! The module `strategies` (feature `proptest`) lets other programs fuzz their own code: random
//! chains and refinements, valid by construction, two thirds of them at the hard spots of floating
//! point.
//!
//! **Not here**: form-factor formulas; information measures.

mod brightness;
mod continuous;
mod error;
pub mod random;
mod refinement;
mod reversible;
mod visibility;

pub use brightness::brightness_chain;
pub(crate) use brightness::in_unit;
pub use continuous::{ContinuousChain, continuous_chain, patch_integrals};
pub use error::ChainError;
pub use refinement::Refinement;
pub use reversible::ReversibleChain;
pub use visibility::{open_visibility_chain, visibility_chain};
