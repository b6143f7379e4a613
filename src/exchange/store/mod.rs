//! A matrix of form factors larger than memory, in a folder that survives its writer.
//!
//! ```text
//!   DIR/zarr.json              a group of Zarr, version 3
//!   DIR/form_factors/c/I/J     F of the rows from I · side and the columns from J · side, f64
//!   DIR/bounds/c/I/J           bounds on the absolute errors, f32, rounded up
//!   DIR/areas/c/0              the area of each row, f64
//!   DIR/form_factors/scene.txt all that the numbers depend on
//! ```
//!
//! Chunks are raw, little-endian, of one size; what lies beyond the last row is NaN. A *tile* is
//! the rows of I with those of J ≥ I: its exchange areas give the chunks (I, J) and (J, I). Each
//! chunk is written aside and renamed, so that a chunk that exists is done. A tile needs nothing of
//! others: any number of threads, processes or machines that share the folder write the same bytes,
//! and one that is killed loses the tiles it had begun.
//!
//! **Memory** per thread `40 side²` bytes, and what the scene's pairs take; no matrix is held.
//!
//! Open `identity` for what a store is of, `zarr` for its metadata, `check` for the state of one,
//! `stored` for how a whole one is read, `products` for what a solution leaves in it until it is
//! finished.
//!
//! **Not covered**: loss of power, which may leave an empty chunk: it counts as missing.

mod check;
mod chunk;
mod error;
mod identity;
mod products;
mod row_sums;
mod stored;
mod zarr;

pub use check::{StoreState, check_store};
pub use error::StoreError;
pub use products::ProductFiles;
pub(crate) use stored::unread;
pub use stored::{StoredBlocks, StoredMatrix};

use super::passes::tiles::Block;
use super::ranks::{Deal, RankFailed, agreed};
use super::{Congruence, ExchangeError, PassCounts, PassSummary, ScenePairs};
use crate::scene::{Occlusion, Scene};
use chunk::{Aside, Chunks};
use identity::Identity;
use rayon::prelude::*;
use std::ops::Range;
use std::path::Path;

/// Rows along a chunk, at most: 8 MB of form factors.
const LARGEST_SIDE: usize = 1024;
/// Rows along a chunk of a small matrix, so that there is work for every thread.
const SMALLEST_SIDE: usize = 64;
/// Chunks along a side of a small matrix, about.
const CHUNKS: usize = 8;

/// A share of a matrix's tiles: those with `index ≡ number (mod of)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// The number of the share, from 0.
    pub number: usize,
    /// The number of shares, ≥ 1.
    pub of: usize,
}

impl Default for Shard {
    /// All of them.
    fn default() -> Self {
        Self { number: 0, of: 1 }
    }
}

/// A matrix of form factors in a folder.
#[derive(Debug)]
pub struct MatrixStore<'p> {
    pairs: &'p ScenePairs<'p>,
    side: usize,
    factors: Chunks,
    bounds: Chunks,
    aside: Aside,
}

/// The outcome of filling a store.
#[derive(Debug, Clone, PartialEq)]
pub struct StoreFilled {
    /// Tiles of the whole matrix.
    pub tiles: usize,
    /// Tiles that were there before.
    pub found: usize,
    /// Tiles that were computed now.
    pub written: usize,
    /// The pairs that were computed now, and whether they reach the tolerance.
    pub summary: PassSummary,
}

impl<'p> MatrixStore<'p> {
    /// A store of a scene's matrix in a folder: a new one, or with `resume` that of the same
    /// matrix which is there.
    ///
    /// **Arguments** `pairs`: those of the scene, with this treatment of congruent pairs and of
    /// what stands in the way; of their ranks the first makes the folder that the others find.
    ///
    /// # Errors
    /// [`StoreError::NotEmpty`] if anything is there that is not to be resumed;
    /// [`StoreError::OtherMatrix`] if it is the store of another matrix; [`StoreError::Io`];
    /// [`ExchangeError::Rank`] of another rank's.
    pub fn open(
        folder: &Path,
        scene: &Scene,
        pairs: &'p ScenePairs<'p>,
        treatment: (Congruence, Occlusion),
        resume: bool,
    ) -> Result<Self, StoreError> {
        let own = |resume| Self::of_rank(folder, scene, pairs, treatment, resume);
        let first = (pairs.ranks().number() == 0).then(|| own(resume));
        match agreed::<_, StoreError>(pairs.ranks(), first.transpose())? {
            Some(store) => Ok(store),
            None => own(true),
        }
    }

    fn of_rank(
        folder: &Path,
        scene: &Scene,
        pairs: &'p ScenePairs<'p>,
        (congruence, occlusion): (Congruence, Occlusion),
        resume: bool,
    ) -> Result<Self, StoreError> {
        let rows = pairs.rows();
        let side = side_of(rows);
        let tolerance = pairs.tolerance();
        let identity = Identity::of(scene, (rows, side), tolerance, (congruence, occlusion));
        identity.settle(folder, resume)?;
        let aside = Aside::new(folder)?;
        zarr::write(&aside, folder, rows, side)?;
        let [factors, bounds] = Chunks::of_matrix(folder, side);
        let areas = Chunks::of_areas(folder, rows);
        areas.write(&aside, &[0], &chunk::doubles(pairs.areas().iter().copied()))?;
        Ok(Self {
            pairs,
            side,
            factors,
            bounds,
            aside,
        })
    }

    /// The tiles, by rows of chunks and columns of chunks, in their order.
    fn tiles(&self) -> Vec<[usize; 2]> {
        let chunks = self.pairs.rows().div_ceil(self.side);
        let of = |first| (first..chunks).map(move |second| [first, second]);
        (0..chunks).flat_map(of).collect()
    }

    fn is_done(&self, [first, second]: [usize; 2]) -> bool {
        let places = [[first, second], [second, first]];
        let is_there = |place| self.factors.is_whole(place) && self.bounds.is_whole(place);
        places.iter().all(|place| is_there(place))
    }

    /// Computes the tiles of a share that are not there yet, those of the other ranks of the pairs,
    /// too.
    ///
    /// # Errors
    /// [`StoreError::Exchange`] if two patches are refused; [`StoreError::Io`]. Tiles that were
    /// finished before stay.
    pub fn fill(&self, shard: Shard) -> Result<StoreFilled, StoreError> {
        let tiles = self.tiles();
        let ours: Vec<[usize; 2]> = tiles
            .iter()
            .copied()
            .skip(shard.number)
            .step_by(shard.of.max(1))
            .collect();
        let deal = Deal::new(self.pairs.ranks(), 0);
        let own = deal.own_parts(0..ours.len());
        let own: Vec<[usize; 2]> = own.map(|part| ours[part]).collect();
        let fill = |tile: &[usize; 2]| {
            let counts = (!self.is_done(*tile)).then(|| self.put(*tile)).transpose();
            self.pairs.advance(self.pairs_of(*tile));
            counts
        };
        let filled: Result<Vec<Option<PassCounts>>, StoreError> =
            own.par_iter().map(fill).collect();
        let filled = agreed(deal.ranks(), filled)?;
        let numbers = filled.into_iter().flat_map(|counts| {
            let is_written = f64::from(u8::from(counts.is_some()));
            let counts = counts.unwrap_or_default().numbers();
            std::iter::once(is_written).chain(counts)
        });
        let (mut counts, mut written) = (PassCounts::default(), 0);
        let width = 1 + PassCounts::NUMBERS;
        deal.share(0..ours.len(), width, numbers.collect(), &mut |numbers| {
            counts.merge(&PassCounts::of_numbers(&numbers[1..]));
            written += usize::from(numbers[0] > 0.0);
        });
        Ok(StoreFilled {
            tiles: tiles.len(),
            found: ours.len() - written,
            written,
            summary: self.pairs.summary(counts),
        })
    }

    /// Computes a tile and writes its chunks.
    fn put(&self, [first, second]: [usize; 2]) -> Result<PassCounts, StoreError> {
        let side = self.side;
        let [mut there, mut back] = [self.blank(), self.blank()];
        let block = Block {
            rows: self.rows_of(first),
            columns: self.rows_of(second),
            is_visible: false,
        };
        let (areas, roundings) = (self.pairs.areas(), self.pairs.area_bounds());
        let counts = self.pairs.walk(
            &block,
            |place| place,
            |[row, column], _, answer| {
                let [i, j] = [row - first * side, column - second * side];
                there.set(i * side + j, answer.quotient([areas[row], roundings[row]]));
                back.set(
                    j * side + i,
                    answer.quotient([areas[column], roundings[column]]),
                );
            },
        )?;
        if first == second {
            there.complete(&back, side);
        }
        self.write([first, second], &there)?;
        if first != second {
            self.write([second, first], &back)?;
        }
        Ok(counts)
    }

    fn write(&self, place: [usize; 2], values: &Values) -> Result<(), StoreError> {
        let factors = chunk::doubles(values.factors.iter().copied());
        self.factors.write(&self.aside, &place, &factors)?;
        let bounds = chunk::singles_above(values.bounds.iter().copied());
        self.bounds.write(&self.aside, &place, &bounds)
    }

    fn rows_of(&self, chunk: usize) -> Range<usize> {
        let start = chunk * self.side;
        start..(start + self.side).min(self.pairs.rows())
    }

    fn pairs_of(&self, [first, second]: [usize; 2]) -> usize {
        let [rows, columns] = [first, second].map(|chunk| self.rows_of(chunk).len());
        if first == second {
            rows * (rows - 1) / 2
        } else {
            rows * columns
        }
    }

    fn blank(&self) -> Values {
        let entries = self.side * self.side;
        Values {
            factors: vec![f64::NAN; entries],
            bounds: vec![f64::NAN; entries],
        }
    }
}

/// The entries of a chunk, row by row; NaN beyond the last row.
struct Values {
    factors: Vec<f64>,
    bounds: Vec<f64>,
}

impl Values {
    fn set(&mut self, at: usize, [factor, bound]: [f64; 2]) {
        self.factors[at] = factor;
        self.bounds[at] = bound;
    }

    /// Takes what is below the diagonal from elsewhere.
    fn complete(&mut self, other: &Self, side: usize) {
        for row in 0..side {
            for at in row * side..row * side + row {
                self.set(at, [other.factors[at], other.bounds[at]]);
            }
        }
    }
}

/// The rows along a chunk of a matrix of so many.
fn side_of(rows: usize) -> usize {
    let even = rows.div_ceil(CHUNKS).next_multiple_of(SMALLEST_SIDE);
    even.clamp(SMALLEST_SIDE, LARGEST_SIDE)
}

impl From<RankFailed> for StoreError {
    fn from(failed: RankFailed) -> Self {
        Self::Exchange(failed.into())
    }
}

impl From<ExchangeError> for StoreError {
    fn from(error: ExchangeError) -> Self {
        Self::Exchange(error)
    }
}
