//! Every row of splits.csv, by numerical gain curves.
//!
//! Values at a given place are evaluated there. An optimum is found from the curve
//! alone: the best of the places k/20, then Newton's method on numerical differences.

use crate::maximum::newton;
use crate::precision::Real;
use crate::quadrature::{COARSE, FINE};
use crate::reference::{Digits, assert_digits, row};
use crate::split_curves::Curve;

const PARALLEL: Curve = Curve::Parallel { depth: 1 };

/// Rows that state U at a place, in tenths.
const POINTS: [(&str, Curve, i32); 10] = [
    ("curve_perp_par_t2", PARALLEL, 2),
    ("curve_perp_par_t4", PARALLEL, 4),
    ("curve_perp_par_t6", PARALLEL, 6),
    ("curve_perp_par_t8", PARALLEL, 8),
    ("curve_perp_orth_t2", Curve::Orthogonal, 2),
    ("curve_perp_orth_t4", Curve::Orthogonal, 4),
    ("curve_three_t2", Curve::ThreeSquares, 2),
    ("curve_three_t4", Curve::ThreeSquares, 4),
    ("curve_three_t6", Curve::ThreeSquares, 6),
    ("curve_three_t8", Curve::ThreeSquares, 8),
];

/// Pairs of rows `…_t` and `…_U` that state an optimum, of rectangles at right angles.
/// The orthogonal curve has two mirrored maxima, of which the rows state the first.
const OPTIMA: [(&str, Curve); 4] = [
    ("split_perp_par_bothdepth1", PARALLEL),
    ("split_perp_orth_bothdepth1", Curve::Orthogonal),
    ("split_perp_par_splitdepth2", Curve::Parallel { depth: 2 }),
    ("three_squares", Curve::ThreeSquares),
];

/// The pair of rows that state the optimum of the inclined squares.
const INCLINED: (&str, Curve) = ("split_incl60_par", Curve::Inclined);

/// The row that states the form factor of the inclined squares.
const INCLINED_FORM_FACTOR: &str = "ff_incl_60_check";

/// The rows recomputed here.
pub fn ids() -> Vec<String> {
    let optima = OPTIMA.into_iter().chain([INCLINED]);
    let optima = optima.flat_map(|(prefix, _)| [format!("{prefix}_t"), format!("{prefix}_U")]);
    let points = POINTS.iter().map(|(id, _, _)| (*id).to_string());
    optima
        .chain(points)
        .chain([INCLINED_FORM_FACTOR.to_string()])
        .collect()
}

fn assert_value(id: &str, value: &Real) {
    assert_digits(id, &row("splits", id)["value"], Digits::Printed, value);
}

/// Recomputes the two rows of an optimum, at two levels of the quadrature.
fn assert_optimum((prefix, curve): (&str, Curve)) {
    let places = match curve {
        Curve::Orthogonal => 1..10,
        _ => 1..20,
    };
    let values = places.map(|k| {
        let place = Real::ratio(k, 20);
        let value = curve.gain(&place, &COARSE);
        (place, value)
    });
    let best = values
        .max_by(|a, b| a.1.partial_cmp(&b.1).unwrap())
        .unwrap();
    for level in [&COARSE, &FINE] {
        let place = newton(std::slice::from_ref(&best.0), |t| curve.gain(&t[0], level)).remove(0);
        let gain = curve.gain(&place, level);
        assert!(gain > best.1, "{prefix}: {gain} is not above {}", best.1);
        assert_value(&format!("{prefix}_t"), &place);
        assert_value(&format!("{prefix}_U"), &gain);
    }
}

/// U(t) = Σ_k A_k F_k log2 F_k − A F log2 F at t = 2/10, 4/10, 6/10, 8/10:
/// splits.csv, rows `curve_*`.
#[test]
fn numerical_gain_curves_reproduce_the_tabulated_gains() {
    for (id, curve, tenths) in POINTS {
        for level in [&COARSE, &FINE] {
            assert_value(id, &curve.gain(&Real::ratio(tenths, 10), level));
        }
    }
}

/// The place and the value of the maximum of U(t) for rectangles at right angles:
/// splits.csv, rows `split_perp_*` and `three_squares_*`.
#[test]
#[ignore = "recomputes 8 rows of splits.csv in about 11 s: \
            cargo test --release --test recomputed -- --ignored"]
fn numerical_gain_curves_reproduce_the_optima_at_right_angles() {
    for optimum in OPTIMA {
        assert_optimum(optimum);
    }
}

/// The place and the value of the maximum of U(t) for unit squares at 60 degrees, cut
/// parallel to the common edge, and the form factor itself: splits.csv, rows
/// `split_incl60_par_*` and `ff_incl_60_check`.
#[test]
#[ignore = "recomputes 3 rows of splits.csv in about 13 s: \
            cargo test --release --test recomputed -- --ignored"]
fn contour_integrals_reproduce_the_optimum_at_sixty_degrees() {
    for level in [&COARSE, &FINE] {
        assert_value(INCLINED_FORM_FACTOR, &Curve::Inclined.whole(level));
    }
    assert_optimum(INCLINED);
}
