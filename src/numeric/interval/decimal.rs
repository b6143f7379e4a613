//! Decimal numbers into intervals and back, rounded outwards.

use super::Interval;
use super::endpoint::{Direction, Endpoint};
use super::precise::Precise;

/// Two decimal numbers that an interval lies between.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct DecimalBounds {
    /// A decimal number not above the lower end.
    pub lower: String,
    /// A decimal number not below the upper end.
    pub upper: String,
}

/// Digits that are handled at a time.
const CHUNK: usize = 15;

/// More decimals than any precision leaves certain.
const MOST_DECIMALS: u32 = 100_000;

/// Numbers from 2^LONGEST are too long to be written out.
const LONGEST: i32 = 332_000;

impl Interval {
    /// The decimal number `text`, rounded outwards to `bits` bits; `None` if it is not a plain
    /// decimal with an optional exponent.
    #[must_use]
    pub fn parse(text: &str, bits: u32) -> Option<Self> {
        let text = text.trim();
        let (text, exponent) = match text.split_once(['e', 'E']) {
            Some((text, exponent)) => (text, exponent.parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (is_negative, text) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
        let digits = format!("{whole}{decimals}");
        let is_plain = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
        let scale = exponent.checked_sub(i32::try_from(decimals.len()).ok()?)?;
        let is_long = |length: usize| length > MOST_DECIMALS as usize;
        if !is_plain || is_long(digits.len()) || scale.unsigned_abs() > MOST_DECIMALS {
            return None;
        }
        let exact_bits = u32::try_from(4 * digits.len()).ok()? + bits + 64;
        let number = |value: f64| Self::precise(value, exact_bits);
        let mut value = number(0.0);
        for chunk in digits.as_bytes().chunks(CHUNK) {
            let piece: f64 = std::str::from_utf8(chunk).ok()?.parse().ok()?;
            let shift = number(10f64.powi(i32::try_from(chunk.len()).ok()?));
            value = value * &shift + &number(piece);
        }
        let power = number(10.0).power(scale.unsigned_abs());
        let value = if scale < 0 {
            value / &power
        } else {
            value * &power
        };
        let value = value.with_precision(bits);
        Some(if is_negative { -value } else { value })
    }

    /// The ends as decimal numbers, rounded outwards two digits beyond the first in which they
    /// differ; `None` for an interval without bounds, or with more than some hundred thousand
    /// digits before the point.
    ///
    /// # Examples
    /// ```
    /// use infoscene::numeric::Interval;
    /// let third = Interval::precise(1.0, 128) / Interval::precise(3.0, 128);
    /// let bounds = third.to_decimal(30).unwrap();
    /// assert_eq!(bounds.lower, "0.333333333333333333333333333333");
    /// assert_eq!(bounds.upper, "0.333333333333333333333333333334");
    /// ```
    #[must_use]
    pub fn to_decimal(&self, most_decimals: u32) -> Option<DecimalBounds> {
        let is_long = |end: &Precise| end.exponent() > LONGEST;
        if !self.is_bounded() || is_long(&self.lower) || is_long(&self.upper) {
            return None;
        }
        let decimals = most_decimals.min(self.certain_decimals() + 2);
        let lower = decimal(&self.lower, decimals, Direction::Down);
        let upper = decimal(&self.upper, decimals, Direction::Up);
        if lower == upper {
            // exact: no zeros behind the last digit
            let shortest = lower
                .split_once('.')
                .map_or(lower.as_str(), |(whole, fraction)| {
                    match fraction.trim_end_matches('0').len() {
                        0 => whole,
                        digits => &lower[..=whole.len() + digits],
                    }
                });
            let [lower, upper] = [shortest.to_owned(), shortest.to_owned()];
            return Some(DecimalBounds { lower, upper });
        }
        Some(DecimalBounds { lower, upper })
    }

    /// The ends as decimal numbers with every certain digit, as [`to_decimal`](Self::to_decimal)
    /// without a limit.
    ///
    /// # Examples
    /// ```
    /// use infoscene::numeric::Interval;
    /// let bounds = Interval::precise(0.375, 128).every_decimal().unwrap();
    /// assert_eq!([bounds.lower, bounds.upper], ["0.375", "0.375"]);
    /// ```
    #[must_use]
    pub fn every_decimal(&self) -> Option<DecimalBounds> {
        self.to_decimal(MOST_DECIMALS)
    }

    /// The number of decimals behind the point that the width leaves certain.
    #[must_use]
    pub fn certain_decimals(&self) -> u32 {
        let width = self.upper.plus(&self.lower.negated(), Direction::Up);
        if width.is_zero() {
            // a dyadic number: as many decimals as it has binary places, exactly
            let bits = i64::from(self.lower.bits()) - i64::from(self.lower.exponent());
            return u32::try_from(bits.clamp(0, 2000)).unwrap_or(0);
        }
        // 2^e ≤ width < 2^(e+1)
        let binary = -i64::from(width.exponent()) - 1;
        let decimals = binary * 30_103 / 100_000;
        u32::try_from(decimals.clamp(0, MOST_DECIMALS.into())).unwrap_or(0)
    }
}

/// `value` with this many decimals, rounded to the given side.
fn decimal(value: &Precise, decimals: u32, direction: Direction) -> String {
    let is_negative = *value < value.constant(0.0);
    let (magnitude, direction) = if is_negative {
        (value.negated(), direction.opposite())
    } else {
        (value.clone(), direction)
    };
    // enough bits that value · 10^decimals is exact
    let bits = magnitude.bits() + 4 * decimals + 64 + magnitude.exponent().max(0).unsigned_abs();
    let number = |value: f64| Interval::precise(value, bits);
    let scaled = Interval::point(magnitude.with_precision(bits, Direction::Down))
        * &number(10.0).power(decimals);
    let mut whole = scaled.lower.floor();
    if direction == Direction::Up && whole < scaled.upper {
        whole = whole.plus(&whole.constant(1.0), Direction::Up);
    }
    let mut digits = integer_digits(whole);
    let decimals = decimals as usize;
    if digits.len() <= decimals {
        digits = "0".repeat(decimals + 1 - digits.len()) + &digits;
    }
    let sign = if is_negative && digits.bytes().any(|digit| digit != b'0') {
        "-"
    } else {
        ""
    };
    let (whole, fraction) = digits.split_at(digits.len() - decimals);
    if fraction.is_empty() {
        format!("{sign}{whole}")
    } else {
        format!("{sign}{whole}.{fraction}")
    }
}

/// The decimal digits of a whole number ≥ 0.
fn integer_digits(mut whole: Precise) -> String {
    let unit = whole.constant(1e15);
    let mut chunks = Vec::new();
    while whole >= unit {
        // rounded down, a quotient never falls below the whole number it contains
        let rest = whole.over(&unit, Direction::Down).floor();
        let taken = rest.times(&unit, Direction::Down).negated();
        chunks.push(
            whole
                .plus(&taken, Direction::Down)
                .to_double(Direction::Down),
        );
        whole = rest;
    }
    let first = format!("{}", whole.to_double(Direction::Down));
    chunks
        .iter()
        .rev()
        .fold(first, |digits, chunk| digits + &format!("{chunk:0>15}"))
}
