//! Triangles that make up a simple polygon, by cutting off ears.
//!
//! An ear is a corner that turns left and whose triangle holds no other corner. A simple polygon has two (Meisters,
//! 1975); of the ears the fattest is cut, so that no more slivers arise than must.
//!
//! **Not covered**: speed beyond some hundred corners (the work grows with their cube).

use glam::DVec3;

/// Triangles of corner indices, counter-clockwise as the polygon is; `corners − 2` of them.
///
/// **Arguments** the corners of a simple polygon in a plane with unit normal `normal`, counter-clockwise.
#[must_use]
pub fn triangulated(corners: &[DVec3], normal: DVec3) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let mut triangles = Vec::with_capacity(corners.len().saturating_sub(2));
    while left.len() > 3 {
        let n = left.len();
        let at = |i: usize| [left[(i + n - 1) % n], left[i % n], left[(i + 1) % n]];
        let ears = (0..n).filter(|i| is_ear(corners, normal, at(*i), &left));
        // none only if rounding hides them all: any left turn will do then
        let best = ears
            .max_by(|i, j| fatness(corners, at(*i)).total_cmp(&fatness(corners, at(*j))))
            .or_else(|| (0..n).find(|i| turn(corners, normal, at(*i)) > 0.0))
            .unwrap_or(0);
        triangles.push(at(best));
        left.remove(best);
    }
    triangles.extend(<[usize; 3]>::try_from(left));
    triangles
}

/// Twice the signed area of a triangle.
fn turn(corners: &[DVec3], normal: DVec3, [a, b, c]: [usize; 3]) -> f64 {
    let (a, b, c) = (corners[a], corners[b], corners[c]);
    (b - a).cross(c - b).dot(normal)
}

/// Area over squared perimeter.
fn fatness(corners: &[DVec3], [a, b, c]: [usize; 3]) -> f64 {
    let (a, b, c) = (corners[a], corners[b], corners[c]);
    let perimeter = a.distance(b) + b.distance(c) + c.distance(a);
    (b - a).cross(c - a).length() / (perimeter * perimeter)
}

fn is_ear(corners: &[DVec3], normal: DVec3, [a, b, c]: [usize; 3], left: &[usize]) -> bool {
    let inside = |p: &usize| {
        let at_a_corner = [a, b, c].iter().any(|i| corners[*i] == corners[*p]);
        !at_a_corner
            && turn(corners, normal, [a, b, *p]) >= 0.0
            && turn(corners, normal, [b, c, *p]) >= 0.0
            && turn(corners, normal, [c, a, *p]) >= 0.0
    };
    turn(corners, normal, [a, b, c]) > 0.0 && !left.iter().any(inside)
}
