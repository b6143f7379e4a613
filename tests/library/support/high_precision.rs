//! Arithmetic with 256 bits or any other number, rounded to nearest: reference values, never
//! enclosures.
//!
//! A thin dress around `astro-float` and its own elementary functions, so that a closed form can be
//! evaluated with some 75 digits: an independent judge of the library's `f64` values and of its
//! intervals.
//!
//! **Not covered**: directed rounding; nothing here may be called a bound.

use astro_float_num::{BigFloat, Consts, Radix, RoundingMode, Sign};
use infoscene::numeric::Scalar;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

const NEAREST: RoundingMode = RoundingMode::ToEven;

thread_local! {
    /// The cache of π and ln 2 that `astro-float` asks for; `None` only if memory ran out.
    static CONSTANTS: RefCell<Option<Consts>> = RefCell::new(Consts::new().ok());
}

/// A real number with a significand of `BITS` bits and a 32-bit exponent.
///
/// An operation without a result (0/0, ln of a negative number) gives NaN, as in `f64`.
#[derive(Debug, Clone)]
pub struct BigReal<const BITS: usize>(BigFloat);

/// 256 bits, some 75 digits.
pub type HighPrecision = BigReal<256>;

impl<const BITS: usize> BigReal<BITS> {
    /// The number `value`, exactly.
    #[must_use]
    pub fn new(value: f64) -> Self {
        if value.abs() < f64::MIN_POSITIVE {
            // `from_f64` loses a factor of two on subnormals: scaled into the normal range and back
            let scale = 2f64.powi(64);
            let scaled = Self(BigFloat::from_f64(value * scale, BITS));
            return scaled / Self(BigFloat::from_f64(scale, BITS));
        }
        Self(BigFloat::from_f64(value, BITS))
    }

    /// The decimal `text`, rounded to `BITS` bits; `None` if it is not a finite number.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let value = with_constants(|constants| {
            BigFloat::parse(text.trim(), Radix::Dec, BITS, NEAREST, constants)
        });
        (!value.is_nan() && !value.is_inf()).then_some(Self(value))
    }

    fn is_small(&self) -> bool {
        // below 2⁻⁸ the logarithm and exponential forms lose bits and the series converge fast
        self.0.is_zero() || self.0.exponent().is_some_and(|e| e < -7)
    }

    fn power_series(&self, coefficient: impl Fn(u32) -> f64, start: u32) -> Self {
        // Σ_{k ≥ start} x^k / coefficient(k): the denominators are integers, exact in f64
        let mut power = Self::new(1.0);
        for _ in 0..start {
            power = power * self;
        }
        let mut sum = self.zero();
        for k in start.. {
            let term = power.clone() / Self::new(coefficient(k));
            let done = term.is_negligible_beside(&sum) || k as usize > 2 * BITS;
            sum = sum + term;
            if done {
                break;
            }
            power = power * self;
        }
        sum
    }

    fn is_negligible_beside(&self, sum: &Self) -> bool {
        match (self.0.exponent(), sum.0.exponent()) {
            _ if self.0.is_zero() => true,
            (Some(term), Some(total)) if !sum.0.is_zero() => {
                i64::from(term)
                    < i64::from(total) - (i64::try_from(BITS).unwrap_or(i64::MAX / 2) + 14)
            }
            _ => false,
        }
    }
}

fn with_constants(compute: impl FnOnce(&mut Consts) -> BigFloat) -> BigFloat {
    CONSTANTS.with_borrow_mut(|constants| match constants {
        Some(constants) => compute(constants),
        None => astro_float_num::NAN,
    })
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<const BITS: usize> $trait for BigReal<BITS> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(&other.0, BITS, NEAREST))
            }
        }
        impl<const BITS: usize> $trait<&BigReal<BITS>> for BigReal<BITS> {
            type Output = Self;
            fn $method(self, other: &Self) -> Self {
                Self(self.0.$method(&other.0, BITS, NEAREST))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<const BITS: usize> Neg for BigReal<BITS> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.neg())
    }
}

impl<const BITS: usize> PartialEq for BigReal<BITS> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl<const BITS: usize> PartialOrd for BigReal<BITS> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.cmp(&other.0).map(|sign| sign.cmp(&0))
    }
}

impl<const BITS: usize> Scalar for BigReal<BITS> {
    fn constant(&self, value: f64) -> Self {
        Self::new(value)
    }
    fn pi(&self) -> Self {
        Self(with_constants(|constants| constants.pi(BITS, NEAREST)))
    }
    fn to_f64(&self) -> f64 {
        if self.0.is_nan() {
            return f64::NAN;
        }
        // the two leading 64-bit words: right to within one unit in the last place
        let Some((words, _, sign, exponent, _)) = self.0.as_raw_parts() else {
            return if self.0.is_negative() {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            };
        };
        let mut magnitude = 0.0;
        for word in words.iter().rev().take(2) {
            #[expect(
                clippy::cast_precision_loss,
                reason = "the low bits of a 64-bit word round away"
            )]
            let piece = *word as f64;
            magnitude = if magnitude > 0.0 {
                magnitude + piece / 2f64.powi(64)
            } else {
                piece
            };
        }
        // the significand is a fraction in [1/2, 1), its leading word has weight 2⁻⁶⁴
        let scale = exponent.clamp(-4000, 4000) - 64;
        let half = scale / 2;
        magnitude = magnitude * 2f64.powi(half) * 2f64.powi(scale - half);
        if sign == Sign::Neg {
            -magnitude
        } else {
            magnitude
        }
    }
    fn sqrt(&self) -> Self {
        Self(self.0.sqrt(BITS, NEAREST))
    }
    fn ln(&self) -> Self {
        Self(with_constants(|constants| {
            self.0.ln(BITS, NEAREST, constants)
        }))
    }
    fn ln_1p(&self) -> Self {
        if self.is_small() {
            // ln(1+x) = Σ (−1)^{k+1} x^k / k
            self.power_series(|k| f64::from(k) * if k % 2 == 1 { 1.0 } else { -1.0 }, 1)
        } else {
            (Self::new(1.0) + self).ln()
        }
    }
    fn exp(&self) -> Self {
        Self(with_constants(|constants| {
            self.0.exp(BITS, NEAREST, constants)
        }))
    }
    fn exp_m1(&self) -> Self {
        if self.is_small() {
            // Σ x^k/k!; the factorials leave f64's integers at 18!, so the sum runs on the ratio
            let mut term = self.clone();
            let mut sum = self.zero();
            for k in 2..BITS {
                let done = term.is_negligible_beside(&sum);
                sum = sum + &term;
                if done {
                    break;
                }
                term = term * self / Self::new(k as f64);
            }
            sum
        } else {
            self.exp() - Self::new(1.0)
        }
    }
    fn atan2(&self, x: &Self) -> Self {
        let zero = self.zero();
        if *x > zero {
            return Self(with_constants(|constants| {
                (self.clone() / x).0.atan(BITS, NEAREST, constants)
            }));
        }
        let half_pi = self.pi() / Self::new(2.0);
        let complement = |y: &Self| {
            Self(with_constants(|constants| {
                (x.clone() / y).0.atan(BITS, NEAREST, constants)
            }))
        };
        if *self > zero {
            half_pi - complement(self)
        } else if *self < zero {
            -half_pi - complement(self)
        } else if *x < zero {
            self.pi()
        } else {
            zero
        }
    }
    fn divergence_kernel(&self) -> Self {
        if self.is_small() {
            // φ(x) = Σ_{k≥2} (−1)^k x^k / (k(k−1))
            self.power_series(
                |k| f64::from(k) * f64::from(k - 1) * if k % 2 == 0 { 1.0 } else { -1.0 },
                2,
            )
        } else {
            let one_plus = Self::new(1.0) + self;
            if one_plus.is_zero() {
                -self.clone()
            } else {
                one_plus.ln() * &one_plus - self
            }
        }
    }
    fn x_ln_x(&self) -> Self {
        if self.is_zero() {
            self.clone()
        } else {
            self.abs().ln() * self
        }
    }
}
