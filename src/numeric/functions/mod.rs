//! Elementary and special functions, each with its error bound.

pub(crate) mod digamma;
pub(crate) mod dilogarithm;
pub mod elementary;
pub(crate) mod entropy_kernel;
pub(crate) mod extremes;
pub(crate) mod unit;
