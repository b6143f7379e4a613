//! Estimates from counts, against the chain they are counted from and their formulas as written.

use approx::assert_relative_eq;
use infoscene::chain::ReversibleChain;
use infoscene::information::{PairCounts, mutual_information};
use nalgebra::DMatrix;
use std::f64::consts::LN_2;

/// Rounding of some ten terms of order one.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Symmetric matrices of counts, some with states that meet themselves.
fn chains() -> Vec<DMatrix<f64>> {
    vec![
        DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 1.0, 0.0]),
        DMatrix::from_row_slice(2, 2, &[3.0, 5.0, 5.0, 7.0]),
        DMatrix::from_row_slice(3, 3, &[0.0, 4.0, 9.0, 4.0, 0.0, 1.0, 9.0, 1.0, 0.0]),
        DMatrix::from_row_slice(3, 3, &[6.0, 2.0, 0.0, 2.0, 0.0, 8.0, 0.0, 8.0, 1.0]),
    ]
}

/// Unordered pairs: those of two states are met from either side.
fn counted(joint: &DMatrix<f64>) -> Vec<([usize; 2], u64)> {
    let n = joint.nrows();
    let upper = (0..n).flat_map(|i| (i..n).map(move |j| (i, j)));
    let count = |i: usize, j: usize| {
        let ordered = joint[(i, j)] * if i == j { 1.0 } else { 2.0 };
        ordered as u64
    };
    upper.map(|(i, j)| ([i, j], count(i, j))).collect()
}

/// Counts in proportion to the probabilities give the chain's own mutual information, whether
/// weights are known or counted.
#[test]
fn plug_in_estimate_of_proportional_counts_is_the_chains() {
    for joint in chains() {
        let chain = ReversibleChain::try_new(joint.clone()).unwrap();
        let counts = PairCounts::try_new(chain.weights(), counted(&joint)).unwrap();
        let expected = mutual_information(&chain);
        assert_relative_eq!(counts.plug_in(), expected, epsilon = ROUNDING);
        let found = counts.plug_in_of_counted_weights();
        assert_relative_eq!(found, expected, epsilon = ROUNDING);
    }
}

/// New numbers for the states, pairs turned round, counts in several parts: all the same.
#[test]
fn estimates_do_not_depend_on_names_and_order() {
    let weights = [2.0, 1.0, 3.0, 0.5];
    let cells = [
        ([0, 1], 7),
        ([0, 2], 1),
        ([2, 3], 2),
        ([1, 2], 12),
        ([3, 0], 1),
    ];
    let order = [2, 0, 3, 1];
    let mut renamed = [0.0; 4];
    for (state, weight) in weights.iter().enumerate() {
        renamed[order[state]] = *weight;
    }
    let mut turned = Vec::new();
    for ([i, j], count) in cells.iter().rev() {
        turned.push(([order[*j], order[*i]], count - 1));
        turned.push(([order[*i], order[*j]], 1));
    }
    let one = PairCounts::try_new(&weights, cells).unwrap();
    let other = PairCounts::try_new(&renamed, turned).unwrap();
    assert_eq!((one.samples(), one.occupied()), (23, 5));
    assert_eq!((other.samples(), other.occupied()), (23, 5));
    let all = |counts: &PairCounts| {
        [
            counts.plug_in(),
            counts.plug_in_of_counted_weights(),
            counts.miller_madow(),
            counts.corrected(),
            counts.standard_error(),
            counts.unseen(),
        ]
    };
    for (one, other) in all(&one).into_iter().zip(all(&other)) {
        assert_relative_eq!(one, other, epsilon = ROUNDING);
    }
    assert_eq!(one.unseen(), 2.0 / 23.0);
}

/// Chao, Wang and Jost 2013, eq. (4a), with harmonic numbers and the sum over r as printed: states
/// of weight 1/n, so that `I = log2(n²/2) − H` for pairs of different states.
#[test]
fn corrected_estimate_is_the_formula_as_printed() {
    for cells in [
        vec![1, 1, 1, 2, 2, 5, 9],
        vec![1, 1, 1, 1, 3],
        vec![1, 4],
        vec![2, 2, 6],
        vec![1, 1, 2],
        vec![1; 6],
        (1..60).map(|k| 1 + k % 7).collect(),
    ] {
        let states = 2 * cells.len();
        let pair = |(k, count): (usize, &u64)| ([2 * k, 2 * k + 1], *count);
        let counts = cells.iter().enumerate().map(pair);
        let found = PairCounts::try_new(&vec![1.0; states], counts).unwrap();
        let total: u64 = cells.iter().sum();
        let n = total as f64;
        let harmonic = |from: u64| (from..total).map(|k| 1.0 / k as f64).sum::<f64>();
        let mut entropy: f64 = cells.iter().map(|k| *k as f64 / n * harmonic(*k)).sum();
        let met = |times: u64| cells.iter().filter(|k| **k == times).count() as f64;
        let (once, twice) = (met(1), met(2));
        let a = if twice > 0.0 {
            2.0 * twice / ((n - 1.0) * once + 2.0 * twice)
        } else {
            2.0 / ((n - 1.0) * (once - 1.0) + 2.0)
        };
        if once > 0.0 && a < 1.0 {
            let q = 1.0 - a;
            let sum: f64 = (1..total).map(|r| q.powf(r as f64) / r as f64).sum();
            entropy += once / n * q.powf(1.0 - n) * (-a.ln() - sum);
        }
        let expected = (states as f64).powi(2).log2() - 1.0 - entropy / LN_2;
        // the printed difference loses the digits of q^(N−1) ≥ 1e-3 or so
        assert_relative_eq!(found.corrected(), expected, epsilon = 1e-11);
    }
}
