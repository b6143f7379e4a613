//! Powers of two as units, so that scaling a number rounds nothing.
//!
//! **Not covered**: quotients that leave the normal range of `f64`, which are rounded there.

/// The exponent bits of a double.
const EXPONENT: u64 = 0x7ff << 52;

/// `2⁵²`, by which subnormal numbers become normal.
#[expect(clippy::cast_precision_loss, reason = "a power of two")]
const NORMALISER: f64 = (1_u64 << 52) as f64;

/// The power of two at or below the magnitude of a number; zero, infinities and NaN keep their
/// magnitude.
///
/// # Examples
/// ```
/// use infoscene::numeric::power_of_two_below;
/// assert_eq!((power_of_two_below(7.9), power_of_two_below(-8.0)), (4.0, 8.0));
/// ```
#[must_use]
#[inline(always)]
pub fn power_of_two_below(number: f64) -> f64 {
    if number.is_normal() {
        f64::from_bits(number.to_bits() & EXPONENT)
    } else if number.is_subnormal() {
        f64::from_bits((number * NORMALISER).to_bits() & EXPONENT) / NORMALISER
    } else {
        number.abs()
    }
}

/// The power of two nearest to the magnitude of a number as a ratio: the number is between `1/√2`
/// and `√2` of it.
///
/// **Arguments** at most `2¹⁰²³`; zero and NaN keep their magnitude.
///
/// # Examples
/// ```
/// use infoscene::numeric::power_of_two_near;
/// assert_eq!((power_of_two_near(5.6), power_of_two_near(5.7)), (4.0, 8.0));
/// ```
#[must_use]
#[inline(always)]
pub fn power_of_two_near(number: f64) -> f64 {
    power_of_two_below(number * std::f64::consts::SQRT_2)
}
