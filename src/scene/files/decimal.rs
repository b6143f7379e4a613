//! One less a decimal, exactly: `1 − 0.9` is `0.1`, and not the `0.09999999999999998` of two
//! roundings.
//!
//! View3D files hold the emissivity where a scene holds the reflectance. As decimals each is made
//! from the other without a rounding, so that a reflectance that is written reads back to the same
//! `f64`.

/// More digits than any `f64` between 0 and 1 has before they are all zeros or cannot matter.
const MOST_DIGITS: i64 = 1200;

/// The decimal `1 − value` for a plain or scientific decimal in `[0, 1]`; None for anything else.
pub(crate) fn complement(value: &str) -> Option<String> {
    let value = value.strip_prefix('+').unwrap_or(value);
    let (mantissa, exponent) = match value.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
        None => (value, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = whole.bytes().chain(fraction.bytes());
    let digits: Vec<u8> = digits
        .map(|byte| byte.is_ascii_digit().then(|| byte - b'0'))
        .collect::<Option<_>>()?;
    if digits.is_empty() {
        return None;
    }
    let first = digits.iter().position(|digit| *digit > 0);
    let Some(first) = first else {
        return Some("1".to_owned());
    };
    // the value is 0.d₁d₂d₃… · 10^point with d₁ > 0
    let leading = i64::try_from(whole.len()).ok()? - i64::try_from(first).ok()?;
    let point = leading.checked_add(exponent)?;
    let significant = &digits[first..];
    if point > 0 {
        let is_one = point == 1 && significant[0] == 1 && significant[1..].iter().all(|d| *d == 0);
        return is_one.then(|| "0".to_owned());
    }
    if point < -MOST_DIGITS {
        return Some("1".to_owned());
    }
    let zeros = usize::try_from(-point).ok()?;
    let mut left: Vec<u8> = std::iter::repeat_n(0, zeros)
        .chain(significant.iter().copied())
        .collect();
    while left.last() == Some(&0) {
        left.pop();
    }
    // nines' complement, and one more in the last place
    let last = left.len() - 1;
    for (place, digit) in left.iter_mut().enumerate() {
        *digit = if place == last { 10 } else { 9 } - *digit;
    }
    let text = left.iter().map(|digit| char::from(b'0' + digit));
    Some("0.".chars().chain(text).collect())
}
