//! Integrals over an interval, with an estimate of their error.
//!
//! The double-exponential rule of the crate `quadrature`, guarded: it turns NaN and infinity
//! into 0 and stops at 385 points without a word. Here every value must be finite, and the
//! error estimate is returned with the value and checked against the tolerance.
//!
//! **Not covered**: bounds; the error is an *estimate*.

use crate::numeric::{Bounded, NumericError};
use std::cell::Cell;

/// `∫ f dx` from `lower` to `upper` by the double-exponential rule, with the rule's own estimate of
/// its error.
///
/// **Arguments** a function that is smooth inside; end singularities of the kind of `ln x` are
/// fine, the ends are not evaluated. `tolerance`: absolute, at least about 1e-13 of the scale.
///
/// # Errors
/// [`NumericError::EmptyInterval`]; [`NumericError::NotFinite`] where the function is not
/// finite; [`NumericError::NotConverged`] if the estimate stays above the tolerance.
///
/// # Examples
/// ```
/// let area = infoscene::numeric::integral(f64::exp, (0.0, 1.0), 1e-12)?;
/// assert!((area.value - 1f64.exp_m1()).abs() < 1e-12);
/// # Ok::<(), infoscene::numeric::NumericError>(())
/// ```
pub fn integral(
    function: impl Fn(f64) -> f64,
    (lower, upper): (f64, f64),
    tolerance: f64,
) -> Result<Bounded, NumericError> {
    if !(lower.is_finite() && upper.is_finite() && lower < upper) {
        return Err(NumericError::EmptyInterval { lower, upper });
    }
    let offender = Cell::new(None);
    let guarded = |position: f64| {
        let value = function(position);
        if !value.is_finite() {
            offender.set(Some((position, value)));
        }
        value
    };
    let output = quadrature::integrate(guarded, lower, upper, tolerance);
    if let Some((position, value)) = offender.get() {
        return Err(NumericError::NotFinite { position, value });
    }
    if output.error_estimate > tolerance {
        return Err(NumericError::NotConverged {
            iterations: u64::from(output.num_function_evaluations),
            best: output.integral,
            residual: output.error_estimate,
        });
    }
    Ok(Bounded::estimate(output.integral, output.error_estimate))
}
