//! Sums over the rows of a stored matrix: one pass over the half of its files below the diagonal.
//!
//! A tile is the rows of one chunk with those of another; as in
//! [`ScenePairs::row_sums`](crate::exchange::ScenePairs::row_sums) each is summed on its own, and
//! sums of tiles are added up in their order.
//!
//! **Memory** O(n) and `40 side²` bytes a thread.

use super::stored::StoredMatrix;
use crate::exchange::passes::row_sums::sums_of_tiles;
use crate::exchange::passes::tiles::Block;
use crate::exchange::plan::facing::Facing;
use crate::exchange::ranks::Deal;
use crate::exchange::{ExchangeError, PassCounts, PassSummary, Tile, TileSums};
use crate::form_factor::ExchangeArea;

impl StoredMatrix<'_> {
    /// `K` sums over each row, of terms that are the same for (i, j) and (j, i); terms are asked
    /// for as in [`ScenePairs::row_sums`](crate::exchange::ScenePairs::row_sums).
    ///
    /// # Errors
    /// [`ExchangeError::Unread`].
    pub fn row_sums<const K: usize>(
        &self,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K] + Sync,
    ) -> Result<(Vec<[f64; K]>, PassSummary), ExchangeError> {
        let pairs = self.pairs();
        let chunks = self.chunks();
        let bands = (0..chunks).map(|first| {
            let tile = |second| {
                Tile::of(Block {
                    rows: self.rows_of(second),
                    columns: self.rows_of(first),
                    is_visible: false,
                })
            };
            (first..chunks).map(tile).collect()
        });
        let of_tile = |tile: &Tile| {
            let sums = self.tile_sums(tile, &term);
            pairs.advance(tile.pairs());
            sums
        };
        let deal = Deal::new(pairs.ranks(), pairs.rows());
        let (totals, counts) = sums_of_tiles(&deal, bands, of_tile)?;
        debug_assert_eq!(counts, PassCounts::default(), "nothing was computed");
        Ok((totals, self.summary()))
    }

    fn tile_sums<const K: usize>(
        &self,
        tile: &Tile,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K],
    ) -> Result<TileSums<K>, ExchangeError> {
        let Block { rows, columns, .. } = tile.block();
        let place = [rows.start, columns.start].map(|row| row / self.side());
        let [values, bounds] =
            [false, true].map(|are_bounds| self.lines(place, 0..rows.len(), are_bounds));
        let [values, bounds] = [values?, bounds?];
        let mut sums = TileSums::none(tile);
        for row in rows.clone() {
            // on the diagonal, each pair once
            for column in columns.start..columns.end.min(row + 1) {
                if self.pairs().facing(row, column) != Facing::Visible {
                    continue;
                }
                let [r, c] = [row - rows.start, column - columns.start];
                let at = r * self.side() + c;
                let exchange = ExchangeArea {
                    value: self.exchange(row, values[at], false)?,
                    error: self.exchange(row, bounds[at], true)?,
                };
                sums.add([r, c], row == column, term(row, column, &exchange));
            }
        }
        Ok(sums)
    }

    /// The summary of a pass over a stored matrix: pairs that miss the tolerance were told when it
    /// was stored.
    pub(crate) fn summary(&self) -> PassSummary {
        let mut summary = self.pairs().summary(PassCounts::default());
        let plan = &mut summary.plan;
        plan.stored = plan.pairs - plan.untouched;
        plan.occlusion = None;
        plan.ignored = None;
        summary
    }
}
