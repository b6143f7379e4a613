//! The cuts of §4.2 against 28-digit values, and against 256-bit roots for other exponents.

use crate::support::high_precision::HighPrecision;
use crate::support::references::{rows, value};
use infoscene::discretize::{Cut, GradientCut};
use infoscene::numeric::{Scalar, tolerance};

/// Relative error of a complement, the crate's promise up to exponents of 1e6.
const COMPLEMENT: f64 = 1e-12;

fn row(n: u32, quantity: &str) -> f64 {
    let prefix = if quantity.starts_with("mse") {
        "mse42"
    } else {
        "mi42"
    };
    let suffix = quantity.rsplit(' ').next().unwrap();
    value("section_4_2.csv", &format!("{prefix}_n{n}_{suffix}"))
}

/// Cuts for n = 1, 2, 3, 4, 8, 64: the printed reading, m = 1.
#[test]
fn printed_cuts_agree_with_28_digits() {
    assert_eq!(rows("section_4_2.csv").len(), 51);
    for n in [1, 2, 3, 4, 8, 64] {
        let cut = GradientCut::try_new(n.into(), 1.0).unwrap();
        let information = cut.mutual_information_cut().unwrap();
        let square = cut.mean_square_cut().unwrap();
        assert!((information.position - row(n, "mi l")).abs() <= tolerance::POSITION);
        assert!((information.complement / row(n, "mi 1ml") - 1.0).abs() <= COMPLEMENT);
        assert!((information.value / row(n, "mi f_bits") - 1.0).abs() <= tolerance::GAIN);
        assert!((square.position - row(n, "mse l")).abs() <= tolerance::POSITION);
        assert!((square.complement / row(n, "mse 1ml") - 1.0).abs() <= COMPLEMENT);
        assert!((square.value / row(n, "mse mse") - 1.0).abs() <= tolerance::GAIN);
    }
}

/// Cuts for n = 1, 2, 3, 4 under the section's own hypotheses, m = n: 0.4828, 0.6224, 0.7034,
/// 0.7560.
#[test]
fn cuts_under_the_hypotheses_agree_with_30_digits() {
    for n in 1..=4 {
        let cut = GradientCut::try_new(n.into(), n.into()).unwrap();
        let cut = cut.mutual_information_cut().unwrap();
        let row = |quantity| value("section_4_2.csv", &format!("mi42same_n{n}_{quantity}"));
        assert!((cut.position - row("l")).abs() <= tolerance::POSITION);
        assert!((cut.complement / row("1ml") - 1.0).abs() <= COMPLEMENT);
        assert!((cut.value / row("f_bits") - 1.0).abs() <= tolerance::GAIN);
    }
}

/// The root of a function that falls from plus to minus, by bisection to 2⁻²⁰⁰.
fn bisect(f: impl Fn(&HighPrecision) -> HighPrecision, lower: f64, upper: f64) -> HighPrecision {
    let zero = HighPrecision::new(0.0);
    let (mut lower, mut upper) = (HighPrecision::new(lower), HighPrecision::new(upper));
    assert!(f(&lower) > zero && f(&upper) < zero, "no change of sign");
    for _ in 0..210 {
        let middle = (lower.clone() + &upper) / HighPrecision::new(2.0);
        if f(&middle) > zero {
            lower = middle
        } else {
            upper = middle
        }
    }
    lower
}

/// `dJ/dτ` of the printed objective with general exponents, at 256 bits and written out plainly:
/// with G = e^−pτ, W = e^−(p+m)τ it is `−p G ln(a/b) + (p+m) W (a − b)`.
fn plain_derivative(p: f64, m: f64, tau: &HighPrecision) -> HighPrecision {
    let number = HighPrecision::new;
    let g = (-(tau.clone() * &number(p))).exp();
    let w = (-(tau.clone() * &number(p) + &(tau.clone() * &number(m)))).exp();
    let one = number(1.0);
    let a = g.clone() / &w;
    let b = (one.clone() - &g) / &(one - &w);
    let weight_rate = (number(p) + &number(m)) * &w;
    weight_rate * &(a.clone() - &b) - &((a / b).ln() * &g * &number(p))
}

/// The objective itself, plainly: `G log2(G/W) + (1−G) log2((1−G)/(1−W))`.
fn plain_gain(p: f64, m: f64, tau: &HighPrecision) -> HighPrecision {
    let number = HighPrecision::new;
    let g = (-(tau.clone() * &number(p))).exp();
    let w = (-(tau.clone() * &number(p) + &(tau.clone() * &number(m)))).exp();
    let one = number(1.0);
    let (rest_g, rest_w) = (one.clone() - &g, one - &w);
    let near = (g.clone() / &w).ln() * &g;
    (near + &((rest_g.clone() / &rest_w).ln() * &rest_g)) / &number(2.0).ln()
}

/// Exponents from one end of the range to the other, printed (m = 1) and derived (m = n) reading:
/// position to 1e-14, complement to 1e-12 relative, gain to 1e-13 relative, against the 256-bit
/// root of the plain derivative.
#[test]
fn cuts_agree_with_their_references() {
    let small = [1e-6, 1e-3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0];
    let large = [10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e9, 1e12];
    for n in small.into_iter().chain(large) {
        for m in [1.0, n] {
            let cut = GradientCut::try_new(n, m)
                .unwrap()
                .mutual_information_cut()
                .unwrap();
            let scale = 1.0 / (n + 1.0);
            let tau = bisect(
                |tau| plain_derivative(n + 1.0, m, tau),
                0.1 * scale,
                3.0 * scale,
            );
            let gain = plain_gain(n + 1.0, m, &tau).to_f64();
            assert!(
                (cut.value / gain - 1.0).abs() <= tolerance::GAIN,
                "n {n} m {m}: {cut:?} {gain}"
            );
            assert_cut(&cut, &tau);
        }
    }
}

/// The mean-square condition `(2n+1) lⁿ − 2n lⁿ⁺¹ = 1`, and for the error that is
/// left, `1/(2n+1) − l m² − (1−l) m′²` with the two means.
#[test]
fn mean_square_cuts_agree_with_256_bits() {
    for n in [
        1e-6, 1e-3, 0.5, 0.7, 1.0, 1.5, 2.0, 10.0, 1e3, 1e6, 1e9, 1e12,
    ] {
        let cut = GradientCut::try_new(n, 1.0)
            .unwrap()
            .mean_square_cut()
            .unwrap();
        let [one, exponent] = [1.0, n].map(HighPrecision::new);
        let doubled = exponent.clone() + &exponent;
        let power = |tau: &HighPrecision| (-(tau.clone() * &exponent)).exp();
        let condition = |tau: &HighPrecision| {
            let l = (-tau.clone()).exp();
            (doubled.clone() + &one) * &power(tau) - &(doubled.clone() * &power(tau) * &l) - &one
        };
        let tau = bisect(condition, 0.01 / (n + 0.1), 10.0 / (n + 0.1));
        let l = (-tau.clone()).exp();
        let rest = one.clone() - &l;
        let near = power(&tau) / &(exponent.clone() + &one);
        let far = (one.clone() - &(power(&tau) * &l)) / &rest / &(exponent.clone() + &one);
        let explained = l * &near.square() + &(rest * &far.square());
        let error = (one.clone() / &(doubled.clone() + &one) - &explained).to_f64();
        assert!(
            (cut.value / error - 1.0).abs() <= tolerance::GAIN,
            "n {n}: {cut:?} {error:e}"
        );
        assert_cut(&cut, &tau);
    }
}

/// The position and its complement against `e^−τ` and `1 − e^−τ`.
fn assert_cut(cut: &Cut, tau: &HighPrecision) {
    let position = (-tau.clone()).exp().to_f64();
    let complement = -(-tau.clone()).exp_m1().to_f64();
    assert!(
        (cut.position - position).abs() <= tolerance::POSITION,
        "{cut:?} {position}"
    );
    assert!(
        (cut.complement / complement - 1.0).abs() <= COMPLEMENT,
        "{cut:?} {complement}"
    );
}
