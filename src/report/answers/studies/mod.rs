//! Answers of the studies, as tables and records.
//!
//! `plain` has studies with one number per row and the fuzzing campaign, `routes` those that set
//! several methods side by side, `gradient` the reach of the cuts of §4.2, `sampling` the estimates
//! from random lines and fig. 5.

pub(crate) mod gradient;
pub(crate) mod plain;
pub(crate) mod routes;
pub(crate) mod sampling;
