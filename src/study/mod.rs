//! Campaigns: Theorem 1 fuzzed, what happens to numbers in stiff and extreme cases, error against run time.
//!
//! [`fuzz`] (feature `proptest`) throws random refinements at Theorem 1 and at the gain's promised accuracy.
//! [`stability`] measures what the naive forms lose, [`precision`] what an enclosure costs.
//!
//! **Not here**: printing.

mod exact_gain;
#[cfg(feature = "proptest")]
pub mod fuzz;
pub mod precision;
pub mod stability;

pub use exact_gain::exact_gain;

/// One measurement of a study.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Row {
    /// What was computed.
    pub case: String,
    /// How it was computed.
    pub method: String,
    /// The exact value.
    pub value: f64,
    /// |computed − exact| / exact, or an enclosure's width over it.
    pub relative_error: f64,
    /// Time of one evaluation, in seconds.
    pub seconds: f64,
}
