//! Unoccluded form factors: the fraction of the power leaving one patch that reaches another.
//!
//! ```text
//!   A_i F_ij = ∫∫ cos θ_x cos θ_y / (π r²) dy dx        (direct exchange area, symmetric in i, j)
//! ```
//!
//! Everything is computed as an exchange area, once per pair, so reciprocity
//! `A_i F_ij = A_j F_ji` holds exactly. One file per route: [`parallel`] and [`perpendicular`]
//! rectangles in closed form, at any offset; [`RectanglePair`] recognises which of them a pair is,
//! clips what lies behind either plane, and reports a value with its error bound.
//!
//! **Not covered**: other polygons, and occlusion: every value is the unoccluded one.
//!
//! References: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-11 to C-15;
//! Cohen and Wallace, *Radiosity and Realistic Image Synthesis*, 1993, ch. 4.

mod choice;
mod contour;
mod edge_pair;
mod error;
mod exchange;
mod gauss_points;
mod horizon;
mod kernel;
pub mod parallel;
pub mod perpendicular;
mod point_to_polygon;
mod polygon;
mod potential;
mod rectangle_kernel;
mod rectangle_pair;
pub mod reference;
mod route;
pub mod sampling;
mod shape;
mod strip_exchange;
mod view;

pub use choice::DEFAULT_TOLERANCE;
pub use error::FormFactorError;
pub use exchange::{Exchange, ExchangeArea};
pub use point_to_polygon::{point_form_factor, point_kernel};
pub use polygon::Polygon;
pub use rectangle_pair::RectanglePair;
pub use route::{Answer, Route};
