//! Every row of section_4_2.csv, by golden-section search.
//!
//! Two one-variable problems for the powers n: the printed objective of section 4.2
//! is maximised and the mean square error of two pieces minimised, neither by way of
//! a derivative. A search finds the place to half the working digits, here 40.

use crate::maximum::golden_section;
use crate::precision::Real;
use crate::reference::{Digits, assert_digits, row};

/// The powers n of the rows.
const POWERS: [usize; 6] = [1, 2, 3, 4, 8, 64];

/// The rows recomputed here.
pub fn ids() -> Vec<String> {
    let kinds = ["mi42_n*_l", "mi42_n*_1ml", "mi42_n*_f_bits"];
    let kinds = kinds
        .into_iter()
        .chain(["mse42_n*_l", "mse42_n*_1ml", "mse42_n*_mse"]);
    let of = |kind: &str| POWERS.map(|n| kind.replace('*', &n.to_string()));
    kinds.flat_map(of).collect()
}

/// l^(n+1) log2(1/l) + (1 − l^(n+1)) log2((1 − l^(n+1))/(1 − l^(n+2))).
fn objective(n: usize, l: &Real) -> Real {
    let one = Real::int(1);
    let power = l.powi(n + 1);
    let rest = &one - &power;
    let ratio = &rest / (&one - &power * l);
    rest * ratio.log2() - power * l.log2()
}

/// ∫₀¹ (xⁿ − m(x))² dx, where m is the mean of xⁿ over `[0, l]` and over `[l, 1]`:
/// by ∫ x²ⁿ = 1/(2n + 1) less the squared means times the lengths.
fn mean_square_error(n: usize, l: &Real) -> Real {
    let one = Real::int(1);
    let order = i32::try_from(n).unwrap();
    let primitive = |x: &Real| x.powi(n + 1) / Real::int(order + 1);
    let lower = primitive(l);
    let upper = primitive(&one) - &lower;
    let length = &one - l;
    Real::ratio(1, 2 * order + 1) - lower.squared() / l - upper.squared() / length
}

/// The maximum of `f` on (0, 1), searched around the best of 127 equidistant points.
fn maximum(f: impl Fn(&Real) -> Real) -> Real {
    let point = |k: i32| Real::ratio(k, 128);
    let values: Vec<Real> = (1..128).map(|k| f(&point(k))).collect();
    let pairs = (1..128).zip(&values);
    let (best, _) = pairs.max_by(|a, b| a.1.partial_cmp(b.1).unwrap()).unwrap();
    golden_section(point(best - 1), point(best + 1), f)
}

/// Compares the place of the optimum, its complement and the value with their rows.
fn assert_rows(place: &Real, value: &Real, ids: [String; 3]) {
    let complement = Real::int(1) - place;
    for (id, number) in ids.iter().zip([place, &complement, value]) {
        assert_digits(
            id,
            &row("section_4_2", id)["value"],
            Digits::Printed,
            number,
        );
    }
}

/// The maximiser l and the maximum of
/// l^(n+1) log2(1/l) + (1 − l^(n+1)) log2((1 − l^(n+1))/(1 − l^(n+2))):
/// section_4_2.csv, rows `mi42_*`.
#[test]
#[ignore = "recomputes half of section_4_2.csv in less than 1 s: cargo test --release --test recomputed -- --ignored"]
fn searching_the_printed_objective_reproduces_its_optima() {
    for n in POWERS {
        let place = maximum(|l| objective(n, l));
        let ids = ["l", "1ml", "f_bits"].map(|kind| format!("mi42_n{n}_{kind}"));
        assert_rows(&place, &objective(n, &place), ids);
    }
}

/// The minimiser l and the minimum of ∫₀¹ (xⁿ − two-piece mean)² dx:
/// section_4_2.csv, rows `mse42_*`.
#[test]
#[ignore = "recomputes half of section_4_2.csv in less than 1 s: cargo test --release --test recomputed -- --ignored"]
fn searching_the_mean_square_error_reproduces_its_optima() {
    for n in POWERS {
        let place = maximum(|l| -mean_square_error(n, l));
        let ids = ["l", "1ml", "mse"].map(|kind| format!("mse42_n{n}_{kind}"));
        assert_rows(&place, &mean_square_error(n, &place), ids);
    }
}
