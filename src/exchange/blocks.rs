//! Symmetric matrices below their diagonals, in blocks of consecutive rows: held, shared out among
//! ranks, or stored.
//!
//! A block has about so many entries as any other, and is read as one piece: row after row, each
//! left of the diagonal. The blocks depend on the number of rows alone, so that sums over blocks
//! that are added up in their order have the same bits for any number of threads and ranks, and
//! wherever the entries are.

use super::ExchangeError;
use super::ranks::{Alone, Ranks};
use crate::numeric::{Symmetric, row_blocks};
use std::borrow::Cow;
use std::ops::Range;

/// Blocks of a small matrix.
const FEWEST: usize = 16;

/// Entries of a block of a large one: 32 MB.
const MOST_ENTRIES: usize = 1 << 22;

/// A symmetric matrix that is read below its diagonal, block by block.
pub trait LowerBlocks: Sync {
    /// Number of rows.
    fn order(&self) -> usize;

    /// The ranks that the blocks are dealt out to, block k to rank `k mod N`.
    fn ranks(&self) -> &dyn Ranks {
        &Alone
    }

    /// The rows of each block.
    fn blocks(&self) -> Vec<Range<usize>> {
        let entries = self.order() * self.order().saturating_sub(1) / 2;
        let count = entries.div_ceil(MOST_ENTRIES).max(FEWEST);
        row_blocks(self.order(), count).collect()
    }

    /// The entries of a block's rows left of the diagonal, row after row; a block of this rank.
    ///
    /// # Errors
    /// [`ExchangeError::Unread`] if they are stored and cannot be read.
    fn block(&self, block: usize, rows: Range<usize>) -> Result<Cow<'_, [f64]>, ExchangeError>;
}

impl LowerBlocks for Symmetric<f64> {
    fn order(&self) -> usize {
        Self::order(self)
    }

    fn block(&self, _: usize, rows: Range<usize>) -> Result<Cow<'_, [f64]>, ExchangeError> {
        Ok(Cow::Borrowed(self.rows(rows)))
    }
}

/// A matrix of which each rank holds its blocks.
#[derive(Clone)]
pub struct HeldBlocks<'p> {
    order: usize,
    ranks: &'p dyn Ranks,
    blocks: Vec<Vec<f64>>,
}

impl<'p> HeldBlocks<'p> {
    /// The matrix of this order whose blocks this rank holds, in their order.
    pub(crate) const fn new(order: usize, ranks: &'p dyn Ranks, blocks: Vec<Vec<f64>>) -> Self {
        Self {
            order,
            ranks,
            blocks,
        }
    }
}

impl LowerBlocks for HeldBlocks<'_> {
    fn order(&self) -> usize {
        self.order
    }

    fn ranks(&self) -> &dyn Ranks {
        self.ranks
    }

    fn block(&self, block: usize, _: Range<usize>) -> Result<Cow<'_, [f64]>, ExchangeError> {
        Ok(Cow::Borrowed(&self.blocks[block / self.ranks.count()]))
    }
}
