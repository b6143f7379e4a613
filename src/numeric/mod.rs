//! The numbers everything else is written in.
//!
//! Each formula of this crate is written once, over [`Scalar`]: `f64` gives the fast value,
//! [`Interval`] an enclosure of the exact one, [`Dual`] the derivative with it. Beside it stand the
//! entropy kernels (`0·log 0 = 0` lives there and nowhere else), exact and compensated sums, roots
//! and maxima (guarded in `f64`, [certified](certified_maximum) over intervals), guarded
//! quadrature, and the one table of tolerances.
//!
//! **Not here**: geometry, and anything that knows what a form factor is.

mod double_double;
mod dual;
mod error;
mod evidence;
pub mod functions;
mod integrate;
pub mod interval;
mod parallel;
mod scalar;
mod scaled;
mod solve;
mod sums;
mod symmetric;
pub mod tolerance;
mod vectorised;

pub use double_double::{DoubleDouble, SQUARED_EPSILON};
pub use dual::Dual;
pub use error::NumericError;
pub use evidence::{Bounded, Grade};
pub use functions::digamma::digamma;
pub use functions::dilogarithm::{
    dilogarithm_deficit, dilogarithm_of_complement, imaginary_dilogarithm,
};
pub use functions::entropy_kernel::{divergence_kernel, x_ln_x, x_log2_ratio, x_log2_x};
pub use functions::extremes::{larger, largest, smaller};
pub use functions::unit::{power_of_two_below, power_of_two_near};
pub use integrate::gauss_legendre::{GaussLegendre, MOST_POINTS};
pub(crate) use integrate::gauss_legendre::{NodeNumber, legendre_node};
pub use integrate::tanh_sinh::{Integral, integral};
pub use interval::Interval;
pub use interval::precise::Precise;
pub(crate) use parallel::{parallel_map, try_parallel_map};
pub use scalar::Scalar;
pub use scaled::{Scaled, common_scale};
pub use solve::certified::maximum::{
    Certificate, CertifiedMaximum, EndPoint, Maximand, certified_maximum,
};
pub use solve::certified::roots::{
    CertifiedRoot, CertifiedRoots, IntervalFunction, certified_roots,
};
pub use solve::certified::stationary_point::{VectorFunction, certified_stationary_point};
pub use solve::maximum::{Maximum, maximum, maximum_by_derivatives, maximum_of_many};
pub use solve::root::{Root, root};
pub use sums::compensated_sum::{CompensatedSum, compensated_sum};
pub use sums::expansion::Expansion;
pub(crate) use sums::expansion::two_sum;
pub use symmetric::Symmetric;
pub(crate) use vectorised::vector_value;
pub use vectorised::{LANES, Lanes, across, vectorised};
