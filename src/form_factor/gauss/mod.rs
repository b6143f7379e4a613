//! Gauss rules over one polygon of a pair, with closed forms or kernels on the other.

pub(crate) mod kernel;
pub(crate) mod lambert;
pub(crate) mod points;
pub(crate) mod strip;
