//! The reach of the cuts of §4.2: their limits, other profiles, other directions.
//!
//! [`limits`] follows both cuts as the exponent grows, [`profiles`] finds them for ramps,
//! exponentials, steps and bumps, [`directions`] turns them away from the gradient. The numbers
//! that come of it stand in `data/report/findings.md`.

pub mod directions;
pub mod limits;
pub mod profiles;
