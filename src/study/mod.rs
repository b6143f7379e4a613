//! Campaigns: Theorem 1 fuzzed, digits kept in stiff and extreme cases, error against run time.
//!
//! * [`form_factors`]: error against run time of every route, on known pairs and on families of
//!   random ones; the digits that routes keep of extreme pairs.
//! * [`gain`]: the digits that naive forms of the gain lose; `gain::fuzz` (feature `proptest`)
//!   throws random refinements at Theorem 1 and at the gain's promised accuracy.
//! * [`light`]: the digits that solvers keep of stiff radiosities; the variance of random walks.
//! * [`hierarchy`]: the oracles of refinement, on equal terms; information against error over
//!   random meshes.
//! * [`cuts`]: the cuts of §4.2 followed to their limits, for other radiosities, and turned.
//! * [`lines`]: estimates from random lines, and fig. 5 read as one of them.
//! * [`scale`]: time and memory against the number of patches, and what they would be on a cluster.
//! * [`enclosures`]: the cost of certainty. [`mod@refinement`]: discrete mutual information on its
//!   way to the continuous one.
//!
//! The slow roads of [`reference`](mod@crate::reference) judge.
//!
//! **Not here**: printing.

pub mod cuts;
pub mod enclosures;
mod error;
pub mod form_factors;
pub mod gain;
pub mod hierarchy;
pub mod light;
pub mod lines;
pub mod refinement;
mod run_time;
pub mod scale;

pub use error::StudyError;

/// One measurement of a study.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Row {
    /// The quantity computed.
    pub case: String,
    /// The method.
    pub method: String,
    /// The exact value.
    pub value: f64,
    /// |computed − exact| / exact, an enclosure's width over it, or a walk's standard deviation.
    pub relative_error: f64,
    /// Time of one evaluation, in seconds.
    pub seconds: f64,
}
