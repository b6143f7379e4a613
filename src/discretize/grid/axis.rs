//! Lines along one axis of a box, and the classes of congruent pairs of cells between them.
//!
//! A form factor is even in the distance along a common axis, so that cells (i, k) count as (k, i).
//! Further sharing depends on the lines:
//!
//! ```text
//!   regular      (i, k) as (0, |i − k|)                       n relations
//!   symmetric    (i, k) as the mirror images (n−1−i, n−1−k)   about n²/4; one depth for both ends
//!   any          nothing more                                 n (n + 1)/2; a depth for each end
//! ```

use crate::discretize::error::DiscretizeError;
use crate::geometry::{Offsets, Span};
use crate::numeric::Scalar;

/// The spacing of the lines of an axis, as far as it is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// All cells are equally long.
    Regular,
    /// Every line has a mirror image about the middle.
    Symmetric,
    /// Lines of which no relation is known.
    Any,
}

impl Spacing {
    /// `"regular"`, `"symmetric"` or `"any"`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Regular => "regular",
            Self::Symmetric => "symmetric",
            Self::Any => "any",
        }
    }
}

/// The derivatives of a place by the free lines, which are counted from the lower end; lines that
/// do not move it are left out.
pub(crate) type Moves<S> = Vec<(usize, S)>;

/// Two cells of an axis that stand for all congruent pairs.
#[derive(Debug, Clone)]
pub(crate) struct Relation<S> {
    pub spans: [Span<S>; 2],
    pub offsets: Offsets<S>,
    /// The derivatives of the four differences of ends, the lower ends first.
    pub moves: [Moves<S>; 4],
    pub count: f64,
}

/// The distance of a cell from an end of its axis, for all cells at the same one.
#[derive(Debug, Clone)]
pub(crate) struct Depth<S> {
    pub span: Span<S>,
    /// The derivatives of the lower and the upper end.
    pub moves: [Moves<S>; 2],
    pub count: f64,
}

/// An edge of a box, divided: lines `0 = t_0 < t_1 < … < t_n = 1`, in units of the edge.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis<S> {
    edge: S,
    lines: Vec<S>,
    spacing: Spacing,
}

impl<S: Scalar> Axis<S> {
    /// An axis with lines of this spacing, the ends included.
    ///
    /// # Errors
    /// [`DiscretizeError::Geometry`] unless they increase.
    pub(crate) fn try_new(
        edge: S,
        lines: Vec<S>,
        spacing: Spacing,
    ) -> Result<Self, DiscretizeError> {
        debug_assert!(lines.len() >= 2, "the ends are among the lines");
        let axis = Self {
            edge,
            lines,
            spacing,
        };
        for cell in 0..axis.cells() {
            axis.span(cell)?;
        }
        Ok(axis)
    }

    pub(crate) fn cells(&self) -> usize {
        self.lines.len() - 1
    }

    pub(crate) const fn edge(&self) -> &S {
        &self.edge
    }

    /// All lines, the ends included.
    pub(crate) fn lines(&self) -> &[S] {
        &self.lines
    }

    pub(crate) const fn spacing(&self) -> Spacing {
        self.spacing
    }

    /// The number of lines that may move, each with its mirror image; the middle one and the ends
    /// stay.
    pub(crate) fn free(&self) -> usize {
        (self.cells() - 1) / 2
    }

    /// The length of a cell in a regular division.
    fn step(&self) -> S {
        let cells = u32::try_from(self.cells()).unwrap_or(u32::MAX);
        self.edge.clone() / &self.edge.constant(f64::from(cells))
    }

    fn times_step(&self, steps: usize) -> S {
        let steps = u32::try_from(steps).unwrap_or(u32::MAX);
        self.step() * &self.edge.constant(f64::from(steps))
    }

    fn span(&self, cell: usize) -> Result<Span<S>, DiscretizeError> {
        if self.spacing == Spacing::Regular {
            return Ok(Span::with_length(self.times_step(cell), self.step())?);
        }
        let [lower, upper] = [cell, cell + 1].map(|line| self.lines[line].clone() * &self.edge);
        Ok(Span::try_new(lower, upper)?)
    }

    /// Line `a` less line `b`; exactly 0 for the same line.
    fn offset(&self, a: usize, b: usize) -> S {
        if a == b {
            self.edge.zero()
        } else if self.spacing == Spacing::Regular {
            let between = self.times_step(a.abs_diff(b));
            if a < b { -between } else { between }
        } else {
            (self.lines[a].clone() - &self.lines[b]) * &self.edge
        }
    }

    /// The derivative of a line by a free one, whose mirror image moves the other way.
    fn moves(&self, line: usize) -> Option<(usize, S)> {
        let free = self.free();
        let mirrored = self.cells() - line;
        if (1..=free).contains(&line) {
            Some((line - 1, self.edge.clone()))
        } else if (1..=free).contains(&mirrored) {
            Some((mirrored - 1, -self.edge.clone()))
        } else {
            None
        }
    }

    /// The derivatives of the difference of two lines.
    pub(crate) fn offset_moves(&self, a: usize, b: usize) -> Moves<S> {
        if a == b {
            return Vec::new();
        }
        let subtracted = self.moves(b).map(|(line, by)| (line, -by));
        match (self.moves(a), subtracted) {
            (Some((one, by)), Some((other, more))) if one == other => {
                vec![(one, by + &more)]
            }
            (first, second) => first.into_iter().chain(second).collect(),
        }
    }

    fn relation(&self, [i, k]: [usize; 2], count: f64) -> Result<Relation<S>, DiscretizeError> {
        let spans = [self.span(i)?, self.span(k)?];
        let differences = [i, i + 1].map(|a| [k, k + 1].map(|b| self.offset(a, b)));
        let lengths = spans.each_ref().map(|span| span.length().clone());
        let moves = [[i, k], [i, k + 1], [i + 1, k], [i + 1, k + 1]];
        Ok(Relation {
            offsets: Offsets::new(differences, lengths),
            spans,
            moves: moves.map(|[a, b]| self.offset_moves(a, b)),
            count,
        })
    }

    /// One pair of cells of each class.
    pub(crate) fn relations(&self) -> Result<Vec<Relation<S>>, DiscretizeError> {
        let n = self.cells();
        let mut relations = Vec::new();
        for i in 0..n {
            for k in i..n {
                let mirrored = (n - 1 - k, n - 1 - i);
                let alike = match self.spacing {
                    Spacing::Regular if i > 0 => continue,
                    Spacing::Regular => n - k,
                    Spacing::Symmetric if mirrored < (i, k) => continue,
                    Spacing::Symmetric if mirrored != (i, k) => 2,
                    Spacing::Symmetric | Spacing::Any => 1,
                };
                let orders = if i == k { 1.0 } else { 2.0 };
                let alike = f64::from(u32::try_from(alike).unwrap_or(u32::MAX));
                relations.push(self.relation([i, k], orders * alike)?);
            }
        }
        Ok(relations)
    }

    /// One depth of each class, from either end.
    pub(crate) fn depths(&self) -> Result<Vec<Depth<S>>, DiscretizeError> {
        let n = self.cells();
        let is_symmetric = self.spacing != Spacing::Any;
        let moves = |line| self.moves(line).into_iter().collect::<Moves<S>>();
        let mut depths = Vec::new();
        for cell in 0..n {
            depths.push(Depth {
                span: self.span(cell)?,
                moves: [moves(cell), moves(cell + 1)],
                count: if is_symmetric { 2.0 } else { 1.0 },
            });
        }
        if !is_symmetric {
            for cell in 0..n {
                let span =
                    Span::with_length(self.offset(n, cell + 1), self.span(cell)?.length().clone())?;
                depths.push(Depth {
                    span,
                    moves: [self.offset_moves(n, cell + 1), self.offset_moves(n, cell)],
                    count: 1.0,
                });
            }
        }
        Ok(depths)
    }
}
