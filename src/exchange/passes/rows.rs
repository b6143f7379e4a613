//! Rows of exchange areas, one at a time; and single rows, columns and entries.

use super::tiles::Block;
use crate::exchange::pairs::row_pair::{nothing, per_area};
use crate::exchange::plan::counts::{PassCounts, PassSummary};
use crate::exchange::plan::facing::Facing;
use crate::exchange::{ExchangeError, RowSum, ScenePairs, Selection};
use crate::form_factor::Answer;
use crate::numeric::{CompensatedSum, try_parallel_map};
use std::collections::{BTreeMap, BTreeSet};
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
    /// The counts of the entries on and above the diagonal.
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
        // each pair is counted in the first of its rows
        walk(columns.start..columns.end.min(from))?;
        let mut counts = PassCounts::default();
        if columns.contains(&from) {
            counts.merge(&walk(from..from + 1)?);
        }
        counts.merge(&walk(columns.start.max(from + 1)..columns.end)?);
        Ok(RowPart { answers, counts })
    }

    /// The entries of a selection in its order; a row is paired with itself only where it may see
    /// itself. The summary is that of these pairs alone, each once.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`](crate::scene::SceneError::NoSuchPatch),
    /// [`ExchangeError::Pair`](crate::exchange::ExchangeError::Pair).
    pub fn entries(
        &self,
        selection: &Selection,
    ) -> Result<(Vec<Entry>, PassSummary), ExchangeError> {
        selection.check(self.rows())?;
        let is_there =
            |[from, to]: &[usize; 2]| from != to || self.facing(*from, *from) == Facing::Visible;
        let both = selection.at_both_ends(self.rows());
        // of the two directions of a pair the upper one counts
        let is_counted = |from: usize, to: usize| from <= to || !(both[from] && both[to]);
        let listed: Vec<[usize; 2]> = selection.pairs(self.rows()).filter(is_there).collect();
        let parts = try_parallel_map(listed.len().div_ceil(RUN), &|part| {
            let run = &listed[part * RUN..listed.len().min((part + 1) * RUN)];
            let mut counts = PassCounts::default();
            let entries: Result<Vec<Entry>, ExchangeError> = run
                .iter()
                .map(|[from, to]| {
                    let mut own = PassCounts::default();
                    let answer = self.counted_row_pair(*from, *to, &mut own)?;
                    if is_counted(*from, *to) {
                        counts.merge(&own);
                    }
                    Ok(Entry {
                        from: *from,
                        to: *to,
                        answer,
                    })
                })
                .collect();
            self.advance(run.len());
            Ok::<_, ExchangeError>((entries?, counts))
        })?;
        let (mut entries, mut counts) = (Vec::with_capacity(listed.len()), PassCounts::default());
        for (part, more) in parts {
            entries.extend(part);
            counts.merge(&more);
        }
        let counted = entries
            .iter()
            .filter(|entry| is_counted(entry.from, entry.to));
        let summary = if selection.is_all() {
            self.summary(counts)
        } else {
            self.summary_of_entries(counted, counts)
        };
        Ok((entries, summary))
    }

    /// The sums of those rows whose entries are all in a selection.
    ///
    /// **Arguments** `entries`: those of the [`selection`](Self::entries).
    #[must_use]
    pub fn complete_sums(&self, selection: &Selection, entries: &[Entry]) -> Vec<RowSum> {
        let is_from = selection.to.is_none();
        if !is_from && selection.from.is_some() {
            return Vec::new();
        }
        let mut sums: BTreeMap<usize, [CompensatedSum; 2]> = BTreeMap::new();
        for Entry { from, to, answer } in entries {
            // a row's exchange areas are those of its column
            let [value, error] = sums.entry(if is_from { *from } else { *to }).or_default();
            value.add(answer.exchange.value);
            error.add(answer.exchange.error);
        }
        let of_row = |(row, [value, error]): (usize, [CompensatedSum; 2])| {
            let [area, bound] = [self.areas()[row], self.area_bounds()[row]];
            (area > 0.0).then(|| RowSum {
                row,
                sum: per_area(value.total(), area),
                error: per_area(error.total(), area) + per_area(bound, area),
                resolution_error: per_area(self.crack_error(row), area),
            })
        };
        sums.into_iter().filter_map(of_row).collect()
    }

    /// The summary of some entries, no pair of which comes twice.
    fn summary_of_entries<'e>(
        &self,
        entries: impl Iterator<Item = &'e Entry>,
        counts: PassCounts,
    ) -> PassSummary {
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
                    Facing::Visible if self.takes_class(one, other) => {
                        classes.extend(self.class(one, other));
                    }
                    Facing::Visible => {}
                    Facing::Coplanar => left_out[0] += 1,
                    Facing::BackFacing => left_out[1] += 1,
                }
            }
        }
        self.summary_of(pairs, left_out, classes.len(), counts)
    }
}
