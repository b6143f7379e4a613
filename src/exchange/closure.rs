//! The sums of the rows of form factors, which are one in a closed scene.
//!
//! ```text
//!   closed:  |Σ_j F_ij − 1| ≤ Σ_j bound_ij / A_i + 4 ε + ρ_i  for every i
//! ```
//!
//! ρ is what the cracks between surfaces can change that the resolution of the coordinates explains
//! ([`ScenePairs::crack_errors`]), 0 where they are exact.
//!
//! The 4 ε are for the area and the quotient; where an area is a sum or a difference, they are
//! relative to the areas that it is made of.
//!
//! In an open scene the rest of the light of a row, one less its sum, escapes. A row without area
//! has no light: its sum is 0, nothing escapes, and it leaves a scene closed.
//!
//! **Not covered**: the state outside that takes this rest; it belongs to the chains.

use super::pairs::row_pair::per_area;
use super::{ExchangeAreas, ExchangeError, ScenePairs};
use crate::numeric::CompensatedSum;
use std::sync::Arc;

/// The sum of a row of form factors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowSum {
    /// The patch, or the row that several are summed into, from 0.
    pub row: usize,
    /// `Σ_j F_ij`.
    pub sum: f64,
    /// A bound on the error of the sum.
    pub error: f64,
    /// A bound on what cracks that the resolution of the coordinates explains can change of a sum
    /// of one.
    pub resolution_error: f64,
}

impl RowSum {
    /// The distance from one up to which the row counts as closed.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.error + self.resolution_error
    }
}

/// The rows of a scene's form factors.
#[derive(Debug, Clone, PartialEq)]
pub struct Closure {
    rows: Vec<RowSum>,
    has_area: Vec<bool>,
    names: Arc<[String]>,
    is_turned_away: bool,
}

impl Closure {
    /// The closure of rows with these names, from the areas, with the bounds on their rounding and
    /// the quotient's, and the sums of the rows of exchange areas and of their error bounds.
    pub(crate) fn new(
        names: Arc<[String]>,
        [areas, area_bounds]: [&[f64]; 2],
        sums: impl IntoIterator<Item = [f64; 2]>,
        is_turned_away: bool,
    ) -> Self {
        let known = sums.into_iter().zip(areas.iter().zip(area_bounds));
        let rows = known
            .enumerate()
            .map(|(row, ([exchange, bound], (area, area_bound)))| RowSum {
                row,
                sum: per_area(exchange, *area),
                error: per_area(bound, *area) + per_area(*area_bound, *area),
                resolution_error: 0.0,
            })
            .collect();
        let has_area = areas.iter().map(|area| *area > 0.0).collect();
        Self {
            rows,
            has_area,
            names,
            is_turned_away,
        }
    }

    /// The closure of rows between whose surfaces there are cracks, each with what these change of
    /// the sum of its exchange areas.
    #[must_use]
    pub(crate) fn resolved(mut self, areas: &[f64], errors: &[f64]) -> Self {
        for ((row, area), error) in self.rows.iter_mut().zip(areas).zip(errors) {
            row.resolution_error = per_area(*error, *area);
        }
        self
    }

    /// Computes the row sums of a scene's form factors.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused.
    pub fn of(pairs: &ScenePairs<'_>) -> Result<Self, ExchangeError> {
        let (sums, summary) = pairs.row_sums(|_, _, exchange| [exchange.value, exchange.error])?;
        debug_assert_eq!(summary.is_turned_away, pairs.is_turned_away());
        Ok(Self::of_sums(pairs, sums))
    }

    /// The closure of a scene whose rows of exchange areas, and of bounds on their errors, have
    /// these sums.
    pub(crate) fn of_sums(
        pairs: &ScenePairs<'_>,
        sums: impl IntoIterator<Item = [f64; 2]>,
    ) -> Self {
        let closure = Self::new(
            pairs.shared_names(),
            [pairs.areas(), pairs.area_bounds()],
            sums,
            pairs.is_turned_away(),
        );
        closure.resolved(pairs.areas(), &pairs.crack_errors())
    }

    /// Sums the rows of exchange areas that are held.
    #[must_use]
    pub fn of_held(exchange: &ExchangeAreas) -> Self {
        let n = exchange.rows();
        let mut sums = vec![[CompensatedSum::default(); 2]; n];
        for i in 0..n {
            let own = exchange.get(i, i).exchange;
            let mut row = [own.value, own.error].map(|own| {
                let mut sum = CompensatedSum::default();
                sum.add(own);
                sum
            });
            let entries = exchange.values().row(i).iter();
            let entries = entries.zip(exchange.errors().row(i));
            for ((value, bound), column) in entries.zip(&mut sums) {
                column[0].add(*value);
                column[1].add(*bound);
                row[0].add(*value);
                row[1].add(*bound);
            }
            sums[i] = row;
        }
        let sums = sums.iter().map(|row| row.map(|sum| sum.total()));
        let closure = Self::new(
            exchange.shared_names(),
            [exchange.areas(), exchange.area_bounds()],
            sums,
            exchange.summary().is_turned_away,
        );
        match exchange.resolution_errors() {
            Some(errors) => closure.resolved(exchange.areas(), errors.cracks()),
            None => closure,
        }
    }

    /// All rows, in order.
    #[must_use]
    pub fn rows(&self) -> &[RowSum] {
        &self.rows
    }

    /// The rows that have an area, in order.
    fn with_area(&self) -> impl Iterator<Item = &RowSum> {
        let rows = self.rows.iter().zip(&self.has_area);
        rows.filter_map(|(row, has_area)| has_area.then_some(row))
    }

    /// The row farthest from one, of those with an area.
    ///
    /// # Panics
    /// If there are no rows; a scene has one at least.
    #[must_use]
    pub fn worst(&self) -> RowSum {
        let off = |row: &RowSum| (row.sum - 1.0).abs();
        let mut rows = self.with_area();
        let mut worst = rows.next().unwrap_or(&self.rows[0]);
        for row in rows {
            if off(row) > off(worst) {
                worst = row;
            }
        }
        *worst
    }

    /// The row farthest beyond its tolerance.
    fn farthest(&self) -> RowSum {
        let beyond = |row: &RowSum| (row.sum - 1.0).abs() - row.resolution_error;
        let mut worst = self.rows[0];
        for row in &self.rows[1..] {
            if beyond(row) > beyond(&worst) {
                worst = *row;
            }
        }
        worst
    }

    /// Whether every row sums to one within its bound, and what the resolution can change.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.with_area()
            .all(|row| (row.sum - 1.0).abs() <= row.tolerance())
    }

    /// Refuses a scene that is not closed.
    ///
    /// # Errors
    /// [`ExchangeError::TurnedAway`] if no patch faces another one, as all fronts are outside;
    /// [`ExchangeError::OpenScene`] with the row farthest from one; [`ExchangeError::RowAboveOne`].
    pub fn require_closed(&self) -> Result<(), ExchangeError> {
        if self.is_turned_away {
            return Err(ExchangeError::TurnedAway);
        }
        self.require_at_most_one()?;
        if self.is_closed() {
            return Ok(());
        }
        let worst = self.farthest();
        Err(ExchangeError::OpenScene {
            row: worst.row,
            name: self.names[worst.row].clone(),
            sum: worst.sum,
            tolerance: worst.error,
            resolution_error: worst.resolution_error,
        })
    }

    /// Refuses a scene whose patches overlap or hide each other.
    ///
    /// # Errors
    /// [`ExchangeError::RowAboveOne`] with the row farthest above one.
    pub fn require_at_most_one(&self) -> Result<(), ExchangeError> {
        let mut worst: Option<&RowSum> = None;
        for row in &self.rows {
            if row.sum - 1.0 > row.tolerance() && worst.is_none_or(|worst| row.sum > worst.sum) {
                worst = Some(row);
            }
        }
        worst.map_or(Ok(()), |row| {
            Err(ExchangeError::RowAboveOne {
                row: row.row,
                name: self.names[row.row].clone(),
                sum: row.sum,
                tolerance: row.error,
                resolution_error: row.resolution_error,
            })
        })
    }

    /// The part of the power of row i that meets no patch; 0 where the row sums to one within its
    /// bound, or has no area.
    ///
    /// # Panics
    /// If there is no row i.
    #[must_use]
    pub fn escaping(&self, i: usize) -> f64 {
        let row = self.rows[i];
        let escaping = 1.0 - row.sum;
        if self.has_area[i] && escaping > row.tolerance() {
            escaping
        } else {
            0.0
        }
    }
}
