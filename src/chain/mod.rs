//! Reversible Markov chains and the refinement of their states (Theorem 1).
//!
//! A chain is its symmetric joint matrix `J_ij = w_i P_ij`: the reciprocity relation
//! `w_i P_ij = w_j P_ji` holds by construction, the stationary distribution is the row sum.
//!
//! **Not here**: form-factor formulas; information measures.

mod error;
pub mod random;
mod refinement;
mod reversible;
mod visibility;

pub use error::ChainError;
pub use refinement::StateRefinement;
pub use reversible::ReversibleChain;
pub use visibility::visibility_chain;
