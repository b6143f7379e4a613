//! The irradiance at points of a box, from sources that vary linearly over each cell.
//!
//! ```text
//!   H(x) = Σ_g Σ_q n C + n_a (x_a C + X) + n_b (x_b C + Y)    q: crossings of the lines of face g
//! ```
//!
//! with the sums n over cells at q of `B − s·c`, of s_a and of s_b, where s is the slope of a cell
//! and c its middle. Across a common edge cells are cut into [`PARTS`], each with its own constant.

use super::grid::{FACES, Grid, axes, sense};
use super::potential::{from_adjacent, from_opposite};
use std::borrow::Cow;

/// Parts of a cell away from a common edge.
const PARTS: usize = 4;

/// A crossing of lines, and the sums of values and slopes there.
#[derive(Debug, Clone, Copy)]
struct Node {
    place: [f64; 3],
    value: f64,
    slopes: [f64; 2],
}

/// The sources of a box.
#[derive(Debug)]
pub(super) struct Sources {
    edges: [f64; 3],
    /// The nodes of each face, as its opposite sees it.
    opposite: Vec<Vec<Node>>,
    /// The nodes of each face, as faces at the ends of its two axes see it.
    adjacent: Vec<[Vec<Node>; 2]>,
}

impl Sources {
    /// The sources with these means on the cells of a grid, by faces; slopes are differences of
    /// neighbours of one kind.
    pub(super) fn new(grid: &Grid, means: &[Vec<f64>], kinds: &[Vec<usize>]) -> Self {
        let mut sources = Self {
            edges: [0, 1, 2].map(|axis| grid.edge(axis)),
            opposite: Vec::new(),
            adjacent: Vec::new(),
        };
        for face in 0..FACES {
            let cells = Cells::new(grid, face, &means[face], &kinds[face]);
            sources.opposite.push(cells.nodes());
            sources
                .adjacent
                .push([0, 1].map(|end| cells.cut(end).nodes()));
        }
        sources
    }

    /// The irradiance at a point of a face.
    pub(super) fn irradiance(&self, face: usize, point: [f64; 3]) -> f64 {
        let others = (0..FACES).filter(|other| *other != face);
        others.map(|other| self.from(face, point, other)).sum()
    }

    fn from(&self, face: usize, p: [f64; 3], other: usize) -> f64 {
        let ([k, ..], [l, a, b]) = (axes(face), axes(other));
        if k == l {
            let nodes = self.opposite[other].iter();
            let terms = nodes.map(|node| {
                let q = node.place;
                let [c, x, y] = from_opposite(q[a] - p[a], q[b] - p[b], self.edges[k]);
                let [along, across] = node.slopes;
                (node.value + p[a] * along + p[b] * across) * c + along * x + across * y
            });
            return terms.sum();
        }
        // the axis of the other face that leads away from this one, and the one along the edge
        let end = usize::from(k == b);
        let m = 3 - k - l;
        let terms = self.adjacent[other][end].iter().map(|node| {
            let q = node.place;
            let [c, x] = from_adjacent(q[m] - p[m], (p[l] - q[l]).abs(), (q[k] - p[k]).abs());
            let along = node.slopes[1 - end];
            (node.value + p[m] * along) * c + along * x
        });
        sense(face) * terms.sum::<f64>()
    }
}

/// The cells of a face with their slopes.
struct Cells<'g> {
    grid: Cow<'g, Grid>,
    face: usize,
    means: Vec<f64>,
    slopes: [Vec<f64>; 2],
}

impl<'g> Cells<'g> {
    fn new(grid: &'g Grid, face: usize, means: &[f64], kinds: &[usize]) -> Self {
        let middles = grid.middles(face);
        let [_, columns] = grid.cells(face);
        let [_, a, b] = axes(face);
        let slopes = [(a, columns), (b, 1)].map(|(axis, step)| {
            let place = |cell: usize| middles[cell].0[axis];
            let slope = |cell: usize| {
                let is_beside = |other: &usize| {
                    // a step along the row must not lead into another one
                    let is_in_line = step > 1 || other / columns == cell / columns;
                    *other < means.len() && is_in_line && kinds[*other] == kinds[cell]
                };
                let rate =
                    |other: usize| (means[other] - means[cell]) / (place(other) - place(cell));
                let before = cell.checked_sub(step).filter(is_beside);
                let after = Some(cell + step).filter(is_beside);
                match [before, after] {
                    [Some(before), Some(after)] => {
                        // of the parabola through all three
                        let (near, far) = (place(cell) - place(before), place(after) - place(cell));
                        (rate(before) * far + rate(after) * near) / (near + far)
                    }
                    [Some(other), None] | [None, Some(other)] => rate(other),
                    [None, None] => 0.0,
                }
            };
            (0..means.len()).map(slope).collect()
        });
        Self {
            grid: Cow::Borrowed(grid),
            face,
            means: means.to_vec(),
            slopes,
        }
    }

    /// The cells cut along one of both axes, where they are constant then.
    fn cut(&self, end: usize) -> Cells<'static> {
        let axis = axes(self.face)[1 + end];
        let grid = self.grid.refined(axis, PARTS);
        let [_, columns] = self.grid.cells(self.face);
        let [_, fine] = grid.cells(self.face);
        let (middles, parts) = (self.grid.middles(self.face), grid.middles(self.face));
        let whole = |part: usize| match end {
            0 => part / fine / PARTS * columns + part % fine,
            _ => part / fine * columns + part % fine / PARTS,
        };
        let mean = |(part, (place, _)): (usize, &([f64; 3], f64))| {
            let cell = whole(part);
            self.means[cell] + self.slopes[end][cell] * (place[axis] - middles[cell].0[axis])
        };
        let slope = |part: usize| self.slopes[1 - end][whole(part)];
        let along: Vec<f64> = (0..parts.len()).map(slope).collect();
        let none = vec![0.0; parts.len()];
        Cells {
            means: parts.iter().enumerate().map(mean).collect(),
            slopes: if end == 0 {
                [none, along]
            } else {
                [along, none]
            },
            grid: Cow::Owned(grid),
            face: self.face,
        }
    }

    /// The crossings where anything changes.
    fn nodes(&self) -> Vec<Node> {
        let [_, a, b] = axes(self.face);
        let middles = self.grid.middles(self.face);
        let origin = |(cell, (place, _)): (usize, &([f64; 3], f64))| {
            let [along, across] = [0, 1].map(|axis| self.slopes[axis][cell]);
            self.means[cell] - along * place[a] - across * place[b]
        };
        let origins: Vec<f64> = middles.iter().enumerate().map(origin).collect();
        let [values, along, across] = [&origins, &self.slopes[0], &self.slopes[1]]
            .map(|cells| self.grid.to_nodes(self.face, cells));
        let places = self.grid.nodes(self.face);
        let nodes = places.iter().enumerate().map(|(at, place)| Node {
            place: *place,
            value: values[at],
            slopes: [along[at], across[at]],
        });
        nodes.collect()
    }
}
