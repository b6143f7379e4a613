//! What one patch sends to another comes back: `A_i F_ij = A_j F_ji`.

use crate::support::strategies::rectangle_pair;
use infoscene::chain::{ChainError, ReversibleChain};
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::SplitAxis;
use nalgebra::{DMatrix, dmatrix};
use proptest::prelude::*;

proptest! {
    /// The same exchange area from either frame, within the bounds and what the rounding of coordinates in
    /// either frame can change: a shift by δ moves at most the flux through a rim of that width.
    #[test]
    fn exchange_area_is_the_same_from_both_sides((first, second) in rectangle_pair()) {
        let there = RectanglePair::try_new(&first, &second).unwrap().exchange_area();
        let back = RectanglePair::try_new(&second, &first).unwrap().exchange_area();
        if let (Ok(there), Ok(back)) = (there, back) {
            let coordinates = [first, second].map(|r| r.corners().map(|c| c.abs().max_element()));
            let coordinate = coordinates.into_iter().flatten().fold(0.0, f64::max);
            let rim = 2.0 * SplitAxis::ALL.map(|axis| first.edge(axis).length()).iter().sum::<f64>();
            let rounding = 2.0 * f64::EPSILON * coordinate * rim;
            let allowed = there.error_bound + back.error_bound + rounding;
            prop_assert!((there.value - back.value).abs() <= allowed, "{there:?} {back:?}");
        }
    }
}

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
