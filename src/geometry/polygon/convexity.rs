//! Convex outlines and convex hulls in a plane.

use glam::{DVec2, DVec3};

/// Tells whether an outline never turns right, but for a slack.
///
/// **Arguments** `corners`: counter-clockwise about the unit `normal`; `slack`: the largest sine of
/// a right turn that counts as none. A star-shaped outline that goes round more than once passes,
/// too.
#[inline(always)]
pub(crate) fn is_convex(corners: &[DVec3], normal: DVec3, slack: f64) -> bool {
    let n = corners.len();
    (0..n).all(|i| {
        let [a, b, c] = [i, i + 1, i + 2].map(|k| corners[k % n]);
        let (into, out) = (b - a, c - b);
        let turn = into.cross(out).dot(normal);
        turn >= 0.0 || (slack > 0.0 && turn >= -slack * into.length() * out.length())
    })
}

/// The corners of the convex hull of points in a plane, counter-clockwise about its normal.
///
/// **Arguments** `normal`: a unit vector; `flat`: corners nearer than this to the line through
/// their neighbours are left out.
#[must_use]
pub fn convex_hull(mut points: Vec<DVec3>, normal: DVec3, flat: f64) -> Vec<DVec3> {
    let across = normal.any_orthonormal_vector();
    let up = normal.cross(across);
    let place = |point: &DVec3| DVec2::new(across.dot(*point), up.dot(*point));
    points.sort_by(|a, b| {
        let (a, b) = (place(a), place(b));
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    });
    let chain = |points: &mut dyn Iterator<Item = &DVec3>| {
        let mut kept: Vec<DVec3> = Vec::new();
        for point in points {
            while let [.., before, last] = kept.as_slice() {
                let (start, turn) = (place(before), place(last));
                let end = place(point);
                let length = (end - start).length();
                if (end - start).perp_dot(turn - start) <= -flat * length {
                    break;
                }
                kept.pop();
            }
            kept.push(*point);
        }
        kept
    };
    let mut lower = chain(&mut points.iter());
    let mut upper = chain(&mut points.iter().rev());
    lower.pop();
    upper.pop();
    lower.append(&mut upper);
    lower
}
