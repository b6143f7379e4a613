//! The digamma function.

use infoscene::numeric::digamma;
use std::f64::consts::LN_2;

/// `ψ(n) = −γ + Σ_{k<n} 1/k`, with γ to 16 digits (OEIS A001620), and `ψ(½) = −γ − 2 ln 2`.
#[test]
fn digamma_agrees_with_harmonic_numbers() {
    let gamma: f64 = 0.577_215_664_901_532_9;
    let mut harmonic: f64 = 0.0;
    for n in 1..2000 {
        let x = f64::from(n);
        let expected = harmonic - gamma;
        let allowed = 16.0 * f64::EPSILON * (1.0 + expected.abs());
        assert!((digamma(x) - expected).abs() <= allowed, "{n}");
        harmonic += 1.0 / x;
    }
    let expected = -gamma - 2.0 * LN_2;
    // rounding of some ten terms of order one
    assert!((digamma(0.5) - expected).abs() <= 64.0 * f64::EPSILON);
}
