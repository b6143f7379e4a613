//! The numbers everything else is written in.
//!
//! Each formula of this crate is written once, over [`Scalar`]: `f64` gives the
//! fast value, [`Interval`] an enclosure of the exact one, [`Dual`] the derivative with it. Beside it stand
//! the entropy kernels (`0·log 0 = 0` lives there and nowhere else), exact and
//! compensated sums, roots and maxima (guarded in `f64`, [certified](certified_maximum) over intervals),
//! guarded quadrature, and the one table of tolerances.
//!
//! **Not here**: geometry, and anything that knows what a form factor is.

mod certified;
mod compensated_sum;
mod digamma;
mod dilogarithm;
mod double_double;
mod dual;
pub mod elementary;
mod entropy_kernel;
mod error;
mod evidence;
mod expansion;
mod extremes;
mod gauss_legendre;
pub mod interval;
mod maximum;
mod parallel;
mod quadrature;
mod root;
mod scalar;
mod scaled;
mod symmetric;
pub mod tolerance;
mod unit;
mod vectorised;
pub mod wide;

pub use certified::{
    Certificate, CertifiedMaximum, CertifiedRoot, CertifiedRoots, EndPoint, IntervalFunction,
    Maximand, VectorFunction, certified_maximum, certified_roots, certified_stationary_point,
};
pub use compensated_sum::{CompensatedSum, compensated_sum};
pub use digamma::digamma;
pub use dilogarithm::{dilogarithm_deficit, dilogarithm_of_complement, imaginary_dilogarithm};
pub use double_double::{DoubleDouble, SQUARED_EPSILON};
pub use dual::Dual;
pub use entropy_kernel::{divergence_kernel, x_ln_x, x_log2_ratio, x_log2_x};
pub use error::NumericError;
pub use evidence::{Bounded, Grade};
pub use expansion::Expansion;
pub(crate) use expansion::two_sum;
pub use extremes::{larger, largest, smaller};
pub use gauss_legendre::{GaussLegendre, MOST_POINTS};
pub(crate) use gauss_legendre::{NodeNumber, legendre_node};
pub use interval::{Interval, Precise};
pub use maximum::{Maximum, maximum, maximum_by_derivatives, maximum_of_many};
pub(crate) use parallel::{parallel_map, try_parallel_map};
pub use quadrature::{Integral, integral};
pub use root::{Root, root};
pub use scalar::Scalar;
pub use scaled::{Scaled, common_scale};
pub use symmetric::Symmetric;
pub use unit::{power_of_two_below, power_of_two_near};
pub(crate) use vectorised::vector_value;
pub use vectorised::{LANES, Lanes, across, vectorised};
