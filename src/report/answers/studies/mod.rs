//! Answers of the studies.

pub(crate) mod gradient;
pub(crate) mod plain;
pub(crate) mod routes;
pub(crate) mod sampling;
