//! The exchange areas of a scene, below the diagonal, each block with the rank that it is dealt to.
//!
//! **Memory** `n²/2` values and `n²/2` bounds, over all ranks; as many bounds again where
//! coordinates are rounded.

use crate::exchange::blocks::{HeldBlocks, LowerBlocks};
use crate::exchange::plan::counts::{PassCounts, PassSummary};
use crate::exchange::ranks::{Deal, Ranks, agreed};
use crate::exchange::{ExchangeError, ScenePairs};
use crate::form_factor::ExchangeArea;
use crate::numeric::{entries_of, parallel_map, real};
use rayon::prelude::*;
use std::borrow::Cow;
use std::ops::Range;

/// The exchange areas of a scene that ranks hold, with bounds on their errors.
pub struct ExchangeBlocks<'p> {
    /// The values off the diagonal.
    pub values: HeldBlocks<'p>,
    /// The bounds on their errors.
    pub bounds: HeldBlocks<'p>,
    /// The exchange areas of rows with themselves.
    pub own: Vec<ExchangeArea>,
    /// The plan, and whether the tolerance was reached.
    pub summary: PassSummary,
}

/// A block that was computed.
struct Block {
    values: Vec<f64>,
    bounds: Vec<f64>,
    counts: PassCounts,
    /// Rows that exchange something with themselves.
    own: Vec<(usize, ExchangeArea)>,
}

/// A row left of the diagonal, to be filled.
struct Row<'r> {
    row: usize,
    values: &'r mut [f64],
    bounds: &'r mut [f64],
}

/// A block's rows left of the diagonal.
fn rows_of<'r>(rows: Range<usize>, values: &'r mut [f64], bounds: &'r mut [f64]) -> Vec<Row<'r>> {
    let (mut values, mut bounds) = (values, bounds);
    let mut found = Vec::with_capacity(rows.len());
    for row in rows {
        let (own, rest) = values.split_at_mut(row);
        let (own_bounds, rest_of_bounds) = bounds.split_at_mut(row);
        found.push(Row {
            row,
            values: own,
            bounds: own_bounds,
        });
        (values, bounds) = (rest, rest_of_bounds);
    }
    found
}

impl<'p> ScenePairs<'p> {
    /// All pairs, each once, by the ranks whose blocks they are in.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused; [`ExchangeError::Rank`].
    pub fn exchange_blocks(&self) -> Result<ExchangeBlocks<'p>, ExchangeError> {
        let (n, ranks) = (self.rows(), self.ranks());
        let deal = Deal::new(ranks, n);
        let rows = HeldBlocks::new(n, ranks, Vec::new()).blocks();
        let own_parts = deal.own_parts(0..rows.len());
        let filled: Result<Vec<Block>, ExchangeError> = own_parts
            .map(|part| self.filled_block(rows[part].clone()))
            .collect();
        let filled = agreed(ranks, filled)?;
        let numbers = filled.iter().flat_map(|block| block.counts.numbers());
        let mut counts = PassCounts::default();
        deal.share(
            0..rows.len(),
            PassCounts::NUMBERS,
            numbers.collect(),
            &mut |numbers| counts.merge(&PassCounts::of_numbers(numbers)),
        );
        let own = filled.iter().flat_map(|block| &block.own);
        let own = own.flat_map(|(row, exchange)| [real(*row), exchange.value, exchange.error]);
        let own = own_areas(n, &deal.complete(own.collect()));
        let (values, bounds) = filled
            .into_iter()
            .map(|block| (block.values, block.bounds))
            .unzip();
        Ok(ExchangeBlocks {
            values: HeldBlocks::new(n, ranks, values),
            bounds: HeldBlocks::new(n, ranks, bounds),
            own,
            summary: self.summary(counts),
        })
    }

    fn filled_block(&self, rows: Range<usize>) -> Result<Block, ExchangeError> {
        let mut values = vec![0.0; entries_of(&rows)];
        let mut bounds = values.clone();
        let to_fill = rows_of(rows, &mut values, &mut bounds);
        let filled: Vec<_> = to_fill
            .into_par_iter()
            .map(
                |Row {
                     row,
                     values,
                     bounds,
                 }| {
                    let filled = self.lower_row(row, |column, answer| {
                        values[column] = answer.exchange.value;
                        bounds[column] = answer.exchange.error;
                    })?;
                    Ok::<_, ExchangeError>((row, filled))
                },
            )
            .collect();
        let (mut counts, mut own) = (PassCounts::default(), Vec::new());
        for filled in filled {
            let (row, (more, answer)) = filled?;
            counts.merge(&more);
            own.extend(answer.map(|answer| (row, answer.exchange)));
        }
        Ok(Block {
            values,
            bounds,
            counts,
            own,
        })
    }

    /// Bounds on what the resolution of the coordinates can change of exchange areas, off the
    /// diagonal; none if they are exact.
    #[must_use]
    pub fn resolution_blocks(&self) -> Option<HeldBlocks<'p>> {
        self.loose()?;
        let (n, ranks) = (self.rows(), self.ranks());
        let rows = HeldBlocks::new(n, ranks, Vec::new()).blocks();
        let own: Vec<usize> = Deal::new(ranks, n).own_parts(0..rows.len()).collect();
        let blocks = parallel_map(own.len(), &|block| {
            self.resolution_of(rows[own[block]].clone())
        });
        Some(HeldBlocks::new(n, ranks, blocks))
    }
}

/// Bounds on what the resolution of the coordinates can change of exchange areas, computed where
/// they are read.
#[derive(Debug, Clone, Copy)]
pub struct ResolutionRows<'p>(&'p ScenePairs<'p>);

impl<'p> ScenePairs<'p> {
    /// Bounds on what the resolution of the coordinates can change of exchange areas, none of them
    /// held.
    #[must_use]
    pub const fn resolution_rows(&'p self) -> ResolutionRows<'p> {
        ResolutionRows(self)
    }

    /// The bounds of some rows left of the diagonal, row after row.
    fn resolution_of(&self, rows: Range<usize>) -> Vec<f64> {
        rows.flat_map(|row| (0..row).map(move |column| self.resolution_error(row, column)))
            .collect()
    }
}

impl LowerBlocks for ResolutionRows<'_> {
    fn order(&self) -> usize {
        self.0.rows()
    }

    fn ranks(&self) -> &dyn Ranks {
        self.0.ranks()
    }

    fn block(&self, _: usize, rows: Range<usize>) -> Result<Cow<'_, [f64]>, ExchangeError> {
        Ok(Cow::Owned(self.0.resolution_of(rows)))
    }
}

/// The exchange areas of rows with themselves, of the rows that have one: row, value and bound.
fn own_areas(rows: usize, numbers: &[f64]) -> Vec<ExchangeArea> {
    let none = ExchangeArea {
        value: 0.0,
        error: 0.0,
    };
    let mut own = vec![none; rows];
    for [row, value, error] in numbers.as_chunks::<3>().0 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "an index, as it was sent"
        )]
        let row = *row as usize;
        own[row] = ExchangeArea {
            value: *value,
            error: *error,
        };
    }
    own
}
