//! Polygons that may stand in the way.

use crate::form_factor::Polygon;

/// The polygons that may stand between two others, each blocking from both sides.
#[derive(Debug, Clone, Copy)]
pub struct Occluders<'a> {
    /// The polygons, in any order; those that take nothing away cost time only.
    pub polygons: &'a [&'a Polygon],
    /// The distance up to which corners, edges and planes count as meeting; 0 leaves rounding
    /// alone.
    pub touching: f64,
}
