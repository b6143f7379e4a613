//! Rows of exchange areas, one at a time; and single rows, columns and entries.

use super::{Account, ExchangeError, ScenePairs, Sight, Tally};
use crate::form_factor::Answer;
use crate::numeric::try_parallel_map;
use std::collections::BTreeSet;

/// An ordered pair and what it exchanges.
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

impl ScenePairs {
    /// Shows all rows in order, each a list of what the patch, or the sum, exchanges with rows 0, 1, …, itself included; only one is
    /// held. A pair that shares no value is computed for both of its rows, in the same way.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`](super::ExchangeError::Pair) if two patches are refused, or what `visit` returns.
    pub fn for_each_row<E: From<ExchangeError>>(
        &self,
        mut visit: impl FnMut(usize, &[Answer]) -> Result<(), E>,
    ) -> Result<Account, E> {
        let n = self.patches();
        let mut tally = Tally::default();
        let mut row = Vec::with_capacity(n);
        for from in 0..n {
            let runs = try_parallel_map(n.div_ceil(RUN), &|run| {
                self.run(from, run * RUN..n.min((run + 1) * RUN))
            })?;
            row.clear();
            for (answers, counts) in runs {
                row.extend(answers);
                tally.merge(&counts);
            }
            visit(from, &row)?;
            // all rows take the same time, n/2 pairs of the n²/2
            self.progress
                .done((from + 1) * (n - 1) / 2 - from * (n - 1) / 2);
        }
        Ok(self.account(tally))
    }

    /// Part of a row, and the counts of what is not below the diagonal.
    fn run(
        &self,
        from: usize,
        columns: std::ops::Range<usize>,
    ) -> Result<(Vec<Answer>, Tally), ExchangeError> {
        let mut tally = Tally::default();
        let mut answers = Vec::with_capacity(columns.len());
        for to in columns {
            let mut below = Tally::default();
            let counts = if to < from { &mut below } else { &mut tally };
            answers.push(self.between(from, to, counts)?);
        }
        Ok((answers, tally))
    }

    /// The ordered pairs from one row, or to one, or both; a row is paired with itself only where it may see itself. The account is
    /// that of these pairs alone.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`](super::SceneError::NoSuchPatch), [`ExchangeError::Pair`](super::ExchangeError::Pair).
    pub fn entries(
        &self,
        from: Option<usize>,
        to: Option<usize>,
    ) -> Result<(Vec<Entry>, Account), ExchangeError> {
        for row in [from, to].into_iter().flatten() {
            self.check(row)?;
        }
        let all = |one: Option<usize>| one.map_or(0..self.patches(), |one| one..one + 1);
        let is_part = from.is_some() || to.is_some();
        let mut entries = Vec::new();
        let mut classes = BTreeSet::new();
        let mut tally = Tally::default();
        let (mut pairs, mut left_out) = (0, [0; 2]);
        for from in all(from) {
            for to in all(to).filter(|to| *to != from || self.sight(from, from) == Sight::Open) {
                // of all pairs, which come both ways, the first counts
                let mut again = Tally::default();
                let is_new = is_part || from <= to;
                let counts = if is_new { &mut tally } else { &mut again };
                let answer = self.between(from, to, counts)?;
                let polygons = self.members.pairs(from, to);
                let counted = polygons.filter(|pair| is_part && pair.iter().all(|m| m.sign > 0.0));
                for [one, other] in counted.map(|pair| pair.map(|member| member.polygon)) {
                    pairs += 1;
                    match self.plan.sight(one, other) {
                        Sight::Open => classes.extend(self.class(one, other)),
                        Sight::Coplanar => left_out[0] += 1,
                        Sight::BackFacing => left_out[1] += 1,
                    }
                }
                entries.push(Entry { from, to, answer });
            }
        }
        let account = if is_part {
            self.account_of(pairs, left_out, classes.len(), tally)
        } else {
            self.account(tally)
        };
        Ok((entries, account))
    }
}
