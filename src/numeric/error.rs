//! Errors of computations that know no geometry.

/// A guarded numerical routine refused its input or could not keep its promise.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NumericError {
    /// The ends of an interval are not finite or not in increasing order.
    #[error("[{lower}, {upper}] is not a finite interval of positive length")]
    EmptyInterval {
        /// Lower end as given.
        lower: f64,
        /// Upper end as given.
        upper: f64,
    },
    /// The function took a value that is not finite.
    #[error("the function is {value} at {position}")]
    NotFinite {
        /// The place of evaluation.
        position: f64,
        /// The value returned.
        value: f64,
    },
    /// The function does not change sign between the ends.
    #[error("no change of sign: {at_lower} at {lower}, {at_upper} at {upper}")]
    NoSignChange {
        /// Lower end.
        lower: f64,
        /// Value there.
        at_lower: f64,
        /// Upper end.
        upper: f64,
        /// Value there.
        at_upper: f64,
    },
    /// The derivative has no descending zero inside the interval: the largest value is at an end.
    #[error("no interior maximum in [{lower}, {upper}]")]
    NoInteriorMaximum {
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// Interval arithmetic could not prove that there is exactly one root.
    #[error(
        "the root between {lower} and {upper} cannot be isolated; more precision does not help"
    )]
    NotIsolated {
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// An iteration stopped before it reached what it promises.
    #[error("not converged after {iterations} iterations: best {best}, residual {residual:e}")]
    NotConverged {
        /// Iterations done.
        iterations: u64,
        /// Best position found.
        best: f64,
        /// Residual there.
        residual: f64,
    },
}
