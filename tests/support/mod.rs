//! What several test crates share: reading `data/reference`, and generators.
#![allow(dead_code, reason = "each test crate uses a part of this module")]

pub mod high_precision;
pub mod intervals;
pub mod misrounded;
pub mod references;
pub mod rooms;
pub mod strategies;
