//! Form factors from points in doubles, for those who ask often: with gradients, and past others.
//!
//! No allocation, no bounds: values are right to rounding where nothing is in the way, and where
//! convex polygons are. [`super::point_form_factor_past`] has a bound.

mod edge;
mod gradient;
mod plate;

pub use gradient::{PointFactor, point_form_factor_with_gradient};
pub(crate) use plate::{Plate, PointView, Seen};
