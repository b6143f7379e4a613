//! The functions that every entropy is a sum of.
//!
//! ```text
//!   x_ln_x(x)         = x ln |x|,               0 log 0 = 0
//!   x_log2_x(x)       = x log2 x,               0 log 0 = 0
//!   x_log2_ratio(x,y) = x log2 (x/y),           0 where x = 0
//!   φ(x)              = (1+x) ln(1+x) − x       ≥ 0, = 0 only at x = 0
//! ```
//!
//! φ turns a relative entropy into a sum of non-negative terms: with shares
//! `p_k`, `a_k` that both sum to one and `x_k = p_k/a_k − 1`,
//! `Σ p_k ln(p_k/a_k) = Σ a_k φ(x_k)`, because `Σ a_k x_k = 0`.
//!
//! **Not covered**: negative arguments; the callers' constructors refuse them.

use super::elementary::{ln, ln_1p, log2};

/// `x·ln|x|`, continued by 0 at `x = 0`.
///
/// **Accuracy** `f64`: two roundings and the error of [`ln`].
#[must_use]
pub fn x_ln_x(x: f64) -> f64 {
    if x == 0.0 { x } else { x * ln(x.abs()) }
}

/// `x·log2 x` with `0·log2 0 = 0`, in bits.
///
/// **Arguments** `x` ≥ 0.
/// **Accuracy** `f64`: two roundings and the error of [`log2`].
#[must_use]
pub fn x_log2_x(x: f64) -> f64 {
    if x > 0.0 { x * log2(x) } else { 0.0 * x }
}

/// `x·log2(x/y)` with the value 0 at `x = 0`, in bits.
///
/// **Arguments** `x` ≥ 0, and `y` > 0 wherever `x` > 0.
#[must_use]
pub fn x_log2_ratio(x: f64, y: f64) -> f64 {
    if x <= 0.0 {
        return 0.0 * x;
    }
    let ratio = x / y;
    // a quotient that leaves the normal range has lost its digits
    x * if ratio.is_normal() {
        log2(ratio)
    } else {
        log2(x) - log2(y)
    }
}

/// Below this |x| the plain form of φ loses more than three bits.
const SERIES_RADIUS: f64 = 0.25;

/// `φ(x) = (1+x)·ln(1+x) − x`, to full relative precision.
///
/// ```text
///   z = x/(2+x):  φ = 2 [ z² + (1+z)(atanh z − z) ] / (1 − z),
///                 atanh z − z = z³ (1/3 + z²/5 + z⁴/7 + …)
/// ```
///
/// **Arguments** `x` ≥ −1.
/// **Returns** a number ≥ 0; 1 at `x = −1`.
/// **Accuracy** `f64`: relative error ≤ [`tolerance::DIVERGENCE_KERNEL`], measured against
/// 256 bits by `divergence_kernel_keeps_its_digits` down to |x| = 1e-300 squared underflow.
///
/// [`tolerance::DIVERGENCE_KERNEL`]: crate::numeric::tolerance::DIVERGENCE_KERNEL
///
/// # Examples
/// ```
/// use infoscene::numeric::divergence_kernel;
/// assert_eq!(divergence_kernel(-1.0), 1.0);
/// assert_eq!(divergence_kernel(0.0), 0.0);
/// // x = 1e-10: x²/2 to ten digits, where the plain form has none left.
/// assert!((divergence_kernel(1e-10) / 0.5e-20 - 1.0).abs() < 1e-9);
/// ```
#[must_use]
pub fn divergence_kernel(x: f64) -> f64 {
    if x.abs() >= SERIES_RADIUS {
        if x > -1.0 {
            return (1.0 + x) * ln_1p(x) - x;
        }
        return -x; // (1+x)·ln(1+x) = 0 at x = −1
    }
    let z = x / (2.0 + x); // |z| ≤ 1/7: ten terms reach 7⁻²⁰ < 2e-17
    let z2 = z * z;
    let tail = (0..10).rev().fold(0.0, |sum, k: i32| {
        sum * z2 + 1.0 / f64::from(2 * k + 3) // 1/3, 1/5, …
    });
    2.0 * z2 * (1.0 + (1.0 + z) * z * tail) / (1.0 - z)
}
