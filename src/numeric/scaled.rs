//! Doubles taken apart into significand and power of two, so that products and quotients of tiny
//! and huge ones neither overflow nor underflow on the way.
//!
//! **Not covered**: negative numbers.

use super::functions::elementary;

/// A double as `significand · 2^exponent`, significand 0 or in [1, 2).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scaled {
    /// 0, or in [1, 2).
    pub significand: f64,
    /// Power of two.
    pub exponent: i32,
}

impl Scaled {
    /// Takes a number ≥ 0 apart.
    #[must_use]
    pub(crate) fn new(value: f64) -> Self {
        const EXPONENT_MASK: u64 = 0x7ff << 52;
        if value <= 0.0 || !value.is_finite() {
            return Self {
                significand: value,
                exponent: 0,
            };
        }
        let (normal, shift) = if value < f64::MIN_POSITIVE {
            (value * 2f64.powi(64), -64)
        } else {
            (value, 0)
        };
        let bits = normal.to_bits();
        let exponent = ((bits & EXPONENT_MASK) >> 52) as i32 - 1023;
        let significand = f64::from_bits((bits & !EXPONENT_MASK) | (1023 << 52));
        Self {
            significand,
            exponent: exponent + shift,
        }
    }

    /// Natural logarithm of a number > 0.
    #[must_use]
    pub(crate) fn ln(self) -> f64 {
        elementary::ln(self.significand) + f64::from(self.exponent) * std::f64::consts::LN_2
    }

    /// `value · 2^power`, correctly rounded into `f64`'s range.
    #[must_use]
    pub(crate) fn times_power(self, power: i32) -> f64 {
        let power = (self.exponent + power).clamp(-2200, 2200);
        // in two steps only where one power would leave the range
        if (-1022..=1023).contains(&power) {
            self.significand * 2f64.powi(power)
        } else {
            self.significand * 2f64.powi(power / 2) * 2f64.powi(power - power / 2)
        }
    }
}

/// The numbers divided by the power of two of the largest, and that power.
#[must_use]
pub(crate) fn common_scale(numbers: &[Scaled]) -> (Vec<f64>, i32) {
    let positive = numbers.iter().filter(|number| number.significand > 0.0);
    let unit = positive.map(|number| number.exponent).max().unwrap_or(0);
    (
        numbers
            .iter()
            .map(|number| number.times_power(-unit))
            .collect(),
        unit,
    )
}
