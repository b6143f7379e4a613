//! Numbers with no more digits than are certain.

use crate::numeric::interval::Endpoint;
use crate::numeric::{Interval, Scalar};

/// Most significant digits a table shows; records carry all.
const MOST_DIGITS: i32 = 12;

/// `value` with as many decimals as its error leaves certain.
///
/// The last decimal shown is off by at most one unit; a value below its error is `0`. Meant for
/// errors below 0.1: no digit before the point is ever left out.
///
/// # Examples
/// ```
/// use infoscene::report::certain_digits;
/// assert_eq!(certain_digits(0.399_201_026_045, 1e-5), "0.3992");
/// assert_eq!(certain_digits(3.0, 0.0), "3");
/// assert_eq!(certain_digits(-1e-16, 1e-12), "0");
/// ```
#[must_use]
pub fn certain_digits(value: f64, error: f64) -> String {
    if value.abs() <= error {
        return "0".to_owned();
    }
    if error <= 0.0 && value.fract().abs() <= 0.0 {
        return value.to_string();
    }
    #[allow(
        clippy::cast_possible_truncation,
        reason = "decimal exponents of doubles fit"
    )]
    let exponent = |x: f64| x.log10().floor() as i32;
    // what is not finite has no digits either, and is refused where its record is made
    let by_digits = (MOST_DIGITS - 1).saturating_sub(exponent(value.abs()));
    let by_error = if error > 0.0 {
        -exponent(2.0 * error) - 1
    } else {
        i32::MAX
    };
    let decimals = by_digits.min(by_error).max(0);
    if value.abs() < 1e-3 {
        let digits = (decimals + exponent(value.abs())).clamp(0, MOST_DIGITS - 1);
        return format!("{value:.*e}", usize::try_from(digits).unwrap_or(0));
    }
    format!("{value:.*}", usize::try_from(decimals).unwrap_or(0))
}

/// The number in an enclosure, rounded to as many decimals as its width leaves certain, 20 at most.
///
/// The last decimal shown is off by at most one unit; an enclosure of 0 is `0`.
///
/// # Examples
/// ```
/// use infoscene::numeric::Interval;
/// use infoscene::report::enclosed_digits;
/// let third = Interval::precise(-1.0, 128) / Interval::precise(3.0, 128);
/// assert_eq!(enclosed_digits(&third), "-0.33333333333333333333");
/// assert_eq!(enclosed_digits(&Interval::precise(0.75, 128)), "0.75");
/// ```
#[must_use]
pub fn enclosed_digits(enclosure: &Interval) -> String {
    let exact = enclosure.to_decimal(MOST_SHOWN);
    if let Some(bounds) = exact.filter(|_| enclosure.is_point()) {
        return bounds.lower;
    }
    if enclosure.contains_zero() {
        return "0".to_owned();
    }
    let decimals = enclosure
        .certain_decimals()
        .saturating_sub(1)
        .min(MOST_SHOWN);
    // half a unit away from 0, then cut
    let bits = enclosure.lower().bits();
    let half = Interval::parse(&format!("5e-{}", decimals + 1), bits);
    let rounded = half.and_then(|half| {
        let middle = Interval::point(enclosure.midpoint());
        let (sign, magnitude) = if middle < middle.zero() {
            ("-", -middle)
        } else {
            ("", middle)
        };
        let bounds = (magnitude + &half).to_decimal(decimals)?;
        Some(format!("{sign}{}", bounds.lower))
    });
    rounded.unwrap_or_else(|| certain_digits(enclosure.to_f64(), enclosure.width()))
}

/// Most decimals of an enclosed number in a table; records carry all.
const MOST_SHOWN: u32 = 20;

/// The least power of ten that is not below a number > 0, `1e-55`. Of a width, another platform
/// prints this, too.
#[must_use]
pub fn power_of_ten(value: f64) -> String {
    format!("1e{}", value.log10().ceil())
}

/// One significant digit in scientific notation, `1e-12`; 0 is `0`.
#[must_use]
pub fn scientific(value: f64) -> String {
    if value.abs() > 0.0 {
        format!("{value:.0e}")
    } else {
        "0".to_owned()
    }
}
