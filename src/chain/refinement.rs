//! States divided into sub-states, with the hypotheses of Theorem 1 checked.
//!
//! A refinement is a refined chain and, for each of its states, the coarse state it is a part of.
//! With `J′` the refined joint matrix the theorem's hypotheses read
//!
//! ```text
//!   (a)  w_ik P_ik,j = w_j P_j,ik       J′ is symmetric: it is a reversible chain
//!   (b)  P_ji = Σ_k P_j,ik              Σ_{k ∈ i, l ∈ j} J′_kl = J_ij for all i, j, also for j = i
//! ```
//!
//! From these `w_i = Σ_k w_ik` follows. Any number of states may be divided at once, into any
//! number of sub-states, and refinements can be chained.

use super::error::ChainError;
use super::reversible::ReversibleChain;
use crate::numeric::{compensated_sum, tolerance};
use nalgebra::DMatrix;
use std::fmt;

/// A reversible chain, a refinement of it, and for each refined state the state it is a part of.
#[derive(Clone, PartialEq)]
pub struct Refinement {
    coarse: ReversibleChain,
    refined: ReversibleChain,
    parents: Vec<usize>,
}

impl Refinement {
    /// Checks that `refined` refines `coarse`, state `k` of the first being a part of state
    /// `parents[k]` of the second, both in the same scale.
    ///
    /// # Errors
    /// [`ChainError::WrongShape`], [`ChainError::NoSuchState`];
    /// [`ChainError::NotCovering`] where the sum over the parts is off by more than
    /// [`tolerance::RECIPROCITY`] times their number, relative to the entry (hypothesis (b)).
    /// Hypothesis (a) is checked where `refined` is made: [`ChainError::NotReciprocal`].
    pub fn try_new(
        coarse: ReversibleChain,
        refined: ReversibleChain,
        parents: Vec<usize>,
    ) -> Result<Self, ChainError> {
        let n = coarse.states();
        let (sums, counts) = lumped(&refined, &parents, n)?;
        for state in 0..n {
            for other in 0..=state {
                let (parts, whole) = (sums[(state, other)], coarse.joint()[(state, other)]);
                #[allow(clippy::cast_precision_loss, reason = "no state has 2^53 parts")]
                let allowed = tolerance::RECIPROCITY * (counts[state] * counts[other]) as f64;
                if (parts - whole).abs() > allowed * whole {
                    // the error names the divided one of the two, which is the one to mend
                    let (state, other) = if counts[state] > 1 {
                        (state, other)
                    } else {
                        (other, state)
                    };
                    return Err(ChainError::NotCovering {
                        state,
                        other,
                        parts,
                        whole,
                    });
                }
            }
        }
        Ok(Self {
            coarse,
            refined,
            parents,
        })
    }

    /// The refinement whose coarse chain is `refined` with the parts of each state put together:
    /// state `k` becomes a part of state `parents[k]`.
    ///
    /// # Errors
    /// [`ChainError::WrongShape`] unless there is a parent for every state and a part for every
    /// parent from 0 up.
    ///
    /// # Examples
    /// ```
    /// use infoscene::chain::{Refinement, ReversibleChain};
    /// use infoscene::information::{mutual_information, refinement_gain};
    /// use nalgebra::dmatrix;
    /// let joint = dmatrix![0.0, 1.0, 1.0; 1.0, 0.0, 1.0; 1.0, 1.0, 0.0];
    /// let three = ReversibleChain::try_new(joint)?;
    /// let refinement = Refinement::coarsening(three, vec![0, 1, 1])?;
    /// let [after, before] = [refinement.refined(), refinement.coarse()].map(mutual_information);
    /// assert!((refinement_gain(&refinement) - (after - before)).abs() < 1e-15);
    /// # Ok::<(), infoscene::chain::ChainError>(())
    /// ```
    pub fn coarsening(refined: ReversibleChain, parents: Vec<usize>) -> Result<Self, ChainError> {
        if let Some(state) = parents
            .iter()
            .copied()
            .find(|parent| *parent >= parents.len())
        {
            return Err(ChainError::NoSuchState {
                state,
                last: parents.len() - 1,
            });
        }
        let n = parents.iter().max().map_or(0, |most| most + 1);
        let (sums, _) = lumped(&refined, &parents, n)?;
        Ok(Self {
            coarse: ReversibleChain::try_new(sums)?,
            refined,
            parents,
        })
    }

    /// The refinement that divides one state of `chain` into as many sub-states as `outward` has
    /// rows.
    ///
    /// The input is that of the theorem; sub-state 0 takes the state's place, the others follow at
    /// the end. Only tests use it, to state the theorem as printed;
    /// [`coarsening`](Self::coarsening) makes every refinement.
    ///
    /// **Arguments** `outward`: m × n, entry `(k, j)` is `w_ik P_ik,j`; the column of the state
    /// itself is not read. `within`: m × m, entry `(k, l)` is `w_ik P_ik,il`. Both in the chain's
    /// own scale.
    ///
    /// # Errors
    /// [`ChainError::NoSuchState`], [`ChainError::WrongShape`], [`ChainError::InvalidEntry`];
    /// [`ChainError::NotReciprocal`] where `within` is not symmetric (hypothesis (a));
    /// [`ChainError::NotCovering`] (hypothesis (b)).
    pub fn of_state(
        chain: &ReversibleChain,
        state: usize,
        outward: &DMatrix<f64>,
        within: &DMatrix<f64>,
    ) -> Result<Self, ChainError> {
        let (n, m) = (chain.states(), outward.nrows());
        if state >= n {
            return Err(ChainError::NoSuchState { state, last: n - 1 });
        }
        for (what, matrix, expected) in [
            ("the list of sub-states", outward, (m.max(1), n)),
            ("the sub-states' inner matrix", within, (m, m)),
        ] {
            if matrix.shape() != expected {
                let (found, expected) = (matrix.len(), expected.0 * expected.1);
                return Err(ChainError::WrongShape {
                    what,
                    found,
                    expected,
                });
            }
        }
        let sub_state = |index: usize| match index {
            _ if index == state => Some(0),
            _ if index >= n => Some(index - n + 1),
            _ => None,
        };
        let size = n + m - 1;
        let refined =
            ReversibleChain::try_new(DMatrix::from_fn(size, size, |row, column| {
                match (sub_state(row), sub_state(column)) {
                    (None, None) => chain.joint()[(row, column)],
                    (Some(k), None) => outward[(k, column)],
                    (None, Some(k)) => outward[(k, row)],
                    (Some(k), Some(l)) => within[(k, l)],
                }
            }))?;
        let parents = (0..size)
            .map(|index| if index < n { index } else { state })
            .collect();
        Self::try_new(chain.clone(), refined, parents)
    }

    /// The refinement of this one by a further refinement of its refined chain.
    ///
    /// # Errors
    /// [`ChainError::WrongShape`] unless `next` refines as many states as this one has made;
    /// [`ChainError::NotCovering`] unless it refines the same chain.
    pub fn then(&self, next: &Self) -> Result<Self, ChainError> {
        let (found, expected) = (next.coarse.states(), self.refined.states());
        if found != expected {
            return Err(ChainError::WrongShape {
                what: "the further refinement",
                found,
                expected,
            });
        }
        let parents = next
            .parents
            .iter()
            .map(|parent| self.parents[*parent])
            .collect();
        Self::try_new(self.coarse.clone(), next.refined.clone(), parents)
    }

    /// The chain before the refinement.
    #[must_use]
    pub const fn coarse(&self) -> &ReversibleChain {
        &self.coarse
    }

    /// The chain after the refinement.
    #[must_use]
    pub const fn refined(&self) -> &ReversibleChain {
        &self.refined
    }

    /// The coarse state that each state of the refined chain is a part of.
    #[must_use]
    pub fn parents(&self) -> &[usize] {
        &self.parents
    }

    /// The parts of each coarse state, in order.
    #[must_use]
    pub fn parts(&self) -> Vec<Vec<usize>> {
        let mut parts = vec![Vec::new(); self.coarse.states()];
        for (part, parent) in self.parents.iter().enumerate() {
            parts[*parent].push(part);
        }
        parts
    }
}

/// The joint matrix of `refined` summed over the parts of each of `n` states, and the numbers of
/// parts.
fn lumped(
    refined: &ReversibleChain,
    parents: &[usize],
    n: usize,
) -> Result<(DMatrix<f64>, Vec<usize>), ChainError> {
    let (found, expected) = (parents.len(), refined.states());
    if found != expected {
        return Err(ChainError::WrongShape {
            what: "the list of parents",
            found,
            expected,
        });
    }
    let mut counts = vec![0; n];
    for parent in parents {
        match counts.get_mut(*parent) {
            Some(count) => *count += 1,
            None => {
                return Err(ChainError::NoSuchState {
                    state: *parent,
                    last: n - 1,
                });
            }
        }
    }
    if let Some(state) = counts.iter().position(|count| *count == 0) {
        return Err(ChainError::NoPart { state });
    }
    let mut terms = vec![Vec::new(); n * n];
    for (l, column) in refined.joint().column_iter().enumerate() {
        for (k, entry) in column.iter().enumerate().filter(|(_, entry)| **entry > 0.0) {
            let (i, j) = (parents[k].max(parents[l]), parents[k].min(parents[l]));
            terms[i * n + j].push(*entry);
        }
    }
    let sums = DMatrix::from_fn(n, n, |row, column| {
        let (i, j) = (row.max(column), row.min(column));
        let sum = compensated_sum(terms[i * n + j].iter().copied());
        // entries off the diagonal blocks were met from both sides
        if i == j { sum } else { 0.5 * sum }
    });
    Ok((sums, counts))
}

/// The debug text is Rust source that makes the refinement again.
impl fmt::Debug for Refinement {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(formatter, "Refinement::coarsening(")?;
        writeln!(
            formatter,
            "    ReversibleChain::try_new(nalgebra::dmatrix!["
        )?;
        let rows: Vec<String> = self
            .refined
            .joint()
            .row_iter()
            .map(|row| {
                row.iter()
                    .map(|entry| format!("{entry:?}"))
                    .collect::<Vec<_>>()
                    .join(", ")
            })
            .collect();
        writeln!(formatter, "        {}", rows.join(";\n        "))?;
        writeln!(formatter, "    ])?,")?;
        writeln!(formatter, "    vec!{:?},", self.parents)?;
        write!(formatter, ")?")
    }
}
