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
use super::{NumericError, root, tolerance};

/// A local maximum, with the derivative that is left there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Maximum {
    /// Where the derivative changes sign from plus to minus.
    pub position: f64,
    /// The function's value there.
    pub value: f64,
    /// The derivative's value there: what is left of zero.
    pub residual: f64,
    /// How often the derivative was evaluated.
    pub evaluations: u64,
}

/// The highest maximum of `function` inside `(lower, upper)`.
///
/// The derivative is scanned at the ends of `intervals` equal pieces (at most 256), and by powers of
/// two towards either end; the ends themselves, where it need not be finite, are never evaluated. Of
/// maxima that are equal within rounding the leftmost is returned.
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
    let towards_ends = (SMALLEST_POWER..=-8).map(|power| f64::from(power).exp2());
    let shares: Vec<f64> = towards_ends
        .clone()
        .chain((1..intervals).map(|k| f64::from(k) / f64::from(intervals)))
        .chain(towards_ends.rev().map(|share| 1.0 - share))
        .collect();
    let point = |share: f64| lower + width * share;
    let mut best: Option<Maximum> = None;
    let mut evaluations = 0;
    let mut left = (lower, f64::NEG_INFINITY);
    for share in shares {
        let right = (point(share), finite(&derivative, point(share))?);
        evaluations += 1;
        if left.1 > 0.0 && right.1 <= 0.0 {
            let found = root(&derivative, left.0, right.0)?;
            evaluations += found.evaluations;
            let value = finite(&function, found.position)?;
            let is_higher = best
                .is_none_or(|best| value > best.value + tolerance::EQUAL_MAXIMA * value.abs());
            if is_higher {
                let (position, residual) = (found.position, found.residual);
                best = Some(Maximum { position, value, residual, evaluations: 0 });
            }
        }
        left = right;
    }
    best.map(|best| Maximum { evaluations, ..best })
        .ok_or(NumericError::NoInteriorMaximum { lower, upper })
}

/// The outermost scanned points lie this power of two of the width inside.
const SMALLEST_POWER: i32 = -40;

/// A maximum in several ordered coordinates `0 < t_1 < … < t_n < 1`, one root after the other.
///
/// Each sweep moves every coordinate to the root of its own partial derivative between its
/// neighbours, and the sweeps are repeated until no coordinate moves by more than rounding.
/// `partial(t, k)` is the derivative in coordinate `k`; it must be positive just right of the
/// left neighbour and negative just left of the right one.
///
/// # Errors
/// [`NumericError::NotConverged`] if the coordinates still move after the last sweep, and what
/// [`root`] refuses.
pub fn coordinate_maximum(
    partial: impl Fn(&[f64], usize) -> f64,
    mut coordinates: Vec<f64>,
) -> Result<Vec<f64>, NumericError> {
    let mut moved = f64::INFINITY;
    for _ in 0..tolerance::COORDINATE_SWEEPS {
        moved = 0.0;
        for k in 0..coordinates.len() {
            let lower = if k == 0 { 0.0 } else { coordinates[k - 1] };
            let upper = coordinates.get(k + 1).copied().unwrap_or(1.0);
            let inset = (upper - lower) * 2f64.powi(-20);
            let along = |position: f64| {
                let mut moved = coordinates.clone();
                moved[k] = position;
                partial(&moved, k)
            };
            let found = root(along, lower + inset, upper - inset)?.position;
            moved = f64::max(moved, (found - coordinates[k]).abs());
            coordinates[k] = found;
        }
        if moved <= tolerance::COORDINATE_AT_REST {
            return Ok(coordinates);
        }
    }
    Err(NumericError::NotConverged {
        iterations: u64::from(tolerance::COORDINATE_SWEEPS),
        best: coordinates.first().copied().unwrap_or(f64::NAN),
        residual: moved,
    })
}
