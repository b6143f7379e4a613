//! Form factors past polygons that stand in the way.

mod bounds;
mod laws;
mod points;
mod reference_values;
mod slits;
