//! Planes and outlines.

mod flat_boxes;
mod outlines;
mod rectangles;
