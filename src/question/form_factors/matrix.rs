//! The matrix of a scene's form factors, and that of the bounds on their errors, a line at a time.
//!
//! ```text
//!   F_ij = x_ij / A_i ,   |error of F_ij| ≤ e_ij / A_i + b_i / A_i · F_ij
//! ```
//!
//! `x ± e` is the exchange area, the same both ways; `A ± b` the area of a row. So the exchange
//! areas of one row give a row of the matrix and a column, whichever a file wants.

use crate::exchange::{ExchangeAreas, ExchangeError, PassSummary, ScenePairs};
use crate::form_factor::Answer;
use crate::question::unreached::Unreached;
use crate::scene::{Scene, SceneError};

/// The quantity that a matrix is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MatrixEntries {
    /// Form factors: the sum of a row is 1 in a closed scene.
    FormFactors,
    /// Bounds on the absolute errors of the form factors.
    Bounds,
}

/// The matrix of a scene's form factors, a line at a time.
#[derive(Debug)]
pub struct FormFactorMatrix<'a> {
    pub(super) scene: &'a Scene,
    pub(super) pairs: &'a ScenePairs<'a>,
    /// All pairs, if they are held.
    pub(super) held: Option<&'a ExchangeAreas>,
    /// The pairs that miss the tolerance, if all are held.
    pub(super) unreached: Option<&'a Unreached>,
}

/// The exchange areas of one row with all others, as a row of the matrix or as a column.
#[derive(Debug)]
pub struct MatrixLine<'a> {
    index: usize,
    answers: &'a [Answer],
    /// The area of each row, with the bound on its rounding and the quotient's.
    areas: &'a [[f64; 2]],
}

/// The area of each row, with the bound on its rounding and that of a quotient by it.
pub(super) fn areas(pairs: &ScenePairs<'_>) -> Vec<[f64; 2]> {
    let areas = pairs.areas().iter().zip(pairs.area_bounds());
    areas.map(|(area, bound)| [*area, *bound]).collect()
}

impl MatrixEntries {
    fn of(self, answer: &Answer, area: [f64; 2]) -> f64 {
        let [value, bound] = answer.quotient(area);
        match self {
            Self::FormFactors => value,
            Self::Bounds => bound,
        }
    }
}

impl<'a> MatrixLine<'a> {
    /// The line with this index.
    ///
    /// **Arguments** the exchange areas of its row with each row, and the area of each row with the
    /// bound on its rounding and that of a quotient by it.
    #[must_use]
    pub const fn new(index: usize, answers: &'a [Answer], areas: &'a [[f64; 2]]) -> Self {
        Self {
            index,
            answers,
            areas,
        }
    }

    /// The index of the line, from 0.
    #[must_use]
    pub const fn index(&self) -> usize {
        self.index
    }

    /// The entries of the row with this index.
    pub fn row(&self, entries: MatrixEntries) -> impl Iterator<Item = f64> + '_ {
        let area = self.areas[self.index];
        let answers = self.answers.iter();
        answers.map(move |answer| entries.of(answer, area))
    }

    /// The entries of the column with this index.
    pub fn column(&self, entries: MatrixEntries) -> impl Iterator<Item = f64> + '_ {
        let answers = self.answers.iter().zip(self.areas);
        answers.map(move |(answer, area)| entries.of(answer, *area))
    }
}

impl FormFactorMatrix<'_> {
    /// The number of rows, and of columns.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.pairs.rows()
    }

    /// The area of each row.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        self.pairs.areas()
    }

    /// The reflectance of each row, the mean of its channels; none where it is not known.
    ///
    /// # Errors
    /// [`SceneError::MixedRow`] if patches of one row differ.
    pub fn reflectances(&self) -> Result<Vec<Option<f64>>, SceneError> {
        let rows = (0..self.rows()).map(|row| match self.scene.group_reflectance(row) {
            Ok(colour) => Ok(Some(colour.mean())),
            Err(SceneError::MaterialUnknown { .. }) => Ok(None),
            Err(error) => Err(error),
        });
        rows.collect()
    }

    /// The number of entries that are not exactly zero, known if all pairs are held.
    #[must_use]
    pub fn count(&self, entries: MatrixEntries) -> Option<usize> {
        self.held?;
        let mut count = 0;
        let counted = self.for_each_line(|line| {
            count += line.row(entries).filter(|entry| *entry != 0.0).count();
            Ok::<(), ExchangeError>(())
        });
        counted.ok().map(|_| count)
    }

    /// Shows all lines in order; if all pairs are not held, they are computed on the way.
    ///
    /// **Returns** the pairs that miss the tolerance, if some do.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused, or what `visit` returns.
    pub fn for_each_line<E: From<ExchangeError>>(
        &self,
        mut visit: impl FnMut(&MatrixLine<'_>) -> Result<(), E>,
    ) -> Result<Option<Unreached>, E> {
        let areas = areas(self.pairs);
        let mut show = |index, answers: &[Answer]| visit(&MatrixLine::new(index, answers, &areas));
        if let Some(held) = self.held {
            let mut answers = Vec::with_capacity(self.rows());
            for index in 0..self.rows() {
                answers.clear();
                answers.extend((0..self.rows()).map(|other| held.get(index, other)));
                show(index, &answers)?;
            }
            return Ok(self.unreached.cloned());
        }
        let summary: PassSummary = self.pairs.for_each_row(show)?;
        let names: Vec<&str> = self.pairs.names().iter().map(String::as_str).collect();
        Ok(Unreached::pairs(&names, &summary, self.pairs.tolerance()))
    }
}
