//! The grid on the faces of a box: lines that crowd towards edges and materials' borders.
//!
//! ```text
//!   between two borders p and q:  p + (q − p) t³ (10 − 15 t + 6 t²),   t = 0, 1/m, …, 1
//! ```
//!
//! Face `2 k + s` is across axis k, at its lower (s = 0) or upper end; its cells run along the axes
//! k + 1 and k + 2, row by row.

use super::potential::{adjacent, opposite};
use crate::numeric::real;

/// The lines of a grid along each axis, from 0.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    pub(super) lines: [Vec<f64>; 3],
}

/// The faces of a box.
pub(super) const FACES: usize = 6;

/// The axes of a face: across it, then along it.
pub(super) const fn axes(face: usize) -> [usize; 3] {
    let across = face / 2;
    [across, (across + 1) % 3, (across + 2) % 3]
}

/// −1 if distances from a face fall as coordinates grow.
pub(super) fn sense(face: usize) -> f64 {
    if face.is_multiple_of(2) { 1.0 } else { -1.0 }
}

impl Grid {
    /// The grid of a box whose materials change at these positions along each axis, its ends among
    /// them, with about so many cells along an edge.
    pub(super) fn new(borders: &[Vec<f64>; 3], cells: usize) -> Self {
        let lines = borders.each_ref().map(|borders| {
            let whole = borders.last().copied().unwrap_or(0.0);
            let mut lines = vec![0.0];
            for ends in borders.windows(2) {
                let (from, length) = (ends[0], ends[1] - ends[0]);
                let share = (length / whole).sqrt();
                let count = (1..cells)
                    .take_while(|k| real(*k) < share * real(cells))
                    .count()
                    + 1;
                lines.extend((1..count).map(|k| {
                    let t = real(k) / real(count);
                    from + length * t * t * t * (10.0 - t * (15.0 - 6.0 * t))
                }));
                lines.push(ends[1]);
            }
            lines
        });
        Self { lines }
    }

    /// The length of an edge.
    pub(super) fn edge(&self, axis: usize) -> f64 {
        self.lines[axis].last().copied().unwrap_or(0.0)
    }

    /// The numbers of cells of a face along its two axes.
    pub(super) fn cells(&self, face: usize) -> [usize; 2] {
        let [_, along, across] = axes(face);
        [along, across].map(|axis| self.lines[axis].len() - 1)
    }

    /// The point of a face at these positions along its axes.
    pub(super) fn place(&self, face: usize, along: [f64; 2]) -> [f64; 3] {
        let [k, a, b] = axes(face);
        let mut place = [0.0; 3];
        place[k] = if face.is_multiple_of(2) {
            0.0
        } else {
            self.edge(k)
        };
        (place[a], place[b]) = (along[0], along[1]);
        place
    }

    /// The crossings of a face's lines, row by row.
    pub(super) fn nodes(&self, face: usize) -> Vec<[f64; 3]> {
        let [_, a, b] = axes(face);
        let rows = self.lines[a].iter();
        let places = rows.flat_map(|x| self.lines[b].iter().map(move |y| [*x, *y]));
        places.map(|along| self.place(face, along)).collect()
    }

    /// The middle and the area of each cell of a face.
    pub(super) fn middles(&self, face: usize) -> Vec<([f64; 3], f64)> {
        let [_, a, b] = axes(face);
        let rows = self.lines[a].windows(2);
        let cells = rows.flat_map(|x| self.lines[b].windows(2).map(move |y| [x, y]));
        let cell = |[x, y]: [&[f64]; 2]| {
            let middle = self.place(face, [0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1])]);
            (middle, (x[1] - x[0]) * (y[1] - y[0]))
        };
        cells.map(cell).collect()
    }

    /// G of places on two faces.
    pub(super) fn potential(&self, [f, g]: [usize; 2], p: [f64; 3], q: [f64; 3]) -> f64 {
        let ([k, a, b], l) = (axes(f), g / 2);
        if k == l {
            return opposite(p[a] - q[a], p[b] - q[b], self.edge(k));
        }
        let m = 3 - k - l;
        let (u, v) = ((p[l] - q[l]).abs(), (q[k] - p[k]).abs());
        sense(f) * sense(g) * adjacent(p[m] - q[m], u, v)
    }

    /// The grid with each cell cut into so many along one axis.
    pub(super) fn refined(&self, axis: usize, parts: usize) -> Self {
        let mut refined = self.clone();
        let own = &self.lines[axis];
        let cut = |ends: &[f64]| {
            let (from, step) = (ends[0], (ends[1] - ends[0]) / real(parts));
            (0..parts)
                .map(move |k| from + step * real(k))
                .collect::<Vec<_>>()
        };
        let mut lines: Vec<f64> = own.windows(2).flat_map(cut).collect();
        lines.extend(own.last());
        refined.lines[axis] = lines;
        refined
    }

    /// The sums of cells' values with the signs of their corners, for each crossing of a face.
    pub(super) fn to_nodes(&self, face: usize, cells: &[f64]) -> Vec<f64> {
        let [rows, columns] = self.cells(face);
        let mut nodes = vec![0.0; (rows + 1) * (columns + 1)];
        for (i, row) in cells.chunks(columns).enumerate() {
            for (j, value) in row.iter().enumerate() {
                let at = i * (columns + 1) + j;
                nodes[at] += value;
                nodes[at + 1] -= value;
                nodes[at + columns + 1] -= value;
                nodes[at + columns + 2] += value;
            }
        }
        nodes
    }

    /// The sums of crossings' values with the signs of a cell's corners, for each cell of a face.
    pub(super) fn to_cells(&self, face: usize, nodes: &[f64]) -> Vec<f64> {
        let [rows, columns] = self.cells(face);
        let cells = (0..rows).flat_map(|i| (0..columns).map(move |j| i * (columns + 1) + j));
        let sum = |at: usize| {
            nodes[at] - nodes[at + 1] - nodes[at + columns + 1] + nodes[at + columns + 2]
        };
        cells.map(sum).collect()
    }
}
