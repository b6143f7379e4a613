//! The exchange areas `A_i F_ij` of all pairs of a scene, each computed once.

use super::{Scene, SceneError};
use crate::form_factor::{ExchangeArea, RectanglePair};
use crate::geometry::Rectangle;
use nalgebra::DMatrix;

/// A symmetric matrix of exchange areas, with a bound on the error of each.
#[derive(Debug, Clone, PartialEq)]
pub struct ExchangeAreas {
    values: DMatrix<f64>,
    error_bounds: DMatrix<f64>,
}

impl ExchangeAreas {
    /// `A_i F_ij`, symmetric, zero on the diagonal.
    #[must_use]
    pub const fn values(&self) -> &DMatrix<f64> {
        &self.values
    }

    /// A bound on the absolute error of each entry.
    #[must_use]
    pub const fn error_bounds(&self) -> &DMatrix<f64> {
        &self.error_bounds
    }

    /// The values alone.
    #[must_use]
    pub fn into_values(self) -> DMatrix<f64> {
        self.values
    }
}

impl Scene {
    /// The unoccluded exchange areas of all pairs.
    ///
    /// # Errors
    /// [`SceneError::Patch`] if a patch is not a rectangle, [`SceneError::Pair`] if two rectangles'
    /// edges do not run along three common axes.
    pub fn exchange_areas(&self) -> Result<ExchangeAreas, SceneError> {
        let n = self.patches().len();
        let rectangles: Vec<Rectangle> = (0..n)
            .map(|index| self.rectangle(index))
            .collect::<Result<_, _>>()?;
        let mut values = DMatrix::zeros(n, n);
        let mut error_bounds = DMatrix::zeros(n, n);
        for (first, rectangle) in rectangles.iter().enumerate() {
            for (second, other) in rectangles.iter().enumerate().skip(first + 1) {
                let ExchangeArea { value, error_bound } = RectanglePair::try_new(rectangle, other)
                    .and_then(|pair| pair.exchange_area())
                    .map_err(|source| SceneError::Pair {
                        first,
                        second,
                        source,
                    })?;
                values[(first, second)] = value;
                values[(second, first)] = value;
                error_bounds[(first, second)] = error_bound;
                error_bounds[(second, first)] = error_bound;
            }
        }
        Ok(ExchangeAreas {
            values,
            error_bounds,
        })
    }
}
