//! Exchange areas with bounds on their errors, and the routes that found them.

use super::Route;
use crate::numeric::{Bounded, Grade};

/// An exchange area with a bound on its error.
///
/// Scenes hold millions of them, so the grade is the type's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExchangeArea {
    /// `A_1 F_12 = A_2 F_21`, in squared units of length, ≥ 0.
    pub value: f64,
    /// Bound on the absolute error, in the same unit: for corners as given
    /// ([`Polygon`](super::Polygon)), or for rectangles as placed in the frame of the first
    /// ([`RectanglePair`](super::RectanglePair)). It rests on the error bounds of
    /// [`elementary`](crate::numeric::functions::elementary).
    pub error: f64,
}

impl ExchangeArea {
    /// The grade of the error.
    pub const GRADE: Grade = Grade::Bound;

    /// The exchange area of two polygons that do not face each other.
    pub(crate) const NOTHING: Self = Self {
        value: 0.0,
        error: 0.0,
    };

    /// The value with its error and their grade.
    #[must_use]
    pub const fn bounded(self) -> Bounded {
        Bounded::of_grade(self.value, self.error, Self::GRADE)
    }
}

/// An exchange area, and the route that found it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// The value and the bound on its error.
    pub exchange: ExchangeArea,
    /// The route.
    pub route: Route,
}
