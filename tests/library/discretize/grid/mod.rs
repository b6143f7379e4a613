//! Tensor grids on the inside of a box: values against other roads, invariance, derivatives, best
//! grids.

mod agreement;
mod best;
mod derivatives;
mod invariance;
mod reference_values;
mod refusals;
mod three_cells;

use infoscene::discretize::BoxGrid;
use proptest::prelude::*;

/// Edges that differ by up to four orders of magnitude, some of them alike.
fn edges() -> impl Strategy<Value = [f64; 3]> {
    let edge = || {
        prop_oneof![
            Just(1.0),
            0.1..10.0_f64,
            (-2.0..2.0_f64).prop_map(|x| 10f64.powf(x))
        ]
    };
    [edge(), edge(), edge()]
}

/// Inner lines of up to `most` cells: equally spaced, symmetric, or any; some cells are very
/// narrow.
fn lines(most: usize) -> impl Strategy<Value = Vec<f64>> {
    let gap = prop_oneof![
        4 => 0.2..1.0_f64,
        1 => Just(0.5),
        1 => (-4.0..0.0_f64).prop_map(|x| 10f64.powf(x)),
    ];
    let gaps = proptest::collection::vec(gap, 1..=most);
    (gaps, 0..3).prop_map(|(mut gaps, kind)| {
        let n = gaps.len();
        match kind {
            0 => gaps.fill(1.0),
            1 => (0..n / 2).for_each(|k| gaps[n - 1 - k] = gaps[k]),
            _ => (),
        }
        let whole: f64 = gaps.iter().sum();
        let mut line = 0.0;
        let sums = gaps[..n - 1].iter().map(|gap| {
            line += gap / whole;
            line
        });
        sums.collect()
    })
}

fn grid(edges: [f64; 3], lines: &[f64]) -> BoxGrid {
    BoxGrid::try_new(edges, lines).unwrap()
}
