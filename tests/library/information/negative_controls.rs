//! Theorem 1 without one of its hypotheses: the conclusion fails on a concrete chain, by
//! hand-checked values.

use infoscene::chain::{ChainError, Refinement, ReversibleChain};
use infoscene::information::mutual_information;
use infoscene::numeric::x_log2_ratio;
use nalgebra::{DMatrix, dmatrix};

/// Eq. (8) written out: `Σ w_i P_ij log2(P_ij/w_j)`, for any weights and rows.
fn plain_information(weights: &[f64], transitions: &DMatrix<f64>) -> f64 {
    let n = weights.len();
    let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    pairs
        .map(|(i, j)| weights[i] * x_log2_ratio(transitions[(i, j)], weights[j]))
        .sum()
}

/// Two states that alternate: I = 1 bit.
fn alternating() -> ReversibleChain {
    ReversibleChain::try_new(dmatrix![0.0, 1.0; 1.0, 0.0]).unwrap()
}

/// Drop (a), keep (b): state 1 is divided into halves, P_0,1k = 1/2 each (they cover), but what
/// leaves the halves ignores where it came from: P_1k,j = w_j. State 0 still says ½·log2(½/¼)·2·½ =
/// ½ bit, the halves say nothing: I′ = 1/2 < 1.
#[test]
fn without_reciprocity_the_conclusion_fails() {
    let weights = [0.5, 0.25, 0.25];
    let transitions = dmatrix![0.0, 0.5, 0.5; 0.5, 0.25, 0.25; 0.5, 0.25, 0.25];
    assert_eq!(plain_information(&weights, &transitions), 0.5);
    assert!(plain_information(&weights, &transitions) < mutual_information(&alternating()));
    let refusal = ReversibleChain::try_from_transitions(&weights, &transitions).unwrap_err();
    let numbers = ChainError::NotReciprocal {
        row: 0,
        column: 1,
        value: 0.25,
        mirrored: 0.125,
    };
    assert_eq!(refusal, numbers);
}

/// Drop (b), keep (a): the halves carry 1/2 each to state 0 but also 1/2 to each other, so they do
/// not cover J_11 = 0. The joint matrix is that of a fair choice between the two others: I′ = log2
/// 3 − 1 = 0.58 < 1.
#[test]
fn without_covering_the_conclusion_fails() {
    let chain = alternating();
    let (outward, within) = (dmatrix![0.5, 0.0; 0.5, 0.0], dmatrix![0.0, 0.5; 0.5, 0.0]);
    let refusal = Refinement::of_state(&chain, 1, &outward, &within).unwrap_err();
    assert_eq!(
        refusal,
        ChainError::NotCovering {
            state: 1,
            other: 1,
            parts: 1.0,
            whole: 0.0
        }
    );
    let refined = dmatrix![0.0, 0.5, 0.5; 0.5, 0.0, 0.5; 0.5, 0.5, 0.0];
    let information = mutual_information(&ReversibleChain::try_new(refined).unwrap());
    approx::assert_relative_eq!(
        information,
        3f64.log2() - 1.0,
        epsilon = 0.0,
        max_relative = 1e-15
    );
    assert!(information < mutual_information(&chain));
}

/// One negative part: fluxes 2 and −1 of weights 1 and −1/10 have positive ratios 2 and 10, and
/// 2·log2 2 − log2 10 − (2−1)·log2(1/0.9) = 2 − 3.3219 − 0.1520 = −1.4739 < 0. Such entries are
/// refused.
#[test]
fn with_a_negative_entry_the_conclusion_fails() {
    let gain: f64 = 2.0 * 2f64.log2() - 10f64.log2() - (1.0 / 0.9f64).log2();
    assert!((gain + 1.473_931_188_332_412).abs() < 1e-14, "{gain}");
    let refusal = ReversibleChain::try_new(dmatrix![0.0, -1.0; -1.0, 2.0]).unwrap_err();
    assert_eq!(
        refusal,
        ChainError::InvalidEntry {
            row: 0,
            column: 1,
            value: -1.0
        }
    );
}
