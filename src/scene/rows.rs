//! Rows of exchange areas, one at a time; and single rows, columns and entries.

use super::{Account, SceneError, ScenePairs, Sight, Tally};
use crate::form_factor::Answer;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// An ordered pair and what it exchanges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// The patch that sends.
    pub from: usize,
    /// The patch that receives.
    pub to: usize,
    /// The exchange area, the same for (to, from).
    pub answer: Answer,
}

/// Entries of a row that one thread computes at a time.
const RUN: usize = 64;

impl ScenePairs {
    /// Shows all rows in order, each a list of what the patch exchanges with patches 0, 1, …, itself included; only one is
    /// held. A pair that shares no value is computed for both of its rows, in the same way.
    ///
    /// # Errors
    /// [`SceneError::Pair`](super::SceneError::Pair) if two patches are refused, or what `visit` returns.
    pub fn for_each_row<E: From<SceneError>>(
        &self,
        mut visit: impl FnMut(usize, &[Answer]) -> Result<(), E>,
    ) -> Result<Account, E> {
        let n = self.patches();
        let mut tally = Tally::default();
        let mut row = Vec::with_capacity(n);
        for from in 0..n {
            let runs: Vec<Result<_, SceneError>> = (0..n.div_ceil(RUN))
                .into_par_iter()
                .map(|run| self.run(from, run * RUN..n.min((run + 1) * RUN)))
                .collect();
            row.clear();
            for run in runs {
                let (answers, counts) = run?;
                row.extend(answers);
                tally.merge(&counts);
            }
            visit(from, &row)?;
        }
        Ok(self.account(tally))
    }

    /// Part of a row, and the counts of what is above the diagonal.
    fn run(
        &self,
        from: usize,
        columns: std::ops::Range<usize>,
    ) -> Result<(Vec<Answer>, Tally), SceneError> {
        let mut tally = Tally::default();
        let mut answers = Vec::with_capacity(columns.len());
        for to in columns {
            answers.push(if to > from && self.plan.sight(from, to) == Sight::Open {
                self.look(from, to, &mut tally)?
            } else {
                self.pair(from, to)?
            });
        }
        Ok((answers, tally))
    }

    /// The ordered pairs from one patch, or to one, or both; a patch is not paired with itself. The account is that of these
    /// pairs alone.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`](super::SceneError::NoSuchPatch), [`SceneError::Pair`](super::SceneError::Pair).
    pub fn entries(
        &self,
        from: Option<usize>,
        to: Option<usize>,
    ) -> Result<(Vec<Entry>, Account), SceneError> {
        let last = self.patches() - 1;
        if let Some(index) = [from, to].into_iter().flatten().find(|index| *index > last) {
            return Err(SceneError::NoSuchPatch { index, last });
        }
        let all = |one: Option<usize>| one.map_or(0..=last, |one| one..=one);
        let is_part = from.is_some() || to.is_some();
        let mut entries = Vec::new();
        let mut classes = BTreeSet::new();
        let mut tally = Tally::default();
        let (mut pairs, mut left_out) = (0, [0; 2]);
        for from in all(from) {
            for to in all(to).filter(|to| *to != from) {
                // of all pairs, which come both ways, the first counts
                let is_new = is_part || from < to;
                let sight = self.plan.sight(from, to);
                let answer = if sight == Sight::Open && is_new {
                    classes.extend(self.class(from, to));
                    self.look(from, to, &mut tally)?
                } else {
                    self.pair(from, to)?
                };
                if is_new {
                    pairs += 1;
                    left_out[0] += usize::from(sight == Sight::Coplanar);
                    left_out[1] += usize::from(sight == Sight::BackFacing);
                }
                entries.push(Entry { from, to, answer });
            }
        }
        Ok((
            entries,
            self.account_of(pairs, left_out, classes.len(), tally),
        ))
    }
}
