//! Roots and maxima: guarded in `f64`, certified in intervals.

pub(crate) mod certified;
pub(crate) mod maximum;
pub(crate) mod root;
