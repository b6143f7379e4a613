//! The error of this room: input that is not a reversible chain, or not a refinement of one.

use crate::exchange::ExchangeError;
use crate::scene::SceneError;

/// A chain or a refinement was refused; the message names the entry.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ChainError {
    /// The matrix has no entries.
    #[error("a chain needs at least one state")]
    Empty,
    /// The matrix is not square.
    #[error("the matrix has {rows} rows and {columns} columns: it must be square")]
    NotSquare {
        /// Rows given.
        rows: usize,
        /// Columns given.
        columns: usize,
    },
    /// An entry is NaN, infinite or negative.
    #[error("entry ({row}, {column}) is {value}: it must be finite and ≥ 0")]
    InvalidEntry {
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// The value given.
        value: f64,
    },
    /// A weight is NaN, infinite or negative.
    #[error("weight {state} is {value}: it must be finite and ≥ 0")]
    InvalidWeight {
        /// The state, from 0.
        state: usize,
        /// The value given.
        value: f64,
    },
    /// A product of a weight and a transition probability is too small.
    #[error(
        "weight {row} times the probability of going to {column} leaves f64's normal range: \
         scale the weights up"
    )]
    Underflow {
        /// The state left.
        row: usize,
        /// The state entered.
        column: usize,
    },
    /// Two entries that must be equal are not: the chain is not reversible.
    #[error(
        "entry ({row}, {column}) is {value:e} and ({column}, {row}) is {mirrored:e}: \
         reciprocity w_i P_ij = w_j P_ji needs them equal"
    )]
    NotReciprocal {
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// Entry above.
        value: f64,
        /// Entry below.
        mirrored: f64,
    },
    /// All entries are zero, or their sum overflows.
    #[error("the entries sum to {total}: the total must be finite and > 0")]
    NoMass {
        /// Sum of all entries.
        total: f64,
    },
    /// A row of transition probabilities does not sum to one.
    #[error(
        "row {row} of the transition probabilities sums to {sum}, off by more than {tolerance:e}"
    )]
    RowSumNotOne {
        /// Row, from 0.
        row: usize,
        /// The sum of the row.
        sum: f64,
        /// The deviation from one that is accepted.
        tolerance: f64,
    },
    /// A state index is out of range.
    #[error("there is no state {state}: the chain has states 0 to {last}")]
    NoSuchState {
        /// The value given.
        state: usize,
        /// Largest index.
        last: usize,
    },
    /// The list of counts is empty.
    #[error("no pair of states was counted: an estimate needs samples")]
    NoSamples,
    /// A pair was counted that has no probability.
    #[error("the pair ({row}, {column}) was counted, but one of the two has weight 0")]
    ImpossiblePair {
        /// One state, from 0.
        row: usize,
        /// The other.
        column: usize,
    },
    /// A coarse state has no part in a refinement.
    #[error("state {state} has no part in the refined chain")]
    NoPart {
        /// The state without parts.
        state: usize,
    },
    /// Matrices of a refinement have the wrong shape.
    #[error("{what} has {found} entries, {expected} are needed")]
    WrongShape {
        /// The name of the matrix.
        what: &'static str,
        /// Entries found.
        found: usize,
        /// Entries needed.
        expected: usize,
    },
    /// Hypothesis (b) of Theorem 1 fails: the sub-states do not add up to the state.
    #[error(
        "the sub-states do not cover state {state}: towards state {other} they carry \
         {parts:e}, the state itself {whole:e} (hypothesis (b))"
    )]
    NotCovering {
        /// The refined state.
        state: usize,
        /// The state towards which the sums differ.
        other: usize,
        /// Sum over the sub-states.
        parts: f64,
        /// Entry of the state.
        whole: f64,
    },
    /// A scene was refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The exchange of a scene's rows was refused.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
}
