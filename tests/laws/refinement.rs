//! Theorem 1: refinement never lowers mutual information, and its hypotheses are needed.

use infoscene::chain::random::RandomChains;
use infoscene::chain::{ChainError, ReversibleChain, StateRefinement};
use infoscene::information::{
    entropy_rate, mutual_information, positional_entropy, refinement_gain,
};
use infoscene::numeric::tolerance;
use nalgebra::{DMatrix, dmatrix};

/// `I′ − I = gain ≥ 0`, the gain from its own sum of non-negative terms.
#[test]
fn refinement_never_lowers_mutual_information() {
    let mut random = RandomChains::new(1);
    for _ in 0..500 {
        let chain = random.chain(9).unwrap();
        let refinement = random.refinement(&chain, 5).unwrap();
        let gain = refinement_gain(&chain, &refinement);
        let refined = refinement.refined(&chain).unwrap();
        let difference = mutual_information(&refined) - mutual_information(&chain);
        assert!(gain >= 0.0);
        assert!(
            (difference - gain).abs() <= tolerance::IDENTITY,
            "{difference} {gain}"
        );
    }
}

/// `0 ≤ I ≤ H_p` and `I = H_p − H_s`.
#[test]
fn mutual_information_lies_between_zero_and_positional_entropy() {
    let mut random = RandomChains::new(2);
    for _ in 0..500 {
        let chain = random.chain(9).unwrap();
        let (entropy, rate) = (positional_entropy(&chain), entropy_rate(&chain));
        let information = mutual_information(&chain);
        assert!(information >= 0.0 && information <= entropy + tolerance::IDENTITY);
        assert!((information - (entropy - rate)).abs() <= tolerance::IDENTITY);
    }
}

/// An independent chain has no mutual information, a deterministic one all of it.
#[test]
fn mutual_information_has_its_exact_ends() {
    let independent = ReversibleChain::try_new(dmatrix![1.0, 3.0; 3.0, 9.0]).unwrap();
    assert_eq!(mutual_information(&independent), 0.0);
    let alternating = ReversibleChain::try_new(dmatrix![0.0, 1.0; 1.0, 0.0]).unwrap();
    assert_eq!(mutual_information(&alternating), 1.0);
    assert_eq!(
        (positional_entropy(&alternating), entropy_rate(&alternating)),
        (1.0, 0.0)
    );
}

/// A proportional division gains exactly nothing.
#[test]
fn proportional_division_gains_nothing() {
    let chain = ReversibleChain::try_new(dmatrix![4.0, 8.0; 8.0, 2.0]).unwrap();
    let outward = dmatrix![0.0, 2.0; 0.0, 6.0]; // a quarter and three quarters
    let within = dmatrix![0.25, 0.75; 0.75, 2.25];
    let refinement = StateRefinement::try_new(&chain, 0, outward, within).unwrap();
    assert_eq!(refinement_gain(&chain, &refinement), 0.0);
}

/// Negative control: sub-states that do not cover the state are refused, and computed all the same
/// they can lower mutual information. By hand: J = ((0,1),(1,0)) has I = 1 bit; its second state "refined" into
/// two that carry 1/2 to state 0 each and 1/2 to each other, 1 in all too many, gives weights (1,1,1)/3, the
/// joint matrix of a fair choice between the two others, I′ = log2 3 − 1 < 1.
#[test]
fn without_covering_the_conclusion_fails() {
    let chain = ReversibleChain::try_new(dmatrix![0.0, 1.0; 1.0, 0.0]).unwrap();
    let outward = dmatrix![0.5, 0.0; 0.5, 0.0];
    let within = dmatrix![0.0, 0.5; 0.5, 0.0];
    let refusal = StateRefinement::try_new(&chain, 1, outward, within).unwrap_err();
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

/// Wrong shapes and numbers are refused with their place.
#[test]
fn refinements_are_checked() {
    let chain = ReversibleChain::try_new(dmatrix![1.0, 1.0; 1.0, 1.0]).unwrap();
    let outward = dmatrix![0.0, 0.5; 0.0, 0.5];
    let within = dmatrix![0.5, 0.0; 0.0, 0.5];
    let refuse = |state, outward: &DMatrix<f64>, within: &DMatrix<f64>| {
        StateRefinement::try_new(&chain, state, outward.clone(), within.clone()).unwrap_err()
    };
    assert_eq!(
        refuse(2, &outward, &within),
        ChainError::NoSuchState { state: 2, last: 1 }
    );
    let lopsided = dmatrix![0.5, 0.25; 0.0, 0.25];
    assert!(matches!(
        refuse(0, &outward, &lopsided),
        ChainError::NotReciprocal { .. }
    ));
    let negative = dmatrix![0.0, 1.5; 0.0, -0.5];
    let entry = ChainError::InvalidEntry {
        row: 1,
        column: 1,
        value: -0.5,
    };
    assert_eq!(refuse(0, &negative, &within), entry);
    assert!(matches!(
        refuse(0, &within, &within),
        ChainError::InvalidEntry { .. } | ChainError::NotCovering { .. }
    ));
    assert!(StateRefinement::try_new(&chain, 0, outward, within).is_ok());
}
