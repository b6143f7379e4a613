//! The number type a closed form is written over.
//!
//! A formula takes `S: Scalar` and builds its constants from its arguments (`x.constant(0.5)`), so
//! that a type may carry its own precision. Comparisons may be undecided for an interval: whichever
//! branch a formula then takes must be right, if less accurate.
//!
//! **Not covered**: complex numbers; trigonometric functions other than `atan2`.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A real number type: `f64`, [`Interval`](super::Interval), [`Dual`](super::Dual).
///
/// The right-hand side of an operator may be borrowed, so that types without
/// `Copy` do not drown a formula in `clone`.
pub trait Scalar:
    Clone
    + Debug
    + PartialOrd
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + for<'a> Add<&'a Self, Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> Div<&'a Self, Output = Self>
{
    /// Whether sums carry the magnitude of their terms, as a measure of rounding. An enclosure has
    /// no use for it.
    const TRACKS_ROUNDING: bool = true;

    /// The number `value`, exactly, at the precision of `self`.
    #[must_use]
    fn constant(&self, value: f64) -> Self;
    /// π at the precision of `self`.
    #[must_use]
    fn pi(&self) -> Self;
    /// The number as an `f64`, to within one unit in the last place.
    #[must_use]
    fn to_f64(&self) -> f64;
    /// Square root of a number ≥ 0.
    #[must_use]
    fn sqrt(&self) -> Self;
    /// Natural logarithm of a number > 0.
    #[must_use]
    fn ln(&self) -> Self;
    /// `ln(1 + x)` for `x > −1`, without forming the sum.
    #[must_use]
    fn ln_1p(&self) -> Self;
    /// `ln(to/from)` where this is `to − from`, for `0 < from ≤ to`.
    #[must_use]
    fn ln_ratio(&self, from: &Self, _to: &Self) -> Self {
        (self.clone() / from).ln_1p()
    }
    /// `eˣ`.
    #[must_use]
    fn exp(&self) -> Self;
    /// `eˣ − 1`, without forming the difference.
    #[must_use]
    fn exp_m1(&self) -> Self;
    /// Angle of the point `(x, self)` from the positive x axis, in `(−π, π]`.
    #[must_use]
    fn atan2(&self, x: &Self) -> Self;
    /// Logarithms of numbers that are positive, finite and normal: as [`ln`](Self::ln), but faster
    /// together.
    #[inline(always)]
    #[must_use]
    fn logarithms<const N: usize>(numbers: [&Self; N]) -> [Self; N] {
        // a loop: what a closure does is not compiled for the processor at hand
        let mut logarithms = numbers.map(Clone::clone);
        for logarithm in &mut logarithms {
            *logarithm = logarithm.ln();
        }
        logarithms
    }
    /// The angles of several points `[y, x]`, of which none is subnormal in both coordinates: as
    /// [`atan2`](Self::atan2), but faster together.
    #[inline(always)]
    #[must_use]
    fn angles<const N: usize>(points: [[&Self; 2]; N]) -> [Self; N] {
        let mut angles = points.map(|[y, _]| y.clone());
        for (angle, [_, x]) in angles.iter_mut().zip(points) {
            *angle = angle.atan2(x);
        }
        angles
    }
    /// `(1+x)·ln(1+x) − x` for `x ≥ −1`, to full relative precision.
    ///
    /// The value is 1 at `x = −1` and never negative; near 0 it is `x²/2`, which the
    /// plain difference loses.
    #[must_use]
    fn divergence_kernel(&self) -> Self;
    /// `x·ln|x|`, continued by 0 at `x = 0`.
    #[must_use]
    fn x_ln_x(&self) -> Self;

    /// Runs `work`; if numbers of this type fit a processor's vectors, compiled for those that it
    /// has.
    #[inline(always)]
    fn vectorised<T>(work: impl FnOnce() -> T) -> T {
        work()
    }

    /// Zero.
    #[must_use]
    fn zero(&self) -> Self {
        self.constant(0.0)
    }
    /// Tells whether this is exactly zero.
    #[must_use]
    fn is_zero(&self) -> bool {
        *self == self.zero()
    }
    /// Tells whether this is certainly ≥ 0. An interval from 0 upwards is, though it does not
    /// compare with 0.
    #[must_use]
    fn is_nonnegative(&self) -> bool {
        *self >= self.zero()
    }
    /// Absolute value.
    #[must_use]
    fn abs(&self) -> Self {
        if *self < self.zero() {
            -self.clone()
        } else {
            self.clone()
        }
    }
    /// `x²`.
    #[must_use]
    fn square(&self) -> Self {
        self.clone() * self
    }
}

/// Inlined into other crates too, where a formula over `f64` is compiled anew.
impl Scalar for f64 {
    #[inline(always)]
    fn constant(&self, value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn pi(&self) -> Self {
        std::f64::consts::PI
    }
    #[inline(always)]
    fn to_f64(&self) -> f64 {
        *self
    }
    #[inline(always)]
    fn sqrt(&self) -> Self {
        f64::sqrt(*self)
    }
    #[inline(always)]
    fn ln(&self) -> Self {
        crate::numeric::functions::elementary::ln(*self)
    }
    #[inline(always)]
    fn ln_1p(&self) -> Self {
        crate::numeric::functions::elementary::ln_1p(*self)
    }
    #[inline(always)]
    fn ln_ratio(&self, from: &Self, to: &Self) -> Self {
        crate::numeric::functions::elementary::ln_ratio(*self, *from, *to)
    }
    #[inline(always)]
    fn exp(&self) -> Self {
        f64::exp(*self)
    }
    #[inline(always)]
    fn exp_m1(&self) -> Self {
        f64::exp_m1(*self)
    }
    #[inline(always)]
    fn atan2(&self, x: &Self) -> Self {
        // the choice of the octant is rounded among numbers of few bits
        let scale = if self.abs().max(x.abs()) < f64::MIN_POSITIVE {
            1.0 / f64::EPSILON
        } else {
            1.0
        };
        crate::numeric::functions::elementary::angle(*self * scale, *x * scale)
    }
    #[inline(always)]
    fn logarithms<const N: usize>(numbers: [&Self; N]) -> [Self; N] {
        let mut copies = [0.0; N];
        for i in 0..N {
            copies[i] = *numbers[i];
        }
        crate::numeric::functions::elementary::logarithms(copies)
    }
    #[inline(always)]
    fn angles<const N: usize>(points: [[&Self; 2]; N]) -> [Self; N] {
        let mut copies = [[0.0; 2]; N];
        for i in 0..N {
            let [y, x] = points[i];
            copies[i] = [*y, *x];
        }
        crate::numeric::functions::elementary::angles(copies)
    }
    #[inline(always)]
    fn divergence_kernel(&self) -> Self {
        super::divergence_kernel(*self)
    }
    #[inline(always)]
    fn x_ln_x(&self) -> Self {
        super::x_ln_x(*self)
    }
    #[inline(always)]
    fn abs(&self) -> Self {
        f64::abs(*self)
    }
    #[inline(always)]
    fn vectorised<T>(work: impl FnOnce() -> T) -> T {
        super::vectorised(work)
    }
}
