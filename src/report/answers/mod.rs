//! Answers as tables and records, a file for each question.
//!
//! `measure` and `sampled` answer `infoscene measure`, `check`, `form_factors`, `grid`, `points`,
//! `radiosity`, `refine` and `store` the questions of these names, `cuts` the question `cut`,
//! `claims` the question `reproduce`; `studies` answers `study`. `pages` are the generated ones of
//! `data/report`. Formats are in `render`, computing is in the rooms before this one.

pub(crate) mod check;
pub(crate) mod claims;
pub(crate) mod cuts;
pub(crate) mod discontinuities;
pub(crate) mod form_factors;
#[cfg(feature = "proptest")]
pub(crate) mod fuzz;
pub(crate) mod grid;
pub(crate) mod measure;
pub(crate) mod pages;
pub(crate) mod points;
pub(crate) mod radiosity;
pub(crate) mod refine;
pub(crate) mod sampled;
pub(crate) mod split;
pub(crate) mod store;
pub(crate) mod studies;
