//! Mutual information of a tensor grid on the inside of a box (figs. 4 and 5).
//!
//! Lines at the same relative places cut all edges, so that each face is a grid of cells. Every
//! face sees the opposite one and four adjacent ones:
//!
//! ```text
//!   I = (1/A_T) Σ_pairs q φ(J/q − 1) + Σ_faces (A_f/A_T)²,     q = A_i A_j/A_T,  J = A_i F_ij
//! ```
//!
//! a sum of non-negative terms; the last one stands for the pairs of cells of one face. No value is
//! computed twice: the exchange area of two cells depends on their places relative to each other
//! along each axis, and the pairs are the products of these few relations.
//!
//! ```text
//!   opposite    relation along either axis
//!   adjacent    a depth each over the plane of the other, relation along the common axis
//! ```
//!
//! With n cells an edge there are O(n³) such classes for regular lines and O(n⁴) for others; equal
//! edges share them, too: 64 regular cells an edge make 24,576 patches, 301,977,600 pairs and
//! 135,200 classes on the cube (`infoscene grid --box 1,1,1 --cells 64`). A scene of the same cells
//! finds its congruent pairs by looking each of the `(6n²)²` pairs up
//! (`exchange/plan/congruence`), which works for any rectangles; that the two ways agree is held by
//! the test `the_grid_of_six_cells_is_the_scene_cube_6`.
//!
//! Open `axis` for the relations along an axis, `classes` for their products, `pair` for one pair
//! of cells, `derivatives` for gradient and Hessian in closed form (one pass for all lines), `best`
//! for the search for the best lines, `certified` for its proof, and `sample` for random lines.
//!
//! The antiderivatives are not tabulated at the corners that cells share, although that would take
//! a sixteenth of the evaluations: with 64 cells the closed forms cancel by up to 1e10, with one of
//! the four differences taken in closed form, and leave a bound of 1e-8 bit; rules along the sides
//! of far cells, at 0.3 µs a class, leave 1e-13.
//!
//! **Errors** as for [`scene_information`](crate::information::scene_information): a *bound*, for
//! the edges of the cells as rounded.
//!
//! **Not covered**: faces that are divided differently; lines that end inside a face.

pub(crate) mod axis;
pub(crate) mod best;
pub(crate) mod certified;
pub(crate) mod classes;
pub(crate) mod derivatives;
pub(crate) mod pair;
pub(crate) mod sample;

use super::division::regular_positions;
use super::error::DiscretizeError;
use crate::information::{divergence_error, pair_divergence};
use crate::numeric::{Bounded, CompensatedSum, Scalar, tolerance, try_parallel_map};
use axis::{Axis, Spacing};
use classes::Classes;
use std::f64::consts::LN_2;

/// A grid on the six faces of a box, whose edges are all cut by the same relative lines.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxGrid<S = f64> {
    /// Edges in units of a power of two near the longest.
    edges: [f64; 3],
    axes: [Axis<S>; 3],
}

/// The mutual information of a grid, and the number of pairs evaluated for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridInformation {
    /// Discrete mutual information, in bits; its error is a bound.
    pub mutual_information: Bounded,
    /// Classes of congruent pairs, each computed once.
    pub classes: usize,
}

/// The edges of the unit cube.
pub const UNIT_CUBE: [f64; 3] = [1.0; 3];

/// The largest number of cells an edge may be divided in: with lines that are not symmetric, on a
/// box with three different edges, that makes a hundred million classes of pairs.
pub const MOST_CELLS: u32 = 64;

/// The shortest cell, relative to the edge: (a) lines rounded to ε leave its length four digits.
const NARROWEST_CELL: f64 = 1e-12;

/// The largest ratio of the longest edge to the shortest: the one that the rules of far cells and
/// the closed forms are measured at (`extreme_grids_keep_their_digits`).
pub const LARGEST_ASPECT: f64 = 1e6;

/// Error of an exchange area relative to itself plus that of independent cells: (a) the sum of both
/// over all pairs is twice the total area, which leaves a bound of some 1e-13 of a bit.
const EXCHANGE_ERROR: f64 = 96.0 * f64::EPSILON;

/// The edges in units of a power of two near the longest.
fn scaled(edges: [f64; 3]) -> Result<[f64; 3], DiscretizeError> {
    for edge in edges {
        if !(edge.is_normal() && edge > 0.0) {
            return Err(DiscretizeError::out_of_range(
                "an edge of the box",
                edge,
                "finite and > 0",
            ));
        }
    }
    let longest = edges.into_iter().fold(0.0, f64::max);
    let shortest = edges.into_iter().fold(f64::INFINITY, f64::min);
    if shortest < longest / LARGEST_ASPECT {
        let condition = "at least a millionth of the longest";
        return Err(DiscretizeError::out_of_range(
            "the shortest edge of the box",
            shortest,
            condition,
        ));
    }
    let unit = crate::numeric::power_of_two_below(longest);
    Ok(edges.map(|edge| edge / unit))
}

/// Refuses a grid without cells, and one that takes too long.
pub(crate) fn checked(cells: u32) -> Result<u32, DiscretizeError> {
    if (1..=MOST_CELLS).contains(&cells) {
        Ok(cells)
    } else {
        let number = f64::from(cells);
        Err(DiscretizeError::out_of_range(
            "the number of cells",
            number,
            "from 1 to 64",
        ))
    }
}

impl BoxGrid {
    /// The grid with these inner lines, in units of the edges.
    ///
    /// Lines that are mirror images of each other about 1/2, to within a rounding, are taken as
    /// exactly that, the lower one as given: their pairs are shared.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] unless they increase inside `(0, 1)` by at least 1e-12, the
    /// edges are > 0 and their ratios at most [`LARGEST_ASPECT`], and there are at most
    /// [`MOST_CELLS`] cells.
    pub fn try_new(edges: [f64; 3], lines: &[f64]) -> Result<Self, DiscretizeError> {
        let cells = checked(u32::try_from(lines.len() + 1).unwrap_or(u32::MAX))?;
        let mut below = 0.0;
        for line in lines {
            if !(line - below >= NARROWEST_CELL && 1.0 - line >= NARROWEST_CELL) {
                let condition =
                    "inside (0, 1), and at least 1e-12 above the line before it and below 1";
                return Err(DiscretizeError::out_of_range(
                    "a grid line",
                    *line,
                    condition,
                ));
            }
            below = *line;
        }
        if lines == regular_positions(cells) {
            return Self::regular(edges, cells);
        }
        let mut pairs = lines.iter().zip(lines.iter().rev());
        if pairs.all(|(a, b)| (*a + *b - 1.0).abs() <= f64::EPSILON) {
            return Self::mirrored(edges, &lines[..(lines.len()) / 2], cells, &1.0);
        }
        let all = std::iter::once(0.0).chain(lines.iter().copied());
        Self::from_lines(edges, &all.chain([1.0]).collect::<Vec<_>>(), Spacing::Any)
    }

    /// The grid of `cells` equal cells an edge.
    ///
    /// # Errors
    /// As [`try_new`](Self::try_new).
    pub fn regular(edges: [f64; 3], cells: u32) -> Result<Self, DiscretizeError> {
        Self::regular_like(edges, checked(cells)?, &1.0)
    }

    /// The grid in numbers of the type and precision of `like`, its lower lines and edges
    /// exactly as they are.
    ///
    /// # Errors
    /// None in practice: the lines were taken before.
    pub fn lifted<S: Scalar>(&self, like: &S) -> Result<BoxGrid<S>, DiscretizeError> {
        let cells = u32::try_from(self.cells()).unwrap_or(u32::MAX);
        let lift = |lines: &[f64]| lines.iter().map(|line| like.constant(*line)).collect();
        let lines = self.lines();
        match self.spacing() {
            Spacing::Regular => BoxGrid::regular_like(self.edges, cells, like),
            Spacing::Symmetric => {
                let half: Vec<S> = lift(&lines[..lines.len() / 2]);
                BoxGrid::mirrored(self.edges, &half, cells, like)
            }
            Spacing::Any => {
                let all: Vec<S> = lift(self.axes[0].lines());
                BoxGrid::from_lines(self.edges, &all, Spacing::Any)
            }
        }
    }

    /// Discrete mutual information with a bound on its error, by the cheapest road to each class of
    /// pairs; the same bits for any number of threads.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a pair is refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::discretize::{BoxGrid, UNIT_CUBE};
    /// let grid = BoxGrid::regular(UNIT_CUBE, 3)?.information()?.mutual_information;
    /// // from a 50-digit evaluation
    /// assert!((grid.value - 0.994_346_184_970_692_6).abs() <= grid.error);
    /// assert!(grid.error < 1e-13);
    /// # Ok::<(), infoscene::discretize::DiscretizeError>(())
    /// ```
    pub fn information(&self) -> Result<GridInformation, DiscretizeError> {
        let classes = self.classes()?;
        let (total, unseen) = self.faces();
        let rows = classes.rows();
        let parts = try_parallel_map(rows.len(), &|row| {
            let (mut sum, mut error, mut count) = (CompensatedSum::default(), 0.0, 0);
            for pair in classes.row(&rows[row]) {
                let product = pair.areas() / total;
                let exchange = pair.exchange_area(product, EXCHANGE_ERROR)?;
                sum.add(pair.count * pair_divergence(exchange.value, product, 1.0));
                let bound = exchange.error;
                error += pair.count * divergence_error(exchange.value, bound, product);
                count += 1;
            }
            Ok::<_, DiscretizeError>((sum, error, count))
        })?;
        let mut sum = CompensatedSum::default();
        sum.add(total * unseen);
        let (mut error, mut count) = (0.0, 0);
        for (part, part_error, part_count) in parts {
            sum.add_sum(&part);
            error += part_error;
            count += part_count;
        }
        let mutual_information = sum.total() / (total * LN_2);
        Ok(GridInformation {
            mutual_information: Bounded::bound(
                mutual_information,
                error / (total * LN_2) + tolerance::INFORMATION * (2.0 + mutual_information),
            ),
            classes: count,
        })
    }
}

impl<S: Scalar> BoxGrid<S> {
    /// The grid of `cells` cells an edge whose lines below 1/2 are `half`; the others are their
    /// mirror images, and 1/2 for an even number of cells.
    ///
    /// **Arguments** `like` sets the type and precision.
    ///
    /// # Errors
    /// [`DiscretizeError::Geometry`] unless the lines increase inside `(0, 1/2)`;
    /// [`DiscretizeError::OutOfRange`] for other edges than [`try_new`](BoxGrid::try_new) takes.
    pub fn mirrored(
        edges: [f64; 3],
        half: &[S],
        cells: u32,
        like: &S,
    ) -> Result<Self, DiscretizeError> {
        let one = like.constant(1.0);
        let middle = cells.is_multiple_of(2).then(|| like.constant(0.5));
        let upper = half.iter().rev().map(|line| one.clone() - line);
        let lines: Vec<S> = std::iter::once(like.zero())
            .chain(half.iter().cloned())
            .chain(middle)
            .chain(upper)
            .chain([one.clone()])
            .collect();
        Self::from_lines(edges, &lines, Spacing::Symmetric)
    }

    /// The grid of `cells` equal cells an edge, in the type and precision of `like`.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] for zero cells, and other edges than
    /// [`try_new`](BoxGrid::try_new) takes.
    pub fn regular_like(edges: [f64; 3], cells: u32, like: &S) -> Result<Self, DiscretizeError> {
        let count = like.constant(f64::from(checked(cells)?));
        let lines = (0..=cells).map(|k| like.constant(f64::from(k)) / &count);
        Self::from_lines(edges, &lines.collect::<Vec<S>>(), Spacing::Regular)
    }

    /// The grid with less known about the spacing of its lines.
    pub(crate) fn respaced(&self, spacing: Spacing) -> Result<Self, DiscretizeError> {
        Self::from_lines(self.edges, self.axes[0].lines(), spacing)
    }

    /// The grid with these lines, the ends included.
    fn from_lines(edges: [f64; 3], lines: &[S], spacing: Spacing) -> Result<Self, DiscretizeError> {
        debug_assert!(lines.len() >= 2, "the ends are among the lines");
        let edges = scaled(edges)?;
        let axis = |edge: f64| Axis::try_new(lines[0].constant(edge), lines.to_vec(), spacing);
        let [x, y, z] = edges;
        let axes = [axis(x)?, axis(y)?, axis(z)?];
        Ok(Self { edges, axes })
    }

    /// The inner lines, increasing, in units of the edges.
    #[must_use]
    pub fn lines(&self) -> &[S] {
        let lines = self.axes[0].lines();
        &lines[1..lines.len() - 1]
    }

    /// The number of cells an edge.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.axes[0].cells()
    }

    /// The spacing that the lines are known to have.
    #[must_use]
    pub const fn spacing(&self) -> Spacing {
        self.axes[0].spacing()
    }

    /// The area of the six faces in the grid's unit, and `Σ (A_f/A_T)²` for the pairs of cells of
    /// one face, which exchange nothing: x = −1, φ = 1.
    pub(crate) fn faces(&self) -> (S, S) {
        let like = &self.axes[0].lines()[0];
        let two = like.constant(2.0);
        let [x, y, z] = self.edges.map(|edge| like.constant(edge));
        let faces = [x.clone() * &y, y * &z, z * &x];
        let total = faces.iter().fold(like.zero(), |sum, face| sum + face) * &two;
        let unseen = faces.into_iter().fold(like.zero(), |sum, face| {
            sum + &((face / &total).square() * &two)
        });
        (total, unseen)
    }

    /// The edges in the grid's unit.
    pub(crate) const fn edges(&self) -> [f64; 3] {
        self.edges
    }

    pub(crate) fn axes(&self) -> &[Axis<S>; 3] {
        &self.axes
    }

    /// One pair of cells of each class.
    pub(crate) fn classes(&self) -> Result<Classes<S>, DiscretizeError> {
        let alike = |axis: usize| {
            let edge = self.edges[axis].to_bits();
            (0..axis).find(|other| self.edges[*other].to_bits() == edge)
        };
        Classes::try_new(
            &self.axes,
            [0, 1, 2].map(|axis| alike(axis).unwrap_or(axis)),
        )
    }

    /// Discrete mutual information, in bits, by closed forms alone: over intervals an enclosure.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a pair is refused.
    pub fn mutual_information(&self) -> Result<S, DiscretizeError> {
        let like = &self.axes[0].lines()[0];
        let one = like.constant(1.0);
        let (total, mut nats) = self.faces();
        for pair in self.classes()?.pairs() {
            let areas = pair.areas();
            let x = pair.exchange()? * &total / &areas - &one;
            let independent = areas / &total.square();
            nats = nats + &(x.divergence_kernel() * &independent * &like.constant(pair.count));
        }
        Ok(nats / &like.constant(2.0).ln())
    }
}
