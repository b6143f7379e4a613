//! Symmetric matrices, each pair of indices held once.
//!
//! ```text
//!   entry (i, j), j < i, at place i(i − 1)/2 + j
//! ```
//!
//! The rows below the diagonal stand one after the other, so that a block of consecutive rows is
//! one slice. The diagonal is not held.

use crate::numeric::real;
use std::ops::Range;

/// A symmetric matrix without its diagonal, packed.
///
/// # Examples
/// ```
/// use infoscene::numeric::Symmetric;
/// let mut sums = Symmetric::filled(3, 0);
/// for (i, row) in sums.rows_mut().into_iter().enumerate() {
///     for (j, entry) in row.iter_mut().enumerate() {
///         *entry = i + j;
///     }
/// }
/// assert_eq!((sums.get(0, 2), sums.get(2, 0)), (&2, &2));
/// assert_eq!(sums.rows(1..3), [1, 2, 3]);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Symmetric<T> {
    order: usize,
    entries: Vec<T>,
}

impl<T> Symmetric<T> {
    /// The matrix whose entries `(1, 0), (2, 0), (2, 1), …` come in this order; what is missing or
    /// too much is refused.
    #[must_use]
    pub fn from_rows(order: usize, entries: Vec<T>) -> Option<Self> {
        (entries.len() == start(order)).then_some(Self { order, entries })
    }

    /// The matrix with one value everywhere off the diagonal.
    #[must_use]
    pub fn filled(order: usize, value: T) -> Self
    where
        T: Clone,
    {
        Self {
            order,
            entries: vec![value; start(order)],
        }
    }

    /// Number of rows, and of columns.
    #[must_use]
    pub const fn order(&self) -> usize {
        self.order
    }

    /// The entry of two different indices, in either order.
    ///
    /// # Panics
    /// If there is no such entry.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> &T {
        debug_assert!(i != j, "the diagonal is not held");
        &self.entries[start(i.max(j)) + i.min(j)]
    }

    /// The entries of row i left of the diagonal; by symmetry, those of column i above it.
    ///
    /// # Panics
    /// If there is no row i.
    #[must_use]
    pub fn row(&self, i: usize) -> &[T] {
        &self.entries[start(i)..start(i + 1)]
    }

    /// The entries of consecutive rows left of the diagonal, one row after the other.
    ///
    /// # Panics
    /// If one of the rows does not exist.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>) -> &[T] {
        &self.entries[start(rows.start)..start(rows.end)]
    }

    /// Each row left of the diagonal, to be filled.
    pub fn rows_mut(&mut self) -> Vec<&mut [T]> {
        let mut rows = Vec::with_capacity(self.order);
        let mut rest = self.entries.as_mut_slice();
        for i in 0..self.order {
            let (row, more) = rest.split_at_mut(i);
            rows.push(row);
            rest = more;
        }
        rows
    }

    /// All entries, row after row.
    #[must_use]
    pub fn entries(&self) -> &[T] {
        &self.entries
    }

    /// All entries, row after row, to be changed.
    pub fn entries_mut(&mut self) -> &mut [T] {
        &mut self.entries
    }

    /// Blocks of consecutive rows with about equally many entries each.
    pub fn blocks(&self, count: usize) -> impl Iterator<Item = Range<usize>> + use<T> {
        row_blocks(self.order, count)
    }
}

/// Blocks of consecutive rows of a matrix of this order with about equally many entries each, below
/// its diagonal.
pub(crate) fn row_blocks(order: usize, count: usize) -> impl Iterator<Item = Range<usize>> + use<> {
    (0..count)
        .map(move |block| block_start(order, block, count)..block_start(order, block + 1, count))
}

/// Number of entries of these rows below the diagonal.
pub(crate) const fn entries_of(rows: &Range<usize>) -> usize {
    start(rows.end) - start(rows.start)
}

/// The place at which row i starts.
const fn start(i: usize) -> usize {
    i * i.saturating_sub(1) / 2
}

/// The first row of a block: the rows before it have the part `block/count` of all entries.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "between 0 and the order"
)]
fn block_start(order: usize, block: usize, count: usize) -> usize {
    debug_assert!(block <= count, "block {block} of {count}");
    if block == count {
        return order;
    }
    (real(order) * (real(block) / real(count)).sqrt()) as usize
}
