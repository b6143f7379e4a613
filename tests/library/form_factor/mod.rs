//! Form factors and exchange areas of two polygons: laws, independent values, bounds.

mod additivity;
mod agreement;
mod enclosures;
mod error_bounds;
mod extreme_polygons;
mod far_rectangles;
mod independent_roads;
mod occlusion;
mod point_gradients;
mod polygon_invariance;
mod reciprocity;
mod rectangle_invariance;
mod reference_values;
mod refusals;
mod rungs;
mod sampling;
