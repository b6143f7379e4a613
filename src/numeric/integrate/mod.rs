//! Rules of integration.
//!
//! `gauss_legendre` serves integrands that are analytic on the whole interval, with an a-priori
//! bound on the error; `tanh_sinh` those that are singular at its ends, with an estimate of the
//! error.

pub(crate) mod gauss_legendre;
pub(crate) mod tanh_sinh;
