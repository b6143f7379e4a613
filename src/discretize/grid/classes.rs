//! The pairs of cells of a grid on a box that see each other, each class of congruent ones once.
//!
//! The pairs of a tensor grid are products of relations along the axes, so that n cells an edge
//! need n³ classes and no comparison of single pairs. A scene of any rectangles has an engine of
//! its own (`exchange/plan/congruence`), which looks each of its n² pairs of patches up; the test
//! `the_grid_of_six_cells_is_the_scene_cube_6` sets one against the other. A row holds the pairs
//! that differ in one relation only: opposite cells with the same relation along the first axis,
//! adjacent ones at the same depths.

use super::axis::{Axis, Depth, Relation};
use super::pair::{CellPair, Faces};
use crate::discretize::error::DiscretizeError;
use crate::numeric::Scalar;

/// The relations and depths of the cells of a box along each axis, and the rows of their products.
#[derive(Debug, Clone)]
pub(crate) struct Classes<S> {
    edges: [S; 3],
    /// The first axis that is divided in the same way as each axis.
    kinds: [usize; 3],
    relations: [Vec<Relation<S>>; 3],
    depths: [Vec<Depth<S>>; 3],
    rows: Vec<Row>,
}

/// A row of pairs that differ in one relation only.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row {
    /// Opposite faces are normal to this axis, adjacent ones have it in common.
    axis: usize,
    index: RowIndex,
    /// The number of pairs of faces, and of orders, that the row stands for.
    count: f64,
}

#[derive(Debug, Clone, Copy)]
enum RowIndex {
    /// The relation along the first of the other axes.
    Opposite(usize),
    /// The depths along the other axes.
    Adjacent([usize; 2]),
}

const fn others(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

impl<S: Scalar> Classes<S> {
    /// The classes of a box whose axes are divided in these ways; `kinds` holds for each axis the
    /// first one that is divided in the same way.
    pub(crate) fn try_new(axes: &[Axis<S>; 3], kinds: [usize; 3]) -> Result<Self, DiscretizeError> {
        debug_assert!((0..3).all(|axis| kinds[kinds[axis]] == kinds[axis] && kinds[axis] <= axis));
        let mut classes = Self {
            edges: axes.each_ref().map(|axis| axis.edge().clone()),
            kinds,
            relations: [const { Vec::new() }; 3],
            depths: [const { Vec::new() }; 3],
            rows: Vec::new(),
        };
        for axis in (0..3).filter(|axis| kinds[*axis] == *axis) {
            classes.relations[axis] = axes[axis].relations()?;
            classes.depths[axis] = axes[axis].depths()?;
        }
        for axis in (0..3).filter(|axis| kinds[*axis] == *axis) {
            let [a, b] = others(axis).map(|other| kinds[other]);
            let alike = kinds
                .into_iter()
                .map(|kind| u8::from(kind == axis))
                .sum::<u8>();
            // both orders of two faces
            let count = 2.0 * f64::from(alike);
            for first in 0..classes.relations[a].len() {
                let index = RowIndex::Opposite(first);
                classes.rows.push(Row { axis, index, count });
            }
            for first in 0..classes.depths[a].len() {
                let from = if a == b { first } else { 0 };
                for second in from..classes.depths[b].len() {
                    let orders = if a == b && first != second { 2.0 } else { 1.0 };
                    classes.rows.push(Row {
                        axis,
                        index: RowIndex::Adjacent([first, second]),
                        count: orders * count,
                    });
                }
            }
        }
        Ok(classes)
    }

    pub(crate) fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// One pair of each class of a row.
    pub(crate) fn row(&self, row: &Row) -> impl Iterator<Item = CellPair<'_, S>> {
        let Row {
            axis,
            index,
            count: multiplicity,
        } = *row;
        let [a, b] = others(axis).map(|other| self.kinds[other]);
        let (last, from) = match index {
            RowIndex::Opposite(first) => (b, if a == b { first } else { 0 }),
            RowIndex::Adjacent(_) => (axis, 0),
        };
        let relations = self.relations[last].iter().enumerate().skip(from);
        relations.map(move |(k, relation)| {
            let (faces, count) = match index {
                RowIndex::Opposite(first) => {
                    let orders = if a == b && first != k { 2.0 } else { 1.0 };
                    let other = &self.relations[a][first];
                    let along = [other, relation];
                    let distance = &self.edges[axis];
                    let faces = Faces::Opposite { along, distance };
                    (faces, orders * other.count * relation.count)
                }
                RowIndex::Adjacent([first, second]) => {
                    let depths = [&self.depths[a][first], &self.depths[b][second]];
                    let along = relation;
                    let faces = Faces::Adjacent { depths, along };
                    (faces, depths[0].count * depths[1].count * relation.count)
                }
            };
            CellPair {
                faces,
                count: count * multiplicity,
            }
        })
    }

    /// One pair of each class.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = CellPair<'_, S>> {
        self.rows.iter().flat_map(|row| self.row(row))
    }
}
