//! Proptest strategies for reversible chains and their refinements.
//!
//! All values are valid by construction: none is rejected, and shrinking leads to few states and
//! simple numbers. A refinement prints as Rust source that makes it again, to be pasted into a
//! test.
//!
//! | family | weight | difficulty |
//! |---|---|---|
//! | [`ChainFamily::Dense`] | 3 | nothing |
//! | [`ChainFamily::Sparse`] | 2 | zeros |
//! | [`ChainFamily::Decomposable`] | 2 | a second eigenvalue within 1e-12 of 1 |
//! | [`ChainFamily::Spread`] | 2 | weights from 1 to 1e-300 |
//! | [`ChainFamily::Room`] | 1 | form factors of a closed room, from 6 states on |
//! | [`DivisionFamily::Free`], [`DivisionFamily::Equal`] | 2, 1 | nothing |
//! | [`DivisionFamily::Lopsided`] | 2 | shares of 1e-15 |
//! | [`DivisionFamily::WithEmpty`] | 2 | a part of no weight |
//! | [`DivisionFamily::NearlyProportional`] | 2 | gains near 1e-30 |
//! | [`DivisionFamily::Proportional`] | 1 | a gain of exactly 0 |
//!
//! ```
//! use infoscene::chain::random::strategies::refinement;
//! use infoscene::information::{mutual_information, refinement_gain};
//! use proptest::prelude::*;
//!
//! proptest!(|(refinement in refinement(12))| {
//!     let refinement = refinement?;
//!     let (coarse, refined) = (refinement.coarse(), refinement.refined());
//!     let difference = mutual_information(refined) - mutual_information(coarse);
//!     prop_assert!(refinement_gain(&refinement) >= 0.0);
//!     prop_assert!((refinement_gain(&refinement) - difference).abs() < 1e-12);
//! });
//! ```

use super::families::{ChainFamily, DivisionFamily, RefinementDraw};
use crate::chain::ChainError;
use crate::chain::refinement::Refinement;
use crate::chain::reversible::ReversibleChain;
use proptest::prelude::*;

/// The number of bytes for every entry of `states` states and of the refinement that divides three
/// of them by four.
fn byte_count(states: usize) -> usize {
    let entries = |states: usize| states * (states + 1) / 2;
    (entries(states) + entries(states + 9) + 4 * states).max(320)
}

/// Draws of refinements of at most `most_states` (≥ 2) states; two in five have 8 or more, if that
/// many are allowed.
pub fn refinement_draw(most_states: usize) -> impl Strategy<Value = RefinementDraw> {
    let most = most_states.max(2);
    let states = if most > 8 {
        prop_oneof![3 => 2..8usize, 2 => 8..=most].boxed()
    } else {
        (2..=most).boxed()
    };
    let parts = prop_oneof![
        3 => (2..=4usize).prop_map(|parts| vec![parts]),
        1 => proptest::collection::vec(2..=4usize, 2..=3),
    ];
    let bytes = proptest::collection::vec(any::<u8>(), byte_count(most));
    (chain_family(most), division_family(), states, parts, bytes).prop_map(
        |(chain, division, states, mut parts, bytes)| {
            parts.truncate(states);
            RefinementDraw {
                chain,
                division,
                states,
                parts,
                bytes,
            }
        },
    )
}

/// Refinements of chains of at most `most_states` states: one to three states divided, each into
/// two to four parts.
///
/// A draw within its stated ranges that cannot be built is a defect of this crate: an error, which
/// a test run must show and not filter away.
pub fn refinement(most_states: usize) -> impl Strategy<Value = Result<Refinement, ChainError>> {
    refinement_draw(most_states).prop_map(|draw| draw.refinement())
}

/// Reversible chains of at most `most_states` states; errors as of [`refinement`].
pub fn reversible_chain(
    most_states: usize,
) -> impl Strategy<Value = Result<ReversibleChain, ChainError>> {
    refinement(most_states).prop_map(|refinement| Ok(refinement?.coarse().clone()))
}

fn chain_family(most: usize) -> impl Strategy<Value = ChainFamily> {
    // a room has six walls
    let of_the_last = if most < 6 {
        ChainFamily::Dense
    } else {
        ChainFamily::Room
    };
    prop_oneof![
        3 => Just(ChainFamily::Dense),
        2 => Just(ChainFamily::Sparse),
        2 => Just(ChainFamily::Decomposable),
        2 => Just(ChainFamily::Spread),
        1 => Just(of_the_last),
    ]
}

fn division_family() -> impl Strategy<Value = DivisionFamily> {
    prop_oneof![
        2 => Just(DivisionFamily::Free),
        1 => Just(DivisionFamily::Equal),
        2 => Just(DivisionFamily::Lopsided),
        2 => Just(DivisionFamily::WithEmpty),
        2 => Just(DivisionFamily::NearlyProportional),
        1 => Just(DivisionFamily::Proportional),
    ]
}
