//! Integrals along stretches of edges, by rules over each shape, with what the bounds are made of.

pub(crate) mod bound;
pub(crate) mod corner;
pub(crate) mod gap;
pub(crate) mod reach;
pub(crate) mod rule;
pub(crate) mod share;
pub(crate) mod slack;
pub(crate) mod stretch;
