//! The largest interior maximum of a function, reported as a root of its derivative.
//!
//! A minimiser sees a maximum only to about `√ε` in position; the root of the derivative
//! is seen to ε. The interval is scanned for descending changes of sign of the derivative,
//! each is refined by [`root`], and the highest one is
//! returned.
//!
//! **Not covered**: a proof that no maximum hides between two scanned points; the result
//! is an estimate of the global maximum, an accurate position of a local one.

use super::root::finite;
use crate::numeric::{NumericError, root};
use nalgebra::{DMatrix, DVector};

/// A local maximum, with the derivative found there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Maximum {
    /// The place where the derivative changes sign from plus to minus.
    pub position: f64,
    /// The function's value there.
    pub value: f64,
    /// The derivative's value there, 0 but for rounding.
    pub residual: f64,
    /// The number of evaluations of the derivative.
    pub evaluations: u64,
}

/// Two maxima nearer than this in relative height count as one: (a) form factors that differ in the
/// third digit turn their ε into some thousand ε of the gain.
const EQUAL_MAXIMA: f64 = 1e-12;

/// Tells whether a maximum is higher than another, beyond what rounding makes of equal ones.
pub(crate) fn is_higher(value: f64, other: f64) -> bool {
    value > other + EQUAL_MAXIMA * value.abs()
}

/// The highest maximum of `function` inside `(lower, upper)`.
///
/// The derivative is scanned at the ends of `intervals` equal pieces, and by powers of two towards
/// either end. The ends themselves are never evaluated, and within 2⁻⁸ of them a point where the
/// derivative is not finite is passed over. Of maxima that are equal within rounding the leftmost
/// is returned.
///
/// # Errors
/// [`NumericError::NoInteriorMaximum`] if the derivative never turns from plus to minus, and
/// what [`root`] refuses.
pub fn maximum(
    function: impl Fn(f64) -> f64,
    derivative: impl Fn(f64) -> f64,
    (lower, upper): (f64, f64),
    intervals: u32,
) -> Result<Maximum, NumericError> {
    if !(lower.is_finite() && upper.is_finite() && lower < upper) {
        return Err(NumericError::EmptyInterval { lower, upper });
    }
    let width = upper - lower;
    // equally spaced inside, and by powers of two towards either end
    let towards_end = |power: i32| f64::from(power).exp2();
    let mut shares: Vec<f64> = (1..intervals)
        .map(|k| f64::from(k) / f64::from(intervals))
        .collect();
    shares.extend((SMALLEST_POWER..=-2).map(towards_end));
    shares.extend((SMALLEST_POWER..=-2).map(|power| 1.0 - towards_end(power)));
    shares.sort_by(f64::total_cmp);
    shares.dedup();
    let point = |share: f64| lower + width * share;
    let mut best: Option<Maximum> = None;
    let mut evaluations = 0;
    let mut left = (lower, f64::NEG_INFINITY);
    for share in shares {
        let right = (point(share), derivative(point(share)));
        if !right.1.is_finite() {
            // next to an end a derivative may not be computable; further inside it must be
            if share.min(1.0 - share) < INNERMOST {
                continue;
            }
            finite(&derivative, right.0)?;
        }
        evaluations += 1;
        if left.1 > 0.0 && right.1 <= 0.0 {
            let found = root(&derivative, left.0, right.0)?;
            evaluations += found.evaluations;
            let value = finite(&function, found.position)?;
            if best.is_none_or(|best| is_higher(value, best.value)) {
                let (position, residual) = (found.position, found.residual);
                best = Some(Maximum {
                    position,
                    value,
                    residual,
                    evaluations: 0,
                });
            }
        }
        left = right;
    }
    best.map(|best| Maximum {
        evaluations,
        ..best
    })
    .ok_or(NumericError::NoInteriorMaximum { lower, upper })
}

/// The outermost scanned points lie this power of two of the width inside.
const SMALLEST_POWER: i32 = -40;

/// Nearer to an end than this share a point may be passed over.
const INNERMOST: f64 = 1.0 / 256.0;

/// A maximum in several ordered coordinates `0 < t_1 < … < t_n < 1`, as the root of the gradient.
///
/// Newton's method with a Hessian from central differences, damped so that no coordinate passes its
/// neighbour. The maximum is a local one near the start.
///
/// # Errors
/// [`NumericError::NotFinite`]; [`NumericError::NotConverged`] if the steps do not die out, or end
/// at something else than a maximum.
pub fn maximum_of_many(
    gradient: impl Fn(&[f64]) -> Vec<f64>,
    start: Vec<f64>,
) -> Result<Vec<f64>, NumericError> {
    let derivatives = |position: &[f64]| {
        let n = position.len();
        let slope = DVector::from_vec(gradient(position));
        let mut curvature = DMatrix::zeros(n, n);
        for k in 0..n {
            let mut aside = [position.to_vec(), position.to_vec()];
            aside[0][k] -= DIFFERENCE;
            aside[1][k] += DIFFERENCE;
            let [before, after] = aside.map(|position| DVector::from_vec(gradient(&position)));
            curvature.set_column(k, &((after - before) / (2.0 * DIFFERENCE)));
        }
        (slope, curvature)
    };
    maximum_by_derivatives(derivatives, start)
}

/// Steps of the maximisation in several coordinates: (b) 64 parts of two unit squares take fewer
/// than a third, measured by `many_parts_come_to_rest`.
const NEWTON_STEPS: u32 = 60;

/// Movement below which a maximum counts as found, on a scale of 1: (a) derivatives rounded to a
/// few ε over curvatures of order one let a coordinate tremble by that much, twice over with its
/// neighbours.
const AT_REST: f64 = 64.0 * f64::EPSILON;

/// Steps below this that no longer shrink are the gradient's rounding: (a) a Newton step of 1e-8 is
/// followed by one near 1e-16 where the third derivative is moderate.
const TREMBLING: f64 = 1e-9;

/// A maximum in several ordered coordinates `0 < t_1 < … < t_n < 1`, by Newton's method for
/// gradient and Hessian.
///
/// Steps are damped so that no coordinate passes its neighbour, and climb where the Hessian is not
/// negative definite; the method ends where a step no longer moves anything beyond rounding, and
/// only at a negative definite Hessian.
///
/// **Accuracy** each coordinate as far as the gradient's rounding over its curvature lets it be
/// seen: about 64 ε for curvatures of order one. A local maximum near the start.
///
/// # Errors
/// [`NumericError::NotFinite`]; [`NumericError::NotConverged`] if the steps do not die out, or end
/// at something else than a maximum.
pub(crate) fn maximum_by_derivatives(
    derivatives: impl Fn(&[f64]) -> (DVector<f64>, DMatrix<f64>),
    start: Vec<f64>,
) -> Result<Vec<f64>, NumericError> {
    let mut position = DVector::from_vec(start);
    let mut moved = f64::INFINITY;
    for _ in 0..NEWTON_STEPS {
        let (slope, curvature) = derivatives(position.as_slice());
        let all = slope.iter().chain(curvature.iter());
        if let Some((k, value)) = all.enumerate().find(|(_, value)| !value.is_finite()) {
            return Err(NumericError::NotFinite {
                position: position[k % position.len()],
                value: *value,
            });
        }
        // −H is symmetric and, at a maximum, positive definite
        let symmetric = -(&curvature + curvature.transpose()) * 0.5;
        let newton = symmetric.clone().cholesky();
        let newton = newton.map(|factor| factor.solve(&slope));
        let is_maximum = newton.is_some();
        let step = newton.unwrap_or_else(|| climbing(symmetric, &slope));
        let step = &step * damping(&position, &step);
        let before = moved;
        moved = step.amax();
        position += step;
        // Newton's steps shrink quadratically until only the gradient's rounding is left
        let trembles = moved <= TREMBLING && moved > 0.5 * before;
        if is_maximum && (moved <= AT_REST || trembles) {
            return Ok(position.as_slice().to_vec());
        }
    }
    Err(NumericError::NotConverged {
        iterations: u64::from(NEWTON_STEPS),
        best: position[0],
        residual: moved,
    })
}

/// Newton's step with the curvatures' magnitudes: uphill in every principal direction, away from
/// saddles.
fn climbing(symmetric: DMatrix<f64>, slope: &DVector<f64>) -> DVector<f64> {
    let principal = symmetric.symmetric_eigen();
    let least = f64::EPSILON * principal.eigenvalues.amax().max(f64::MIN_POSITIVE);
    let mut step = principal.eigenvectors.tr_mul(slope);
    for (along, curvature) in step.iter_mut().zip(&principal.eigenvalues) {
        *along /= curvature.abs().max(least);
    }
    principal.eigenvectors * step
}

/// Width of the central differences: their error, of the square of this, only slows convergence.
const DIFFERENCE: f64 = 1e-5;

/// The largest factor ≤ 1 by which a step leaves every gap at least two thirds of its length.
fn damping(position: &DVector<f64>, step: &DVector<f64>) -> f64 {
    let n = position.len();
    let at = |v: &DVector<f64>, k: usize, end: f64| if k < n { v[k] } else { end };
    (0..=n).fold(1.0, |factor, k| {
        let (left, left_step) = if k == 0 {
            (0.0, 0.0)
        } else {
            (position[k - 1], step[k - 1])
        };
        let gap = at(position, k, 1.0) - left;
        let closing = left_step - at(step, k, 0.0);
        if closing > gap / 3.0 {
            f64::min(factor, gap / (3.0 * closing))
        } else {
            factor
        }
    })
}
