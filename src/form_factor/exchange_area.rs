//! Exchange areas with bounds on their errors, and the routes that found them.

use super::Route;

/// An exchange area with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExchangeArea {
    /// `A_1 F_12 = A_2 F_21`, in squared units of length, ≥ 0.
    pub value: f64,
    /// Bound on the absolute error, in the same unit: for corners as given
    /// ([`Polygon`](super::Polygon)), or for rectangles as placed in the frame of the first
    /// ([`RectanglePair`](super::RectanglePair)). It rests on the error bounds of
    /// [`elementary`](crate::numeric::functions::elementary).
    pub error_bound: f64,
}

impl ExchangeArea {
    /// The exchange area of two polygons that do not face each other.
    pub(super) const NOTHING: Self = Self {
        value: 0.0,
        error_bound: 0.0,
    };
}

/// An exchange area, and the route that found it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// The value and the bound on its error.
    pub exchange: ExchangeArea,
    /// The route.
    pub route: Route,
}
