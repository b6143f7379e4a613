//! Polygons that may stand in the way.

use crate::form_factor::Polygon;
use crate::geometry::bounds;

/// The polygons that may stand between two others, each blocking from both sides.
#[derive(Debug, Clone, Copy)]
pub struct Occluders<'a> {
    /// The polygons, in any order; those that take nothing away cost time only.
    pub polygons: &'a [&'a Polygon],
    /// The distance up to which corners, edges and planes count as meeting; 0 leaves rounding
    /// alone.
    pub touching: f64,
}

impl<'a> Occluders<'a> {
    /// The occluders that reach into the box around two polygons.
    pub(super) fn near(&self, ends: [&Polygon; 2]) -> impl Iterator<Item = &'a Polygon> {
        let corners = ends.iter().flat_map(|end| &end.shape.corners);
        let [low, high] = bounds(corners.copied());
        let reach = low.abs().max(high.abs()).max_element();
        let margin = self.touching.max(64.0 * f64::EPSILON * reach);
        let polygons = self.polygons.iter().copied();
        polygons.filter(move |polygon| {
            let [least, most] = bounds(polygon.shape.corners.iter().copied());
            (most + margin).cmpge(low).all() && (least - margin).cmple(high).all()
        })
    }
}
