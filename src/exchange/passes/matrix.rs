//! The exchange areas `A_i F_ij` of all pairs of a scene, held: each once.
//!
//! **Memory** the pairs are packed ([`Symmetric`]): `n²/2` values, `n²/2` bounds, `n²/2` bytes for
//! the routes; and the rows that see themselves.

use super::tiles::Block;
use crate::exchange::pairs::row_pair::nothing;
use crate::exchange::plan::counts::{PassCounts, PassSummary};
use crate::exchange::plan::facing::Facing;
use crate::exchange::{Congruence, ExchangeError, ResolutionErrors, ScenePairs};
use crate::form_factor::{Answer, DEFAULT_TOLERANCE, ExchangeArea, Route};
use crate::numeric::Symmetric;
use crate::scene::{Occlusion, Scene};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;

/// A symmetric matrix of exchange areas, with a bound on the error of each. A row stands for a
/// patch, or for several that are summed; only these may have something on the diagonal.
#[derive(Debug, Clone, PartialEq)]
pub struct ExchangeAreas {
    names: Arc<[String]>,
    areas: Vec<f64>,
    area_bounds: Vec<f64>,
    /// The rows that may see themselves.
    diagonal: HashMap<usize, Answer>,
    values: Symmetric<f64>,
    errors: Symmetric<f64>,
    routes: Symmetric<Route>,
    summary: PassSummary,
    resolution: Option<ResolutionErrors>,
}

/// One row left of the diagonal, to be filled.
struct Row<'r> {
    values: &'r mut [f64],
    errors: &'r mut [f64],
    routes: &'r mut [Route],
}

type Filled = (PassCounts, Option<Answer>);

impl ExchangeAreas {
    /// Number of rows: of the patches, unless some are summed.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.areas.len()
    }

    /// The names of the rows.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The names of the rows, to be kept.
    pub(crate) fn shared_names(&self) -> Arc<[String]> {
        Arc::clone(&self.names)
    }

    /// The values off the diagonal, packed.
    #[must_use]
    pub const fn values(&self) -> &Symmetric<f64> {
        &self.values
    }

    /// The bounds on the errors of [`values`](Self::values).
    #[must_use]
    pub const fn errors(&self) -> &Symmetric<f64> {
        &self.errors
    }

    /// The rows' areas, without what lies in them.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Bounds on the rounding of the areas and of one quotient by them
    /// ([`ScenePairs::area_bounds`]).
    #[must_use]
    pub fn area_bounds(&self) -> &[f64] {
        &self.area_bounds
    }

    /// Whether this row may exchange something with itself.
    #[must_use]
    pub fn sees_itself(&self, row: usize) -> bool {
        self.diagonal.contains_key(&row)
    }

    /// `A_i F_ij` with its bound and route ([`ScenePairs::row_pair`]).
    ///
    /// # Panics
    /// If there is no row i or j.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> Answer {
        assert!(i.max(j) < self.rows(), "there is no row {}", i.max(j));
        if i == j {
            let own = self.diagonal.get(&i);
            return own.copied().unwrap_or(nothing(Facing::Coplanar, true));
        }
        Answer {
            exchange: ExchangeArea {
                value: *self.values.get(i, j),
                error: *self.errors.get(i, j),
            },
            route: *self.routes.get(i, j),
        }
    }

    /// The plan, and whether the tolerance was reached.
    #[must_use]
    pub const fn summary(&self) -> &PassSummary {
        &self.summary
    }

    /// Bounds on what the resolution of the coordinates can change; none if they are exact.
    #[must_use]
    pub const fn resolution_errors(&self) -> Option<&ResolutionErrors> {
        self.resolution.as_ref()
    }

    /// A bound on what the resolution of the coordinates can change of the exchange area of two
    /// rows ([`ScenePairs::resolution_error`]).
    ///
    /// # Panics
    /// If there is no row i or j.
    #[must_use]
    pub fn resolution_error(&self, i: usize, j: usize) -> f64 {
        match &self.resolution {
            None => 0.0,
            Some(errors) if i == j => errors.own()[i],
            Some(errors) => *errors.exchange().get(i, j),
        }
    }

    /// The full matrix `A_i F_ij`, for which the bounds are given up.
    #[must_use]
    pub fn into_values(self) -> DMatrix<f64> {
        let n = self.rows();
        DMatrix::from_fn(n, n, |i, j| self.get(i, j).exchange.value)
    }
}

impl ScenePairs<'_> {
    /// All pairs, each once, in parallel.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused.
    pub fn exchange_areas(&self) -> Result<ExchangeAreas, ExchangeError> {
        let mut values = Symmetric::filled(self.rows(), 0.0);
        let mut errors = Symmetric::filled(self.rows(), 0.0);
        let mut routes = Symmetric::filled(self.rows(), Route::Coplanar);
        let rows = values.rows_mut().into_iter().zip(errors.rows_mut());
        let rows = rows.zip(routes.rows_mut());
        let to_fill: Vec<Row<'_>> = rows
            .map(|((values, errors), routes)| Row {
                values,
                errors,
                routes,
            })
            .collect();
        let filled: Vec<Result<Filled, ExchangeError>> = to_fill
            .into_par_iter()
            .enumerate()
            .map(|(row, entries)| self.fill(row, entries))
            .collect();
        let (mut counts, mut diagonal) = (PassCounts::default(), HashMap::new());
        for (row, filled) in filled.into_iter().enumerate() {
            let (more, own) = filled?;
            counts.merge(&more);
            diagonal.extend(own.map(|own| (row, own)));
        }
        Ok(ExchangeAreas {
            names: self.shared_names(),
            areas: self.areas().to_vec(),
            area_bounds: self.area_bounds().to_vec(),
            diagonal,
            values,
            errors,
            routes,
            summary: self.summary(counts),
            resolution: ResolutionErrors::of(self),
        })
    }

    /// Fills a row left of the diagonal, and computes what is on it.
    fn fill(&self, row: usize, entries: Row<'_>) -> Result<Filled, ExchangeError> {
        self.lower_row(row, |column, answer| {
            entries.values[column] = answer.exchange.value;
            entries.errors[column] = answer.exchange.error;
            entries.routes[column] = answer.route;
        })
    }

    /// Visits the pairs of a row with those before it, and returns the counts and what is on the
    /// diagonal, if the row may see itself.
    pub(super) fn lower_row(
        &self,
        row: usize,
        mut visit: impl FnMut(usize, &Answer),
    ) -> Result<Filled, ExchangeError> {
        let mut counts = self.walk(
            &Block::of_row(row, 0..row),
            |place| place,
            |[_, column], _, answer| visit(column, answer),
        )?;
        self.advance(row);
        let mut own = None;
        let more = self.walk(
            &Block::of_row(row, row..row + 1),
            |place| place,
            |_, facing, answer| own = (facing == Facing::Visible).then_some(*answer),
        )?;
        counts.merge(&more);
        Ok((counts, own))
    }
}

impl Scene {
    /// The exchange areas of all pairs past all that stands between, to [`DEFAULT_TOLERANCE`] where
    /// a route reaches it.
    ///
    /// As if nothing were in the way they come from [`ScenePairs`] with [`Occlusion::Ignore`].
    ///
    /// # Errors
    /// [`ExchangeError::Scene`] if patches overlap; [`ExchangeError::Pair`] if two patches are
    /// refused.
    pub fn exchange_areas(&self) -> Result<ExchangeAreas, ExchangeError> {
        let (tolerance, occlusion) = (DEFAULT_TOLERANCE, Occlusion::default());
        ScenePairs::try_new(self, tolerance, Congruence::Shared, occlusion)?.exchange_areas()
    }
}
