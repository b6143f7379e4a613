//! Convex outlines in a plane.

use glam::DVec3;

/// Tells whether an outline never turns right, but for a slack.
///
/// **Arguments** `corners`: counter-clockwise about the unit `normal`; `slack`: the largest sine of
/// a right turn that counts as none. A star-shaped outline that goes round more than once passes,
/// too.
#[inline(always)]
pub(crate) fn is_convex(corners: &[DVec3], normal: DVec3, slack: f64) -> bool {
    debug_assert!(slack >= 0.0, "{slack}");
    let n = corners.len();
    (0..n).all(|i| {
        let [a, b, c] = [i, i + 1, i + 2].map(|k| corners[k % n]);
        let (into, out) = (b - a, c - b);
        let turn = into.cross(out).dot(normal);
        turn >= 0.0 || (slack > 0.0 && turn >= -slack * into.length() * out.length())
    })
}
