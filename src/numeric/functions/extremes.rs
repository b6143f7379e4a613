//! Largest and smallest numbers that pass NaN on: a computation that went wrong must be seen.
//!
//! `f64::max` returns the other number where one is NaN, so that a maximum over results hides a
//! failure. These return NaN.

/// The larger of two numbers; NaN if either is.
#[must_use]
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.max(b)
    }
}

/// The smaller of two numbers; NaN if either is.
#[must_use]
pub fn smaller(a: f64, b: f64) -> f64 {
    -larger(-a, -b)
}

/// The largest of some numbers ≥ 0: 0 for none, NaN if one of them is.
#[must_use]
pub fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, larger)
}
