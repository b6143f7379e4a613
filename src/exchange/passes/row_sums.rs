//! Sums over the rows of a symmetric matrix that is never held.
//!
//! ```text
//!   S_i = Σ_j f(i, j),     f(i, j) = f(j, i) computed once, for rows that see each other
//! ```
//!
//! Each [tile](crate::exchange::Tile) is summed on its own, over its rows and over its columns, and
//! the sums of the tiles are added up in their order. So every sum takes its terms in an order that
//! depends on the scene alone, and comes out the same for any number of threads, and of
//! [ranks](crate::exchange::Ranks).
//!
//! **Memory** O(n).

use crate::exchange::plan::counts::{PassCounts, PassSummary};
use crate::exchange::plan::facing::Facing;
use crate::exchange::ranks::{Alone, Deal, agreed};
use crate::exchange::scene_pairs::ScenePairs;
use crate::exchange::{ExchangeError, Tile};
use crate::form_factor::ExchangeArea;
use crate::numeric::CompensatedSum;
use rayon::prelude::*;
use std::ops::Range;

/// Tiles that each rank sums before the sums are handed to those whose rows they are.
const TILES_A_RANK: usize = 64;

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

impl<const K: usize> TileSums<K> {
    /// The sums over the columns and over the rows, as numbers.
    fn numbers(&self) -> [Vec<f64>; 2] {
        [&self.columns, &self.rows].map(|sums| {
            let sums = sums.as_flattened().iter();
            sums.flat_map(CompensatedSum::parts).collect()
        })
    }
}

/// The places of a tile's columns and of its rows, in the order in which their sums are added.
fn shape(tile: &Tile) -> Vec<Range<usize>> {
    let block = tile.block();
    vec![block.columns.clone(), block.rows.clone()]
}

impl<const K: usize> RowSums<K> {
    /// Adds the sums that a tile brings to some places.
    fn add(&mut self, places: Range<usize>, numbers: &[f64]) {
        let sums = self.sums[places].as_flattened_mut();
        for (sum, parts) in sums.iter_mut().zip(numbers.as_chunks::<2>().0) {
            sum.add_sum(&CompensatedSum::of_parts(*parts));
        }
    }

    /// Adds the sums of some of the tiles, each rank those of its own rows, and the counts of all.
    fn take(&mut self, deal: &Deal<'_>, (first, tiles): (usize, &[Tile]), own: &[TileSums<K>]) {
        let parts = first..first + tiles.len();
        let numbers: Vec<[Vec<f64>; 2]> = own.iter().map(TileSums::numbers).collect();
        let numbers: Vec<Vec<&[f64]>> = numbers
            .iter()
            .map(|both| both.iter().map(Vec::as_slice).collect())
            .collect();
        deal.deliver(
            parts.clone(),
            2 * K,
            &|part| shape(&tiles[part - first]),
            &numbers,
            &mut |_, places, numbers| self.add(places, numbers),
        );
        let counts = own.iter().flat_map(|sums| sums.counts.numbers()).collect();
        deal.share(parts, PassCounts::NUMBERS, counts, &mut |numbers| {
            self.counts.merge(&PassCounts::of_numbers(numbers));
        });
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
        let deal = Deal::new(self.ranks(), self.rows());
        let (mut sums, mut first, mut tiles) = (self.no_sums(), 0, Vec::new());
        let enough = TILES_A_RANK * deal.ranks().count();
        let mut bands = self.bands(SIDE).peekable();
        while let Some(band) = bands.next() {
            let left_out = band.pairs - band.tiles.iter().map(Tile::pairs).sum::<usize>();
            self.advance(left_out);
            tiles.extend(band.tiles);
            if tiles.len() < enough && bands.peek().is_some() {
                continue;
            }
            let own: Vec<usize> = deal.own_parts(first..first + tiles.len()).collect();
            let of_tile = |part: &usize| {
                let tile: &Tile = &tiles[part - first];
                let sums = self.tile_sums(tile, &term);
                self.advance(tile.pairs());
                sums
            };
            let found: Vec<Result<TileSums<K>, ExchangeError>> =
                own.par_iter().map(of_tile).collect();
            let found: Result<Vec<TileSums<K>>, ExchangeError> = found.into_iter().collect();
            sums.take(&deal, (first, &tiles), &agreed(deal.ranks(), found)?);
            first += tiles.len();
            tiles.clear();
        }
        Ok(self.totals(&deal, sums))
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
        let deal = Deal::new(&Alone, self.rows());
        let mut all = self.no_sums();
        for (tile, more) in sums {
            all.take(&deal, (0, &[tile]), &[more]);
        }
        self.totals(&deal, all)
    }

    fn no_sums<const K: usize>(&self) -> RowSums<K> {
        RowSums {
            sums: vec![[CompensatedSum::default(); K]; self.rows()],
            counts: PassCounts::default(),
        }
    }

    fn totals<const K: usize>(
        &self,
        deal: &Deal<'_>,
        all: RowSums<K>,
    ) -> (Vec<[f64; K]>, PassSummary) {
        let own = all.sums[deal.own_places()].as_flattened().iter();
        let totals = deal.complete(own.map(CompensatedSum::total).collect());
        let mut by_row = vec![[0.0; K]; self.rows()];
        for (row, totals) in self
            .plane_sets()
            .order()
            .iter()
            .zip(totals.as_chunks::<K>().0)
        {
            by_row[*row] = *totals;
        }
        (by_row, self.summary(all.counts))
    }
}
