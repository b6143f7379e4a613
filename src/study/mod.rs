//! Campaigns: Theorem 1 fuzzed, and what happens to numbers in stiff and extreme cases.
//!
//! [`fuzz`] (feature `proptest`) throws random refinements at Theorem 1 and at the gain's promised accuracy.
//! [`stability`] measures what the naive forms lose.
//!
//! **Not here**: printing.

mod exact_gain;
#[cfg(feature = "proptest")]
pub mod fuzz;
pub mod stability;

pub use exact_gain::{RESOLUTION, exact_gain};
