//! The best cut of a patch across a gradient of radiosity (§4.2).
//!
//! Open `cut` first: the two cuts of the paper, by mutual information and by mean square, for
//! radiosity that grows as a power. `limit` has their limits as the exponent grows, `comparison`
//! the cost of each by the measure of the other, `profile` and `profile_cut` other radiosities
//! (ramps, exponentials, steps, bumps), and `straight` cuts in any direction.
//!
//! **Not covered**: divisions of any shape; `proofs/gradient` shows that none gains more than the
//! best cut across the gradient.

pub(crate) mod comparison;
pub(crate) mod cut;
pub(crate) mod limit;
pub(crate) mod profile;
pub(crate) mod profile_cut;
pub(crate) mod straight;
