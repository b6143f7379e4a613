//! The cuts of §4.2 for growing exponents n: `n (1 − l)` tends to its limit, and misses it by a
//! multiple of 1/n.

use infoscene::discretize::{GradientCut, GradientLimit};
use infoscene::numeric::{Interval, Scalar};
use infoscene::study::cuts::limits::gradient_limits;

/// The third term: `n (n (1 − l) − limit) − rate` is 6.2/n, 3.2/n and 2.5/n in 60-digit arithmetic
/// at n = 1e3, and falls as 1/n.
const THIRD: f64 = 7.0;

/// All three cuts from n = 10 to 1e12, each difference enclosed.
#[test]
fn scaled_cuts_approach_their_limits_at_the_derived_rate() {
    let rows = gradient_limits().unwrap();
    assert_eq!(rows.len(), 39);
    for row in rows.iter().filter(|row| row.exponent >= 10.0) {
        let left = row.scaled_difference.clone() - &row.limits.rate;
        let bound = left.constant(THIRD / row.exponent);
        assert!(left.abs() < bound, "{:?} {}", row.cut, row.exponent);
        assert!(left.width() < 1e-40, "{:e}", left.width());
    }
}

/// The control: against another's limit the difference times n grows without end.
#[test]
fn scaled_cuts_do_not_approach_another_limit() {
    let limit = |cut: GradientLimit| cut.enclosed(128).unwrap().limit.to_f64();
    let [fixed, same, square] = GradientLimit::ALL.map(limit);
    assert!(fixed - same > 0.2 && same - square > 0.1);
    let cut = GradientCut::try_new(1e9, 1e9).unwrap();
    let scaled = 1e9 * cut.mutual_information_cut().unwrap().complement;
    for other in [fixed, square] {
        assert!(1e9 * (scaled - other).abs() > 1e8);
    }
}

/// The product pτ depends on m/p alone: 2 (n + 1) and 2 m have the same −(n + 1) ln l.
#[test]
fn position_depends_on_the_ratio_of_the_exponents() {
    let scaled = |n: f64, m: f64| {
        let cut = GradientCut::try_new(n, m).unwrap();
        let cut = cut.certified_mutual_information_cut(192).unwrap();
        let p = cut.position.constant(n + 1.0);
        -(cut.position.ln() * &p)
    };
    for (n, m) in [(1.0, 1.0), (3.0, 0.5), (7.0, 40.0)] {
        let difference: Interval = scaled(n, m) - &scaled(2.0 * n + 1.0, 2.0 * m);
        assert!(difference.contains_zero() && difference.width() < 1e-50);
        // the control: another ratio, another place
        assert!(!(scaled(n, m) - &scaled(2.0 * n + 1.0, m)).contains_zero());
    }
}

/// The limit with m = n is `ln(eˣ − 1)`, x the one with fixed m.
#[test]
fn limits_are_related() {
    let [fixed, same] = [
        GradientLimit::FixedIrradiance,
        GradientLimit::EqualExponents,
    ]
    .map(|cut| cut.enclosed(192).unwrap().limit);
    let difference = fixed.exp_m1().ln() - &same;
    assert!(difference.contains_zero() && difference.width() < 1e-50);
}

/// Both cuts tend to e^−x as n falls to 0 with m = n, x the limit with fixed m: at n = 1e-6 within
/// some n.
#[test]
fn cuts_meet_where_radiosity_is_a_logarithm() {
    let x = GradientLimit::FixedIrradiance.enclosed(128).unwrap().limit;
    let meeting = (-x).exp().to_f64();
    for n in [1e-3, 1e-6] {
        let cut = GradientCut::try_new(n, n).unwrap();
        for cut in [cut.mutual_information_cut(), cut.mean_square_cut()] {
            let left = (cut.unwrap().position - meeting).abs();
            assert!(left > 0.1 * n && left < n, "{n}: {left:e}");
        }
        // the control: with m = 1 the cut goes elsewhere
        let printed = GradientCut::try_new(n, 1.0).unwrap();
        assert!(printed.mutual_information_cut().unwrap().position > meeting + 0.05);
    }
}
