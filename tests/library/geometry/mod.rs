//! Planes and outlines.

mod outlines;
mod rectangles;
mod sides;
