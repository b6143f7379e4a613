//! A reversible chain, stored as its symmetric joint matrix.
//!
//! ```text
//!   J_ij = w_i P_ij = J_ji,     w_i = Σ_j J_ij,     P_ij = J_ij / w_i
//! ```
//!
//! The total Σ J need not be one; every measure divides by it.

use super::error::ChainError;
use crate::numeric::{compensated_sum, real, tolerance};
use nalgebra::DMatrix;

/// A reversible Markov chain on `n` states.
#[derive(Debug, Clone, PartialEq)]
pub struct ReversibleChain {
    joint: DMatrix<f64>,
    weights: Vec<f64>,
    total: f64,
}

impl ReversibleChain {
    /// The chain with this joint matrix, in any one scale.
    ///
    /// # Errors
    /// [`ChainError::Empty`], [`ChainError::NotSquare`], [`ChainError::InvalidEntry`],
    /// [`ChainError::NotReciprocal`] unless the matrix equals its transpose exactly,
    /// [`ChainError::NoMass`].
    ///
    /// # Examples
    /// ```
    /// use infoscene::chain::ReversibleChain;
    /// use nalgebra::dmatrix;
    /// let chain = ReversibleChain::try_new(dmatrix![1.0, 3.0; 3.0, 1.0])?;
    /// assert_eq!(chain.stationary_probability(0), 0.5);
    /// assert_eq!(chain.transition_probability(0, 1), 0.75);
    /// # Ok::<(), infoscene::chain::ChainError>(())
    /// ```
    pub fn try_new(joint: DMatrix<f64>) -> Result<Self, ChainError> {
        let (rows, columns) = joint.shape();
        if rows != columns {
            return Err(ChainError::NotSquare { rows, columns });
        }
        if rows == 0 {
            return Err(ChainError::Empty);
        }
        for column in 0..columns {
            for row in 0..=column {
                let (value, mirrored) = (joint[(row, column)], joint[(column, row)]);
                for (row, column, value) in [(row, column, value), (column, row, mirrored)] {
                    if !(value.is_finite() && value >= 0.0) {
                        return Err(ChainError::InvalidEntry { row, column, value });
                    }
                }
                if value.to_bits() != mirrored.to_bits() && (value - mirrored).abs() > 0.0 {
                    return Err(ChainError::NotReciprocal {
                        row,
                        column,
                        value,
                        mirrored,
                    });
                }
            }
        }
        // by symmetry a row sum is a column sum, and columns are contiguous
        let weights: Vec<f64> = joint
            .column_iter()
            .map(|column| compensated_sum(column.iter().copied()))
            .collect();
        let total = compensated_sum(weights.iter().copied());
        if !(total.is_finite() && total > 0.0) {
            return Err(ChainError::NoMass { total });
        }
        Ok(Self {
            joint,
            weights,
            total,
        })
    }

    /// The chain with stationary weights `w` (in any scale) and transition probabilities `P`.
    ///
    /// # Errors
    /// As [`try_new`](Self::try_new); [`ChainError::InvalidWeight`]; [`ChainError::RowSumNotOne`]
    /// beyond n·16 ε; [`ChainError::Underflow`] where a product `w_i P_ij` leaves `f64`'s normal
    /// range; [`ChainError::NotReciprocal`] where `w_i P_ij` and `w_j P_ji` differ by more than
    /// [`tolerance::RECIPROCITY`] of the larger; their mean is stored otherwise.
    pub fn try_from_transitions(
        weights: &[f64],
        transitions: &DMatrix<f64>,
    ) -> Result<Self, ChainError> {
        let (rows, columns) = transitions.shape();
        if rows != columns {
            return Err(ChainError::NotSquare { rows, columns });
        }
        if weights.len() != rows {
            let (found, expected) = (weights.len(), rows);
            return Err(ChainError::WrongShape {
                what: "the weight vector",
                found,
                expected,
            });
        }
        let tolerance = tolerance::RECIPROCITY * real(rows);
        for (row, entries) in transitions.row_iter().enumerate() {
            let sum = compensated_sum(entries.iter().copied());
            if (sum - 1.0).abs() > tolerance {
                return Err(ChainError::RowSumNotOne {
                    row,
                    sum,
                    tolerance,
                });
            }
        }
        if let Some(state) = weights
            .iter()
            .position(|weight| !(weight.is_finite() && *weight >= 0.0))
        {
            return Err(ChainError::InvalidWeight {
                state,
                value: weights[state],
            });
        }
        check_flows(weights, transitions)?;
        let flow = |row: usize, column: usize| weights[row] * transitions[(row, column)];
        Self::try_new(DMatrix::from_fn(rows, rows, |row, column| {
            let (value, mirrored) = (
                flow(row.min(column), row.max(column)),
                flow(row.max(column), row.min(column)),
            );
            value + 0.5 * (mirrored - value)
        }))
    }

    /// The number of states.
    #[must_use]
    pub fn states(&self) -> usize {
        self.weights.len()
    }

    /// The joint matrix, as it was given.
    #[must_use]
    pub const fn joint(&self) -> &DMatrix<f64> {
        &self.joint
    }

    /// The row sums of the joint matrix: the stationary distribution times [`total`](Self::total).
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The sum of all joint entries.
    #[must_use]
    pub const fn total(&self) -> f64 {
        self.total
    }

    /// The stationary probability `w_i` of state i; these sum to one.
    ///
    /// # Panics
    /// If there is no state `i`.
    #[must_use]
    pub fn stationary_probability(&self, i: usize) -> f64 {
        self.weights[i] / self.total
    }

    /// The transition probability `P_ij`; 0 from a state of no weight.
    ///
    /// # Panics
    /// If there is no state `i` or `j`.
    #[must_use]
    pub fn transition_probability(&self, i: usize, j: usize) -> f64 {
        if self.weights[i] > 0.0 {
            self.joint[(i, j)] / self.weights[i]
        } else {
            0.0
        }
    }
}

/// Checks that the flows `w_i P_ij` are in range, and equal to `w_j P_ji`.
fn check_flows(weights: &[f64], transitions: &DMatrix<f64>) -> Result<(), ChainError> {
    let rows = weights.len();
    let flow = |row: usize, column: usize| weights[row] * transitions[(row, column)];
    for row in 0..rows {
        for column in 0..rows {
            let (value, mirrored) = (flow(row, column), flow(column, row));
            let factors = [weights[row], transitions[(row, column)]];
            if factors.iter().all(|factor| *factor > 0.0) && value < f64::MIN_POSITIVE {
                return Err(ChainError::Underflow { row, column });
            }
            if (value - mirrored).abs() > tolerance::RECIPROCITY * value.abs().max(mirrored.abs()) {
                return Err(ChainError::NotReciprocal {
                    row,
                    column,
                    value,
                    mirrored,
                });
            }
        }
    }
    Ok(())
}
