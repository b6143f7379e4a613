//! Numbers that carry their errors, and the functions, sums, roots and integrals built on them.
//!
//! Each formula of this crate is written once, over [`Scalar`]: `f64` gives the fast value,
//! [`Interval`] an enclosure of the exact one, [`Dual`] the derivative with it, and
//! `Dual<Interval>` an enclosure of the derivative.
//!
//! | question | where |
//! |---|---|
//! | number types | [`Scalar`], [`Interval`], [`Dual`], [`DoubleDouble`] |
//! | a value with its error | [`Bounded`], and the [`Grade`] of the error |
//! | elementary functions, entropy kernels (`0·log 0 = 0`) | [`functions`], [`x_log2_x`] |
//! | compensated and exact sums | [`compensated_sum`], [`Expansion`] |
//! | roots and maxima in `f64` | [`root`], [`maximum`], [`maximum_of_many`] |
//! | roots and maxima with proof | [`certified_roots`], [`certified_maximum`] |
//! | stationary points with proof | [`certified_stationary_point`] |
//! | integrals | [`GaussLegendre`], [`integral`] |
//! | rank correlation | [`rank_correlation`] |
//! | accuracy promises | [`tolerance`] |
//!
//! # Numbers you can trust
//!
//! An expression in `Interval` contains the exact value, at any precision; a maximum is certified
//! by its derivative's enclosure.
//!
//! ```
//! use infoscene::discretize::PatchSplit;
//! use infoscene::geometry::SplitAxis;
//! use infoscene::numeric::Interval;
//! use infoscene::scene::Scene;
//!
//! let squares = Scene::built_in("two-squares")?;
//! let split = PatchSplit::try_new(&squares, 0, &[1], SplitAxis::U)?;
//!
//! // the gain of a cut at 0.4, enclosed to some 70 digits
//! let cut = Interval::parse("0.4", 256).ok_or("a decimal number")?;
//! let gain = split.rectangles()?.lifted(&cut).gain(&[cut])?;
//! assert!(gain.width() < 1e-70);
//!
//! // the best cut of all, with proof: it is the only stationary point; Coq has the same decimals
//! let best = split.certified_best(128)?;
//! let digits = best.position.to_decimal(30).ok_or("bounded")?;
//! assert!(digits.lower.starts_with("0.39920102604538512521124559685"));
//! assert_eq!(best.certificate.to_string(), "the only maximum, and the only stationary point");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Roots, maxima and stationary points of other functions are certified alike: implement
//! [`IntervalFunction`], [`Maximand`] or [`VectorFunction`].
//!
//! **Not here**: geometry, and anything that knows what a form factor is.

mod count;
mod double_double;
mod dual;
mod error;
mod evidence;
pub mod functions;
mod integrate;
pub mod interval;
mod parallel;
mod rank_correlation;
mod scalar;
mod scaled;
mod solve;
mod sums;
mod symmetric;
pub mod tolerance;
mod vectorised;

pub(crate) use count::real;
pub use double_double::DoubleDouble;
// hidden: parts of the arithmetic that tests and benchmarks reach one by one, not an interface
#[doc(hidden)]
pub use double_double::SQUARED_EPSILON;
pub use dual::Dual;
pub use error::NumericError;
pub use evidence::{Bounded, Grade};
pub use functions::digamma::digamma;
#[doc(hidden)]
pub use functions::dilogarithm::{
    dilogarithm_deficit, dilogarithm_of_complement, imaginary_dilogarithm,
};
pub use functions::entropy_kernel::{divergence_kernel, x_ln_x, x_log2_ratio, x_log2_x};
#[doc(hidden)]
pub use functions::extremes::{larger, largest, smaller};
#[doc(hidden)]
pub use functions::unit::{power_of_two_below, power_of_two_near};
pub use integrate::gauss_legendre::GaussLegendre;
pub(crate) use integrate::gauss_legendre::{MOST_POINTS, NodeNumber, legendre_node};
pub use integrate::tanh_sinh::integral;
pub use interval::Interval;
pub use interval::precise::Precise;
pub(crate) use parallel::{parallel_map, try_parallel_map};
pub use rank_correlation::rank_correlation;
pub use scalar::Scalar;
pub(crate) use scaled::{Scaled, common_scale};
pub use solve::certified::maximum::{
    Certificate, CertifiedMaximum, EndPoint, Maximand, certified_maximum,
};
pub use solve::certified::roots::{
    CertifiedRoot, CertifiedRoots, IntervalFunction, certified_roots,
};
pub use solve::certified::stationary_point::{VectorFunction, certified_stationary_point};
pub(crate) use solve::conjugate_gradients::conjugate_gradients;
pub(crate) use solve::gmres::gmres;
pub use solve::maximum::{Maximum, maximum, maximum_of_many};
pub(crate) use solve::maximum::{is_higher, maximum_by_derivatives};
pub use solve::root::{Root, root};
pub(crate) use sums::compensated_sum::CompensatedSum;
pub use sums::compensated_sum::compensated_sum;
#[doc(hidden)]
pub use sums::expansion::Expansion;
pub(crate) use sums::expansion::two_sum;
pub use symmetric::Symmetric;
pub(crate) use symmetric::{entries_of, row_blocks};
pub(crate) use vectorised::{LANES, Lanes, across, vector_value, vectorised};
