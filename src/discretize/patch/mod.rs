//! The cut of one patch that gains the most mutual information (§4.1, §5).
//!
//! Open `split` first: the front door for any polygons. `search` finds the best positions,
//! `part_exchange` turns exchange areas of parts into gain and slope, `rectangles` has them in
//! closed form for aligned rectangles, with enclosures and proofs, and `polygons` for all others,
//! in `f64`. `between` finds what stands between the patch and the others, `highest` the
//! highest gain of many directions quickly.
//!
//! **Not covered**: cuts that are not parallel to each other.

pub(crate) mod between;
pub(crate) mod highest;
pub(crate) mod part_exchange;
pub(crate) mod polygons;
pub(crate) mod rectangles;
pub(crate) mod search;
pub(crate) mod split;
