//! Unoccluded form factors: the fraction of the power leaving one patch that reaches another.
//!
//! ```text
//!   A_i F_ij = ∫∫ cos θ_x cos θ_y / (π r²) dy dx        (direct exchange area, symmetric in i, j)
//! ```
//!
//! Everything is computed as an exchange area, once per pair, so reciprocity `A_i F_ij = A_j F_ji`
//! holds exactly. A [`Polygon`] is any planar simple one, made ready; a pair of them takes the
//! cheapest [`Route`] whose error bound meets the tolerance, and the answer names it. One file per
//! route:
//!
//! ```text
//!   parallel, perpendicular    aligned rectangles in closed form, at any offset
//!   rectangle_kernel           aligned rectangles far apart: Gauss rules along their sides
//!   contour                    both outlines: closed forms of coplanar edges, Gauss rules (`panels`) for skew ones
//!   precise_contour            the same in double-double
//!   point_to_polygon           Lambert's formula, with a Gauss rule over one polygon
//!   kernel                     Gauss rules over both
//! ```
//!
//! `horizon` clips what lies behind the other's plane, `view` measures what is left, `choice`
//! chooses. [`mod@reference`] is a slow road of its own to judge them by, [`sampling`] another. A
//! bound holds for corners as given: what their rounding does to a polygon that is not quite planar
//! is in it.
//!
//! [`Logarithms`] are those of distance and cosines, averaged over what a pair exchanges.
//!
//! **Not covered**: occlusion: every value is the unoccluded one.
//!
//! References: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-11 to C-15;
//! Cohen and Wallace, *Radiosity and Realistic Image Synthesis*, 1993, ch. 4.

mod aligned;
mod choice;
mod contour;
mod coplanar_edges;
mod corners;
mod edge;
mod error;
mod exchange;
mod exchange_area;
mod gauss_points;
mod horizon;
mod kernel;
mod layout;
mod logarithms;
mod panels;
pub mod parallel;
pub mod perpendicular;
mod point_to_polygon;
mod polygon;
mod potential;
mod precise_contour;
mod rectangle_kernel;
mod rectangle_pair;
pub mod reference;
mod route;
pub mod sampling;
mod shape;
mod strip_exchange;
mod view;
mod workspace;

pub use choice::DEFAULT_TOLERANCE;
pub(crate) use corners::EdgeSlopes;
pub use error::FormFactorError;
pub use exchange::Exchange;
pub use exchange_area::{Answer, ExchangeArea};
pub(crate) use layout::Layout;
pub use logarithms::Logarithms;
pub use point_to_polygon::{point_form_factor, point_kernel};
pub use polygon::Polygon;
pub use rectangle_pair::RectanglePair;
pub use route::Route;
