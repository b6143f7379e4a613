//! Tiles: the unit of work of a pass over all pairs.
//!
//! ```text
//!   off the diagonal:  all (i, j) with i in the rows, j in the columns, no row in common
//!   on the diagonal:   the pairs i ≤ j of one run of rows; (i, i) is 0 unless row i may see
//!                      itself
//! ```
//!
//! All passes walk over pairs in the same way ([`ScenePairs::walk`]), each pair once. A tile needs
//! nothing but the scene's pairs, so that tiles may be computed anywhere, in any order; what is
//! summed of them is summed in the order of [`ScenePairs::tiles`], and comes out the same for any
//! number of threads or machines.

use crate::exchange::pairs::row_pair::nothing;
use crate::exchange::plan::counts::PassCounts;
use crate::exchange::plan::facing::Facing;
use crate::exchange::{ExchangeError, ScenePairs};
use crate::form_factor::Answer;
use crate::form_factor::together::TOGETHER;
use std::ops::Range;

/// A rectangle of pairs: rows against rows, by place in some order of the rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Block {
    /// The rows; the same as the columns, or without a row in common with them.
    pub(crate) rows: Range<usize>,
    /// The columns.
    pub(crate) columns: Range<usize>,
    /// Whether the planes of all pairs are known to face each other.
    pub(crate) is_visible: bool,
}

impl Block {
    /// One row against some, about whose planes nothing is known.
    pub(crate) const fn of_row(row: usize, columns: Range<usize>) -> Self {
        Self {
            rows: row..row + 1,
            columns,
            is_visible: false,
        }
    }

    fn is_on_diagonal(&self) -> bool {
        self.rows == self.columns
    }
}

/// Some rows against some rows, in the order by the planes that they lie in.
///
/// A tile belongs to the pairs that it was made by, and to others of the same scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tile(Block);

impl Tile {
    /// Number of pairs of different rows.
    #[must_use]
    pub fn pairs(&self) -> usize {
        let (rows, columns) = (self.0.rows.len(), self.0.columns.len());
        if self.0.is_on_diagonal() {
            rows * (rows - 1) / 2
        } else {
            rows * columns
        }
    }

    /// A block as a tile.
    pub(in crate::exchange) const fn of(block: Block) -> Self {
        Self(block)
    }

    pub(crate) const fn block(&self) -> &Block {
        &self.0
    }
}

/// The exchange areas of a tile, all of its rows with all of its columns.
#[derive(Debug, Clone, PartialEq)]
pub struct TileAnswers {
    /// The rows of the scene that are the tile's rows.
    pub rows: Vec<usize>,
    /// The rows of the scene that are the tile's columns.
    pub columns: Vec<usize>,
    /// The exchange areas, row by row.
    pub values: Vec<f64>,
    /// The bounds on their errors.
    pub errors: Vec<f64>,
    /// The counts of the tile's pairs.
    pub counts: PassCounts,
}

/// The tiles with the same rows.
pub(crate) struct Band {
    /// Number of pairs of these rows with those that come later, in tiles or not.
    pub(crate) pairs: usize,
    pub(crate) tiles: Vec<Tile>,
}

/// Consecutive rows, by place in the order by plane sets.
#[derive(Debug, Clone)]
struct Run {
    places: Range<usize>,
    /// The plane set that they all have, if it is one.
    plane_set: Option<usize>,
}

impl ScenePairs<'_> {
    /// The tiles of up to `side` × `side` rows that may exchange anything, in the order in which
    /// their sums are added up. Each pair that the plan does not leave out is in one of them.
    ///
    /// # Examples
    /// ```
    /// use infoscene::exchange::{Congruence, ScenePairs};
    /// use infoscene::scene::{Occlusion, Scene};
    /// let cube = Scene::built_in("cube:2")?;
    /// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Exact)?;
    /// let mut sum = 0.0;
    /// for tile in pairs.tiles(8) {
    ///     sum += 2.0 * pairs.tile(&tile)?.values.iter().sum::<f64>();
    /// }
    /// // faces of four patches each: no tile is on the diagonal, and the scene is closed
    /// assert!((sum - 6.0).abs() < 1e-13);
    /// # Ok::<(), infoscene::exchange::ExchangeError>(())
    /// ```
    pub fn tiles(&self, side: usize) -> impl Iterator<Item = Tile> {
        self.bands(side).flat_map(|band| band.tiles)
    }

    /// The tiles, those with the same rows at a time.
    pub(crate) fn bands(&self, side: usize) -> impl Iterator<Item = Band> {
        let runs = self.runs(side.max(1));
        (0..runs.len()).map(move |first| {
            let rows = &runs[first];
            let tiles = runs[first..].iter();
            Band {
                pairs: rows.places.clone().map(|row| self.rows() - 1 - row).sum(),
                tiles: tiles
                    .filter_map(|columns| self.tile_of(rows, columns))
                    .collect(),
            }
        })
    }

    /// The exchange areas of a tile.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused.
    pub fn tile(&self, tile: &Tile) -> Result<TileAnswers, ExchangeError> {
        let Block { rows, columns, .. } = tile.block();
        let order = self.plane_sets().order();
        let width = columns.len();
        let mut values = vec![0.0; rows.len() * width];
        let mut errors = values.clone();
        let is_on_diagonal = tile.block().is_on_diagonal();
        let counts = self.walk(
            tile.block(),
            |place| order[place],
            |[row, column], _, answer| {
                let (row, column) = (row - rows.start, column - columns.start);
                let mut put = |at: usize| {
                    values[at] = answer.exchange.value;
                    errors[at] = answer.exchange.error;
                };
                put(row * width + column);
                if is_on_diagonal {
                    put(column * width + row);
                }
            },
        )?;
        Ok(TileAnswers {
            rows: order[rows.clone()].to_vec(),
            columns: order[columns.clone()].to_vec(),
            values,
            errors,
            counts,
        })
    }

    /// Visits the pairs of a block, row by row, by their places: the one way in which passes
    /// evaluate pairs.
    ///
    /// **Arguments** `row_at`: the row at a place; `visit`: takes the places of a pair, whether
    /// its planes face each other, and its answer.
    #[inline]
    pub(crate) fn walk(
        &self,
        block: &Block,
        row_at: impl Fn(usize) -> usize,
        mut visit: impl FnMut([usize; 2], Facing, &Answer),
    ) -> Result<PassCounts, ExchangeError> {
        let Block { rows, columns, .. } = block;
        let is_on_diagonal = block.is_on_diagonal();
        debug_assert!(is_on_diagonal || rows.end <= columns.start || columns.end <= rows.start);
        let mut counts = PassCounts::default();
        let mut known = [None; TOGETHER];
        for row in rows.clone() {
            let first = row_at(row);
            let start = if is_on_diagonal { row } else { columns.start };
            let facing = |second: usize| {
                if block.is_visible {
                    Facing::Visible
                } else {
                    self.facing(first, second)
                }
            };
            for start in (start..columns.end).step_by(TOGETHER) {
                let columns = start..columns.end.min(start + TOGETHER);
                let others = columns.clone().map(&row_at);
                let others =
                    others.map(|second| (facing(second) == Facing::Visible).then_some(second));
                self.evaluate_together(first, others, &mut known);
                for (column, known) in columns.zip(&known) {
                    let second = row_at(column);
                    let facing = facing(second);
                    let answer = match facing {
                        Facing::Visible => {
                            self.visible_row_pair(first, second, *known, &mut counts)?
                        }
                        hidden => nothing(hidden, first == second),
                    };
                    visit([row, column], facing, &answer);
                }
            }
        }
        Ok(counts)
    }

    /// The tile of two runs, if they may exchange anything.
    fn tile_of(&self, rows: &Run, columns: &Run) -> Option<Tile> {
        let is_visible = match (rows.plane_set, columns.plane_set) {
            (Some(first), Some(second)) => {
                if self.facing_sets(first, second) != Facing::Visible {
                    return None;
                }
                true
            }
            _ => false,
        };
        Some(Tile(Block {
            rows: rows.places.clone(),
            columns: columns.places.clone(),
            is_visible,
        }))
    }

    /// The rows in the order of their plane sets, cut into runs; a run starts with each plane set
    /// of many rows.
    fn runs(&self, side: usize) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        for (plane_set, places) in self.plane_sets().places().enumerate() {
            let is_large = places.len() > side / 4;
            match runs.last_mut() {
                Some(last) if !is_large && places.end - last.places.start <= side => {
                    last.places.end = places.end;
                    last.plane_set = None;
                }
                _ => {
                    let starts = places.clone().step_by(side);
                    runs.extend(starts.map(|start| Run {
                        places: start..places.end.min(start + side),
                        plane_set: Some(plane_set),
                    }));
                }
            }
        }
        runs
    }
}
