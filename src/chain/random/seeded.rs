//! Random refinements from a seed, the same on every machine.

use super::families::{ChainFamily, DivisionFamily, RefinementDraw};
use crate::chain::error::ChainError;
use crate::chain::refinement::Refinement;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A source of random refinements of dense and sparse chains, states divided at will.
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

    /// A chain of 2 to `most` states whose first state is divided into 2 to 4 parts.
    ///
    /// # Errors
    /// No case is known: see [`RefinementDraw::refinement`].
    pub fn refinement(&mut self, most: usize) -> Result<Refinement, ChainError> {
        let chain = if self.source.random() {
            ChainFamily::Dense
        } else {
            ChainFamily::Sparse
        };
        RefinementDraw {
            chain,
            division: DivisionFamily::Free,
            states: self.source.random_range(2..=most.max(2)),
            parts: vec![self.source.random_range(2..=4)],
            bytes: (0..160).map(|_| self.source.random()).collect(),
        }
        .refinement()
    }

    /// `count` numbers from 0 to 1, about one in five of them 0, the first never.
    pub fn numbers(&mut self, count: usize) -> Vec<f64> {
        let mut numbers: Vec<f64> = (0..count)
            .map(|_| {
                if self.source.random_bool(0.2) {
                    0.0
                } else {
                    self.source.random()
                }
            })
            .collect();
        if let Some(first) = numbers.first_mut() {
            *first = 1.0 - self.source.random::<f64>(); // in (0, 1]
        }
        numbers
    }

    /// A whole number from `least` to `most`, both included.
    pub fn count(&mut self, least: usize, most: usize) -> usize {
        debug_assert!(least <= most, "{least} to {most}");
        self.source.random_range(least..=most.max(least))
    }
}
