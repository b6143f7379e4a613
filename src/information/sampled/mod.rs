//! Mutual information estimated from random lines, with its bias and its standard error.

pub(crate) mod chords;
pub(crate) mod expected_bias;
pub(crate) mod line_sample;
pub(crate) mod pair_counts;
