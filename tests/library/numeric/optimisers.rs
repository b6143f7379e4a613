//! Roots, maxima and integrals keep their promises, and refuse what the crates behind them accept.

use infoscene::numeric::{
    Expansion, NumericError, compensated_sum, integral, maximum, maximum_of_many, root,
};
use proptest::prelude::*;

proptest! {
    /// The root of a cubic with one known root, to two units in the last place.
    #[test]
    fn roots_are_found_to_full_precision(position in 0.01..0.99f64, slope in 0.1..10.0f64) {
        let found = root(|x| slope * (x - position) * (1.0 + x * x), 0.0, 1.0).unwrap();
        prop_assert!((found.position - position).abs() <= 4.0 * f64::EPSILON * position);
    }

    /// A sum of numbers and their opposites is exact.
    #[test]
    fn expansions_sum_exactly(
        mut terms in proptest::collection::vec(-1e30..1e30f64, 1..20),
        rest in -1.0..1.0f64,
    ) {
        let opposite: Vec<f64> = terms.iter().map(|x| -x).collect();
        terms.push(rest);
        terms.extend(opposite);
        prop_assert_eq!(Expansion::sum(terms).to_f64(), rest);
    }
}

/// `argmin` alone returns "converged" for a function that is NaN everywhere, and for two ends of
/// equal sign whose product underflows.
#[test]
fn roots_of_nothing_are_refused() {
    let nan = root(|_| f64::NAN, 0.0, 1.0);
    assert!(
        matches!(nan, Err(NumericError::NotFinite { .. })),
        "{nan:?}"
    );
    let tiny = root(|x| 1e-300 * (1.0 + x), 0.0, 1.0);
    assert!(
        matches!(tiny, Err(NumericError::NoSignChange { .. })),
        "{tiny:?}"
    );
    let inside = root(
        |x| {
            if x > 0.4 && x < 0.6 {
                f64::NAN
            } else {
                x - 0.5
            }
        },
        0.0,
        1.0,
    );
    assert!(
        matches!(inside, Err(NumericError::NotFinite { .. })),
        "{inside:?}"
    );
    for (lower, upper) in [
        (1.0, 0.0),
        (0.0, 0.0),
        (f64::NAN, 1.0),
        (0.0, f64::INFINITY),
    ] {
        let empty = root(|x| x - 0.5, lower, upper);
        assert!(
            matches!(empty, Err(NumericError::EmptyInterval { .. })),
            "{empty:?}"
        );
    }
}

/// The ends themselves count, and a tiny function is as good as a large one.
#[test]
fn roots_at_the_ends_and_of_tiny_functions_are_found() {
    assert_eq!(root(|x| x, 0.0, 1.0).unwrap().position, 0.0);
    assert_eq!(root(|x| x - 1.0, 0.0, 1.0).unwrap().position, 1.0);
    let tiny = root(|x| 1e-300 * (x - 0.25), 0.0, 1.0).unwrap();
    assert!((tiny.position - 0.25).abs() <= f64::EPSILON);
}

/// The higher of two maxima is found, the left of equal ones, and none is a refusal.
#[test]
fn the_highest_maximum_is_found() {
    let wave = |height: f64| move |x: f64| (10.0 * x).sin() + height * x;
    let slope = |height: f64| move |x: f64| 10.0 * (10.0 * x).cos() + height;
    let found = maximum(wave(1.0), slope(1.0), (0.0, 1.0), 32).unwrap();
    let exact = ((-0.1f64).acos() + std::f64::consts::TAU) / 10.0;
    assert!((found.position - exact).abs() < 1e-15, "{found:?}");
    let left = maximum(wave(0.0), slope(0.0), (0.0, 1.0), 32).unwrap();
    assert!((left.position - std::f64::consts::FRAC_PI_2 / 10.0).abs() < 1e-15);
    let none = maximum(|x| x, |_| 1.0, (0.0, 1.0), 32);
    assert!(matches!(none, Err(NumericError::NoInteriorMaximum { .. })));
}

/// A maximum in two coordinates: `−(x−0.3)² − (y−0.6)² − (x−0.3)(y−0.6)`.
#[test]
fn maxima_in_two_coordinates_are_found() {
    let gradient = |t: &[f64]| {
        let (x, y) = (t[0] - 0.3, t[1] - 0.6);
        vec![-2.0 * x - y, -2.0 * y - x]
    };
    let found = maximum_of_many(gradient, vec![0.1, 0.9]).unwrap();
    assert!(
        (found[0] - 0.3).abs() < 1e-14 && (found[1] - 0.6).abs() < 1e-14,
        "{found:?}"
    );
    let nan = maximum_of_many(|_| vec![f64::NAN], vec![0.5]);
    assert!(matches!(nan, Err(NumericError::NotFinite { .. })));
    let saddle = maximum_of_many(|t| vec![t[0] - 0.5], vec![0.4]);
    assert!(
        matches!(saddle, Err(NumericError::NotConverged { .. })),
        "{saddle:?}"
    );
}

/// `|result − exact| ≤ tolerance` for every tolerance that the rule can be asked for.
#[test]
fn integrals_keep_their_tolerance() {
    for exponent in 2..=12 {
        let tolerance = 10f64.powi(-exponent);
        let smooth = integral(f64::exp, (0.0, 1.0), tolerance).unwrap();
        assert!((smooth.value - 1f64.exp_m1()).abs() <= tolerance);
        let singular = integral(f64::ln, (0.0, 1.0), tolerance).unwrap();
        assert!((singular.value + 1.0).abs() <= tolerance);
    }
}

/// The crate behind turns NaN into 0 and stops without a word; here both are refused.
#[test]
fn integrals_of_nothing_are_refused() {
    let nan = integral(|x| if x > 0.5 { f64::NAN } else { 1.0 }, (0.0, 1.0), 1e-6);
    assert!(
        matches!(nan, Err(NumericError::NotFinite { .. })),
        "{nan:?}"
    );
    let wild = integral(|x| (1e4 * x).sin(), (0.0, 1.0), 1e-9);
    assert!(
        matches!(wild, Err(NumericError::NotConverged { .. })),
        "{wild:?}"
    );
}

/// A sum that loses its last bits term by term, and compensated does not.
#[test]
fn compensated_sums_do_not_drift() {
    let terms = || std::iter::once(1.0).chain(std::iter::repeat_n(1e-16, 10_000));
    assert_eq!(terms().sum::<f64>(), 1.0);
    approx::assert_ulps_eq!(
        compensated_sum(terms()),
        1.0 + 1e-12,
        epsilon = 0.0,
        max_ulps = 1
    );
}
