//! Theorem 1 without one of its hypotheses: the conclusion fails on a concrete chain, by hand-checked values.

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

/// Drop (a), keep (b): state 1 is divided into halves, P_0,1k = 1/2 each (they cover), but what leaves the
/// halves ignores where it came from: P_1k,j = w_j. State 0 still says ½·log2(½/¼)·2·½ = ½ bit, the halves say
/// nothing: I′ = 1/2 < 1.
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

/// Drop (b), keep (a): the halves carry 1/2 each to state 0 but also 1/2 to each other, so they do not cover
/// J_11 = 0. The joint matrix is that of a fair choice between the two others: I′ = log2 3 − 1 = 0.58 < 1.
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
/// 2·log2 2 − log2 10 − (2−1)·log2(1/0.9) = 2 − 3.3219 − 0.1520 = −1.4739 < 0. Such entries are refused.
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

/// Wrong shapes and numbers are refused with their place.
#[test]
fn refinements_are_checked() {
    let chain = ReversibleChain::try_new(dmatrix![1.0, 1.0; 1.0, 1.0]).unwrap();
    let (outward, within) = (dmatrix![0.0, 0.5; 0.0, 0.5], dmatrix![0.5, 0.0; 0.0, 0.5]);
    let refuse = |state, outward: &DMatrix<f64>, within: &DMatrix<f64>| {
        Refinement::of_state(&chain, state, outward, within).unwrap_err()
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
    assert!(matches!(
        refuse(0, &negative, &within),
        ChainError::InvalidEntry { value: -0.5, .. }
    ));
    let short = dmatrix![0.0, 0.5; 0.0, 0.4];
    let gap = ChainError::NotCovering {
        state: 0,
        other: 1,
        parts: 0.9,
        whole: 1.0,
    };
    assert_eq!(refuse(0, &short, &within), gap);
    let shape = |result: Result<Refinement, ChainError>| {
        assert!(
            matches!(result, Err(ChainError::WrongShape { .. })),
            "{result:?}"
        );
    };
    shape(Refinement::of_state(&chain, 0, &dmatrix![0.5], &within));
    shape(Refinement::of_state(&chain, 0, &outward, &dmatrix![1.0]));
    shape(Refinement::coarsening(chain.clone(), vec![0]));
    let gap = Refinement::coarsening(chain.clone(), vec![0, 2]).unwrap_err();
    assert_eq!(gap, ChainError::NoSuchState { state: 2, last: 1 });
    let wild = Refinement::coarsening(chain.clone(), vec![0, usize::MAX]).unwrap_err();
    assert_eq!(
        wild,
        ChainError::NoSuchState {
            state: usize::MAX,
            last: 1
        }
    );
    let three = ReversibleChain::try_new(DMatrix::from_element(3, 3, 1.0)).unwrap();
    let gap = Refinement::coarsening(three, vec![0, 2, 2]).unwrap_err();
    assert_eq!(gap, ChainError::NoPart { state: 1 });
    assert!(Refinement::of_state(&chain, 0, &outward, &within).is_ok());
    let same = Refinement::coarsening(chain.clone(), vec![0, 1]).unwrap();
    let one = Refinement::coarsening(chain, vec![0, 0]).unwrap();
    shape(same.then(&Refinement::coarsening(one.coarse().clone(), vec![0]).unwrap()));
}

/// A draw outside its ranges is refused.
#[test]
fn a_recipe_with_a_state_of_no_parts_is_refused() {
    use infoscene::chain::recipe::{ChainFamily, DivisionFamily, RefinementDraw};
    let draw = |parts| RefinementDraw {
        chain: ChainFamily::Dense,
        division: DivisionFamily::Free,
        states: 2,
        parts,
        bytes: Vec::new(),
    };
    assert!(matches!(
        draw(vec![2, 0]).refinement(),
        Err(ChainError::WrongShape { .. })
    ));
    assert!(draw(vec![2, 1, 9]).refinement().is_ok());
}

/// A refinement prints as Rust source that makes it again.
#[test]
fn refinements_print_as_source() {
    let chain = ReversibleChain::try_new(dmatrix![0.0, 1.5; 1.5, 1e-300]).unwrap();
    let text = format!("{:?}", Refinement::coarsening(chain, vec![0, 0]).unwrap());
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    assert_eq!(
        lines,
        [
            "Refinement::coarsening(",
            "ReversibleChain::try_new(nalgebra::dmatrix![",
            "0.0, 1.5;",
            "1.5, 1e-300",
            "])?,",
            "vec![0, 0],",
            ")?",
        ]
    );
}
