//! Elementary and special functions, each with its error bound.
//!
//! `elementary` has the logarithm and the angle of doubles, with the same bits on every machine and
//! in vectors; `entropy_kernel` the functions that every entropy is a sum of; `dilogarithm` and
//! `digamma` the special functions of the continuous mutual information and of estimates from
//! samples; `extremes` the largest and smallest numbers that pass NaN on; `unit` powers of two as
//! units.

pub(crate) mod digamma;
pub(crate) mod dilogarithm;
pub mod elementary;
pub(crate) mod entropy_kernel;
pub(crate) mod extremes;
pub(crate) mod unit;
