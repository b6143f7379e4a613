//! Planes that part a convex polygon from the hull of two others, and segments that pierce it.
//!
//! Two convex bodies C and K penetrate each other by
//!
//! ```text
//!   depth(C, K) = min over unit vectors n of  max_K n·x − min_C n·x
//! ```
//!
//! the length of the shortest shift that parts them; it is ≤ 0 if and only if a plane parts them.
//! The minimum is attained at a face of the difference body: at the normal of a face of C or of K,
//! or at the cross product of an edge of C and an edge of K. All of them are tried.
//!
//! A segment from a corner of i⁺ to one of j⁺ that pierces K inside settles most bodies that do
//! penetrate. If it meets K at `m` from K's boundary, with its ends at heights of `h` at least over
//! K's plane, at a distance of `L`, then for n with a part b in K's plane
//!
//! ```text
//!   max_K n·x − min_C n·x  ≥  b m + max(0, √(1 − b²) h − b L)  ≥  min(h/2, m h/4L)
//! ```
//!
//! Reference: Gilbert, Johnson, "Distance functions and their application to robot path planning in
//! the presence of obstacles", *IEEE Journal of Robotics and Automation* 1 (1985), 21–30, for the
//! difference body.

use crate::geometry::Plane;
use glam::DVec3;

/// Tells whether a plane parts a convex polygon `k` from the hull of `a` and `b`, with a gap of
/// more than `gap`.
///
/// **Arguments** `normals`: of the planes of `k`, `a` and `b`.
pub(crate) fn are_apart([a, b]: [&[DVec3]; 2], k: &[DVec3], normals: [DVec3; 3], gap: f64) -> bool {
    directions(a, b, k, normals).any(|direction| parts(direction, a, b, k, -gap))
}

/// The edges of a polygon, from each corner to the next.
pub(super) fn edges(polygon: &[DVec3]) -> impl Iterator<Item = DVec3> + Clone {
    let n = polygon.len();
    (0..n).map(move |i| polygon[(i + 1) % n] - polygon[i])
}

/// The directions in which the depth of `k` in the hull of `a ∪ b` can be smallest, the likely ones
/// first: the normals of the three planes; of the planes through an edge of `a` or `b` and a corner
/// of the other; the cross products of the edges of `k` with the edges of the hull, which are edges
/// of `a`, of `b`, or run from one to the other.
pub(super) fn directions<'a>(
    a: &'a [DVec3],
    b: &'a [DVec3],
    k: &'a [DVec3],
    planes: [DVec3; 3],
) -> impl Iterator<Item = DVec3> + 'a {
    let sides = |edged: &'a [DVec3], other: &'a [DVec3]| {
        edged
            .iter()
            .zip(edges(edged))
            .flat_map(move |(corner, edge)| {
                other.iter().map(move |apex| edge.cross(*apex - *corner))
            })
    };
    let across = a
        .iter()
        .flat_map(move |from| b.iter().map(move |to| *to - *from));
    let rims = edges(a).chain(edges(b)).chain(across);
    let crossed = rims.flat_map(move |rim| edges(k).map(move |edge| edge.cross(rim)));
    planes
        .into_iter()
        .chain(sides(a, b))
        .chain(sides(b, a))
        .chain(crossed)
}

/// Tells whether a segment from a corner of `a` to one of `b` is sure to pierce `k` by more than
/// `noise`.
pub(super) fn is_pierced(a: &[DVec3], b: &[DVec3], k: &[DVec3], plane: &Plane, noise: f64) -> bool {
    let sides = || k.iter().zip(edges(k));
    a.iter().any(|from| {
        let above = plane.height(*from);
        b.iter().any(|to| {
            let below = plane.height(*to);
            let height = above.abs().min(below.abs());
            if above * below >= 0.0 || height <= 2.0 * noise {
                return false;
            }
            let met = from.lerp(*to, above / (above - below));
            let slope = height / (4.0 * from.distance(*to));
            sides().all(|(corner, edge)| {
                // whichever way k runs around, its plane faces one
                let inward = plane.normal.cross(edge);
                (met - *corner).dot(inward) * slope > noise * inward.length()
            })
        })
    })
}

/// Shortest vector whose length is not lost in the underflow of its square.
pub(super) const SHORTEST_VECTOR: f64 = 1e-150;

/// Tells whether a plane across `direction`, on either side, parts `k` from `a ∪ b`, but for
/// `noise`.
pub(super) fn parts(direction: DVec3, a: &[DVec3], b: &[DVec3], k: &[DVec3], noise: f64) -> bool {
    let length = direction.length();
    // parallel, or edges below 1e-75 of the unit: no direction
    if length < SHORTEST_VECTOR {
        return false;
    }
    let origin = k[0];
    let normal = direction / length;
    let range = |points: &mut dyn Iterator<Item = &DVec3>| {
        points
            .map(|point| (*point - origin).dot(normal))
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| {
                [low.min(height), high.max(height)]
            })
    };
    let [low, high] = range(&mut a.iter().chain(b));
    let [lowest, highest] = range(&mut k.iter());
    highest - low <= noise || high - lowest <= noise
}
