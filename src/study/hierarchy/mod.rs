//! Refinement by oracles, judged by finer solutions of the same rooms; measures of information
//! against error.
//!
//! **Not here**: the oracles themselves; bounds on errors.

pub mod information;
pub mod oracles;
mod random_mesh;
mod rooms;
