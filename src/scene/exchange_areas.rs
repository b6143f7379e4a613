//! The exchange areas `A_i F_ij` of all pairs of a scene, held: each once.
//!
//! **Memory** the pairs i < j are packed: `n²/2` values, `n²/2` bounds, `n²/2` bytes for the routes.

use super::{Account, Congruence, Scene, SceneError, ScenePairs, Sight, Tally};
use crate::form_factor::{Answer, DEFAULT_TOLERANCE, ExchangeArea, Route};
use nalgebra::DMatrix;
use rayon::prelude::*;

/// A symmetric matrix of exchange areas, zero on the diagonal, with a bound on the error of each.
#[derive(Debug, Clone, PartialEq)]
pub struct ExchangeAreas {
    areas: Vec<f64>,
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

impl ExchangeAreas {
    /// Number of patches.
    #[must_use]
    pub const fn patches(&self) -> usize {
        self.areas.len()
    }

    /// The patches' areas.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
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

    /// `A_i F_ij` with its bound and route; a patch with itself exchanges nothing.
    ///
    /// # Panics
    /// If there is no patch i or j.
    #[must_use]
    pub fn get(&self, i: usize, j: usize) -> Answer {
        assert!(i.max(j) < self.patches(), "there is no patch {}", i.max(j));
        if i == j {
            let exchange = ExchangeArea {
                value: 0.0,
                error_bound: 0.0,
            };
            return Answer {
                exchange,
                route: Route::Coplanar,
            };
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
        let patches = self.patches();
        let values = self.values;
        DMatrix::from_fn(patches, patches, |i, j| {
            if i == j {
                0.0
            } else {
                values[packed(i.max(j)) + i.min(j)]
            }
        })
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
    /// [`SceneError::Pair`] if two patches are refused.
    pub fn exchange_areas(&self) -> Result<ExchangeAreas, SceneError> {
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
        let mut tally = Tally::default();
        for column in tallies {
            tally.merge(&column?);
        }
        Ok(ExchangeAreas {
            areas: self.areas().to_vec(),
            values,
            error_bounds,
            routes,
            account: self.account(tally),
        })
    }

    fn fill(&self, second: usize, column: Column<'_>) -> Result<Tally, SceneError> {
        let mut tally = Tally::default();
        for first in 0..second {
            match self.plan.sight(first, second) {
                Sight::Open => {
                    let answer = self.look(first, second, &mut tally)?;
                    column.values[first] = answer.exchange.value;
                    column.error_bounds[first] = answer.exchange.error_bound;
                    column.routes[first] = answer.route;
                }
                Sight::Coplanar => {}
                Sight::BackFacing => column.routes[first] = Route::BackFacing,
            }
        }
        Ok(tally)
    }
}

impl Scene {
    /// The unoccluded exchange areas of all pairs, to [`DEFAULT_TOLERANCE`] where a route reaches it.
    ///
    /// # Errors
    /// [`SceneError::Pair`] if two patches are refused.
    pub fn exchange_areas(&self) -> Result<ExchangeAreas, SceneError> {
        ScenePairs::try_new(self, DEFAULT_TOLERANCE, Congruence::Shared)?.exchange_areas()
    }
}
