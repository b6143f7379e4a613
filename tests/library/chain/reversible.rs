//! Chains are reversible, and bad matrices are refused with the entry.

use infoscene::chain::{ChainError, ReversibleChain};
use nalgebra::{DMatrix, dmatrix};

/// A joint matrix that differs from its transpose is refused, both entries named.
#[test]
fn a_chain_without_reciprocity_is_refused() {
    let refusal = ReversibleChain::try_new(dmatrix![1.0, 2.0; 2.5, 1.0]).unwrap_err();
    assert_eq!(
        refusal,
        ChainError::NotReciprocal {
            row: 0,
            column: 1,
            value: 2.0,
            mirrored: 2.5
        }
    );
}

/// Three states that circulate have a stationary distribution and no reciprocity.
#[test]
fn a_circulating_chain_is_refused() {
    let circulation = dmatrix![0.0, 1.0, 0.0; 0.0, 0.0, 1.0; 1.0, 0.0, 0.0];
    let refusal = ReversibleChain::try_from_transitions(&[1.0, 1.0, 1.0], &circulation);
    assert!(
        matches!(refusal, Err(ChainError::NotReciprocal { .. })),
        "{refusal:?}"
    );
}

/// Transition probabilities go in and come out.
#[test]
fn transition_probabilities_are_given_back() {
    // w = (1/2, 1/3, 1/6), w_i P_ij symmetric
    let transitions = dmatrix![0.5, 0.25, 0.25; 0.375, 0.5, 0.125; 0.75, 0.25, 0.0];
    let weights = [0.5, 1.0 / 3.0, 1.0 / 6.0];
    let chain = ReversibleChain::try_from_transitions(&weights, &transitions).unwrap();
    let back = DMatrix::from_fn(3, 3, |i, j| chain.transition_probability(i, j));
    approx::assert_relative_eq!(
        back,
        transitions,
        epsilon = 0.0,
        max_relative = 4.0 * f64::EPSILON
    );
    for (i, weight) in weights.iter().enumerate() {
        approx::assert_ulps_eq!(
            chain.stationary_probability(i),
            *weight,
            epsilon = 0.0,
            max_ulps = 4
        );
    }
}

#[test]
fn bad_joint_matrices_are_refused_with_the_entry() {
    let refuse = |matrix: DMatrix<f64>| ReversibleChain::try_new(matrix).unwrap_err();
    assert_eq!(refuse(DMatrix::zeros(0, 0)), ChainError::Empty);
    assert_eq!(
        refuse(DMatrix::zeros(1, 2)),
        ChainError::NotSquare {
            rows: 1,
            columns: 2
        }
    );
    assert_eq!(
        refuse(DMatrix::zeros(2, 2)),
        ChainError::NoMass { total: 0.0 }
    );
    let entry = |row, column, value| ChainError::InvalidEntry { row, column, value };
    assert_eq!(refuse(dmatrix![1.0, -1.0; -1.0, 1.0]), entry(0, 1, -1.0));
    assert!(matches!(
        refuse(dmatrix![1.0, 0.0; 0.0, f64::NAN]),
        ChainError::InvalidEntry {
            row: 1,
            column: 1,
            ..
        }
    ));
    let huge = refuse(DMatrix::from_element(2, 2, 1e308));
    assert_eq!(
        huge,
        ChainError::NoMass {
            total: f64::INFINITY
        }
    );
    let even = dmatrix![0.5, 0.5; 0.5, 0.5];
    let from = |weights: [f64; 2]| ReversibleChain::try_from_transitions(&weights, &even);
    let negative = ChainError::InvalidWeight {
        state: 0,
        value: -1.0,
    };
    assert_eq!(from([-1.0, 1.0]).unwrap_err(), negative);
    assert!(matches!(
        from([1e-320, 1e-320]).unwrap_err(),
        ChainError::Underflow { .. }
    ));
    assert!(from([7e307, 7e307]).is_ok());
    let halved = dmatrix![0.5, 0.4; 0.5, 0.5];
    let refusal = ReversibleChain::try_from_transitions(&[1.0, 1.0], &halved).unwrap_err();
    assert!(
        matches!(refusal, ChainError::RowSumNotOne { row: 0, .. }),
        "{refusal}"
    );
}
