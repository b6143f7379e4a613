//! Rows of exchange areas, one at a time; and single rows, columns and entries.

use super::tiles::Block;
use crate::exchange::plan::counts::{PassCounts, PassSummary};
use crate::exchange::plan::facing::Facing;
use crate::exchange::row_pair::nothing;
use crate::exchange::{ExchangeError, ScenePairs};
use crate::form_factor::Answer;
use crate::numeric::try_parallel_map;
use std::collections::BTreeSet;
use std::ops::Range;

/// An ordered pair and its exchange area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// The row that sends.
    pub from: usize,
    /// The row that receives.
    pub to: usize,
    /// The exchange area, the same for (to, from).
    pub answer: Answer,
}

/// Entries of a row that one thread computes at a time.
const RUN: usize = 64;

/// Consecutive entries of a row.
#[derive(Default)]
struct RowPart {
    answers: Vec<Answer>,
    /// The counts of the entries below the diagonal.
    below: PassCounts,
    /// The counts of the others.
    counts: PassCounts,
}

impl ScenePairs<'_> {
    /// Shows all rows in order, each a list of the exchange areas with rows 0, 1, …, itself
    /// included; only one is held. A pair that shares no value is computed for both of its rows, in
    /// the same way: [tiles](Self::tiles) compute it once.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`](crate::exchange::ExchangeError::Pair) if two patches are refused, or
    /// the error that `visit` returns.
    pub fn for_each_row<E: From<ExchangeError>>(
        &self,
        mut visit: impl FnMut(usize, &[Answer]) -> Result<(), E>,
    ) -> Result<PassSummary, E> {
        let n = self.rows();
        let mut counts = PassCounts::default();
        for from in 0..n {
            let row = self.row(from, 0..n)?;
            counts.merge(&row.counts);
            visit(from, &row.answers)?;
            // all rows take the same time, n/2 pairs of the n²/2
            self.advance((from + 1) * (n - 1) / 2 - from * (n - 1) / 2);
        }
        Ok(self.summary(counts))
    }

    /// Some entries of a row, in parallel.
    fn row(&self, from: usize, columns: Range<usize>) -> Result<RowPart, ExchangeError> {
        let starts: Vec<usize> = columns.clone().step_by(RUN).collect();
        let parts = try_parallel_map(starts.len(), &|part| {
            self.row_part(from, starts[part]..columns.end.min(starts[part] + RUN))
        })?;
        let mut row = RowPart::default();
        for part in parts {
            row.answers.extend(part.answers);
            row.below.merge(&part.below);
            row.counts.merge(&part.counts);
        }
        Ok(row)
    }

    /// Some entries of a row: below the diagonal, on it, above it.
    fn row_part(&self, from: usize, columns: Range<usize>) -> Result<RowPart, ExchangeError> {
        let mut answers = vec![nothing(Facing::Coplanar, true); columns.len()];
        let mut walk = |part: Range<usize>| {
            self.walk(
                &Block::of_row(from, part),
                |place| place,
                |[_, to], _, answer| answers[to - columns.start] = *answer,
            )
        };
        let below = walk(columns.start..columns.end.min(from))?;
        let mut counts = PassCounts::default();
        if columns.contains(&from) {
            counts.merge(&walk(from..from + 1)?);
        }
        counts.merge(&walk(columns.start.max(from + 1)..columns.end)?);
        Ok(RowPart {
            answers,
            below,
            counts,
        })
    }

    /// The ordered pairs from one row, or to one, or both; a row is paired with itself only where
    /// it may see itself. The summary is that of these pairs alone.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`](crate::scene::SceneError::NoSuchPatch),
    /// [`ExchangeError::Pair`](crate::exchange::ExchangeError::Pair).
    pub fn entries(
        &self,
        from: Option<usize>,
        to: Option<usize>,
    ) -> Result<(Vec<Entry>, PassSummary), ExchangeError> {
        for row in [from, to].into_iter().flatten() {
            self.check(row)?;
        }
        let all = 0..self.rows();
        let mut counts = PassCounts::default();
        let mut entries = Vec::new();
        // the exchange area is the same both ways: a column is a row
        let (rows, columns) = match (from, to) {
            (Some(from), Some(to)) => (from..from + 1, to..to + 1),
            (Some(row), None) | (None, Some(row)) => (row..row + 1, all),
            (None, None) => (all.clone(), all),
        };
        let is_part = from.is_some() || to.is_some();
        for row in rows {
            let found = self.row(row, columns.clone())?;
            counts.merge(&found.counts);
            // of all pairs, which come both ways, the first counts
            if is_part {
                counts.merge(&found.below);
            }
            for (column, answer) in columns.clone().zip(found.answers) {
                if row == column && self.facing(row, row) != Facing::Visible {
                    continue;
                }
                let [from, to] = if from.is_none() && is_part {
                    [column, row]
                } else {
                    [row, column]
                };
                entries.push(Entry { from, to, answer });
            }
        }
        let summary = if is_part {
            self.summary_of_part(&entries, counts)
        } else {
            self.summary(counts)
        };
        Ok((entries, summary))
    }

    /// The summary of some entries, no pair of which comes twice.
    fn summary_of_part(&self, entries: &[Entry], counts: PassCounts) -> PassSummary {
        let mut classes = BTreeSet::new();
        let (mut pairs, mut left_out) = (0, [0; 2]);
        for Entry { from, to, .. } in entries {
            for [one, other] in self.terms().pairs(*from, *to) {
                if one.sign < 0.0 || other.sign < 0.0 {
                    continue;
                }
                pairs += 1;
                let [one, other] = [one.polygon, other.polygon];
                match self.facing_polygons(one, other) {
                    Facing::Visible => classes.extend(self.class(one, other)),
                    Facing::Coplanar => left_out[0] += 1,
                    Facing::BackFacing => left_out[1] += 1,
                }
            }
        }
        self.summary_of(pairs, left_out, classes.len(), counts)
    }
}
