//! Form factors and exchange areas of two polygons: laws, independent values, bounds.

mod additivity;
mod agreement;
mod error_bounds;
mod far_rectangles;
mod independent_roads;
mod outlines;
mod polygon_invariance;
mod reciprocity;
mod rectangle_invariance;
mod reference_values;
mod sampling;
