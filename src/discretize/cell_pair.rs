//! Two cells on opposite or adjacent faces of a cube, and which pairs exchange the same.
//!
//! A cell has an index on each axis of its face. With lines symmetric about the middle, two indices (i, k) along a
//! common axis are as good as (k, i) and as their mirror images (n−1−i, n−1−k), because a form factor is even in the
//! distance along it; opposite faces have two such axes, which trade places, adjacent ones a common axis and two depths,
//! which trade places.

use super::DiscretizeError;
use crate::form_factor::{parallel, perpendicular};
use crate::geometry::{Offsets, Span};
use crate::numeric::Scalar;
use std::collections::BTreeMap;

/// The faces that two cells lie on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Faces {
    /// Six ordered pairs.
    Opposite,
    /// Twenty-four ordered pairs; the first index of a cell is its depth.
    Adjacent,
}

/// A pair of cells that stands for all that exchange the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Class {
    faces: Faces,
    first: [usize; 2],
    second: [usize; 2],
    /// How many ordered pairs on the whole cube.
    pub(super) count: f64,
}

/// The classes of a grid with `n` cells a side.
pub(super) fn classes(n: usize) -> Vec<Class> {
    let along = |i: usize, k: usize| {
        let (mirrored_i, mirrored_k) = (n - 1 - i, n - 1 - k);
        let pairs = [
            (i, k),
            (k, i),
            (mirrored_i, mirrored_k),
            (mirrored_k, mirrored_i),
        ];
        pairs.into_iter().min().unwrap_or((i, k))
    };
    let mut counts: BTreeMap<_, f64> = BTreeMap::new();
    let indices = || (0..n).flat_map(move |i| (0..n).map(move |k| (i, k)));
    for (i, k) in indices() {
        for (j, l) in indices() {
            let (x, y) = (along(i, k), along(j, l));
            *counts
                .entry((Faces::Opposite, x.min(y), x.max(y)))
                .or_default() += 6.0;
            let depth = (i.min(k), i.max(k));
            *counts.entry((Faces::Adjacent, depth, y)).or_default() += 24.0;
        }
    }
    let class = |((faces, (i, k), (j, l)), count)| Class {
        faces,
        first: [i, j],
        second: [k, l],
        count,
    };
    counts.into_iter().map(class).collect()
}

/// Two cells by their indices, on a grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct CellPair<'g, S> {
    cells: &'g [Span<S>],
    class: Class,
}

impl<'g, S: Scalar> CellPair<'g, S> {
    pub(super) const fn new(cells: &'g [Span<S>], class: Class) -> Self {
        Self { cells, class }
    }

    fn spans(&self, cell: [usize; 2]) -> [Span<S>; 2] {
        cell.map(|index| self.cells[index].clone())
    }

    /// Line `a` less line `b`, both counted from 0 at the edge; exactly 0 for the same line.
    fn offset(&self, a: usize, b: usize) -> S {
        let zero = self.cells[0].length().zero();
        let between = self.cells[a.min(b)..a.max(b)]
            .iter()
            .fold(zero, |sum, cell| sum + cell.length());
        if a < b { -between } else { between }
    }

    /// How cells `a` and `b` of one axis lie to each other.
    fn offsets(&self, a: usize, b: usize) -> Offsets<S> {
        let differences = [a, a + 1].map(|line| [b, b + 1].map(|other| self.offset(line, other)));
        let lengths = [a, b].map(|cell| self.cells[cell].length().clone());
        Offsets::new(differences, lengths)
    }

    /// The product of both areas.
    pub(super) fn areas(&self) -> S {
        let [i, j] = self.class.first;
        let [k, l] = self.class.second;
        [j, k, l]
            .into_iter()
            .fold(self.cells[i].length().clone(), |area, index| {
                area * self.cells[index].length()
            })
    }

    /// The exchange area.
    pub(super) fn exchange(&self) -> Result<S, DiscretizeError> {
        let (first, second) = (self.class.first, self.class.second);
        let exchange = match self.class.faces {
            Faces::Opposite => {
                let distance = self.cells[0].length().constant(1.0);
                parallel::exchange_area(&self.spans(first), &self.spans(second), &distance)?
            }
            Faces::Adjacent => perpendicular::exchange_area_at(
                [&self.cells[first[0]], &self.cells[second[0]]],
                &self.offsets(first[1], second[1]),
            ),
        };
        Ok(exchange.certain()?)
    }
}
