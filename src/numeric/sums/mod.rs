//! Sums whose rounding is kept: compensated, and exact as expansions.

pub(crate) mod compensated_sum;
pub(crate) mod expansion;
