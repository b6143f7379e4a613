//! The exchange areas `A_i F_ij` of all pairs of a scene, held: each once.
//!
//! **Memory** the pairs i < j are packed: `n²/2` values, `n²/2` bounds, `n²/2` bytes for the routes; and the rows that see themselves.

use super::facing::Sight;
use super::row_pairs::nothing;
use super::{Account, Congruence, ExchangeError, Occlusion, Scene, SceneError, ScenePairs, Tally};
use crate::form_factor::{Answer, DEFAULT_TOLERANCE, ExchangeArea, Route};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::collections::HashMap;

/// A symmetric matrix of exchange areas, with a bound on the error of each. What is called a patch is a row of it: some may be
/// several patches, summed; only these may have something on the diagonal.
#[derive(Debug, Clone, PartialEq)]
pub struct ExchangeAreas {
    areas: Vec<f64>,
    area_bounds: Vec<f64>,
    /// The rows that may see themselves.
    diagonal: HashMap<usize, Answer>,
    /// Entry (i, j), i < j, at `j(j − 1)/2 + i`.
    values: Vec<f64>,
    error_bounds: Vec<f64>,
    routes: Vec<Route>,
    account: Account,
}

/// One column above the diagonal, to be filled.
struct Column<'c> {
    values: &'c mut [f64],
    error_bounds: &'c mut [f64],
    routes: &'c mut [Route],
}

type Filled = (Tally, Option<Answer>);

impl ExchangeAreas {
    /// Number of rows: of the patches, unless some are summed.
    #[must_use]
    pub const fn patches(&self) -> usize {
        self.areas.len()
    }

    /// The entries (i, j), i < j, packed: at `j(j − 1)/2 + i`.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The bounds on the errors of [`values`](Self::values).
    #[must_use]
    pub fn error_bounds(&self) -> &[f64] {
        &self.error_bounds
    }

    /// The rows' areas, without what lies in them.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Bounds on the rounding of the areas and of one quotient by them ([`ScenePairs::area_bounds`]).
    #[must_use]
    pub fn area_bounds(&self) -> &[f64] {
        &self.area_bounds
    }

    /// May this row exchange something with itself?
    #[must_use]
    pub fn sees_itself(&self, row: usize) -> bool {
        self.diagonal.contains_key(&row)
    }

    /// `A_i F_ij` with its bound and route ([`ScenePairs::pair`]).
    ///
    /// # Panics
    /// If there is no patch i or j.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> Answer {
        assert!(i.max(j) < self.patches(), "there is no patch {}", i.max(j));
        if i == j {
            let own = self.diagonal.get(&i);
            return own.copied().unwrap_or(nothing(Route::Coplanar));
        }
        let at = packed(i.max(j)) + i.min(j);
        Answer {
            exchange: ExchangeArea {
                value: self.values[at],
                error_bound: self.error_bounds[at],
            },
            route: self.routes[at],
        }
    }

    /// The plan, and whether the tolerance was reached.
    #[must_use]
    pub const fn account(&self) -> &Account {
        &self.account
    }

    /// The full matrix `A_i F_ij`, for which the bounds are given up.
    #[must_use]
    pub fn into_values(self) -> DMatrix<f64> {
        let n = self.patches();
        DMatrix::from_fn(n, n, |i, j| self.get(i, j).exchange.value)
    }
}

/// Where column j starts.
const fn packed(j: usize) -> usize {
    j * j.saturating_sub(1) / 2
}

impl ScenePairs {
    /// All pairs, each once, in parallel.
    ///
    /// # Errors
    /// [`ExchangeError::Pair`] if two patches are refused.
    pub fn exchange_areas(&self) -> Result<ExchangeAreas, ExchangeError> {
        let patches = self.patches();
        let pairs = packed(patches);
        let mut values = vec![0.0; pairs];
        let mut error_bounds = vec![0.0; pairs];
        let mut routes = vec![Route::Coplanar; pairs];
        let mut columns = Vec::with_capacity(patches);
        let mut rest = (&mut *values, &mut *error_bounds, &mut *routes);
        for column in 0..patches {
            let (values, more_values) = rest.0.split_at_mut(column);
            let (error_bounds, more_bounds) = rest.1.split_at_mut(column);
            let (routes, more_routes) = rest.2.split_at_mut(column);
            rest = (more_values, more_bounds, more_routes);
            columns.push(Column {
                values,
                error_bounds,
                routes,
            });
        }
        let tallies: Vec<_> = columns
            .into_par_iter()
            .enumerate()
            .map(|(second, column)| self.fill(second, column))
            .collect();
        let (mut tally, mut diagonal) = (Tally::default(), HashMap::new());
        for (row, column) in tallies.into_iter().enumerate() {
            let (counts, own) = column?;
            tally.merge(&counts);
            diagonal.extend(own.map(|own| (row, own)));
        }
        Ok(ExchangeAreas {
            areas: self.areas().to_vec(),
            area_bounds: self.area_bounds().to_vec(),
            diagonal,
            values,
            error_bounds,
            routes,
            account: self.account(tally),
        })
    }

    /// Fills a column above the diagonal; and what is on it, if the row may see itself.
    fn fill(&self, second: usize, column: Column<'_>) -> Result<Filled, ExchangeError> {
        let mut tally = Tally::default();
        for first in 0..second {
            let answer = self.between(first, second, &mut tally)?;
            column.values[first] = answer.exchange.value;
            column.error_bounds[first] = answer.exchange.error_bound;
            column.routes[first] = answer.route;
        }
        self.progress.done(second);
        let sees_itself = self.sight(second, second) == Sight::Open;
        let own = if sees_itself {
            Some(self.open(second, second, &mut tally)?)
        } else {
            None
        };
        Ok((tally, own))
    }
}

impl Scene {
    /// The exchange areas of all pairs, to [`DEFAULT_TOLERANCE`] where a route reaches it.
    ///
    /// As if nothing were in the way they come from [`ScenePairs`] with [`Occlusion::Ignore`].
    ///
    /// # Errors
    /// [`ExchangeError::Scene`] if patches overlap or something may stand between two of them;
    /// [`ExchangeError::Pair`] if two patches are refused.
    pub fn exchange_areas(&self) -> Result<ExchangeAreas, ExchangeError> {
        let (tolerance, occlusion) = (DEFAULT_TOLERANCE, Occlusion::Refuse);
        ScenePairs::try_new(self, tolerance, Congruence::Shared, occlusion)?.exchange_areas()
    }
}
