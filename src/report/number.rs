//! Numbers with no more digits than are certain.

/// Most significant digits a table shows; records carry all.
const MOST_DIGITS: i32 = 12;

/// `value` with as many decimals as its error leaves certain.
///
/// The last decimal shown is off by at most one unit; a value below its error is `0`. Meant for errors
/// below 0.1: no digit before the point is ever left out.
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
    let by_digits = MOST_DIGITS - 1 - exponent(value.abs());
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

/// One significant digit in scientific notation, `1e-12`; 0 is `0`.
#[must_use]
pub fn scientific(value: f64) -> String {
    if value.abs() > 0.0 {
        format!("{value:.0e}")
    } else {
        "0".to_owned()
    }
}
