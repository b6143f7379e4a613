//! Planes and outlines.

mod centroids;
mod flat_boxes;
mod outlines;
mod rectangles;
