//! The best cut of a patch across a gradient of radiosity (§4.2).

pub(crate) mod comparison;
pub(crate) mod cut;
pub(crate) mod limit;
pub(crate) mod profile;
pub(crate) mod profile_cut;
pub(crate) mod straight;
