//! Form factors: the fraction of the power leaving one patch that reaches another.
//!
//! ```text
//!   A_i F_ij = ∫∫ cos θ_x cos θ_y / (π r²) dy dx        (direct exchange area, symmetric in i, j)
//! ```
//!
//! Everything is computed as an exchange area, once per pair, so reciprocity `A_i F_ij = A_j F_ji`
//! holds exactly. A [`Polygon`] is a patch prepared for form factors; a pair of them takes the
//! cheapest [`Route`] whose error bound meets the tolerance, and the answer names it.
//!
//! | route | domain and method | file |
//! |---|---|---|
//! | closed forms | aligned rectangles, at any offset | [`rectangles`] |
//! | rectangle kernel | aligned rectangles far apart: Gauss rules along sides | `rectangles/far` |
//! | contour | both outlines: closed forms of coplanar edges, Gauss rules for others | `contour` |
//! | double-double | the contour in 106 bits | `contour/double_double` |
//! | point to polygon | Lambert's formula, with a Gauss rule over one polygon | `gauss/lambert` |
//! | kernel | Gauss rules over both polygons | `gauss/kernel` |
//! | points past others | arcs about what is visible | `occlusion/point` |
//! | points, with the gradient | Lambert's formula and its derivative | `point` |
//!
//! `clipped_pair` removes the part of each polygon behind the other's plane and measures the rest;
//! `front_door` is asked, `chooser` chooses the route; `together` measures eight pairs in the lanes
//! of a vector, and takes rules of few points so. `occlusion` takes away what other polygons hide.
//! [`LogMeans`] are the integrals of the logarithms of distance and cosines over the exchange of a
//! pair.
//! [`crate::reference`] is an independent slow computation by which all routes are judged,
//! [`sampling`] another.
//!
//! # Any two polygons
//!
//! Polygons may be concave, touching, far apart, thin, or partly behind each other's plane. The
//! answer is a value, a bound on its error, and the route. The bound holds for the corners as
//! given; where their rounding leaves no certain digit, and where it bends a polygon out of its
//! plane, the bound says so.
//!
//! ```
//! use glam::DVec3;
//! use infoscene::form_factor::{DEFAULT_TOLERANCE, Polygon};
//! use infoscene::geometry::{GeometryError, Patch};
//!
//! // two triangles that share a corner of a cube: (1 − 1/√3)/2
//! let corner = |a, b| {
//!     let patch = Patch::try_new(vec![DVec3::ZERO, a, b])?;
//!     Ok::<_, GeometryError>(Polygon::new(&patch))
//! };
//! let (floor, wall) = (corner(DVec3::X, DVec3::Y)?, corner(DVec3::Y, DVec3::Z)?);
//! let answer = floor.exchange_area(&wall, DEFAULT_TOLERANCE)?;
//! let exact = (1.0 - 1.0 / 3f64.sqrt()) / 2.0 * floor.area();
//! assert!((answer.exchange.value - exact).abs() <= answer.exchange.error);
//! assert!(answer.exchange.error <= 1e-12 * exact);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Accuracy**: the bound and 1e-12 of the value are held against the reference of 256 bits, for
//! some pairs of each family by `answers_agree_with_the_slow_reference`, and for 200 of each by
//! `cargo test --release --test library answers -- --ignored`.
//!
//! **Cost**: the table holds the median time of a pair over 256 of a family, bound and clip
//! included, as a multiple of the textbook's sixteen terms for aligned rectangles (0.36 µs). It was
//! measured by `cargo bench --bench polygons` on one core with AVX-512; bits do not depend on the
//! processor, times do.
//!
//! | family | × textbook |
//! |---|---|
//! | aligned rectangles | 0.23 |
//! | triangles turned at random, two to three sizes apart | 2.4 |
//! | quadrilaterals turned at random, two to three sizes apart | 3.3 |
//! | quadrilaterals, 8 sizes apart | 1.2 |
//! | quadrilaterals, 30 sizes apart | 0.63 |
//! | turned rectangles with a common edge | 3.3 |
//! | triangles with a common corner | 3.7 |
//! | angles of 180° less 1e-6 to 1e-3, in double-double | 195 |
//!
//! **Not covered**: what stands in the way, unless it is named ([`Polygon::exchange_area_past`],
//! [`point_form_factor_past`]): all else is the unoccluded value.
//!
//! References: Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-11 to C-15;
//! Cohen and Wallace, *Radiosity and Realistic Image Synthesis*, 1993, ch. 4.

mod chooser;
mod clipped_pair;
mod contour;
mod error;
mod exchange_area;
mod front_door;
mod gauss;
mod logarithms;
mod occlusion;
mod point;
mod polygon;
// hidden: tests and benchmarks reach its closed forms, a user takes `RectanglePair`
#[doc(hidden)]
pub mod rectangles;
mod route;
pub mod sampling;
pub(crate) mod together;
mod workspace;

pub use error::FormFactorError;
pub use exchange_area::{Answer, ExchangeArea};
pub use front_door::DEFAULT_TOLERANCE;
pub use gauss::lambert::{point_form_factor, point_kernel};
pub use logarithms::LogMeans;
pub use occlusion::{Occluders, point_form_factor_past};
pub(crate) use occlusion::{Sight, Viewpoint};
pub(crate) use point::{Plate, PointView, Seen};
pub use point::{PointFactor, point_form_factor_with_gradient};
pub use polygon::Polygon;
pub use rectangles::corner_sum::Exchange;
pub(crate) use rectangles::derivatives::EdgeSlopes;
pub(crate) use rectangles::layout::Layout;
pub use rectangles::pair::RectanglePair;
pub use route::Route;
