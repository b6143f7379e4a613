//! A store that is read: the exchange areas of a scene below the diagonal, block by block.
//!
//! ```text
//!   J_ij = A_i F_ij,   |J_ij − J*_ij| ≤ A_i b_ij (1 + 4 ε)        j < i, from the chunk of row i
//! ```
//!
//! A pair is read once, so that the exchange areas are symmetric exactly. F is a rounded quotient
//! by `A_i`, and what it is multiplied by is the same number: J is off the exchange area that was
//! computed by ε J at most, and b includes 4 ε F for the area. The factor is for the rounding of
//! the product.
//!
//! **Memory** that of a block a thread ([`LowerBlocks`]).

use super::chunk::{Chunks, of_doubles, of_singles};
use super::identity::Identity;
use super::{StoreError, side_of};
use crate::exchange::blocks::LowerBlocks;
use crate::exchange::plan::facing::Facing;
use crate::exchange::ranks::Ranks;
use crate::exchange::{Congruence, ExchangeError, ScenePairs};
use crate::form_factor::ExchangeArea;
use crate::numeric::entries_of;
use crate::scene::{Occlusion, Scene};
use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;

/// The rounding of a bound's product with an area.
const ROUNDED: f64 = 1.0 + 4.0 * f64::EPSILON;

/// The matrix of a scene in a folder, all of it.
#[derive(Debug)]
pub struct StoredMatrix<'p> {
    pairs: &'p ScenePairs<'p>,
    side: usize,
    factors: Chunks,
    bounds: Chunks,
}

/// The exchange areas of a stored matrix, or the bounds on their errors.
#[derive(Debug, Clone, Copy)]
pub struct StoredBlocks<'s> {
    matrix: &'s StoredMatrix<'s>,
    are_bounds: bool,
}

impl<'p> StoredMatrix<'p> {
    /// The store of a scene's matrix, if it is that and whole.
    ///
    /// **Arguments** `pairs`: those of the scene, prepared in any way; `treatment`: that of
    /// congruent pairs and of what stands in the way, with which the matrix was stored.
    ///
    /// # Errors
    /// [`StoreError::NoStore`]; [`StoreError::OtherMatrix`]; [`StoreError::Incomplete`];
    /// [`StoreError::Io`].
    pub fn open(
        folder: &Path,
        scene: &Scene,
        pairs: &'p ScenePairs<'p>,
        treatment: (Congruence, Occlusion),
    ) -> Result<Self, StoreError> {
        let rows = pairs.rows();
        let side = side_of(rows);
        Identity::of(scene, (rows, side), pairs.tolerance(), treatment).require(folder)?;
        let [factors, bounds] = Chunks::of_matrix(folder, side);
        let chunks = rows.div_ceil(side);
        let places = (0..chunks).flat_map(|i| (0..chunks).map(move |j| [i, j]));
        let is_there = |place: &[usize; 2]| factors.is_whole(place) && bounds.is_whole(place);
        let missing = places.filter(|place| !is_there(place)).count();
        if missing > 0 {
            return Err(StoreError::Incomplete {
                folder: folder.to_owned(),
                missing,
                chunks: chunks * chunks,
            });
        }
        Ok(Self {
            pairs,
            side,
            factors,
            bounds,
        })
    }

    /// Rows along a chunk.
    pub(super) const fn side(&self) -> usize {
        self.side
    }

    /// Chunks along a side of the matrix.
    pub(super) fn chunks(&self) -> usize {
        self.pairs.rows().div_ceil(self.side)
    }

    /// The rows of a chunk.
    pub(super) fn rows_of(&self, chunk: usize) -> Range<usize> {
        let start = chunk * self.side;
        start..(start + self.side).min(self.pairs.rows())
    }

    /// The pairs of the scene.
    #[must_use]
    pub const fn pairs(&self) -> &'p ScenePairs<'p> {
        self.pairs
    }

    /// The exchange areas off the diagonal.
    #[must_use]
    pub const fn values(&self) -> StoredBlocks<'_> {
        StoredBlocks {
            matrix: self,
            are_bounds: false,
        }
    }

    /// The bounds on their errors.
    #[must_use]
    pub const fn error_bounds(&self) -> StoredBlocks<'_> {
        StoredBlocks {
            matrix: self,
            are_bounds: true,
        }
    }

    /// The exchange area of each row with itself.
    ///
    /// # Errors
    /// [`ExchangeError::Unread`].
    pub fn own(&self) -> Result<Vec<ExchangeArea>, ExchangeError> {
        let own = |row: usize| {
            if self.pairs.facing(row, row) != Facing::Visible {
                return Ok([0.0; 2]);
            }
            let one = |are_bounds| {
                let (chunk, at) = (row / self.side, row % self.side);
                let place = [chunk, chunk];
                let line = self.lines(place, at..at + 1, are_bounds)?;
                self.exchange(row, line[at], are_bounds)
            };
            Ok([one(false)?, one(true)?])
        };
        let rows = (0..self.pairs.rows()).map(own);
        rows.map(|own| own.map(|[value, error]| ExchangeArea { value, error }))
            .collect()
    }

    /// Lines of a chunk, as they are stored.
    pub(super) fn lines(
        &self,
        place: [usize; 2],
        lines: Range<usize>,
        are_bounds: bool,
    ) -> Result<Vec<f64>, ExchangeError> {
        let (chunks, size) = if are_bounds {
            (&self.bounds, 4)
        } else {
            (&self.factors, 8)
        };
        let [start, end] = [lines.start, lines.end].map(|line| line * self.side * size);
        let bytes = chunks.read_part(&place, start..end).map_err(unread)?;
        Ok(if are_bounds {
            of_singles(&bytes)
        } else {
            of_doubles(&bytes)
        })
    }

    /// The exchange area of a form factor from a row, or the bound of a bound.
    pub(super) fn exchange(
        &self,
        row: usize,
        stored: f64,
        is_bound: bool,
    ) -> Result<f64, ExchangeError> {
        if !(stored.is_finite() && stored >= 0.0) {
            let what = if is_bound { "bound" } else { "form factor" };
            return Err(ExchangeError::Unread {
                reason: format!("row {row} of the store has a {what} of {stored}: fill it anew"),
            });
        }
        let exchange = self.pairs.areas()[row] * stored;
        Ok(if is_bound {
            exchange * ROUNDED
        } else {
            exchange
        })
    }
}

impl LowerBlocks for StoredBlocks<'_> {
    fn order(&self) -> usize {
        self.matrix.pairs.rows()
    }

    fn ranks(&self) -> &dyn Ranks {
        self.matrix.pairs.ranks()
    }

    fn block(&self, _: usize, rows: Range<usize>) -> Result<Cow<'_, [f64]>, ExchangeError> {
        let (matrix, side) = (self.matrix, self.matrix.side);
        let mut entries = vec![0.0; entries_of(&rows)];
        let first = rows.start;
        for chunk in first / side..rows.end.div_ceil(side) {
            let above = chunk * side;
            let met = first.max(above)..rows.end.min(above + side);
            let lines = met.start - above..met.end - above;
            for column in 0..=chunk {
                let found = matrix.lines([chunk, column], lines.clone(), self.are_bounds)?;
                let left = column * side;
                for (row, line) in met.clone().zip(found.chunks_exact(side)) {
                    let start = entries_of(&(first..row)) + left;
                    // left of the diagonal
                    let line = &line[..side.min(row.saturating_sub(left))];
                    for (entry, stored) in entries[start..].iter_mut().zip(line) {
                        *entry = matrix.exchange(row, *stored, self.are_bounds)?;
                    }
                }
            }
        }
        Ok(Cow::Owned(entries))
    }
}

/// A store that cannot be read, as the error of an exchange.
pub(crate) fn unread(error: StoreError) -> ExchangeError {
    match error {
        StoreError::Exchange(error) => error,
        error => ExchangeError::Unread {
            reason: error.to_string(),
        },
    }
}
