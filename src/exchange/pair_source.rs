//! The pairs of a scene, wherever they come from: one pass over them sums functions of each.

use super::{ExchangeError, LowerPairs, PassSummary, ScenePairs, StoredMatrix};
use crate::form_factor::ExchangeArea;

/// The pairs of a scene, computed, read from a store, or held.
#[derive(Clone, Copy)]
pub enum PairSource<'s> {
    /// They are computed.
    Computed(&'s ScenePairs<'s>),
    /// They are read.
    Stored(&'s StoredMatrix<'s>),
    /// They are held.
    Held(LowerPairs<'s>),
}

impl<'s> From<&'s ScenePairs<'_>> for PairSource<'s> {
    fn from(pairs: &'s ScenePairs<'_>) -> Self {
        Self::Computed(pairs)
    }
}

impl<'s> From<&'s StoredMatrix<'_>> for PairSource<'s> {
    fn from(matrix: &'s StoredMatrix<'_>) -> Self {
        Self::Stored(matrix)
    }
}

impl<'s> From<LowerPairs<'s>> for PairSource<'s> {
    fn from(held: LowerPairs<'s>) -> Self {
        Self::Held(held)
    }
}

impl<'s> PairSource<'s> {
    /// The pairs of the scene.
    #[must_use]
    pub const fn pairs(&self) -> &'s ScenePairs<'s> {
        match self {
            Self::Computed(pairs) => pairs,
            Self::Stored(matrix) => matrix.pairs(),
            Self::Held(held) => held.pairs,
        }
    }

    /// Sums over each row ([`ScenePairs::row_sums`]).
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused; [`ExchangeError::Unread`] if a store
    /// cannot be read.
    pub fn row_sums<const K: usize>(
        &self,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K] + Sync,
    ) -> Result<(Vec<[f64; K]>, PassSummary), ExchangeError> {
        match self {
            Self::Computed(pairs) => pairs.row_sums(term),
            Self::Stored(matrix) => matrix.row_sums(term),
            Self::Held(held) => held.row_sums(term),
        }
    }
}
