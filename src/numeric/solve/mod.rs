//! Roots and maxima: guarded in `f64`, certified in intervals.
//!
//! `gmres` solves linear systems that are known by their products, `conjugate_gradients` symmetric
//! ones. `root` and `maximum` find one in `f64` and tell how well the equation is satisfied there;
//! they are fast and prove nothing. `certified` finds all roots, the highest maximum, or a
//! stationary point in several variables, and proves it by interval arithmetic.

pub(crate) mod certified;
pub(crate) mod conjugate_gradients;
pub(crate) mod gmres;
pub(crate) mod maximum;
pub(crate) mod root;
