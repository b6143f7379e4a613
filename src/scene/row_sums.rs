//! Sums over the rows of a symmetric matrix that is never held.
//!
//! ```text
//!   S_i = Σ_j f(i, j),     f(i, j) = f(j, i) computed once, for the pairs of rows that see each other
//! ```
//!
//! The pairs come in tiles of [`SIDE`] × [`SIDE`] rows. The tiles of one row of tiles are computed in parallel; each adds
//! to the sums of its own columns, and the sums of its rows are added up afterwards in order. So every sum takes its terms in
//! an order that depends on the scene alone, and comes out the same for any number of threads.
//!
//! **Memory** O(n).

use super::ExchangeError;
use super::facing::Sight;
use super::pairs::{Account, ScenePairs};
use super::tally::Tally;
use crate::form_factor::ExchangeArea;
use crate::numeric::CompensatedSum;
use rayon::prelude::*;
use std::ops::Range;

/// Rows along one side of a tile.
const SIDE: usize = 128;

/// `K` sums per row.
type Sums<const K: usize> = [CompensatedSum; K];

/// A run of rows, by place in the order by aspects.
#[derive(Debug, Clone)]
struct Chunk {
    places: Range<usize>,
    /// The aspect that they all have, if it is one.
    aspect: Option<usize>,
}

/// One tile: what it adds to the sums of its rows, and its counts.
type Tile<const K: usize> = Result<(Vec<Sums<K>>, Tally), ExchangeError>;

impl ScenePairs {
    /// `K` sums over each row, of terms that are the same for (i, j) and (j, i); pairs that the plan leaves out are not
    /// asked for, nor a row with itself unless it may see itself.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::{Congruence, Occlusion, Scene, ScenePairs};
    /// let cube = Scene::built_in("cube:2")?;
    /// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Refuse)?;
    /// let (sums, _) = pairs.row_sums(|_, _, exchange| [exchange.value])?;
    /// // the form factors of a closed scene sum to one
    /// assert!((sums[0][0] / pairs.areas()[0] - 1.0).abs() < 1e-13);
    /// # Ok::<(), infoscene::scene::ExchangeError>(())
    /// ```
    pub fn row_sums<const K: usize>(
        &self,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K] + Sync,
    ) -> Result<(Vec<[f64; K]>, Account), ExchangeError> {
        let order: Vec<usize> = self.aspects.rows().concat();
        let chunks = self.chunks();
        let mut sums = vec![[CompensatedSum::default(); K]; order.len()];
        let mut tally = Tally::default();
        for (index, rows) in chunks.iter().enumerate() {
            let columns = split(&mut sums[rows.places.start..], &chunks[index..]);
            let tiles: Vec<(usize, Tile<K>)> = columns
                .into_par_iter()
                .zip(&chunks[index..])
                .enumerate()
                .filter(|(_, (_, columns))| {
                    let may_see = self.may_see(rows, columns);
                    if !may_see {
                        let skipped = rows.places.clone().map(|row| after(row, columns).len());
                        self.progress.done(skipped.sum());
                    }
                    may_see
                })
                .map(|(at, (sums, columns))| (at, self.tile(&order, rows, columns, sums, &term)))
                .collect();
            for (_, tile) in tiles {
                let (row_sums, counts) = tile?;
                tally.merge(&counts);
                for (place, terms) in rows.places.clone().zip(&row_sums) {
                    for (sum, term) in sums[place].iter_mut().zip(terms) {
                        sum.add_sum(term);
                    }
                }
            }
        }
        let mut by_row = vec![[0.0; K]; order.len()];
        for (row, sums) in order.into_iter().zip(&sums) {
            by_row[row] = sums.map(|sum| sum.total());
        }
        Ok((by_row, self.account(tally)))
    }

    /// Rows in the order of their aspects, cut into chunks; a chunk starts with each aspect of many rows.
    fn chunks(&self) -> Vec<Chunk> {
        let mut chunks: Vec<Chunk> = Vec::new();
        let mut start = 0;
        for (aspect, rows) in self.aspects.rows().iter().enumerate() {
            let end = start + rows.len();
            let is_large = rows.len() > SIDE / 4;
            match chunks.last_mut() {
                Some(last) if !is_large && end - last.places.start <= SIDE => {
                    last.places.end = end;
                    last.aspect = None;
                }
                _ => {
                    let parts = (start..end).step_by(SIDE);
                    chunks.extend(parts.map(|start| Chunk {
                        places: start..end.min(start + SIDE),
                        aspect: Some(aspect),
                    }));
                }
            }
            start = end;
        }
        chunks
    }

    /// May a pair of these exchange anything?
    fn may_see(&self, rows: &Chunk, columns: &Chunk) -> bool {
        match (rows.aspect, columns.aspect) {
            (Some(first), Some(second)) => {
                self.aspects.sight(&self.plan.planes, first, second) == Sight::Open
            }
            _ => true,
        }
    }

    fn tile<const K: usize>(
        &self,
        order: &[usize],
        rows: &Chunk,
        columns: &Chunk,
        column_sums: &mut [Sums<K>],
        term: &(impl Fn(usize, usize, &ExchangeArea) -> [f64; K] + Sync),
    ) -> Tile<K> {
        let mut row_sums = vec![[CompensatedSum::default(); K]; rows.places.len()];
        let mut tally = Tally::default();
        let is_mixed = rows.aspect.is_none() || columns.aspect.is_none();
        for (row, row_sums) in rows.places.clone().zip(&mut row_sums) {
            let first = order[row];
            if columns.places.contains(&row) && self.sight(first, first) == Sight::Open {
                let answer = self.open(first, first, &mut tally)?;
                let terms = term(first, first, &answer.exchange);
                for (sum, term) in row_sums.iter_mut().zip(terms) {
                    sum.add(term);
                }
            }
            let after = after(row, columns);
            let pairs = after.len();
            for column in after {
                let second = order[column];
                if is_mixed && self.sight(first, second) != Sight::Open {
                    continue;
                }
                let answer = self.open(first, second, &mut tally)?;
                let terms = term(first, second, &answer.exchange);
                let column_sums = &mut column_sums[column - columns.places.start];
                for ((row, column), term) in row_sums.iter_mut().zip(column_sums).zip(terms) {
                    row.add(term);
                    column.add(term);
                }
            }
            self.progress.done(pairs);
        }
        Ok((row_sums, tally))
    }
}

/// The columns of a chunk that come after a row.
fn after(row: usize, columns: &Chunk) -> Range<usize> {
    let end = columns.places.end;
    columns.places.start.max(row + 1).min(end)..end
}

/// The sums of each chunk, the first of which starts where `sums` does.
fn split<'s, T>(mut sums: &'s mut [T], chunks: &[Chunk]) -> Vec<&'s mut [T]> {
    let mut parts = Vec::with_capacity(chunks.len());
    for chunk in chunks {
        let (part, rest) = sums.split_at_mut(chunk.places.len());
        parts.push(part);
        sums = rest;
    }
    parts
}
