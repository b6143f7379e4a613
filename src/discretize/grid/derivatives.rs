//! The derivatives of the mutual information of a symmetric grid by its lines, all in one pass over
//! the pairs.
//!
//! With `E = J ln(J/q)`, `q = A_i A_j/A_T`, and because the rows of J sum to the areas, whose sum
//! does not change,
//!
//! ```text
//!   A_T ∂_a I  = Σ ∂_a J ln(J/q)
//!   A_T ∂_ab I = Σ [ ∂_ab J ln(J/q) + ∂_a J ∂_b J/J ] − 2 Σ_i ∂_a A_i ∂_b A_i/A_i
//! ```
//!
//! in nats, over ordered pairs. A line moves on every face at once, and its mirror image the other
//! way. The derivatives of J are closed forms ([`EdgeSlopes`](crate::form_factor)); a pair has at
//! most eight edges, whatever the number of lines.
//!
//! **Not covered**: grids whose lines are not symmetric.

use super::BoxGrid;
use super::axis::{Axis, Moves, Spacing};
use super::classes::{Classes, Row};
use super::pair::CellPair;
use crate::discretize::error::DiscretizeError;
use crate::numeric::{Scalar, try_parallel_map};
use nalgebra::{DMatrix, DVector};
use smallvec::SmallVec;
use std::f64::consts::LN_2;

/// Derivatives of the mutual information by the lines below 1/2, in bits.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GridDerivatives {
    pub gradient: DVector<f64>,
    /// The rounding of the gradient: an estimate, as if roundings were random.
    pub gradient_error: DVector<f64>,
    pub hessian: DMatrix<f64>,
}

/// Rows that are summed together, so that the order of sums does not depend on threads; a chunk
/// takes some milliseconds at 64 cells.
const ROWS_PER_CHUNK: usize = 32;

impl BoxGrid {
    /// Gradient and Hessian, from exchange areas within `allowed` of themselves or of those of
    /// independent cells.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a pair is refused.
    pub(crate) fn derivatives(&self, allowed: f64) -> Result<GridDerivatives, DiscretizeError> {
        let grid = self.with_free_lines()?;
        let (classes, free) = (grid.classes()?, grid.axes()[0].free());
        let (total, _) = grid.faces();
        let rows: Vec<&[Row]> = classes.rows().chunks(ROWS_PER_CHUNK).collect();
        let chunks = try_parallel_map(rows.len(), &|chunk| {
            let mut sums = Sums::new(free, &total, true);
            for pair in rows[chunk].iter().flat_map(|row| classes.row(row)) {
                let product = pair.areas() / total;
                let exchange = pair.exchange_area(product, allowed)?;
                let error = exchange.error / exchange.value;
                sums.add(&pair, &exchange.value, &product, error);
            }
            Ok::<_, DiscretizeError>(sums)
        })?;
        let mut sums = Sums::new(free, &total, true);
        for chunk in chunks {
            sums.merge(&chunk);
        }
        let unit = total * LN_2;
        let mut hessian = DMatrix::from_fn(free, free, |a, b| sums.hessian[a * free + b] / unit);
        grid.add_areas(&mut hessian);
        Ok(GridDerivatives {
            gradient: DVector::from_vec(sums.gradient) / unit,
            gradient_error: DVector::from_vec(sums.squares).map(f64::sqrt) / unit,
            hessian,
        })
    }

    /// Adds `−2 Σ_i ∂_a A_i ∂_b A_i/A_i` over the total area, in bits: with l the lengths of cells
    /// relative to an edge, `−4 Σ ∂_a l ∂_b l/l`.
    fn add_areas(&self, hessian: &mut DMatrix<f64>) {
        for (length, moves) in self.axes()[0].lengths() {
            for (a, by) in &moves {
                for (b, more) in &moves {
                    hessian[(*a, *b)] -= 4.0 * by * more / (length * LN_2);
                }
            }
        }
    }
}

impl<S: Scalar> BoxGrid<S> {
    /// The derivative of the mutual information by the position of each line below 1/2, as that
    /// line moves on every face at once and its mirror image the other way, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a pair is refused; [`DiscretizeError::OutOfRange`] if
    /// lines are not symmetric.
    pub fn gradient(&self) -> Result<Vec<S>, DiscretizeError> {
        let grid = self.with_free_lines()?;
        let classes: Classes<S> = grid.classes()?;
        let (total, _) = grid.faces();
        let mut sums = Sums::new(grid.axes()[0].free(), &total, false);
        for pair in classes.pairs() {
            let product = pair.areas() / &total;
            sums.add(&pair, &pair.exchange()?, &product, 0.0);
        }
        let unit = total.constant(2.0).ln() * &total;
        Ok(sums.gradient.into_iter().map(|sum| sum / &unit).collect())
    }

    /// The grid with its lines free to move, not known to be equally spaced.
    fn with_free_lines(&self) -> Result<Self, DiscretizeError> {
        match self.spacing() {
            Spacing::Symmetric => Ok(self.clone()),
            Spacing::Regular => self.respaced(Spacing::Symmetric),
            Spacing::Any => Err(DiscretizeError::out_of_range(
                "the number of lines without a mirror image",
                f64::from(u32::try_from(self.lines().len()).unwrap_or(u32::MAX)),
                "0 where lines move in pairs",
            )),
        }
    }
}

/// Sums over pairs, in nats times the total area.
#[derive(Debug, Clone)]
struct Sums<S> {
    gradient: Vec<S>,
    /// Squares of the roundings.
    squares: Vec<f64>,
    /// Row by row; empty if not wanted.
    hessian: Vec<S>,
}

impl<S: Scalar> Sums<S> {
    fn new(free: usize, like: &S, with_hessian: bool) -> Self {
        Self {
            gradient: vec![like.zero(); free],
            squares: vec![0.0; free],
            hessian: vec![like.zero(); if with_hessian { free * free } else { 0 }],
        }
    }

    fn merge(&mut self, other: &Self) {
        let add = |to: &mut Vec<S>, from: &[S]| {
            for (to, from) in to.iter_mut().zip(from) {
                *to = to.clone() + from;
            }
        };
        add(&mut self.gradient, &other.gradient);
        add(&mut self.hessian, &other.hessian);
        for (to, from) in self.squares.iter_mut().zip(&other.squares) {
            *to += from;
        }
    }

    /// Adds a class of pairs: its exchange area, that of independent cells, and the relative error
    /// of the first.
    fn add(&mut self, pair: &CellPair<'_, S>, exchange: &S, product: &S, error: f64) {
        let (slopes, moves) = (pair.slopes(), pair.moves());
        let count = exchange.constant(pair.count);
        let weight = (exchange.clone() / product).ln() * &count;
        // the free lines that move an edge of the pair
        let mut lines: SmallVec<[(usize, S, f64); 8]> = SmallVec::new();
        for (place, moves) in moves.iter().enumerate() {
            for (line, by) in *moves {
                let slope = slopes.first[place].clone() * by;
                let size = slopes.magnitude[place].to_f64() * by.to_f64().abs();
                match lines.iter_mut().find(|(other, ..)| other == line) {
                    Some((_, sum, sizes)) => {
                        *sum = sum.clone() + &slope;
                        *sizes += size;
                    }
                    None => lines.push((*line, slope, size)),
                }
            }
        }
        for (line, slope, size) in &lines {
            self.gradient[*line] = self.gradient[*line].clone() + &(weight.clone() * slope);
            if S::TRACKS_ROUNDING {
                let rounding = 4.0 * f64::EPSILON * size * weight.to_f64();
                let from_exchange = error * slope.to_f64() * pair.count;
                self.squares[*line] += rounding * rounding + from_exchange * from_exchange;
            }
        }
        if self.hessian.is_empty() {
            return;
        }
        let free = self.gradient.len();
        let share = count / exchange;
        for (line, slope, _) in &lines {
            let slope = share.clone() * slope;
            for (other, by, _) in &lines {
                let entry = &mut self.hessian[line * free + other];
                *entry = entry.clone() + &(slope.clone() * by);
            }
        }
        for (row, moves_of_row) in slopes.second.iter().zip(moves) {
            for (second, moves_of_column) in row.iter().zip(moves) {
                if second.is_zero() {
                    continue;
                }
                let second = weight.clone() * second;
                for (line, by) in moves_of_row {
                    let second = second.clone() * by;
                    for (other, more) in moves_of_column {
                        let entry = &mut self.hessian[line * free + other];
                        *entry = entry.clone() + &(second.clone() * more);
                    }
                }
            }
        }
    }
}

impl Axis<f64> {
    /// The relative length of each cell, and its derivatives.
    fn lengths(&self) -> impl Iterator<Item = (f64, Moves<f64>)> {
        let lines = self.lines();
        (0..self.cells()).map(move |cell| {
            let relative = self
                .offset_moves(cell + 1, cell)
                .into_iter()
                .map(|(line, by)| (line, by / self.edge()));
            (lines[cell + 1] - lines[cell], relative.collect())
        })
    }
}
