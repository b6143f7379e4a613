//! Random reversible chains and refinements, valid by construction, the same for the same seed.
//!
//! A symmetric matrix of non-negative entries is a reversible chain; distributing each entry of a
//! state's row over its sub-states is a refinement that fulfils the hypotheses of Theorem 1.
//!
//! **Not covered**: aiming at the hard spots of floating point.

use super::{ChainError, ReversibleChain, StateRefinement};
use nalgebra::DMatrix;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A source of random chains.
#[derive(Debug, Clone)]
pub struct RandomChains {
    source: ChaCha8Rng,
}

impl RandomChains {
    /// The source with this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self {
            source: ChaCha8Rng::seed_from_u64(seed),
        }
    }

    /// A chain of 2 to `most` states in which about one entry in five is zero.
    ///
    /// # Errors
    /// None that is known: entries are finite, symmetric and not all zero.
    pub fn chain(&mut self, most: usize) -> Result<ReversibleChain, ChainError> {
        let n = self.source.random_range(2..=most.max(2));
        let mut joint = DMatrix::zeros(n, n);
        for row in 0..n {
            for column in 0..=row {
                let entry = self.entry();
                joint[(row, column)] = entry;
                joint[(column, row)] = entry;
            }
        }
        joint[(0, n - 1)] = 1.0; // never all zero
        joint[(n - 1, 0)] = 1.0;
        ReversibleChain::try_new(joint)
    }

    /// A random state of the chain, divided into 2 to `most` sub-states.
    ///
    /// # Errors
    /// [`ChainError::NotCovering`] if rounding broke the cover, which the tolerance excludes.
    pub fn refinement(
        &mut self,
        chain: &ReversibleChain,
        most: usize,
    ) -> Result<StateRefinement, ChainError> {
        let n = chain.states();
        let m = self.source.random_range(2..=most.max(2));
        let state = self.source.random_range(0..n);
        let mut outward = DMatrix::zeros(m, n);
        for j in (0..n).filter(|j| *j != state) {
            let shares = self.shares(m);
            for (k, share) in shares.iter().enumerate() {
                outward[(k, j)] = share * chain.joint()[(state, j)];
            }
        }
        let mut within = DMatrix::zeros(m, m);
        let pairs: Vec<(usize, usize)> =
            (0..m).flat_map(|k| (0..=k).map(move |l| (k, l))).collect();
        for ((k, l), share) in pairs.iter().zip(self.shares(pairs.len())) {
            let part = share * chain.joint()[(state, state)];
            let part = if k == l { part } else { 0.5 * part };
            within[(*k, *l)] = part;
            within[(*l, *k)] = part;
        }
        StateRefinement::try_new(chain, state, outward, within)
    }

    fn entry(&mut self) -> f64 {
        if self.source.random_bool(0.2) {
            0.0
        } else {
            self.source.random_range(0.0..1.0)
        }
    }

    fn shares(&mut self, count: usize) -> Vec<f64> {
        let mut shares: Vec<f64> = (0..count).map(|_| self.entry()).collect();
        shares[0] += 1e-3; // never all zero
        let sum: f64 = shares.iter().sum();
        shares.iter().map(|share| share / sum).collect()
    }
}
