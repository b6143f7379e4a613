//! The dilogarithm `Li₂(z) = −∫₀^z ln(1 − t)/t dt`, where integrals of logarithms over polygons
//! need it.
//!
//! ```text
//!   Li₂(z) = u − u²/4 + Σ_k B_2k u^(2k+1)/(2k+1)!,     u = −ln(1 − z),  |u| < 2π
//!   Li₂(z) = π²/6 − ln z · ln(1 − z) − Li₂(1 − z)
//!   ∫₀^t ln(1 + 2q cos 2s + q²) ds = −Im Li₂(−q e^(2it)),     0 ≤ q ≤ 1,  |t| ≤ π/2
//! ```
//!
//! The reflection is taken where the real part of z is above ½; then |u| < 1.05 (0.7 for real z),
//! and the terms of the series shrink by 36 each.
//!
//! **Not covered**: |z| > 1.
//!
//! Reference: Lewin, *Polylogarithms and Associated Functions*, 1981, §1.3, §4.1, §5.1.

use super::elementary::{angle, ln, ln_1p};
use std::f64::consts::PI;

/// `B_2k/(2k + 1)!` for k = 1, 2, …; the next would be 1e-18.
const COEFFICIENTS: [f64; 9] = [
    1.0 / 36.0,
    -1.0 / 3_600.0,
    1.0 / 211_680.0,
    -1.0 / 10_886_400.0,
    1.0 / 526_901_760.0,
    -691.0 / 16_999_766_784_000.0,
    1.0 / 1_120_863_744_000.0,
    -3617.0 / 181_400_588_328_960_000.0,
    43867.0 / 97_072_790_126_247_936_000.0,
];

/// `Li₂(1 − y)` for `y` in `[0, 1]`; what is outside is taken to the nearer end.
///
/// **Returns** a number from `π²/6` (y = 0) down to 0 (y = 1).
/// **Accuracy** a few ε absolutely, measured by `dilogarithms_agree_with_their_series`.
///
/// # Examples
/// ```
/// use infoscene::numeric::dilogarithm_of_complement;
/// let half = std::f64::consts::PI.powi(2) / 12.0 - 0.5 * std::f64::consts::LN_2.powi(2);
/// assert!((dilogarithm_of_complement(0.5) - half).abs() < 1e-15);
/// ```
#[must_use]
pub fn dilogarithm_of_complement(y: f64) -> f64 {
    if y >= 0.5 {
        real_series(-ln(y.min(1.0)))
    } else {
        PI * PI / 6.0 - dilogarithm_deficit(y)
    }
}

/// `π²/6 − Li₂(1 − y)` for `y` in `[0, 1]`; what is outside is taken to the nearer end.
///
/// **Returns** a number from 0 (y = 0), where it falls like `y (1 − ln y)`, up to `π²/6` (y = 1).
/// **Accuracy** a few ε of itself, measured by `dilogarithms_agree_with_their_series`.
#[must_use]
pub fn dilogarithm_deficit(y: f64) -> f64 {
    if y >= 0.5 {
        PI * PI / 6.0 - dilogarithm_of_complement(y)
    } else if y > 0.0 {
        let rest = ln_1p(-y);
        rest * ln(y) + real_series(-rest)
    } else {
        0.0
    }
}

/// `Im Li₂(−q e^(2it))`: minus the integral of `ln(1 + 2q cos 2s + q²)` from 0 to t.
///
/// **Arguments** `complement` = 1 − q, in `[0, 1]`; the cosine ≥ 0 and the sine of t.
/// **Returns** a number within ±1.015 (Clausen's integral at π/3).
/// **Accuracy** a few ε absolutely, measured by `dilogarithms_agree_with_their_series`.
#[must_use]
pub fn imaginary_dilogarithm(complement: f64, [cosine, sine]: [f64; 2]) -> f64 {
    let q = 1.0 - complement;
    // z = −q e^(2it) and 1 − z, the latter without cancellation near z = 1
    let imaginary = 2.0 * q * sine * cosine;
    let z = [q * (sine - cosine) * (sine + cosine), -imaginary];
    let other = [complement + 2.0 * q * cosine * cosine, imaginary];
    let logarithm = |[re, im]: [f64; 2]| [0.5 * ln(re * re + im * im), angle(im, re)];
    if z[0] <= 0.5 {
        let [re, im] = logarithm(other);
        imaginary_series([-re, -im])
    } else if other[0] * other[0] + other[1] * other[1] > 0.0 {
        let (a, b) = (logarithm(z), logarithm(other));
        // the series of 1 − z has u = −ln z
        -(a[0] * b[1] + a[1] * b[0]) - imaginary_series([-a[0], -a[1]])
    } else {
        0.0
    }
}

/// The series at a real u.
fn real_series(u: f64) -> f64 {
    let square = u * u;
    let tail = COEFFICIENTS.iter().rev().fold(0.0, |s, c| s * square + c);
    u - 0.25 * square + u * square * tail
}

/// The imaginary part of the series at a complex u.
fn imaginary_series([re, im]: [f64; 2]) -> f64 {
    let square = [re * re - im * im, 2.0 * re * im];
    let times = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a * c - b * d, a * d + b * c];
    let tail = COEFFICIENTS.iter().rev().fold([0.0, 0.0], |sum, c| {
        let [a, b] = times(sum, square);
        [a + c, b]
    });
    im - 0.25 * square[1] + times([re, im], times(square, tail))[1]
}
