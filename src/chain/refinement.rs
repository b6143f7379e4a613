//! One state divided into sub-states, with the hypotheses of Theorem 1 checked.
//!
//! ```text
//!   (a)  w_ik P_ik,j = w_j P_j,ik       one number J_{ik,j} for both directions
//!   (b)  P_ji = Σ_k P_j,ik              Σ_k J_{ik,j} = J_ij for every j ≠ i
//! ```
//!
//! For the state itself, which the theorem's proof needs too, (b) reads
//! `Σ_kl J_{ik,il} = J_ii`. That `w_i = Σ_k w_ik` then follows.

use super::{ChainError, ReversibleChain};
use crate::numeric::{compensated_sum, tolerance};
use nalgebra::DMatrix;

/// A state of a chain, divided into `m` sub-states.
#[derive(Debug, Clone, PartialEq)]
pub struct StateRefinement {
    state: usize,
    outward: DMatrix<f64>,
    within: DMatrix<f64>,
    weights: Vec<f64>,
}

impl StateRefinement {
    /// Divides `state` of `chain` into as many sub-states as `outward` has rows.
    ///
    /// **Arguments** `outward`: m × n, entry `(k, j)` is `J_{ik,j}`, what sub-state `k` shares
    /// with state `j`; the column of the state itself must be zero. `within`: m × m, symmetric,
    /// entry `(k, l)` is `J_{ik,il}`. Both in the chain's own scale.
    ///
    /// # Errors
    /// [`ChainError::NoSuchState`], [`ChainError::WrongShape`], [`ChainError::InvalidEntry`];
    /// [`ChainError::NotReciprocal`] where `within` is not symmetric (hypothesis (a));
    /// [`ChainError::NotCovering`] where the sub-states' sum is off by more than
    /// m·[`tolerance::RECIPROCITY`] of the entry (hypothesis (b)).
    pub fn try_new(
        chain: &ReversibleChain,
        state: usize,
        outward: DMatrix<f64>,
        within: DMatrix<f64>,
    ) -> Result<Self, ChainError> {
        let n = chain.states();
        if state >= n {
            return Err(ChainError::NoSuchState { state, last: n - 1 });
        }
        let m = outward.nrows();
        let shape = |what, found, expected| {
            Err(ChainError::WrongShape {
                what,
                found,
                expected,
            })
        };
        if m == 0 {
            return shape("the list of sub-states", 0, 1);
        }
        if outward.ncols() != n {
            return shape("the sub-states' outward matrix", outward.len(), m * n);
        }
        if within.shape() != (m, m) {
            return shape("the sub-states' inner matrix", within.len(), m * m);
        }
        for matrix in [&outward, &within] {
            for column in 0..matrix.ncols() {
                for row in 0..m {
                    let value = matrix[(row, column)];
                    if !(value.is_finite() && value >= 0.0) {
                        return Err(ChainError::InvalidEntry { row, column, value });
                    }
                }
            }
        }
        for row in 0..m {
            for column in 0..row {
                let (value, mirrored) = (within[(row, column)], within[(column, row)]);
                if (value - mirrored).abs() > 0.0 {
                    return Err(ChainError::NotReciprocal {
                        row,
                        column,
                        value,
                        mirrored,
                    });
                }
            }
        }
        #[allow(clippy::cast_precision_loss, reason = "no state has 2^53 sub-states")]
        let allowed = tolerance::RECIPROCITY * m as f64;
        for other in 0..n {
            let (parts, whole) = if other == state {
                (
                    compensated_sum(within.iter().copied()),
                    chain.joint()[(state, state)],
                )
            } else {
                (
                    compensated_sum(outward.column(other).iter().copied()),
                    chain.joint()[(state, other)],
                )
            };
            if (parts - whole).abs() > allowed * whole {
                return Err(ChainError::NotCovering {
                    state,
                    other,
                    parts,
                    whole,
                });
            }
        }
        if let Some(row) = (0..m).find(|k| outward[(*k, state)] > 0.0) {
            let value = outward[(row, state)];
            return Err(ChainError::InvalidEntry {
                row,
                column: state,
                value,
            });
        }
        let weights = (0..m)
            .map(|k| compensated_sum(outward.row(k).iter().chain(within.row(k).iter()).copied()))
            .collect();
        Ok(Self {
            state,
            outward,
            within,
            weights,
        })
    }

    /// The state that is divided.
    #[must_use]
    pub const fn state(&self) -> usize {
        self.state
    }

    /// `J_{ik,j}`: m × n, zero in the column of the state itself.
    #[must_use]
    pub const fn outward(&self) -> &DMatrix<f64> {
        &self.outward
    }

    /// `J_{ik,il}`: m × m.
    #[must_use]
    pub const fn within(&self) -> &DMatrix<f64> {
        &self.within
    }

    /// The sub-states' weights `w_ik`, in the chain's scale.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The refined chain: sub-state 0 takes the state's place, the others follow at the end.
    ///
    /// # Errors
    /// [`ChainError::NoMass`] if nothing is left of a chain whose total was at the edge of `f64`.
    pub fn refined(&self, chain: &ReversibleChain) -> Result<ReversibleChain, ChainError> {
        let n = chain.states();
        let sub_state = |index: usize| match index {
            _ if index == self.state => Some(0),
            _ if index >= n => Some(index - n + 1),
            _ => None,
        };
        let size = n + self.weights.len() - 1;
        ReversibleChain::try_new(DMatrix::from_fn(size, size, |row, column| {
            match (sub_state(row), sub_state(column)) {
                (None, None) => chain.joint()[(row, column)],
                (Some(k), None) => self.outward[(k, column)],
                (None, Some(k)) => self.outward[(k, row)],
                (Some(k), Some(l)) => self.within[(k, l)],
            }
        }))
    }
}
