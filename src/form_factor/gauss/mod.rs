//! Gauss rules over the area of one polygon of a pair, or of both.
//!
//! `points` makes the rules, with an a-priori bound on their truncation; `aspect` has a sharper one
//! for quadrilaterals that are not near. `lambert` takes them over
//! one polygon with Lambert's formula for the other, `kernel` over both; `strip` takes one along a
//! cut line, for the derivative of an exchange area. They need polygons that are apart.

pub(crate) mod aspect;
pub(crate) mod kernel;
pub(crate) mod lambert;
pub(crate) mod points;
pub(crate) mod strip;
