//! Sums of signed terms that keep the magnitude of their terms, as a measure of rounding.
//!
//! The closed forms are alternating sums. Each term is written so that its own relative error is a
//! few ε; then the error of the sum is a few ε times the sum of the terms' magnitudes, which is
//! carried along.
//!
//! Three building blocks keep the relative accuracy of a *difference* between two nearby corners
//! (Δ = b − a is known exactly, as a side length):
//!
//! ```text
//!   atan(b/p) − atan(a/p) = atan2(Δ p, p² + a b)
//!   ln r_b² − ln r_a²     = ln1p((r_b² − r_a²)/r_a²) = −ln1p((r_a² − r_b²)/r_b²)
//!   √(b²+c²) − √(a²+c²)   = Δ (a + b) / (√(b²+c²) + √(a²+c²))
//! ```
//!
//! The first is perfectly conditioned: with M² = (p²+a²)(p²+b²) the argument's rounding is at most
//! some ε M, which moves the angle by as many ε sin(angle).
//!
//! Roundings are counted in halves of ε: one for an operation, four for an angle (2 ε), two for a
//! logarithm, four for one of a ratio; an angle or a root passes on at most what its argument has,
//! or half of it. A sum over corners takes 8: three levels within a corner, three across the eight,
//! and the quotient by 2π.

use crate::form_factor::{ExchangeArea, FormFactorError};
use crate::numeric::{Scalar, tolerance};
use std::array::from_fn;

/// A sum, and the sum of its terms' magnitudes.
#[derive(Debug, Clone, PartialEq)]
pub struct Exchange<S> {
    /// The sum: an exchange area, or its derivative.
    pub value: S,
    /// Σ |term|, what rounding errors are relative to; 0 for a type that does not track rounding.
    pub magnitude: S,
}

impl<S: Scalar> Exchange<S> {
    #[inline(always)]
    pub(crate) fn new(like: &S) -> Self {
        Self {
            value: like.zero(),
            magnitude: like.zero(),
        }
    }

    /// Adds a term that is accurate relative to itself.
    #[inline(always)]
    pub(crate) fn add(&mut self, term: S) {
        if S::TRACKS_ROUNDING {
            self.magnitude = self.magnitude.clone() + &term.abs();
        }
        self.value = self.value.clone() + &term;
    }

    /// Adds a term that is accurate relative to `magnitude`, ≥ |term| in absolute value.
    #[inline(always)]
    pub(crate) fn add_uncertain(&mut self, term: S, magnitude: impl FnOnce() -> S) {
        if S::TRACKS_ROUNDING {
            self.magnitude = self.magnitude.clone() + &magnitude().abs();
        }
        self.value = self.value.clone() + &term;
    }

    pub(crate) fn add_signed(&mut self, sign: Sign, other: &Self) {
        self.magnitude = self.magnitude.clone() + &other.magnitude;
        self.value = match sign {
            Sign::Plus => self.value.clone() + &other.value,
            Sign::Minus => self.value.clone() - &other.value,
        };
    }

    /// The signed sum of a term over the eight corners of a form, all in one loop; to be called
    /// where vector code is made. `columns` lays the numbers out coordinate by coordinate, as
    /// vectors are.
    #[inline(always)]
    pub(crate) fn over_corners<const K: usize, const C: usize>(
        numbers: &[S; C],
        sign: impl Fn(usize) -> Sign,
        columns: impl Fn(&[S; C]) -> [[S; 8]; K],
        term: impl Fn(&[S; C], &[[S; 8]; K], usize) -> Self,
    ) -> Self {
        let columns = columns(numbers);
        let mut values: [S; 8] = from_fn(|_| numbers[0].zero());
        let mut magnitudes = values.clone();
        for i in 0..8 {
            let term = term(numbers, &columns, i);
            values[i] = term.value;
            magnitudes[i] = term.magnitude;
        }
        let values: [S; 8] = from_fn(|i| match sign(i) {
            Sign::Plus => values[i].clone(),
            Sign::Minus => -values[i].clone(),
        });
        Self {
            value: across(values),
            magnitude: across(magnitudes),
        }
    }

    /// Divided by 2π and signed, as the last step of a form.
    #[inline(always)]
    pub(crate) fn over_two_pi(self, sign: Sign) -> Self {
        let two_pi = self.value.pi() * &self.value.constant(2.0);
        let value = match sign {
            Sign::Plus => self.value,
            Sign::Minus => -self.value,
        };
        Self {
            value: value / &two_pi,
            magnitude: self.magnitude / &two_pi,
        }
    }
}

impl Exchange<f64> {
    /// Value and error bound, times the area of a unit square.
    ///
    /// # Errors
    /// [`FormFactorError::OutOfRange`] if the value leaves the range of `f64`.
    #[inline(always)]
    pub fn in_range(&self, unit_area: f64) -> Result<ExchangeArea, FormFactorError> {
        let value = self.value * unit_area;
        let error = tolerance::RECTANGLE_TERMS * f64::EPSILON * self.magnitude * unit_area;
        if value.is_finite() && error.is_finite() {
            Ok(ExchangeArea { value, error })
        } else {
            Err(FormFactorError::OutOfRange { value })
        }
    }

    /// Value and error bound of an exchange area, which must be positive beyond its error.
    ///
    /// # Errors
    /// As [`in_range`](Self::in_range); [`FormFactorError::NotResolved`] if the error bound is not
    /// below the value.
    #[inline(always)]
    pub fn resolved(&self, unit_area: f64) -> Result<ExchangeArea, FormFactorError> {
        let exchange = self.in_range(unit_area)?;
        let ExchangeArea { value, error } = exchange;
        if value > error {
            Ok(exchange)
        } else {
            Err(FormFactorError::NotResolved { value, error })
        }
    }
}

impl<S: Scalar> Exchange<S> {
    /// An exchange area in any number type, in the unit of its spans.
    ///
    /// # Errors
    /// [`FormFactorError::NotResolved`] if it is not positive beyond its rounding, where the type
    /// tracks that; [`FormFactorError::OutOfRange`] if it has no bounds.
    pub fn certain(self) -> Result<S, FormFactorError> {
        let value = self.value.to_f64();
        let error = tolerance::RECTANGLE_TERMS * f64::EPSILON * self.magnitude.to_f64();
        if !value.is_finite() {
            Err(FormFactorError::OutOfRange { value })
        } else if S::TRACKS_ROUNDING && value <= error {
            Err(FormFactorError::NotResolved { value, error })
        } else {
            Ok(self.value)
        }
    }
}

/// The sign of a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sign {
    Plus,
    Minus,
}

impl Sign {
    /// The product of two.
    pub(crate) fn times(self, other: Self) -> Self {
        if self == other {
            Self::Plus
        } else {
            Self::Minus
        }
    }
}

/// `ln r_b² − ln r_a²` from the difference of squares; either form is right, the one taken keeps
/// its digits.
#[inline(always)]
pub(crate) fn log_ratio<S: Scalar>(difference: &S, r2_a: &S, r2_b: &S) -> S {
    let falls = *difference < difference.zero();
    let (step, from, to) = if falls {
        (-difference.clone(), r2_b, r2_a)
    } else {
        (difference.clone(), r2_a, r2_b)
    };
    let log = step.ln_ratio(from, to);
    if falls { -log } else { log }
}

/// The sum of eight, halves first.
#[inline(always)]
fn across<S: Scalar>([a, b, c, d, e, f, g, h]: [S; 8]) -> S {
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}
