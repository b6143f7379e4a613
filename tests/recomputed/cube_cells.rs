//! The exchange areas of the cells of a cube whose faces carry the same grid.
//!
//! All edges are grid segments, so the kernel G of [`crate::parallel_edges`] is
//! needed only for differences of lines as offsets, and for the distances √(1 + δ²)
//! between opposite faces (δ a difference of lines) and √(x² + z²) between adjacent
//! ones (x and z lines). It is integrated once for each.

use crate::parallel_edges::{Distinct, kernel};
use crate::precision::Real;
use crate::quadrature::Level;

/// A cell of a face, by the numbers of its first lines.
pub type Cell = [usize; 2];

/// The cells of a cube, with the kernel at all offsets and distances.
pub struct Cells {
    lines: Vec<Real>,
    /// The number of the offset between two lines.
    offset: Vec<Vec<usize>>,
    /// G between opposite faces: by the number of the lines' offset, which gives the
    /// distance, and by the number of the offset along the edges.
    opposite: Vec<Vec<Real>>,
    /// The number of the sum of squares of two lines.
    sum: Vec<Vec<usize>>,
    /// G between adjacent faces: by the number of the sum and by that of the offset.
    adjacent: Vec<Vec<Real>>,
}

impl Cells {
    /// Integrates the kernel for grid lines from 0 to 1.
    pub fn new(lines: Vec<Real>, level: &Level) -> Self {
        let table = |f: &dyn Fn(&Real, &Real) -> Real| -> Vec<Vec<Real>> {
            let row = |a: &Real| lines.iter().map(|b| f(a, b)).collect();
            lines.iter().map(row).collect()
        };
        let places = |all: &Distinct, table: &[Vec<Real>]| -> Vec<Vec<usize>> {
            let row = |row: &Vec<Real>| row.iter().map(|x| all.place(x)).collect();
            table.iter().map(row).collect()
        };
        let differences = table(&|a, b| (a - b).abs());
        let sums = table(&|a, b| a.squared() + b.squared());
        let offsets = Distinct::new(differences.concat());
        let squares = Distinct::new(sums.concat());
        let one = Real::int(1);
        let at = |square: &Real| kernel(offsets.numbers(), square, level);
        let between_opposite = |delta: &Real| at(&(delta.squared() + &one));
        Self {
            offset: places(&offsets, &differences),
            opposite: offsets.numbers().iter().map(between_opposite).collect(),
            sum: places(&squares, &sums),
            adjacent: squares.numbers().iter().map(at).collect(),
            lines,
        }
    }

    /// All cells of a face.
    pub fn of_a_face(&self) -> impl Iterator<Item = Cell> + use<> {
        let n = self.lines.len() - 1;
        (0..n).flat_map(move |i| (0..n).map(move |k| [i, k]))
    }

    /// The area of a cell.
    pub fn area(&self, [i, k]: Cell) -> Real {
        (&self.lines[i + 1] - &self.lines[i]) * (&self.lines[k + 1] - &self.lines[k])
    }

    /// The exchange area of two cells of opposite faces: all edges count.
    pub fn opposite(&self, [i, k]: Cell, [j, l]: Cell) -> Real {
        let row = |p: usize, q: usize| &self.opposite[self.offset[p][q]];
        self.exchange(i, j, k, l, row) + self.exchange(k, l, i, j, row)
    }

    /// The exchange area of two cells of adjacent faces, the first line counted from
    /// the common edge of the faces: only the edges along it count.
    pub fn adjacent(&self, [i, k]: Cell, [j, l]: Cell) -> Real {
        self.exchange(i, j, k, l, |p, q| &self.adjacent[self.sum[p][q]])
    }

    /// The exchange area of a cell with all cells of the five other faces, for lines
    /// symmetric about 1/2: the common edge with an adjacent face is at 0 or at 1, on
    /// one axis or the other.
    pub fn all_exchange(&self, cell: Cell) -> Real {
        let [i, k] = cell;
        let last = self.lines.len() - 2;
        let mut sum = Real::int(0);
        for other in self.of_a_face() {
            sum += self.opposite(cell, other);
            for seen_from_edge in [[i, k], [last - i, k], [k, i], [last - k, i]] {
                sum += self.adjacent(seen_from_edge, other);
            }
        }
        sum
    }

    /// 1/(2π) times the integral of ln r over the parallel edges at the lines i, i + 1
    /// and j, j + 1, which reach from line k to k + 1 and from l to l + 1. Both cells
    /// face the inside of the cube, so that the edges at i and j run in opposite
    /// directions, as do those at i + 1 and j + 1, and the other pairs in the same.
    fn exchange<'a>(
        &'a self,
        i: usize,
        j: usize,
        k: usize,
        l: usize,
        row: impl Fn(usize, usize) -> &'a Vec<Real>,
    ) -> Real {
        let pair = |p: usize, q: usize| {
            let g = |a: usize, b: usize| &row(p, q)[self.offset[a][b]];
            g(k + 1, l) + g(k, l + 1) - g(k + 1, l + 1) - g(k, l)
        };
        let sum = pair(i, j + 1) + pair(i + 1, j) - pair(i, j) - pair(i + 1, j + 1);
        sum / (Real::int(2) * Real::pi())
    }
}

/// Σ_j F_ij = 1 for the cells of a cube with lines at 0, 1/4, 3/4, 1.
#[test]
fn the_form_factors_of_every_cell_add_up_to_one() {
    let lines = [0, 1, 3, 4].map(|quarters| Real::ratio(quarters, 4));
    let cells = Cells::new(lines.to_vec(), &crate::quadrature::COARSE);
    for cell in cells.of_a_face() {
        let sum = cells.all_exchange(cell) / cells.area(cell);
        assert!((sum - Real::int(1)).abs() < Real::decimal("1e-36"));
    }
}
