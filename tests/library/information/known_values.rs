//! Chains whose information and gains are known: at the ends of `f64`, of hundreds of parts, and
//! exact ones.

use infoscene::chain::{Refinement, ReversibleChain};
use infoscene::information::{
    entropy_rate, mutual_information, positional_entropy, refinement_gain,
};
use infoscene::numeric::{Scalar, tolerance};
use infoscene::reference::exact_gain;
use nalgebra::{DMatrix, dmatrix};

fn chain(joint: DMatrix<f64>) -> ReversibleChain {
    ReversibleChain::try_new(joint).unwrap()
}

fn coarsening(joint: DMatrix<f64>, parents: &[usize]) -> Refinement {
    Refinement::coarsening(chain(joint), parents.to_vec()).unwrap()
}

const TINY: f64 = f64::from_bits(1);

/// The others have `1 − H(1/4)` by themselves.
#[test]
fn a_state_of_the_smallest_weight_changes_nothing() {
    let lonely = chain(dmatrix![1.5, 0.5, 0.0; 0.5, 1.5, 0.0; 0.0, 0.0, TINY]);
    let binary = 1.0 + 0.25 * 0.25f64.log2() + 0.75 * 0.75f64.log2();
    assert!((mutual_information(&lonely) - binary).abs() < 1e-15);
}

#[test]
fn states_of_the_smallest_weights_alternate() {
    let subnormal = chain(dmatrix![0.0, TINY; TINY, 0.0]);
    let measures = (mutual_information(&subnormal), entropy_rate(&subnormal));
    assert_eq!(measures, (1.0, 0.0));
}

#[test]
fn measures_of_lopsided_chains_are_not_negative() {
    let lopsided = chain(dmatrix![1e10, TINY; TINY, 0.0]);
    assert!(mutual_information(&lopsided) >= 0.0 && entropy_rate(&lopsided) >= 0.0);
    let one = chain(dmatrix![1.0]);
    assert!(positional_entropy(&one).is_sign_positive() && entropy_rate(&one).is_sign_positive());
}

/// The entropy of their weights, `w log2(1/w) + w/ln 2` to first order in w (a double near 1e-310
/// has steps of 5e-14 of itself).
#[test]
fn two_states_that_never_meet_tell_their_weights() {
    for (w, digits) in [(1e-200f64, 1e-13), (1e-310, 1e-12)] {
        let apart = mutual_information(&chain(dmatrix![1.0, 0.0; 0.0, w]));
        let exact = w * (std::f64::consts::LOG2_E - w.log2());
        assert!((apart / exact - 1.0).abs() < digits, "{apart:e} {exact:e}");
    }
}

#[test]
fn gains_from_the_largest_to_the_smallest_entries_are_finite() {
    let joint = dmatrix![1e17, 0.0, 0.0; 0.0, 1e-308, 1e-150; 0.0, 1e-150, 1.0];
    let gain = refinement_gain(&coarsening(joint, &[0, 0, 1]));
    assert!(gain.is_finite() && gain >= 0.0, "{gain:e}");
}

/// Two chains with the gain 1.33e-197, computed with 400 bits and more elsewhere.
#[test]
fn the_smallest_gains_of_extreme_chains_are_known() {
    let three = dmatrix![1e100, 0.0, 0.0; 0.0, 1e-230, 1e-100; 0.0, 1e-100, 1.0];
    let four = dmatrix![
        0.0, 1e-100, 1e100, 0.0;
        1e-100, 0.0, 0.0, 1e-230;
        1e100, 0.0, 0.0, 1e-100;
        0.0, 1e-230, 1e-100, 0.0
    ];
    for (joint, parents) in [(three, &[0, 0, 1][..]), (four, &[0, 0, 1, 1])] {
        let gain = refinement_gain(&coarsening(joint, parents));
        assert!((gain / 1.33e-197 - 1.0).abs() < 3e-3, "{gain:e}");
    }
}

/// All the flux of a pair between parts of 1e-160 of their states: `p/(a b) = 1e320`.
#[test]
fn a_flux_between_the_smallest_parts_gains_what_2304_bits_say() {
    let joint = dmatrix![
        1e100, 0.0, 0.0, 0.0;
        0.0, 0.0, 0.0, 1e-60;
        0.0, 0.0, 1e100, 0.0;
        0.0, 1e-60, 0.0, 0.0
    ];
    let between = coarsening(joint, &[0, 0, 1, 1]);
    let exact = exact_gain(&between, 2304).to_f64();
    let found = refinement_gain(&between);
    let off = (found / exact - 1.0).abs();
    assert!(off <= tolerance::GAIN, "{found:e} {exact:e}");
}

/// Hundreds of parts: one state in 301 equal parts, entries 0.087 or 0.112 around a circle; sums
/// must not drift.
#[test]
fn gains_of_hundreds_of_parts_keep_their_digits() {
    let n = 301;
    let joint = DMatrix::from_fn(n, n, |i, j| if (i + j) % 3 == 0 { 0.087 } else { 0.112 });
    let refinement =
        Refinement::coarsening(ReversibleChain::try_new(joint).unwrap(), vec![0; n]).unwrap();
    // all parts in one state: the gain is the whole mutual information
    let (gain, whole) = (
        refinement_gain(&refinement),
        mutual_information(refinement.refined()),
    );
    assert!(
        (gain / whole - 1.0).abs() <= tolerance::GAIN,
        "{gain} {whole}"
    );
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

/// A state divided as the theorem states it, and by hand: 1/4 and 3/4 in proportion gain nothing,
/// the same in separate halves of a state that only sees itself gain one bit of it.
#[test]
fn divisions_of_one_state_have_their_exact_cases() {
    let chain = ReversibleChain::try_new(dmatrix![4.0, 8.0; 8.0, 2.0]).unwrap();
    let (outward, within) = (
        dmatrix![0.0, 2.0; 0.0, 6.0],
        dmatrix![0.25, 0.75; 0.75, 2.25],
    );
    let refinement = Refinement::of_state(&chain, 0, &outward, &within).unwrap();
    assert_eq!(refinement.parents(), [0, 1, 0]);
    assert_eq!(refinement_gain(&refinement), 0.0);

    let lonely = ReversibleChain::try_new(dmatrix![4.0]).unwrap();
    let halves = Refinement::of_state(
        &lonely,
        0,
        &dmatrix![0.0; 0.0],
        &dmatrix![2.0, 0.0; 0.0, 2.0],
    );
    assert_eq!(refinement_gain(&halves.unwrap()), 1.0);
}
