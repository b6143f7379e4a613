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
    /// No sums yet, over the rows and columns of a tile.
    pub(in crate::exchange) fn none(tile: &Tile) -> Self {
        let none = |places: usize| vec![[CompensatedSum::default(); K]; places];
        Self {
            rows: none(tile.block().rows.len()),
            columns: none(tile.block().columns.len()),
            counts: PassCounts::default(),
        }
    }

    /// Adds the terms of a pair, by place in the tile; those of a row with itself once.
    #[inline]
    pub(in crate::exchange) fn add(
        &mut self,
        [row, column]: [usize; 2],
        is_diagonal: bool,
        terms: [f64; K],
    ) {
        for (sum, term) in self.rows[row].iter_mut().zip(terms) {
            sum.add(term);
        }
        if !is_diagonal {
            for (sum, term) in self.columns[column].iter_mut().zip(terms) {
                sum.add(term);
            }
        }
    }

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
    /// No sums yet, at so many places.
    fn none(places: usize) -> Self {
        Self {
            sums: vec![[CompensatedSum::default(); K]; places],
            counts: PassCounts::default(),
        }
    }

    /// The sums at all places, from those of each rank's own.
    fn totals(&self, deal: &Deal<'_>) -> Vec<[f64; K]> {
        let own = self.sums[deal.own_places()].as_flattened().iter();
        let totals = deal.complete(own.map(CompensatedSum::total).collect());
        totals.as_chunks::<K>().0.to_vec()
    }

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
            &mut |brought| {
                for (places, numbers) in brought {
                    self.add(places.clone(), numbers);
                }
            },
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
        let bands = self.bands(SIDE).map(|band| {
            let left_out = band.pairs - band.tiles.iter().map(Tile::pairs).sum::<usize>();
            self.advance(left_out);
            band.tiles
        });
        let of_tile = |tile: &Tile| {
            let sums = self.tile_sums(tile, &term);
            self.advance(tile.pairs());
            sums
        };
        let deal = Deal::new(self.ranks(), self.rows());
        let (totals, counts) = sums_of_tiles(&deal, bands, of_tile)?;
        Ok((self.by_row(&totals), self.summary(counts)))
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
        let mut sums = TileSums::none(tile);
        sums.counts = self.walk(
            block,
            |place| order[place],
            |[row, column], facing, answer| {
                if facing != Facing::Visible {
                    return;
                }
                let terms = term(order[row], order[column], &answer.exchange);
                sums.add(
                    [row - block.rows.start, column - block.columns.start],
                    row == column,
                    terms,
                );
            },
        )?;
        Ok(sums)
    }

    /// The sums over each row, from those over all [tiles](Self::tiles) of one side in their order:
    /// the same to the last bit wherever the tiles were summed.
    pub fn row_sums_of<const K: usize>(
        &self,
        sums: impl IntoIterator<Item = (Tile, TileSums<K>)>,
    ) -> (Vec<[f64; K]>, PassSummary) {
        let deal = Deal::new(&Alone, self.rows());
        let mut all = RowSums::none(self.rows());
        for (tile, more) in sums {
            all.take(&deal, (0, &[tile]), &[more]);
        }
        (self.by_row(&all.totals(&deal)), self.summary(all.counts))
    }

    /// Numbers by place in the order by plane sets, in the order of the rows.
    fn by_row<const K: usize>(&self, totals: &[[f64; K]]) -> Vec<[f64; K]> {
        let mut by_row = vec![[0.0; K]; self.rows()];
        for (row, totals) in self.plane_sets().order().iter().zip(totals) {
            by_row[*row] = *totals;
        }
        by_row
    }
}

/// The sums over each row by its place, of tiles that are summed wherever they are dealt to, and
/// their counts.
///
/// **Arguments** `bands`: the tiles in their order, some at a time.
pub(in crate::exchange) fn sums_of_tiles<const K: usize>(
    deal: &Deal<'_>,
    bands: impl Iterator<Item = Vec<Tile>>,
    of_tile: impl Fn(&Tile) -> Result<TileSums<K>, ExchangeError> + Sync,
) -> Result<(Vec<[f64; K]>, PassCounts), ExchangeError> {
    let (mut sums, mut first, mut tiles) = (RowSums::none(deal.places()), 0, Vec::new());
    let enough = TILES_A_RANK * deal.ranks().count();
    let mut bands = bands.peekable();
    while let Some(band) = bands.next() {
        tiles.extend(band);
        if tiles.len() < enough && bands.peek().is_some() {
            continue;
        }
        let own: Vec<usize> = deal.own_parts(first..first + tiles.len()).collect();
        let found: Vec<Result<TileSums<K>, ExchangeError>> = own
            .par_iter()
            .map(|part| of_tile(&tiles[part - first]))
            .collect();
        let found: Result<Vec<TileSums<K>>, ExchangeError> = found.into_iter().collect();
        sums.take(deal, (first, &tiles), &agreed(deal.ranks(), found)?);
        first += tiles.len();
        tiles.clear();
    }
    Ok((sums.totals(deal), sums.counts))
}
