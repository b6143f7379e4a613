//! Regions of P that see a point past screens: their boundaries, and how long those keep their
//! shape.

pub(crate) mod arrangement;
pub(crate) mod boundary;
pub(crate) mod chord;
pub(crate) mod convex;
pub(crate) mod covers;
pub(crate) mod slice;
pub(crate) mod validity;
