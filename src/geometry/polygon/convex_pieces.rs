//! A simple polygon cut into convex ones.
//!
//! A convex polygon stays whole up to [`LARGEST_PIECE`] corners; beyond that it is cut into fans.
//! Of a concave one [ears](super::ears) are cut off until the rest is convex.
//!
//! Turns are decided exactly, on two of the three coordinates as they are: the axis nearest to the
//! normal is dropped. The pieces have no corners but the polygon's own, so that nothing is rounded.

use super::ears::EarClipper;
use glam::{DVec2, DVec3};
use robust::{Coord, orient2d};

/// Corners of the largest piece: separating directions are counted by the cube of it.
const LARGEST_PIECE: usize = 8;

/// Convex polygons that cover the simple polygon with these corners and this normal, without
/// overlap.
///
/// Should no ear be found, because a polygon that is plane to within its tolerance only is not
/// simple when an axis is dropped, the rest is handed back as one piece, to be taken as its convex
/// hull.
pub(crate) fn convex_pieces(corners: &[DVec3], normal: DVec3) -> Vec<Vec<DVec3>> {
    let size = normal.abs();
    let flat = |c: DVec3| {
        if size.z >= size.x && size.z >= size.y {
            DVec2::new(c.x, c.y * normal.z.signum())
        } else if size.x >= size.y {
            DVec2::new(c.y, c.z * normal.x.signum())
        } else {
            DVec2::new(c.z, c.x * normal.y.signum())
        }
    };
    let flattened: Vec<DVec2> = corners.iter().map(|c| flat(*c)).collect();
    let mut clipper = EarClipper::new(&flattened, exact_turn);
    let of = |indices: &[usize]| -> Vec<DVec3> { indices.iter().map(|i| corners[*i]).collect() };
    let mut pieces = Vec::new();
    while !clipper.is_convex() {
        // a corner at which nothing turns is cut off, too, and leaves no piece
        let turns_at = |place: &usize| clipper.turn(*place) != 0.0;
        let mut places = 0..clipper.left().len();
        let Some(place) = places.find(|place| !turns_at(place) || clipper.is_ear(*place)) else {
            pieces.push(of(clipper.left()));
            return pieces;
        };
        let is_piece = turns_at(&place);
        let triangle = clipper.cut(place);
        if is_piece {
            pieces.push(of(&triangle));
        }
    }
    let rest = of(clipper.left());
    let mut start = 1;
    while start + 1 < rest.len() {
        let end = rest.len().min(start + LARGEST_PIECE - 1);
        let mut piece = vec![rest[0]];
        piece.extend_from_slice(&rest[start..end]);
        pieces.push(piece);
        start = end - 1;
    }
    pieces
}

/// Twice the area of a triangle, positive if it runs counter-clockwise; its sign is exact.
fn exact_turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| Coord { x: p.x, y: p.y });
    orient2d(a, b, c)
}
