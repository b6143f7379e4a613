//! The digamma function ψ at positive arguments.
//!
//! ```text
//!   ψ(x) = ψ(x + 1) − 1/x,    ψ(x) = ln x − 1/(2x) − Σ B_2k/(2k x^2k),    ψ(n) = −γ + Σ_{k<n} 1/k
//! ```
//!
//! **Not covered**: arguments ≤ 0.

use super::elementary::ln;

/// Smallest argument at which seven terms of the asymptotic series leave less than
/// 3617/(8160·16^16) = 3e-20.
const ASYMPTOTIC: f64 = 16.0;

/// `B_2k/2k`, k = 1 to 7.
const COEFFICIENTS: [f64; 7] = [
    1.0 / 12.0,
    -1.0 / 120.0,
    1.0 / 252.0,
    -1.0 / 240.0,
    1.0 / 132.0,
    -691.0 / 32_760.0,
    1.0 / 12.0,
];

/// `ψ(x)`.
///
/// **Arguments** `x` > 0.
/// **Accuracy** absolute error below 16 ε (1 + |ψ|), held by
/// `digamma_agrees_with_harmonic_numbers`.
///
/// # Examples
/// ```
/// use infoscene::numeric::digamma;
/// // −γ, OEIS A001620
/// assert!((digamma(1.0) + 0.577_215_664_901_532_9).abs() < 1e-15);
/// ```
#[must_use]
pub fn digamma(x: f64) -> f64 {
    let (mut x, mut shift) = (x, 0.0);
    while x < ASYMPTOTIC {
        shift += x.recip();
        x += 1.0;
    }
    let square = (x * x).recip();
    let series = COEFFICIENTS.iter().rev();
    let series = series.fold(0.0, |sum, coefficient| (sum + coefficient) * square);
    ln(x) - 0.5 / x - series - shift
}
