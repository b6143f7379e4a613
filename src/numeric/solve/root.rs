//! The root of a continuous function between two points of opposite sign.
//!
//! Brent's method by `argmin`, guarded: its solver accepts a function that is NaN
//! everywhere, and two ends of equal sign whose product underflows. Here the ends are
//! compared by sign, the function is scaled by its larger end value, and every value
//! must be finite.
//!
//! **Not covered**: roots without a change of sign; several roots (one of them is found).
//!
//! Reference: Brent, *Algorithms for Minimization without Derivatives*, 1973, ch. 4.

use crate::numeric::NumericError;
use argmin::core::{CostFunction, Error, Executor, State};
use argmin::solver::brent::BrentRoot;
use std::cell::Cell;

/// A root, with the function's value there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Root {
    /// The place where the function changes sign, within two units in the last place of the
    /// position as far as the function's own rounding lets that be seen.
    pub position: f64,
    /// The function's value there.
    pub residual: f64,
    /// The number of evaluations of the function.
    pub evaluations: u64,
}

/// Iterations after which Brent's method has either converged or never will:
/// bisection alone exhausts the doubles between two ends in about 1100.
const MAXIMUM_ITERATIONS: u64 = 1200;

struct Guarded<'f> {
    function: &'f dyn Fn(f64) -> f64,
    scale: f64,
    evaluations: &'f Cell<u64>,
}

impl CostFunction for Guarded<'_> {
    type Param = f64;
    type Output = f64;

    fn cost(&self, position: &f64) -> Result<f64, Error> {
        self.evaluations.set(self.evaluations.get() + 1);
        let value = (self.function)(*position);
        if value.is_finite() {
            Ok(value / self.scale)
        } else {
            Err(NumericError::NotFinite {
                position: *position,
                value,
            }
            .into())
        }
    }
}

/// The root of `function` in `[lower, upper]`, to full `f64` precision.
///
/// **Arguments** a function that is continuous, finite, and of opposite sign at the ends;
/// an end where it is zero is a root.
/// **Accuracy** the position is final within two units in its last place of a change of
/// sign of the *computed* function.
///
/// # Errors
/// [`NumericError::EmptyInterval`], [`NumericError::NotFinite`],
/// [`NumericError::NoSignChange`], [`NumericError::NotConverged`].
///
/// # Examples
/// ```
/// let root = infoscene::numeric::root(|x| x * x - 2.0, 1.0, 2.0)?;
/// assert!((root.position - 2f64.sqrt()).abs() <= 4.0 * f64::EPSILON);
/// # Ok::<(), infoscene::numeric::NumericError>(())
/// ```
pub fn root(function: impl Fn(f64) -> f64, lower: f64, upper: f64) -> Result<Root, NumericError> {
    root_of(&function, lower, upper)
}

/// The solver is compiled once, for all functions.
fn root_of(function: &dyn Fn(f64) -> f64, lower: f64, upper: f64) -> Result<Root, NumericError> {
    if !(lower.is_finite() && upper.is_finite() && lower < upper) {
        return Err(NumericError::EmptyInterval { lower, upper });
    }
    let at_lower = finite(function, lower)?;
    let at_upper = finite(function, upper)?;
    for (position, value) in [(lower, at_lower), (upper, at_upper)] {
        if value.abs() <= 0.0 {
            return Ok(Root {
                position,
                residual: value,
                evaluations: 2,
            });
        }
    }
    if at_lower.signum() * at_upper.signum() > 0.0 {
        return Err(NumericError::NoSignChange {
            lower,
            at_lower,
            upper,
            at_upper,
        });
    }
    let evaluations = Cell::new(2);
    let problem = Guarded {
        function,
        scale: at_lower.abs().max(at_upper.abs()),
        evaluations: &evaluations,
    };
    let result = Executor::new(problem, BrentRoot::new(lower, upper, 0.0))
        .configure(|state| state.max_iters(MAXIMUM_ITERATIONS))
        .run();
    let not_converged = |iterations, best| NumericError::NotConverged {
        iterations,
        best,
        residual: function(best),
    };
    match result {
        Ok(outcome) => {
            let iterations = outcome.state().get_iter();
            let position = outcome.state().get_best_param().copied().unwrap_or(lower);
            if iterations >= MAXIMUM_ITERATIONS {
                return Err(not_converged(iterations, position));
            }
            Ok(Root {
                position,
                residual: function(position),
                evaluations: evaluations.get(),
            })
        }
        Err(error) => Err(error
            .downcast::<NumericError>()
            .unwrap_or_else(|_| not_converged(evaluations.get(), lower))),
    }
}

pub(crate) fn finite(function: impl Fn(f64) -> f64, position: f64) -> Result<f64, NumericError> {
    let value = function(position);
    if value.is_finite() {
        Ok(value)
    } else {
        Err(NumericError::NotFinite { position, value })
    }
}
