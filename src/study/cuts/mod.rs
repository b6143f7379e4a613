//! How far the cuts of §4.2 carry: limits, profiles, directions.

pub mod directions;
pub mod limits;
pub mod profiles;
