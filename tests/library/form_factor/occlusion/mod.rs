//! Form factors past polygons that stand in the way.

mod points;
mod reference_values;
