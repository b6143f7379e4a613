//! The state of a store: what is there, and whether it keeps the laws of form factors.
//!
//! ```text
//!   0 ≤ F_ij ≤ 1 + e_ij,   |A_i F_ij − A_j F_ji| ≤ A_i e_ij + A_j e_ji,   Σ_j F_ij ≤ 1 + Σ_j e_ij
//! ```

use super::StoreError;
use super::chunk::{Chunks, of_doubles, of_singles};
use super::identity::{layout, no_store};
use crate::numeric::{CompensatedSum, parallel_map, real};
use std::path::Path;

/// Part of the larger exchange area that rounding may change: a quotient and a product.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The state of a store, as a record.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct StoreState {
    /// The number of rows.
    pub rows: usize,
    /// The number of rows along a chunk.
    pub side: usize,
    /// Tiles of the matrix.
    pub tiles: usize,
    /// Tiles that are not there, or not whole.
    pub missing: usize,
    /// The first of them, in rows and columns of chunks.
    pub first_missing: Option<[usize; 2]>,
    /// Entries that break a law beyond their bounds.
    pub broken: usize,
    /// The first of them, as row and column.
    pub first_broken: Option<[usize; 2]>,
    /// The largest bound on the error of an entry.
    pub largest_bound: f64,
    /// The least sum of a row of which all is there; none if there is none.
    pub least_sum: Option<f64>,
    /// The largest sum of such a row.
    pub largest_sum: Option<f64>,
    /// The largest sum of the bounds of such a row.
    pub largest_sum_bound: Option<f64>,
}

/// The state of one tile.
#[derive(Debug, Clone, Default)]
struct TileState {
    is_there: bool,
    broken: usize,
    first_broken: Option<[usize; 2]>,
    largest_bound: f64,
    /// Sums of values and of bounds, over the rows of either chunk.
    sums: Vec<(usize, [f64; 2])>,
}

/// Reads a store through, a tile a thread at a time.
///
/// # Errors
/// [`StoreError::NoStore`], [`StoreError::Io`].
pub fn check_store(folder: &Path) -> Result<StoreState, StoreError> {
    let [rows, side] = layout(folder)?;
    if rows == 0 || side == 0 {
        return Err(no_store(folder));
    }
    let chunks = rows.div_ceil(side);
    let of = |first| (first..chunks).map(move |second| [first, second]);
    let tiles: Vec<[usize; 2]> = (0..chunks).flat_map(of).collect();
    let reader = Reader::open(folder, rows, side)?;
    let states = parallel_map(tiles.len(), &|index| reader.tile(tiles[index]));
    let mut state = StoreState {
        rows,
        side,
        tiles: tiles.len(),
        missing: 0,
        first_missing: None,
        broken: 0,
        first_broken: None,
        largest_bound: 0.0,
        least_sum: None,
        largest_sum: None,
        largest_sum_bound: None,
    };
    let mut sums = vec![Some([CompensatedSum::default(); 2]); rows];
    for (tile, found) in tiles.iter().zip(states) {
        let found = found?;
        if !found.is_there {
            state.missing += 1;
            state.first_missing = state.first_missing.or(Some(*tile));
            for chunk in tile {
                let end = (chunk * side + side).min(rows);
                sums[chunk * side..end].fill(None);
            }
            continue;
        }
        state.broken += found.broken;
        state.first_broken = state.first_broken.or(found.first_broken);
        state.largest_bound = state.largest_bound.max(found.largest_bound);
        for (row, [value, bound]) in found.sums {
            if let Some([values, bounds]) = &mut sums[row] {
                values.add(value);
                bounds.add(bound);
            }
        }
    }
    state.take_sums(&sums);
    Ok(state)
}

impl StoreState {
    /// Whether all is there, and keeps the laws.
    #[must_use]
    pub const fn is_whole(&self) -> bool {
        self.missing == 0 && self.broken == 0
    }

    fn take_sums(&mut self, sums: &[Option<[CompensatedSum; 2]>]) {
        for (row, sum) in sums.iter().enumerate() {
            let Some([value, bound]) = sum.map(|both| both.map(|sum| sum.total())) else {
                continue;
            };
            let least = self.least_sum.map_or(value, |least| least.min(value));
            let largest = self.largest_sum.map_or(value, |most| most.max(value));
            let most = self.largest_sum_bound.map_or(bound, |most| most.max(bound));
            [self.least_sum, self.largest_sum] = [Some(least), Some(largest)];
            self.largest_sum_bound = Some(most);
            if value > 1.0 + bound + real(self.rows) * f64::EPSILON {
                self.broken += 1;
                self.first_broken = self.first_broken.or(Some([row, row]));
            }
        }
    }
}

/// A store that is read.
struct Reader {
    factors: Chunks,
    bounds: Chunks,
    areas: Vec<f64>,
    side: usize,
}

impl Reader {
    fn open(folder: &Path, rows: usize, side: usize) -> Result<Self, StoreError> {
        let [factors, bounds] = Chunks::of_matrix(folder, side);
        let areas = Chunks::of_areas(folder, rows).read(&[0])?;
        let areas = areas.ok_or_else(|| no_store(folder))?;
        Ok(Self {
            factors,
            bounds,
            areas: of_doubles(&areas),
            side,
        })
    }

    fn chunk(&self, place: [usize; 2]) -> Result<Option<[Vec<f64>; 2]>, StoreError> {
        let [factors, bounds] = [self.factors.read(&place)?, self.bounds.read(&place)?];
        let both = factors.zip(bounds);
        Ok(both.map(|(factors, bounds)| [of_doubles(&factors), of_singles(&bounds)]))
    }

    fn tile(&self, [first, second]: [usize; 2]) -> Result<TileState, StoreError> {
        let there = self.chunk([first, second])?;
        let Some((there, back)) = there.zip(self.chunk([second, first])?) else {
            return Ok(TileState::default());
        };
        let mut state = TileState {
            is_there: true,
            ..TileState::default()
        };
        let rows = |chunk: usize| {
            let start = chunk * self.side;
            start..(start + self.side).min(self.areas.len())
        };
        for row in rows(first) {
            let mut sums = [CompensatedSum::default(); 2];
            for column in rows(second) {
                let [i, j] = [row - first * self.side, column - second * self.side];
                let [at, mirrored] = [i * self.side + j, j * self.side + i];
                let one = [there[0][at], there[1][at]];
                let other = [back[0][mirrored], back[1][mirrored]];
                if !is_lawful([one, other], [self.areas[row], self.areas[column]]) {
                    state.broken += 1;
                    state.first_broken = state.first_broken.or(Some([row, column]));
                }
                state.largest_bound = state.largest_bound.max(one[1]).max(other[1]);
                sums[0].add(one[0]);
                sums[1].add(one[1]);
            }
            state.sums.push((row, sums.map(|sum| sum.total())));
        }
        if first != second {
            for row in rows(second) {
                let start = (row - second * self.side) * self.side;
                let line = start..start + rows(first).len();
                let sum = |values: &[f64]| {
                    let mut sum = CompensatedSum::default();
                    for value in &values[line.clone()] {
                        sum.add(*value);
                    }
                    sum.total()
                };
                state.sums.push((row, [sum(&back[0]), sum(&back[1])]));
            }
        }
        Ok(state)
    }
}

/// Whether two entries are form factors of each other, within their bounds.
fn is_lawful([one, other]: [[f64; 2]; 2], areas: [f64; 2]) -> bool {
    let is_factor = |[value, bound]: [f64; 2]| value >= 0.0 && bound >= 0.0 && value <= 1.0 + bound;
    let exchanged = [areas[0] * one[0], areas[1] * other[0]];
    let allowed = areas[0] * one[1] + areas[1] * other[1] + ROUNDING * exchanged[0];
    is_factor(one) && is_factor(other) && (exchanged[0] - exchanged[1]).abs() <= allowed
}
