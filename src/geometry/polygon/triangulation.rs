//! Triangles that make up a simple polygon, by cutting off [ears](super::ears).
//!
//! Of the ears the fattest is cut, so that no more slivers arise than must.
//!
//! **Not covered**: speed beyond some hundred corners (the work grows with their cube).

use super::ears::EarClipper;
use super::weakly_simple::FlatOutline;
use crate::geometry::{GeometryError, Patch};
use glam::DVec3;

/// Triangles with an area that make up a polygon; of straight corners only those that they need.
///
/// # Errors
/// The refusal of a triangle that is too small for `f64`.
pub(crate) fn triangles_of(patch: &Patch) -> Result<Vec<Patch>, GeometryError> {
    let corners = patch.corners();
    let patches = |triangles: Vec<[usize; 3]>| {
        let triangles = triangles.into_iter();
        let patches = triangles.map(|triangle| triangle.map(|i| corners[i]).to_vec());
        patches.map(Patch::try_new).collect::<Result<Vec<_>, _>>()
    };
    // an ear may have left nothing but straight corners
    patches(triangulated(corners, patch.normal()))
        .or_else(|_| patches(FlatOutline::of(corners).triangles()))
}

/// Triangles of corner indices, counter-clockwise as the polygon is; `corners − 2` of them.
///
/// **Arguments** the corners of a simple polygon in a plane with unit normal `normal`,
/// counter-clockwise.
#[must_use]
pub(crate) fn triangulated(corners: &[DVec3], normal: DVec3) -> Vec<[usize; 3]> {
    let turn = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - b).dot(normal);
    let mut clipper = EarClipper::new(corners, turn);
    let mut triangles = Vec::with_capacity(corners.len().saturating_sub(2));
    while clipper.left().len() > 3 {
        let fatness = |place: usize| fatness(clipper.triangle(place).map(|i| corners[i]));
        let fattest = clipper
            .ears()
            .max_by(|i, j| fatness(*i).total_cmp(&fatness(*j)));
        // none only if rounding hides them all: any left turn will do then
        let any_left_turn = || (0..clipper.left().len()).find(|place| clipper.turn(*place) > 0.0);
        let place = fattest.or_else(any_left_turn).unwrap_or(0);
        triangles.push(clipper.cut(place));
    }
    triangles.extend(<[usize; 3]>::try_from(clipper.left()));
    triangles
}

/// Area over squared perimeter.
fn fatness([a, b, c]: [DVec3; 3]) -> f64 {
    let perimeter = a.distance(b) + b.distance(c) + c.distance(a);
    (b - a).cross(c - a).length() / (perimeter * perimeter)
}
