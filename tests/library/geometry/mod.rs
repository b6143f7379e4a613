//! Planes and outlines.

mod sides;
