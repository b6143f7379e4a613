//! Campaigns: Theorem 1 fuzzed, digits kept in stiff and extreme cases, error against run time.
//!
//! `study::fuzz` (feature `proptest`) throws random refinements at Theorem 1 and at the gain's promised
//! accuracy. [`accuracy`] sets the error of every route to a form factor against its run time, on
//! the [families](polygon_pairs) of pairs too; [`stability`] measures the digits that naive forms
//! of the gain lose, [`extreme_pairs`] those that the routes keep of stiff and extreme pairs,
//! [`transport_stability`] those that solvers keep of radiosities, [`precision`] the cost of an
//! enclosure. [`Truth`] judges. [`gradient_limits`] follows the cuts of §4.2 to their limits,
//! [`profiles`] sets both cuts side by side for other radiosities, [`directions`] turns the cut.
//! [`mod@refinement`] follows discrete mutual information to the continuous one, [`mod@sampling`]
//! estimates it from random lines, as [`mod@figure_5`] reads fig. 5.
//!
//! **Not here**: printing.

pub mod accuracy;
pub mod directions;
mod error;
mod exact_gain;
mod extreme_cases;
pub mod extreme_pairs;
pub mod figure_5;
#[cfg(feature = "proptest")]
pub mod fuzz;
mod gauss_order;
pub mod gradient_limits;
pub mod polygon_pairs;
pub mod precision;
pub mod profiles;
pub mod refinement;
pub mod sampling;
pub mod stability;
pub mod transport_stability;
mod truth;
pub mod walk_variance;

pub use error::StudyError;
pub use exact_gain::exact_gain;
pub use truth::Truth;

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
