//! Answers as tables and records, a file for each question.

pub(crate) mod claims;
pub(crate) mod claims_page;
pub(crate) mod cuts;
pub(crate) mod findings;
pub(crate) mod form_factors;
pub(crate) mod grid;
pub(crate) mod measure;
pub(crate) mod radiosity;
pub(crate) mod refinement;
pub(crate) mod sampled;
pub(crate) mod split;
pub(crate) mod studies;
