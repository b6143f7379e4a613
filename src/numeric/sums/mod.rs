//! Sums that keep the rounding of their terms.
//!
//! `compensated_sum` adds any number of doubles with an error that does not grow with their number;
//! it serves wherever terms are already rounded. `expansion` adds and multiplies doubles exactly,
//! as unevaluated sums; it serves where terms cancel.

pub(crate) mod compensated_sum;
pub(crate) mod expansion;
