//! The dilogarithm against its series and known constants.

use infoscene::numeric::{dilogarithm_deficit, dilogarithm_of_complement, imaginary_dilogarithm};
use std::f64::consts::PI;

/// `Li₂(z) = Σ z^k/k²`, slow and plain; with 900 terms right to 1e-18 for |z| ≤ 0.96.
#[test]
fn dilogarithms_agree_with_their_series() {
    let mut worst: f64 = 0.0;
    for step in 1..25 {
        let q = f64::from(step) / 25.0;
        let real: f64 = (1..900).rev().map(|k| q.powi(k) / f64::from(k * k)).sum();
        worst = worst.max((dilogarithm_of_complement(1.0 - q) - real).abs());
        worst = worst.max((dilogarithm_deficit(1.0 - q) - (PI * PI / 6.0 - real)).abs());
        for turn in -20..=20 {
            let t = f64::from(turn) * PI / 40.0;
            let term = |k: i32| {
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                sign * q.powi(k) * (2.0 * f64::from(k) * t).sin() / f64::from(k * k)
            };
            let expected: f64 = (1..900).rev().map(term).sum();
            let found = imaginary_dilogarithm(1.0 - q, [t.cos(), t.sin()]);
            worst = worst.max((found - expected).abs());
        }
    }
    assert!(worst < 8.0 * f64::EPSILON, "{worst:e}");
}

/// Catalan's constant `Im Li₂(i)` and Clausen's integral at π/3, to 16 digits (OEIS A006752,
/// A143298).
#[test]
fn dilogarithms_on_the_unit_circle_are_known_constants() {
    let half = 0.5f64.sqrt();
    let catalan = -imaginary_dilogarithm(0.0, [half, half]);
    assert!((catalan - 0.915_965_594_177_219).abs() < 4.0 * f64::EPSILON);
    // −e^(2it) = e^(iπ/3) at t = −π/3
    let maximum = imaginary_dilogarithm(0.0, [0.5, -0.75f64.sqrt()]);
    assert!((maximum - 1.014_941_606_409_653_6).abs() < 4.0 * f64::EPSILON);
    for (y, value) in [(0.0, PI * PI / 6.0), (1.0, 0.0), (-0.1, PI * PI / 6.0)] {
        assert!((dilogarithm_of_complement(y) - value).abs() < f64::EPSILON);
    }
}

/// `π²/6 − Li₂(1 − y) = y (1 − ln y) + y² (¼ − ½ ln y) + …`, to a few ε of itself however small.
#[test]
fn deficits_of_small_numbers_keep_their_digits() {
    for exponent in 6..300 {
        let y = 10f64.powi(-exponent);
        let expected = y * (1.0 - y.ln()) + y * y * (0.25 - 0.5 * y.ln());
        let off = (dilogarithm_deficit(y) / expected - 1.0).abs();
        assert!(off < 4.0 * f64::EPSILON + y * y, "{y:e}: {off:e}");
    }
    assert_eq!(
        [dilogarithm_deficit(0.0), dilogarithm_deficit(-0.1)],
        [0.0, 0.0]
    );
}
