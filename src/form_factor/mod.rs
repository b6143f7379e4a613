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
//! chooses. [`crate::reference`] is a slow road of its own to judge them by, [`sampling`] another.
//! A bound holds for corners as given: what their rounding does to a polygon that is not quite
//! planar is in it.
//!
//! [`LogMeans`] are those of distance and cosines, averaged over what a pair exchanges.
//!
//! **Not covered**: occlusion: every value is the unoccluded one.
//!
//! References: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-11 to C-15;
//! Cohen and Wallace, *Radiosity and Realistic Image Synthesis*, 1993, ch. 4.

mod chooser;
mod clipped_pair;
mod contour;
mod error;
mod exchange_area;
mod gauss;
mod logarithms;
mod polygon;
pub mod rectangles;
mod route;
pub mod sampling;
mod workspace;

pub use chooser::DEFAULT_TOLERANCE;
pub use error::FormFactorError;
pub use exchange_area::{Answer, ExchangeArea};
pub use gauss::lambert::{point_form_factor, point_kernel};
pub use logarithms::LogMeans;
pub use polygon::Polygon;
pub use rectangles::corner_sum::Exchange;
pub(crate) use rectangles::derivatives::EdgeSlopes;
pub(crate) use rectangles::layout::Layout;
pub use rectangles::pair::RectanglePair;
pub use route::Route;
