//! Ends of intervals: numbers whose operations round down or up.

use crate::numeric::sums::expansion::two_sum;
use std::cmp::Ordering;
use std::fmt::Debug;

/// The direction in which an inexact result is rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Towards −∞.
    Down,
    /// Towards +∞.
    Up,
}

impl Direction {
    pub(super) const fn opposite(self) -> Self {
        match self {
            Self::Down => Self::Up,
            Self::Up => Self::Down,
        }
    }
}

/// A number type with directed rounding: `f64`, [`Precise`](super::precise::Precise).
///
/// An operation returns a number on the given side of the exact result, exactly it where it is
/// representable. The ends ±∞ are numbers like others; the interval types never ask for ∞ − ∞ or 0
/// · ∞.
pub trait Endpoint: Clone + Debug + PartialOrd + 'static {
    /// The number `value`, exactly, at the precision of `self`.
    #[must_use]
    fn constant(&self, value: f64) -> Self;
    /// The nearest number on the given side that this many more bits of precision can tell.
    #[must_use]
    fn with_precision(&self, bits: u32, direction: Direction) -> Self;
    /// Bits of the significand.
    fn bits(&self) -> u32;
    /// `−x`, exactly.
    #[must_use]
    fn negated(&self) -> Self;
    /// `x + y`.
    #[must_use]
    fn plus(&self, other: &Self, direction: Direction) -> Self;
    /// `x · y`.
    #[must_use]
    fn times(&self, other: &Self, direction: Direction) -> Self;
    /// `x / y`, y ≠ 0.
    #[must_use]
    fn over(&self, other: &Self, direction: Direction) -> Self;
    /// `√x`, x ≥ 0.
    #[must_use]
    fn root(&self, direction: Direction) -> Self;
    /// `x · 2^power`, exactly unless it leaves the range.
    #[must_use]
    fn scaled(&self, power: i32, direction: Direction) -> Self;
    /// The power of two e with `2^e ≤ |x| < 2^(e+1)`, of a finite number that is not 0.
    fn exponent(&self) -> i32;
    /// A double on the given side.
    fn to_double(&self, direction: Direction) -> f64;

    /// The side of 0 on which it lies; `Equal` for NaN.
    fn sign(&self) -> Ordering {
        let sign = self.partial_cmp(&self.constant(0.0));
        sign.unwrap_or(Ordering::Equal)
    }
    /// Tells whether this is exactly 0.
    fn is_zero(&self) -> bool {
        *self == self.constant(0.0)
    }
    /// Tells whether this is neither infinite nor NaN.
    fn is_finite(&self) -> bool;
}

/// A double that is off by less than one unit in the last place, moved outwards, but never past 0:
/// an underflow keeps its sign.
fn outward(value: f64, direction: Direction) -> f64 {
    match direction {
        Direction::Down if value == 0.0 && value.is_sign_positive() => value,
        Direction::Up if value == 0.0 && value.is_sign_negative() => value,
        Direction::Down => value.next_down(),
        Direction::Up => value.next_up(),
    }
}

/// `value` if the exact result lies on the wanted side of it (`residual` = exact − value, by sign),
/// else its neighbour.
fn rounded(value: f64, residual: f64, direction: Direction) -> f64 {
    let is_short = match direction {
        Direction::Down => residual < 0.0,
        Direction::Up => residual > 0.0,
    };
    if is_short || residual.is_nan() || !value.is_finite() {
        outward(value, direction)
    } else {
        value
    }
}

/// Below this a rounding error may underflow and cannot be computed exactly.
const RESIDUAL_RANGE: f64 = 1e-270;

impl Endpoint for f64 {
    fn constant(&self, value: f64) -> Self {
        value
    }
    fn with_precision(&self, _bits: u32, _direction: Direction) -> Self {
        *self
    }
    fn bits(&self) -> u32 {
        f64::MANTISSA_DIGITS
    }
    fn negated(&self) -> Self {
        -*self
    }
    fn plus(&self, other: &Self, direction: Direction) -> Self {
        if !(self.is_finite() && other.is_finite()) {
            return self + other;
        }
        let (sum, residual) = two_sum(*self, *other);
        rounded(sum, residual, direction)
    }
    fn times(&self, other: &Self, direction: Direction) -> Self {
        let product = self * other;
        if !(self.is_finite() && other.is_finite()) || *self == 0.0 || *other == 0.0 {
            return product;
        }
        if product.abs() < RESIDUAL_RANGE {
            return outward(product, direction);
        }
        rounded(product, self.mul_add(*other, -product), direction)
    }
    fn over(&self, other: &Self, direction: Direction) -> Self {
        let quotient = self / other;
        if !(self.is_finite() && other.is_finite()) || *self == 0.0 {
            return quotient;
        }
        if self.abs() < RESIDUAL_RANGE || quotient.abs() < RESIDUAL_RANGE {
            return outward(quotient, direction);
        }
        let residual = (-quotient).mul_add(*other, *self);
        rounded(quotient, residual * other.signum(), direction)
    }
    fn root(&self, direction: Direction) -> Self {
        let root = f64::sqrt(*self);
        if !self.is_finite() || *self == 0.0 {
            return root;
        }
        if *self < RESIDUAL_RANGE {
            return outward(root, direction);
        }
        rounded(root, (-root).mul_add(root, *self), direction)
    }
    fn scaled(&self, power: i32, direction: Direction) -> Self {
        // in three steps, as some powers of two between two doubles are not doubles themselves
        let power = power.clamp(-2400, 2400);
        let steps = [power / 3, power / 3, power - power / 3 * 2];
        let times = |value: f64, sign: i32| {
            let factors = steps.map(|step| 2f64.powi(sign * step));
            factors.iter().fold(value, |value, factor| value * factor)
        };
        let scaled = times(*self, 1);
        if !self.is_finite() || *self == 0.0 || scaled.is_normal() {
            return scaled;
        }
        rounded(scaled, self - times(scaled, -1), direction)
    }
    fn exponent(&self) -> i32 {
        let (value, shift) = if self.is_normal() {
            (*self, 0)
        } else {
            (self * 2f64.powi(64), -64)
        };
        #[allow(clippy::cast_possible_truncation, reason = "eleven bits fit")]
        let biased = ((value.to_bits() >> 52) & 0x7ff) as i32;
        biased - 1023 + shift
    }
    fn to_double(&self, _direction: Direction) -> f64 {
        *self
    }
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }
}
