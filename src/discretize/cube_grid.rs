//! Mutual information of a tensor grid on the inside of a cube (figs. 4 and 5).
//!
//! All faces carry the same lines in both directions, and the lines are symmetric about the middle, so
//! a face is seen by the opposite one and by four adjacent ones alike:
//!
//! ```text
//!   I = (1/A_T) [ 6 Σ D_parallel + 24 Σ D_perpendicular ]
//! ```
//!
//! over the cell pairs of one opposite and one adjacent pair of faces, as a sum of non-negative
//! terms. As a line and its mirror image move, only the joint probabilities matter: because
//! `w_i = Σ_j J_ij` sums to one, `dI = Σ dJ_ij ln( J_ij/(w_i w_j) ) − 2 Σ dw_i`, and the last sum vanishes.
//! Pairs that are mirror images of each other are computed once ([`CellPair`]).
//!
//! **Not covered**: boxes, grids whose axes differ, lines that are not symmetric.

use super::DiscretizeError;
use super::cell_pair::{CellPair, classes};
use crate::geometry::Span;
use crate::numeric::{Dual, Scalar, maximum_of_many};

/// Lines `0 < t_1 < … < 1` with `t_k + t_{n+1−k} = 1`, on both axes of all six faces of the unit cube.
#[derive(Debug, Clone, PartialEq)]
pub struct CubeGrid<S = f64> {
    cells: Vec<Span<S>>,
}

/// Area of the cube's faces.
pub(super) const TOTAL_AREA: f64 = 6.0;

impl CubeGrid {
    /// The grid with these inner lines.
    ///
    /// # Errors
    /// [`DiscretizeError::Geometry`] unless they increase inside `(0, 1)`;
    /// [`DiscretizeError::OutOfRange`] unless they are symmetric about 1/2.
    pub fn try_new(lines: &[f64]) -> Result<Self, DiscretizeError> {
        let mirrored = lines.iter().zip(lines.iter().rev());
        if let Some((line, _)) = mirrored
            .into_iter()
            .find(|(a, b)| (*a + *b - 1.0).abs() > f64::EPSILON)
        {
            let (parameter, condition) = ("a grid line", "mirrored about 1/2 by another line");
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value: *line,
                condition,
            });
        }
        Self::from_lines(lines, &1.0)
    }

    /// The grid of `cells` equal cells a side.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] for zero cells.
    pub fn regular(cells: u32) -> Result<Self, DiscretizeError> {
        at_least_one(cells)?;
        Self::try_new(&super::regular_positions(cells))
    }

    /// The grid of `cells` cells a side with the most mutual information near the regular one: every
    /// line at the root of its derivative.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] for zero cells; [`DiscretizeError::Numeric`] if the lines do not
    /// come to rest.
    pub fn best(cells: u32) -> Result<Self, DiscretizeError> {
        let half: Vec<f64> = super::regular_positions(cells.max(1))
            .into_iter()
            .filter(|line| *line < 0.5)
            .collect();
        if half.is_empty() {
            return Self::regular(cells);
        }
        let grid = |doubled: &[f64]| {
            let half: Vec<f64> = doubled.iter().map(|line| 0.5 * line).collect();
            Self::mirrored(&half, cells, &1.0)
        };
        // a refused grid has no gradient; the optimiser reports where
        let gradient = |doubled: &[f64]| {
            grid(doubled)
                .and_then(|grid| grid.gradient())
                .unwrap_or_else(|_| vec![f64::NAN; doubled.len()])
        };
        let doubled = maximum_of_many(gradient, half.iter().map(|line| 2.0 * line).collect())?;
        grid(&doubled)
    }
}

impl<S: Scalar> CubeGrid<S> {
    /// The grid of `cells` cells a side whose lines below 1/2 are `half`; the others are their mirror images, and
    /// 1/2 for an even number of cells.
    ///
    /// **Arguments** `like` sets the type and precision.
    ///
    /// # Errors
    /// [`DiscretizeError::Geometry`] unless the lines increase inside `(0, 1/2)`.
    pub fn mirrored(half: &[S], cells: u32, like: &S) -> Result<Self, DiscretizeError> {
        let one = like.constant(1.0);
        let middle = cells.is_multiple_of(2).then(|| like.constant(0.5));
        let upper = half.iter().rev().map(|line| one.clone() - line);
        let lines: Vec<S> = half.iter().cloned().chain(middle).chain(upper).collect();
        Self::from_lines(&lines, like)
    }

    /// The grid of `cells` equal cells a side, in the type and precision of `like`.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] for zero cells.
    pub fn regular_like(cells: u32, like: &S) -> Result<Self, DiscretizeError> {
        at_least_one(cells)?;
        let count = like.constant(f64::from(cells));
        let lines = (1..cells).map(|k| like.constant(f64::from(k)) / &count);
        Self::from_lines(&lines.collect::<Vec<S>>(), like)
    }

    fn from_lines(lines: &[S], like: &S) -> Result<Self, DiscretizeError> {
        let (zero, one) = (like.zero(), like.constant(1.0));
        let from = std::iter::once(&zero).chain(lines);
        let to = lines.iter().chain(std::iter::once(&one));
        let cells = from
            .zip(to)
            .map(|(from, to)| Span::try_new(from.clone(), to.clone()))
            .collect::<Result<_, _>>()?;
        Ok(Self { cells })
    }

    /// The inner lines, increasing.
    #[must_use]
    pub fn lines(&self) -> Vec<S> {
        self.cells[1..]
            .iter()
            .map(|cell| cell.lower().clone())
            .collect()
    }

    /// Discrete mutual information of the cube with this grid, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a cell is refused.
    pub fn mutual_information(&self) -> Result<S, DiscretizeError> {
        let like = self.cells[0].length();
        let (one, total) = (like.constant(1.0), like.constant(TOTAL_AREA));
        // a face does not see itself: x = −1, φ = 1, on six faces
        let mut nats = one.clone() / &total;
        for (pair, count) in self.pairs() {
            let areas = pair.areas();
            let x = pair.exchange()? * &total / &areas - &one;
            let independent = areas / &total.square();
            nats = nats + &(x.divergence_kernel() * &independent * &like.constant(count));
        }
        Ok(nats / &like.constant(2.0).ln())
    }

    /// The derivative of the mutual information by the position of each line below 1/2, as that line moves on every
    /// face at once and its mirror image against it, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a cell is refused.
    pub fn gradient(&self) -> Result<Vec<S>, DiscretizeError> {
        let cells = self.cells.len();
        let half: Vec<S> = self.lines().into_iter().take((cells - 1) / 2).collect();
        let count = u32::try_from(cells).unwrap_or(u32::MAX);
        let like = Dual::constant_like(self.cells[0].length());
        (0..half.len())
            .map(|k| {
                let mut point: Vec<Dual<S>> = half.iter().map(Dual::constant_like).collect();
                point[k] = Dual::variable(half[k].clone());
                let grid = CubeGrid::mirrored(&point, count, &like)?;
                Ok(grid.mutual_information()?.slope)
            })
            .collect()
    }

    /// One pair of cells of each class, with how many there are on the cube.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (CellPair<'_, S>, f64)> {
        classes(self.cells.len()).into_iter().map(|class| {
            let count = class.count;
            (CellPair::new(&self.cells, class), count)
        })
    }
}

/// Refuses a grid without cells.
const fn at_least_one(cells: u32) -> Result<(), DiscretizeError> {
    if cells > 0 {
        return Ok(());
    }
    let (parameter, condition) = ("the number of cells", "at least 1");
    Err(DiscretizeError::OutOfRange {
        parameter,
        value: 0.0,
        condition,
    })
}
