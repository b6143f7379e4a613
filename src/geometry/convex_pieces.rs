//! A simple polygon cut into convex ones.
//!
//! A convex polygon stays whole up to [`LARGEST_PIECE`] corners; beyond that it is cut into fans. A concave one is cut
//! into triangles by its ears: corners whose triangle contains no other corner. A simple polygon with more than three
//! corners has two of them (Meisters 1975).
//!
//! Turns are decided exactly, on two of the three coordinates as they are: the axis nearest to the normal is
//! dropped. The pieces have no corners but the polygon's own, so that nothing is rounded.
//!
//! Reference: Meisters, "Polygons have ears", *American Mathematical Monthly* 82 (1975), 648–651.

use glam::{DVec2, DVec3};
use robust::{Coord, orient2d};

/// Corners of the largest piece: separating directions are counted by the cube of it.
const LARGEST_PIECE: usize = 8;

/// Convex polygons that cover the simple polygon with these corners and this normal, without overlap.
///
/// Should no ear be found, because a polygon that is plane to within its tolerance only is not simple when an axis is
/// dropped, the rest is handed back as one piece, to be taken as its convex hull.
pub(super) fn convex_pieces(corners: &[DVec3], normal: DVec3) -> Vec<Vec<DVec3>> {
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
    let mut rest: Vec<(DVec3, DVec2)> = corners.iter().map(|c| (*c, flat(*c))).collect();
    let mut pieces = Vec::new();
    while !is_convex(&rest) {
        let n = rest.len();
        let Some(ear) = (0..n).find(|i| is_ear(&rest, *i)) else {
            pieces.push(rest.into_iter().map(|(corner, _)| corner).collect());
            return pieces;
        };
        let ends = [(ear + n - 1) % n, ear, (ear + 1) % n];
        let [before, at, after] = ends.map(|i| rest[i].1);
        if turn(before, at, after) > 0.0 {
            pieces.push(ends.map(|i| rest[i].0).to_vec());
        }
        rest.remove(ear);
    }
    let rest: Vec<DVec3> = rest.into_iter().map(|(corner, _)| corner).collect();
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
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| Coord { x: p.x, y: p.y });
    orient2d(a, b, c)
}

/// A simple polygon is convex if it never turns right.
fn is_convex(rest: &[(DVec3, DVec2)]) -> bool {
    let n = rest.len();
    n <= 3 || (0..n).all(|i| turn(rest[i].1, rest[(i + 1) % n].1, rest[(i + 2) % n].1) >= 0.0)
}

/// Can this corner be cut off: does its triangle contain no other corner? A corner at which nothing turns can.
fn is_ear(rest: &[(DVec3, DVec2)], corner: usize) -> bool {
    let n = rest.len();
    let ends = [(corner + n - 1) % n, corner, (corner + 1) % n];
    let [a, b, c] = ends.map(|i| rest[i].1);
    let opening = turn(a, b, c);
    if opening <= 0.0 {
        return opening >= 0.0;
    }
    (0..n).filter(|i| !ends.contains(i)).all(|i| {
        let p = rest[i].1;
        turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0
    })
}
