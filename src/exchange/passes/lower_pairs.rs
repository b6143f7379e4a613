//! Sums over the rows of pairs that are held below the diagonal, by one rank or several.
//!
//! **Memory** O(n) a block that is being summed, beside what is held.

use super::row_sums::{TileSums, sums_of_tiles};
use super::tiles::{Block, Tile};
use crate::exchange::blocks::LowerBlocks;
use crate::exchange::plan::counts::PassSummary;
use crate::exchange::plan::facing::Facing;
use crate::exchange::ranks::Deal;
use crate::exchange::{ExchangeError, ScenePairs};
use crate::form_factor::ExchangeArea;

/// The pairs of a scene whose exchange areas and bounds are held below the diagonal.
#[derive(Clone, Copy)]
pub struct LowerPairs<'s> {
    /// The pairs as they were asked for.
    pub pairs: &'s ScenePairs<'s>,
    /// The exchange areas.
    pub values: &'s dyn LowerBlocks,
    /// The bounds on their errors.
    pub bounds: &'s dyn LowerBlocks,
    /// The exchange area of each row with itself.
    pub own: &'s [ExchangeArea],
    /// The summary of the pass in which they were computed.
    pub summary: &'s PassSummary,
}

impl LowerPairs<'_> {
    /// `K` sums over each row, of terms that are the same for (i, j) and (j, i); terms are asked
    /// for as in [`ScenePairs::row_sums`].
    ///
    /// # Errors
    /// [`ExchangeError::Unread`] if blocks are stored and cannot be read; [`ExchangeError::Rank`].
    pub fn row_sums<const K: usize>(
        &self,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K] + Sync,
    ) -> Result<(Vec<[f64; K]>, PassSummary), ExchangeError> {
        let blocks = self.values.blocks();
        let bands = blocks.iter().map(|rows| {
            vec![Tile::of(Block {
                rows: rows.clone(),
                columns: 0..rows.end,
                is_visible: false,
            })]
        });
        let of_tile = |tile: &Tile| match blocks.iter().position(|rows| *rows == tile.block().rows)
        {
            Some(block) if !blocks[block].is_empty() => self.block_sums(block, tile, &term),
            _ => Ok(TileSums::none(tile)),
        };
        let deal = Deal::new(self.pairs.ranks(), self.pairs.rows());
        let (totals, _) = sums_of_tiles(&deal, bands, of_tile)?;
        Ok((totals, self.summary.clone()))
    }

    fn block_sums<const K: usize>(
        &self,
        block: usize,
        tile: &Tile,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K],
    ) -> Result<TileSums<K>, ExchangeError> {
        let rows = &tile.block().rows;
        let [values, bounds] =
            [self.values, self.bounds].map(|matrix| matrix.block(block, rows.clone()));
        let [values, bounds] = [values?, bounds?];
        let mut entries = values.iter().zip(bounds.iter());
        let mut sums = TileSums::none(tile);
        for row in rows.clone() {
            let left = entries.by_ref().take(row).enumerate();
            let left = left.map(|(column, (value, error))| {
                let [value, error] = [*value, *error];
                (column, ExchangeArea { value, error })
            });
            for (column, exchange) in left.chain([(row, self.own[row])]) {
                if self.pairs.facing(row, column) == Facing::Visible {
                    let place = [row - rows.start, column];
                    sums.add(place, row == column, term(row, column, &exchange));
                }
            }
        }
        Ok(sums)
    }
}
