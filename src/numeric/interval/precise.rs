//! Interval ends of any precision, on `astro-float`.
//!
//! Only its four operations and its comparisons are used, rounded down or up; the elementary
//! functions of an interval are built from these (`elementary`), and the library's own are the
//! tests' independent judge.

use super::endpoint::{Direction, Endpoint};
use astro_float_num::{BigFloat, RoundingMode, Sign};
use std::cmp::Ordering;

/// A number with a significand of any length and a 32-bit exponent, as the end of an interval.
#[derive(Debug, Clone)]
pub struct Precise {
    value: BigFloat,
    bits: u32,
}

/// Bits in a word of a significand.
const WORD: u32 = 64;

const fn mode(direction: Direction) -> RoundingMode {
    match direction {
        Direction::Down => RoundingMode::Down,
        Direction::Up => RoundingMode::Up,
    }
}

/// Powers of two of a finite number, to either side. The library's own range is wider by a factor
/// of eight, so that no operation on such numbers over- or underflows before it is looked at.
const LARGEST_POWER: i32 = 1 << 28;

/// `value` with `bits` bits: the library keeps whole words.
fn cut(mut value: BigFloat, bits: u32, direction: Direction) -> BigFloat {
    if !bits.is_multiple_of(WORD)
        && let Some(exponent) = value.exponent()
        && !value.is_zero()
    {
        // 2^-exponent · value has `bits` bits behind the point
        value.set_exponent(0);
        value = value.round(bits as usize, mode(direction));
        if let Some(carried) = value.exponent() {
            value.set_exponent(exponent + carried);
        }
    }
    value
}

impl Precise {
    /// The number `value`, exactly, as the start of calculations with `bits` bits (at least 53).
    #[must_use]
    pub fn new(value: f64, bits: u32) -> Self {
        let bits = bits.max(f64::MANTISSA_DIGITS);
        let words = bits as usize;
        // `from_f64` loses a factor of two on subnormals: scaled into the normal range and back
        let mut number = if value != 0.0 && value.abs() < f64::MIN_POSITIVE {
            BigFloat::from_f64(value * 2f64.powi(64), words)
        } else {
            return Self {
                value: BigFloat::from_f64(value, words),
                bits,
            };
        };
        if let Some(exponent) = number.exponent() {
            number.set_exponent(exponent - 64);
        }
        Self {
            value: number,
            bits,
        }
    }

    /// The value of an operation, cut to `bits` and kept within the range of exponents.
    fn finished(value: BigFloat, bits: u32, direction: Direction) -> Self {
        let value = cut(value, bits, direction);
        let Some(exponent) = value.exponent().filter(|_| !value.is_zero()) else {
            return Self { value, bits };
        };
        let is_negative = value.is_negative();
        let is_away_from_zero = is_negative == (direction == Direction::Down);
        let size = match (exponent.cmp(&0), exponent.abs() > LARGEST_POWER) {
            (_, false) => return Self { value, bits },
            (Ordering::Greater, _) if is_away_from_zero => astro_float_num::INF_POS,
            (Ordering::Greater, _) => {
                let mut largest = BigFloat::max_value(bits as usize);
                largest.set_exponent(LARGEST_POWER);
                cut(largest, bits, Direction::Down)
            }
            _ if is_away_from_zero => {
                let mut smallest = BigFloat::from_f64(0.5, bits as usize);
                smallest.set_exponent(-LARGEST_POWER);
                smallest
            }
            _ => BigFloat::from_f64(0.0, bits as usize),
        };
        let value = if is_negative { size.neg() } else { size };
        Self { value, bits }
    }

    /// The largest whole number that is not larger.
    pub(super) fn floor(&self) -> Self {
        Self {
            value: self.value.floor(),
            bits: self.bits,
        }
    }
}

impl PartialEq for Precise {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Precise {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.cmp(&other.value).map(|sign| sign.cmp(&0))
    }
}

impl Endpoint for Precise {
    fn constant(&self, value: f64) -> Self {
        Self::new(value, self.bits)
    }
    fn with_precision(&self, bits: u32, direction: Direction) -> Self {
        let bits = bits.max(f64::MANTISSA_DIGITS);
        if bits >= self.bits || !self.is_finite() || self.value.is_zero() {
            return Self {
                value: self.value.clone(),
                bits,
            };
        }
        let zero = BigFloat::from_f64(0.0, bits as usize);
        let value = self.value.add(&zero, bits as usize, mode(direction));
        Self::finished(value, bits, direction)
    }
    fn bits(&self) -> u32 {
        self.bits
    }
    fn negated(&self) -> Self {
        Self {
            value: self.value.neg(),
            bits: self.bits,
        }
    }
    fn plus(&self, other: &Self, direction: Direction) -> Self {
        let bits = self.bits.max(other.bits);
        let value = self.value.add(&other.value, bits as usize, mode(direction));
        Self::finished(value, bits, direction)
    }
    fn times(&self, other: &Self, direction: Direction) -> Self {
        let bits = self.bits.max(other.bits);
        let value = self.value.mul(&other.value, bits as usize, mode(direction));
        Self::finished(value, bits, direction)
    }
    fn over(&self, other: &Self, direction: Direction) -> Self {
        let bits = self.bits.max(other.bits);
        let value = self.value.div(&other.value, bits as usize, mode(direction));
        Self::finished(value, bits, direction)
    }
    /// Heron's step: whatever y > 0, √x lies between y and x/y.
    fn root(&self, direction: Direction) -> Self {
        if !self.is_finite() || self.value.is_zero() {
            return self.clone();
        }
        let power = self.exponent().div_euclid(2) * 2;
        let near_one = self.scaled(-power, direction);
        let seed = near_one.to_double(direction).sqrt();
        let half = near_one.constant(0.5);
        let mut y = near_one.constant(seed);
        let mut correct = f64::MANTISSA_DIGITS - 4;
        while correct < self.bits + 2 {
            y = near_one
                .over(&y, direction)
                .plus(&y, direction)
                .times(&half, direction);
            correct *= 2;
        }
        let other = near_one.over(&y, direction);
        let (smaller, larger) = if other < y {
            // y came out above, so that x/y rounded up may still be below the root
            (near_one.over(&y, Direction::Down), y)
        } else {
            let above = near_one.over(&y, Direction::Up);
            (y, above)
        };
        let end = match direction {
            Direction::Down => smaller,
            Direction::Up => larger,
        };
        end.scaled(power / 2, direction)
    }
    fn scaled(&self, power: i32, direction: Direction) -> Self {
        let mut value = self.value.clone();
        if let Some(exponent) = value.exponent()
            && !value.is_zero()
        {
            let beyond = 2 * LARGEST_POWER;
            value.set_exponent(exponent.saturating_add(power).clamp(-beyond, beyond));
        }
        Self::finished(value, self.bits, direction)
    }
    fn exponent(&self) -> i32 {
        // the library's significands lie in [1/2, 1)
        self.value.exponent().map_or(0, |exponent| exponent - 1)
    }
    fn to_double(&self, direction: Direction) -> f64 {
        if self.value.is_nan() {
            return f64::NAN;
        }
        let Some((words, _, sign, exponent, _)) = self.value.as_raw_parts() else {
            return if self.value.is_negative() {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            };
        };
        let Some(leading) = words.last().filter(|_| !self.value.is_zero()) else {
            return 0.0;
        };
        // the first 53 bits, cut off: a lower bound on the magnitude
        #[expect(clippy::cast_precision_loss, reason = "53 bits are left")]
        let cut = (leading >> 11) as f64;
        let magnitude = cut.scaled(exponent - 53, Direction::Down);
        let below = if sign == Sign::Neg {
            -magnitude
        } else {
            magnitude
        };
        let is_short = |candidate: f64| {
            let candidate = self.constant(candidate);
            match direction {
                Direction::Down => candidate > *self,
                Direction::Up => candidate < *self,
            }
        };
        if is_short(below) {
            match direction {
                Direction::Down => below.next_down(),
                Direction::Up => below.next_up(),
            }
        } else {
            below
        }
    }
    fn sign(&self) -> Ordering {
        if self.value.is_zero() || self.value.is_nan() {
            Ordering::Equal
        } else if self.value.is_negative() {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    }
    fn is_zero(&self) -> bool {
        self.value.is_zero()
    }
    fn is_finite(&self) -> bool {
        !self.value.is_nan() && !self.value.is_inf()
    }
}
