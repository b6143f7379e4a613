//! Every row of form_factors.csv, by integrals over the contours.
//!
//! The column `inputs` states the corners of two polygons P and Q. The exchange area
//! `A_P F_PQ` of [`crate::contour`] gives the three printed numbers: itself, the form
//! factor F₁₂ after division by the area of P, and the reverse form factor F₂₁ after
//! division by the area of Q.

use crate::contour::{Polygon, area, exchange_area};
use crate::precision::Real;
use crate::quadrature::{COARSE, FINE};
use crate::reference::{Digits, assert_digits, row};

/// The rows recomputed here.
pub const IDS: [&str; 26] = [
    "ff_par_unit_d1",
    "ff_par_unit_d0.1",
    "ff_par_unit_d10",
    "ff_par_unit_d1e-3",
    "ff_par_offset_1",
    "ff_par_2x3",
    "ff_par_strip_1e6",
    "ff_par_sliver_square",
    "ff_perp_1_1",
    "ff_perp_0.1_1",
    "ff_perp_2_1",
    "ff_perp_10_1",
    "ff_perp_1e-6_1",
    "ff_perp_1_1e6",
    "ff_perp_gap1e-9",
    "ff_perp_gap0.5",
    "ff_perp_shift1",
    "ff_incl_30",
    "ff_incl_60",
    "ff_incl_90",
    "ff_incl_150",
    "ff_tri_par",
    "ff_tri_perp_edge",
    "ff_tri_corner_vertex",
    "ff_Lshape_par",
    "ff_hex_par",
];

/// The polygon of an input `P=[["x", "y", "z"], …]`.
fn polygon(input: &str) -> Polygon {
    let corners: Vec<[String; 3]> = serde_json::from_str(&input[2..]).unwrap();
    let point = |corner: [String; 3]| corner.map(|coordinate| Real::decimal(&coordinate));
    corners.into_iter().map(point).collect()
}

/// `A_P F_PQ = 1/(2π) ∮ ∮ ln r dr_P·dr_Q` for the corners of each row, at two levels
/// of the quadrature: form_factors.csv, columns `form_factor`, `reverse_form_factor`
/// and `exchange_area`, all digits printed.
#[test]
#[ignore = "recomputes form_factors.csv in about 10 s: \
            cargo test --release --test recomputed -- --ignored"]
fn contour_integrals_reproduce_every_form_factor_row() {
    for id in IDS {
        let row = row("form_factors", id);
        let (p, q) = row["inputs"].split_once(';').unwrap();
        assert!(p.starts_with("P=") && q.starts_with("Q="), "{id}: {p};{q}");
        let (p, q) = (polygon(p), polygon(q));
        for level in [&COARSE, &FINE] {
            let exchange = exchange_area(&p, &q, level);
            let printed = |column: &str, value: &Real| {
                assert_digits(
                    &format!("{id}, {column}"),
                    &row[column],
                    Digits::Printed,
                    value,
                );
            };
            printed("exchange_area", &exchange);
            printed("form_factor", &(&exchange / area(&p)));
            printed("reverse_form_factor", &(&exchange / area(&q)));
        }
    }
}
