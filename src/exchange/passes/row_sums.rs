//! Sums over the rows of a symmetric matrix that is never held.
//!
//! ```text
//!   S_i = Σ_j f(i, j),     f(i, j) = f(j, i) computed once, for rows that see each other
//! ```
//!
//! Each [tile](crate::exchange::Tile) is summed on its own, over its rows and over its columns, and
//! the sums of the tiles are added up in their order. So every sum takes its terms in an order that
//! depends on the scene alone, and comes out the same for any number of threads.
//!
//! **Memory** O(n).

use crate::exchange::plan::counts::{PassCounts, PassSummary};
use crate::exchange::plan::facing::Facing;
use crate::exchange::scene_pairs::ScenePairs;
use crate::exchange::{ExchangeError, Tile};
use crate::form_factor::ExchangeArea;
use crate::numeric::CompensatedSum;
use rayon::prelude::*;

/// Rows along one side of a tile.
const SIDE: usize = 128;

/// `K` sums per row.
type Sums<const K: usize> = [CompensatedSum; K];

/// The sums over one tile's rows and over its columns, and its counts.
#[derive(Debug, Clone, PartialEq)]
pub struct TileSums<const K: usize> {
    rows: Vec<Sums<K>>,
    columns: Vec<Sums<K>>,
    counts: PassCounts,
}

/// Sums of all rows that are still being added to, by place in the order by plane sets.
struct RowSums<const K: usize> {
    sums: Vec<Sums<K>>,
    counts: PassCounts,
}

impl<const K: usize> RowSums<K> {
    /// Adds the sums of the next tile.
    fn add(&mut self, tile: &Tile, more: &TileSums<K>) {
        let block = tile.block();
        for (places, more) in [(&block.columns, &more.columns), (&block.rows, &more.rows)] {
            for (sums, more) in self.sums[places.clone()].iter_mut().zip(more) {
                for (sum, more) in sums.iter_mut().zip(more) {
                    sum.add_sum(more);
                }
            }
        }
        self.counts.merge(&more.counts);
    }
}

impl ScenePairs<'_> {
    /// `K` sums over each row, of terms that are the same for (i, j) and (j, i); pairs that the
    /// plan leaves out are not asked for, nor a row with itself unless it may see itself.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::exchange::{Congruence, ScenePairs};
    /// use infoscene::scene::{Occlusion, Scene};
    /// let cube = Scene::built_in("cube:2")?;
    /// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Exact)?;
    /// let (sums, _) = pairs.row_sums(|_, _, exchange| [exchange.value])?;
    /// // the form factors of a closed scene sum to one
    /// assert!((sums[0][0] / pairs.areas()[0] - 1.0).abs() < 1e-13);
    /// # Ok::<(), infoscene::exchange::ExchangeError>(())
    /// ```
    pub fn row_sums<const K: usize>(
        &self,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K] + Sync,
    ) -> Result<(Vec<[f64; K]>, PassSummary), ExchangeError> {
        let mut sums = self.no_sums();
        for band in self.bands(SIDE) {
            let of_tile = |tile: &Tile| {
                let sums = self.tile_sums(tile, &term);
                self.advance(tile.pairs());
                sums
            };
            let left_out = band.pairs - band.tiles.iter().map(Tile::pairs).sum::<usize>();
            self.advance(left_out);
            let found: Vec<Result<TileSums<K>, ExchangeError>> =
                band.tiles.par_iter().map(of_tile).collect();
            for (tile, found) in band.tiles.iter().zip(found) {
                sums.add(tile, &found?);
            }
        }
        Ok(self.totals(sums))
    }

    /// The sums over one tile, of terms that are the same for (i, j) and (j, i); terms are asked
    /// for as in [`row_sums`](Self::row_sums).
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused.
    pub fn tile_sums<const K: usize>(
        &self,
        tile: &Tile,
        term: impl Fn(usize, usize, &ExchangeArea) -> [f64; K],
    ) -> Result<TileSums<K>, ExchangeError> {
        let block = tile.block();
        let order = self.plane_sets().order();
        let none = |places: usize| vec![[CompensatedSum::default(); K]; places];
        let (mut rows, mut columns) = (none(block.rows.len()), none(block.columns.len()));
        let counts = self.walk(
            block,
            |place| order[place],
            |[row, column], facing, answer| {
                if facing != Facing::Visible {
                    return;
                }
                let terms = term(order[row], order[column], &answer.exchange);
                let row_sums = &mut rows[row - block.rows.start];
                for (sum, term) in row_sums.iter_mut().zip(terms) {
                    sum.add(term);
                }
                if row != column {
                    let column_sums = &mut columns[column - block.columns.start];
                    for (sum, term) in column_sums.iter_mut().zip(terms) {
                        sum.add(term);
                    }
                }
            },
        )?;
        Ok(TileSums {
            rows,
            columns,
            counts,
        })
    }

    /// The sums over each row, from those over all [tiles](Self::tiles) of one side in their order:
    /// the same to the last bit wherever the tiles were summed.
    pub fn row_sums_of<const K: usize>(
        &self,
        sums: impl IntoIterator<Item = (Tile, TileSums<K>)>,
    ) -> (Vec<[f64; K]>, PassSummary) {
        let mut all = self.no_sums();
        for (tile, more) in sums {
            all.add(&tile, &more);
        }
        self.totals(all)
    }

    fn no_sums<const K: usize>(&self) -> RowSums<K> {
        RowSums {
            sums: vec![[CompensatedSum::default(); K]; self.rows()],
            counts: PassCounts::default(),
        }
    }

    fn totals<const K: usize>(&self, all: RowSums<K>) -> (Vec<[f64; K]>, PassSummary) {
        let mut by_row = vec![[0.0; K]; self.rows()];
        for (row, sums) in self.plane_sets().order().iter().zip(&all.sums) {
            by_row[*row] = sums.map(|sum| sum.total());
        }
        (by_row, self.summary(all.counts))
    }
}
