//! The cut of one patch that gains the most mutual information.

pub(crate) mod part_exchange;
pub(crate) mod polygons;
pub(crate) mod rectangles;
pub(crate) mod search;
pub(crate) mod split;
