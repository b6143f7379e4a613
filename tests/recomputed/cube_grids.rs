//! Every row of cube_grids.csv, by numerical exchange areas of the cells.
//!
//! The inside of the unit cube with the grid lines 0 = c₀ < … < c_n = 1 on all axes of
//! all faces has the discrete mutual information, with A_T = 6 and E_ij = A_i F_ij,
//!
//! ```text
//! I = Σ_ij (A_i/A_T) F_ij log2(F_ij A_T/A_j) = Σ_ij E_ij/6 log2(6 E_ij/(A_i A_j)),
//! ```
//!
//! where a face sees one opposite and four adjacent faces, so that the sum is 6 times
//! the one over the opposite cells of a face and 24 times the one over the adjacent
//! cells. The exchange areas come from [`crate::cube_cells`].

use crate::cube_cells::Cells;
use crate::maximum::newton;
use crate::precision::Real;
use crate::quadrature::{COARSE, FINE, Level};
use crate::reference::{Digits, assert_digits, row};

/// Grids with equidistant lines.
const REGULAR: [i32; 5] = [1, 2, 3, 4, 6];

/// Best symmetric grids: lines per axis, and the places below 1/2 where Newton's
/// method starts.
const OPTIMAL: [(i32, &[&str]); 3] = [(3, &["0.3"]), (4, &["0.2"]), (6, &["0.1", "0.28"])];

/// Rows of the curve over x, the lines being t and 1 − t with t = x/20 = p/q.
/// Two of them are in double precision and state 13 digits.
const CURVE: [(&str, i32, i32, Digits); 3] = [
    ("fig4_x2", 1, 10, Digits::First(13)),
    ("fig4_x6", 3, 10, Digits::First(13)),
    ("fig4_x6.666667 (regular)", 1, 3, Digits::Few),
];

/// The row that states 20 times the line of the best 3 × 3 grid.
const CURVE_OPTIMUM: &str = "fig4_opt_x";

/// The rows recomputed here.
pub fn ids() -> Vec<String> {
    let regular = REGULAR.iter().map(|n| format!("cube_regular_{n}"));
    let optimal = OPTIMAL.iter().flat_map(|(n, starts)| {
        let line = move |k| format!("cube_optimal_{n}_line{k}");
        let lines = (1..=starts.len()).map(line);
        lines.chain([format!("cube_optimal_{n}")])
    });
    let curve = CURVE.iter().map(|(id, ..)| (*id).to_string());
    regular
        .chain(optimal)
        .chain(curve)
        .chain([CURVE_OPTIMUM.to_string()])
        .collect()
}

fn assert_value(id: &str, digits: Digits, value: &Real) {
    assert_digits(id, &row("cube_grids", id)["value"], digits, value);
}

/// The lines of a regular grid.
fn regular(n: i32) -> Vec<Real> {
    (0..=n).map(|k| Real::ratio(k, n)).collect()
}

/// The lines of a symmetric grid with `n` cells per axis, from those below 1/2.
fn symmetric(n: i32, lower: &[Real]) -> Vec<Real> {
    let mut lines = vec![Real::int(0)];
    lines.extend_from_slice(lower);
    let mirrored: Vec<Real> = lines.iter().rev().map(|c| Real::int(1) - c).collect();
    if n % 2 == 0 {
        lines.push(Real::ratio(1, 2));
    }
    lines.extend(mirrored);
    lines
}

/// The mutual information in bits, for lines symmetric about 1/2.
fn information(lines: Vec<Real>, level: &Level) -> Real {
    let cells = Cells::new(lines, level);
    let six = Real::int(6);
    let mut sum = Real::int(0);
    for first in cells.of_a_face() {
        for second in cells.of_a_face() {
            let density = &six / (cells.area(first) * cells.area(second));
            let term = |exchange: Real| &exchange * (&exchange * &density).log2();
            sum += term(cells.opposite(first, second));
            sum += Real::int(4) * term(cells.adjacent(first, second));
        }
        // The cube is closed: the form factors of every cell add up to 1.
        let total = cells.all_exchange(first) / cells.area(first);
        assert!((total - Real::int(1)).abs() < Real::decimal("1e-33"));
    }
    sum
}

/// I of the regular n × n grids: cube_grids.csv, rows `cube_regular_*`.
#[test]
fn numerical_exchange_areas_reproduce_the_regular_grids() {
    for n in REGULAR {
        for level in [&COARSE, &FINE] {
            let value = information(regular(n), level);
            assert_value(&format!("cube_regular_{n}"), Digits::Printed, &value);
        }
    }
}

/// I of 3 × 3 grids with lines t and 1 − t, t = x/20: cube_grids.csv, rows `fig4_x*`.
#[test]
fn numerical_exchange_areas_reproduce_the_curve_of_three_by_three_grids() {
    for (id, p, q, digits) in CURVE {
        for level in [&COARSE, &FINE] {
            let value = information(symmetric(3, &[Real::ratio(p, q)]), level);
            assert_value(id, digits, &value);
        }
    }
}

/// The lines that maximise I near the regular grid, and I there, by Newton's method
/// from starts of one or two digits: cube_grids.csv, rows `cube_optimal_*` and
/// `fig4_opt_x`, which is 20 times the line of the 3 × 3 grid.
#[test]
#[ignore = "recomputes 8 rows of cube_grids.csv in about 70 s: \
            cargo test --release --test recomputed -- --ignored"]
fn newtons_method_reproduces_the_best_grids() {
    for (n, starts) in OPTIMAL {
        let mut lines: Vec<Real> = starts.iter().map(|start| Real::decimal(start)).collect();
        for level in [&COARSE, &FINE] {
            lines = newton(&lines, |lower| information(symmetric(n, lower), level));
            let id = format!("cube_optimal_{n}");
            for (k, line) in lines.iter().enumerate() {
                let line_id = format!("{id}_line{}", k + 1);
                assert_value(&line_id, Digits::Few, line);
                // The row of the value repeats the line.
                let printed = &row("cube_grids", &line_id)["value"];
                assert!(row("cube_grids", &id)["inputs"].contains(printed), "{id}");
            }
            let value = information(symmetric(n, &lines), level);
            assert_value(&id, Digits::Printed, &value);
            if n == 3 {
                assert_value(CURVE_OPTIMUM, Digits::Few, &(&lines[0] * Real::int(20)));
            }
        }
    }
}
