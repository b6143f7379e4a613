//! Form factors past polygons that stand in the way.

mod laws;
mod points;
mod reference_values;
mod slits;
