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
//!
//! **Not covered**: boxes, grids whose axes differ, lines that are not symmetric.

use super::DiscretizeError;
use crate::form_factor::{parallel, perpendicular};
use crate::geometry::Span;
use crate::numeric::{compensated_sum, divergence_kernel, maximum_of_many};
use std::f64::consts::LN_2;

/// Lines `0 < t_1 < … < 1` with `t_k + t_{n+1−k} = 1`, on both axes of all six faces of the unit cube.
#[derive(Debug, Clone, PartialEq)]
pub struct CubeGrid {
    cells: Vec<Span>,
}

/// Area of the cube's faces.
const TOTAL_AREA: f64 = 6.0;

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
        let from = std::iter::once(0.0).chain(lines.iter().copied());
        let to = lines.iter().copied().chain(std::iter::once(1.0));
        let cells = from
            .zip(to)
            .map(|(from, to)| Span::try_new(from, to))
            .collect::<Result<_, _>>()?;
        Ok(Self { cells })
    }

    /// The grid of `cells` equal cells a side.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] for zero cells.
    pub fn regular(cells: u32) -> Result<Self, DiscretizeError> {
        if cells == 0 {
            let (parameter, condition) = ("the number of cells", "at least 1");
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value: 0.0,
                condition,
            });
        }
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
            let lower = doubled.iter().map(|line| 0.5 * line);
            let middle = cells.is_multiple_of(2).then_some(0.5);
            let upper = doubled.iter().rev().map(|line| 1.0 - 0.5 * line);
            Self::try_new(&lower.chain(middle).chain(upper).collect::<Vec<f64>>())
        };
        // a refused grid has no gradient; the optimiser reports where
        let gradient = |doubled: &[f64]| match grid(doubled).and_then(|grid| grid.gradient()) {
            Ok(mut gradient) => {
                gradient.truncate(doubled.len());
                gradient
            }
            Err(_) => vec![f64::NAN; doubled.len()],
        };
        let doubled = maximum_of_many(gradient, half.iter().map(|line| 2.0 * line).collect())?;
        grid(&doubled)
    }

    /// The inner lines, increasing.
    #[must_use]
    pub fn lines(&self) -> Vec<f64> {
        self.cells[1..].iter().map(|cell| *cell.lower()).collect()
    }

    /// Discrete mutual information of the cube with this grid, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a cell is refused.
    pub fn mutual_information(&self) -> Result<f64, DiscretizeError> {
        let mut terms = Vec::new();
        self.for_each_pair(|pair| {
            let independent = pair.areas / (TOTAL_AREA * TOTAL_AREA);
            let joint = pair.exchange()? / TOTAL_AREA;
            terms.push(
                pair.multiplicity * independent * divergence_kernel(joint / independent - 1.0),
            );
            Ok(())
        })?;
        // a face does not see itself: x = −1, φ = 1, on six faces
        terms.push(6.0 / (TOTAL_AREA * TOTAL_AREA));
        Ok(compensated_sum(terms) / LN_2)
    }

    /// The derivative of the mutual information by each line's position, as that line moves on every face
    /// at once and its mirror image against it, in bits; 0 for the middle line.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a cell is refused.
    pub fn gradient(&self) -> Result<Vec<f64>, DiscretizeError> {
        let lines = self.cells.len() - 1;
        let mut terms = vec![Vec::new(); lines];
        self.for_each_pair(|pair| {
            let rates = (0..lines)
                .map(|k| pair.rate(k))
                .collect::<Result<Vec<f64>, _>>()?;
            if rates.iter().all(|rate| rate.abs() <= 0.0) {
                return Ok(());
            }
            let ratio = pair.exchange()? * TOTAL_AREA / pair.areas;
            let factor = pair.multiplicity / TOTAL_AREA * ratio.ln();
            for (k, terms) in terms.iter_mut().enumerate() {
                terms.push(factor * (rates[k] - rates[lines - 1 - k]));
            }
            Ok(())
        })?;
        Ok(terms
            .into_iter()
            .map(|terms| compensated_sum(terms) / LN_2)
            .collect())
    }

    fn for_each_pair(
        &self,
        mut visit: impl FnMut(CellPair<'_>) -> Result<(), DiscretizeError>,
    ) -> Result<(), DiscretizeError> {
        let n = self.cells.len();
        let all = || (0..n).flat_map(move |row| (0..n).map(move |column| [row, column]));
        for (faces, multiplicity) in [(Faces::Opposite, 6.0), (Faces::Adjacent, 24.0)] {
            for first in all() {
                for second in all() {
                    let length = |[row, column]: [usize; 2]| {
                        self.cells[row].length() * self.cells[column].length()
                    };
                    let areas = length(first) * length(second);
                    visit(CellPair {
                        cells: &self.cells,
                        faces,
                        multiplicity,
                        first,
                        second,
                        areas,
                    })?;
                }
            }
        }
        Ok(())
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Faces {
    Opposite,
    Adjacent,
}

/// Two cells by their indices on two axes; for adjacent faces the first index is the depth.
#[derive(Debug, Clone, Copy)]
struct CellPair<'g> {
    cells: &'g [Span],
    faces: Faces,
    multiplicity: f64,
    first: [usize; 2],
    second: [usize; 2],
    areas: f64,
}

impl CellPair<'_> {
    fn spans(&self, cell: [usize; 2]) -> [Span; 2] {
        cell.map(|index| self.cells[index])
    }

    fn exchange(&self) -> Result<f64, DiscretizeError> {
        let (first, second) = (self.spans(self.first), self.spans(self.second));
        let exchange = match self.faces {
            Faces::Opposite => parallel::exchange_area(&first, &second, &1.0)?,
            Faces::Adjacent => {
                let plate = |[depth, width]: [Span; 2]| perpendicular::Plate::try_new(depth, width);
                perpendicular::exchange_area(&plate(first)?, &plate(second)?)
            }
        };
        Ok(exchange.resolved(1.0)?.value)
    }

    /// `∂(A F)` as line `k` moves: each side on the line contributes its strip, outwards or inwards.
    fn rate(&self, k: usize) -> Result<f64, DiscretizeError> {
        let mut rate = 0.0;
        for (this, other) in [(self.first, self.second), (self.second, self.first)] {
            for side in 0..2 {
                let sign = match this[side] {
                    cell if cell == k => 1.0, // the line is this cell's upper end
                    cell if cell == k + 1 => -1.0,
                    _ => continue,
                };
                let at = *self.cells[k].upper();
                let (along, other) = (self.cells[this[1 - side]], self.spans(other));
                rate += sign
                    * match (self.faces, side) {
                        (Faces::Opposite, _) => {
                            let other = [other[side], other[1 - side]];
                            parallel::strip_exchange(&at, &along, &other, &1.0)?.value
                        }
                        (Faces::Adjacent, 0) => {
                            let plate = perpendicular::Plate::try_new(other[0], other[1])?;
                            perpendicular::strip_exchange_at_depth(&at, &along, &plate).value
                        }
                        (Faces::Adjacent, _) => {
                            let plate = perpendicular::Plate::try_new(other[0], other[1])?;
                            perpendicular::strip_exchange_at_width(&along, &at, &plate).value
                        }
                    };
            }
        }
        Ok(rate)
    }
}
