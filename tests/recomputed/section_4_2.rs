//! Every row of section_4_2.csv, by golden-section search.
//!
//! Two one-variable problems for the powers n: the objective of section 4.2 is maximised, as
//! printed and with the weight exponent 2n + 1, and the mean square error of two pieces minimised,
//! neither by way of a derivative; then what either becomes as n grows, l = 1 − x/n. A search finds
//! the place to half the working digits, here 40.

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
    let same = ["l", "1ml", "f_bits"];
    let same = same.map(|kind| [1, 2, 3, 4].map(|n| format!("mi42same_n{n}_{kind}")));
    let limits = ["mi", "same", "mse"].map(|kind| format!("limit42_{kind}"));
    let all = kinds.flat_map(of).chain(same.into_iter().flatten());
    all.chain(limits).collect()
}

/// The objective with G = l^(n+1), W = l^(n+1+m): G log2(G/W) + (1 − G) log2((1 − G)/(1 − W)); m =
/// 1 is printed.
fn objective(n: usize, m: usize, l: &Real) -> Real {
    let one = Real::int(1);
    let flux = l.powi(n + 1);
    let rest = &one - &flux;
    let ratio = &rest / (&one - &flux * l.powi(m));
    rest * ratio.log2() - flux * l.powi(m).log2()
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
fn searching_the_printed_objective_reproduces_its_optima() {
    for n in POWERS {
        let place = maximum(|l| objective(n, 1, l));
        let ids = ["l", "1ml", "f_bits"].map(|kind| format!("mi42_n{n}_{kind}"));
        assert_rows(&place, &objective(n, 1, &place), ids);
    }
}

/// The minimiser l and the minimum of ∫₀¹ (xⁿ − two-piece mean)² dx:
/// section_4_2.csv, rows `mse42_*`.
#[test]
fn searching_the_mean_square_error_reproduces_its_optima() {
    for n in POWERS {
        let place = maximum(|l| -mean_square_error(n, l));
        let ids = ["l", "1ml", "mse"].map(|kind| format!("mse42_n{n}_{kind}"));
        assert_rows(&place, &mean_square_error(n, &place), ids);
    }
}

/// The cuts with the weight exponent 2n + 1: section_4_2.csv, rows `mi42same_*`.
#[test]
fn searching_the_objective_under_the_hypotheses_reproduces_its_optima() {
    for n in 1..=4 {
        let place = maximum(|l| objective(n, n, l));
        let ids = ["l", "1ml", "f_bits"].map(|kind| format!("mi42same_n{n}_{kind}"));
        assert_rows(&place, &objective(n, n, &place), ids);
    }
}

/// The limits of the objectives for n → ∞ at l = 1 − x/n, radiosity e^−u at u = n (1 − position):
/// section_4_2.csv, rows `limit42_*`.
///
/// * printed: weights differ from fluxes by a factor 1 − u/n, so that the gain goes as the variance
///   of u between the two parts, weighted by flux: p₁ m₁² + p₂ m₂² with p₁ = 1 − e^−x, m₂ = x + 1,
///   p₁ m₁ + p₂ m₂ = 1;
/// * weight exponent 2n + 1: G = e^−x, W = e^−2x;
/// * mean square: on an endless patch the explained part is (1 − e^−x)²/x.
#[test]
fn searching_the_limiting_objectives_reproduces_their_optima() {
    let one = || Real::int(1);
    let between = |x: &Real| {
        let far = (-x).exp();
        let mean = x + one();
        let near = one() - &far * &mean;
        near.squared() / (one() - &far) + far * mean.squared()
    };
    let gain = |x: &Real| {
        let flux = (-x).exp();
        let rest = one() - &flux;
        let ratio = &rest / (one() - flux.squared());
        rest * ratio.ln() - &flux * flux.ln()
    };
    let explained = |x: &Real| (one() - (-x).exp()).squared() / x;
    let search = |f: &dyn Fn(&Real) -> Real| golden_section(Real::int(1), Real::int(2), f);
    for (kind, place) in [
        ("mi", search(&between)),
        ("same", search(&gain)),
        ("mse", search(&explained)),
    ] {
        let id = format!("limit42_{kind}");
        let value = &row("section_4_2", &id)["value"];
        assert_digits(&id, value, Digits::Printed, &place);
    }
}
