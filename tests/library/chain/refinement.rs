//! Refinements are checked, and print as source.

use infoscene::chain::{ChainError, Refinement, ReversibleChain};
use nalgebra::{DMatrix, dmatrix};

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
    use infoscene::chain::random::families::{ChainFamily, DivisionFamily, RefinementDraw};
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
