//! Rules of integration.

pub(crate) mod gauss_legendre;
pub(crate) mod tanh_sinh;
