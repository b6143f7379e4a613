//! The part of a polygon on one side of a plane or line.
//!
//! ```text
//!   corner i stays if h_i ≥ 0
//!   an edge with ends on both sides is cut at x_i + (x_j − x_i) h_i/(h_i − h_j)
//! ```
//!
//! Heights may be signed distances over a plane, positions along a line, or anything that is linear
//! along an edge. The caller decides which corners count as on the plane, and gives them a height
//! of 0: no edge is cut at such a corner.
//!
//! **Not covered**: coincident corners, which the caller removes; a concave polygon that falls
//! apart, whose parts stay joined by edges that coincide.
//!
//! Reference: Sutherland, Hodgman, "Reentrant polygon clipping", *Communications of the ACM* 17
//! (1974), 32–42.

use crate::numeric::Scalar;

/// A corner of a clipped polygon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ClippedCorner<S> {
    /// The corner with this index, which the clip keeps.
    Kept(usize),
    /// A new corner where an edge crosses the plane.
    Crossing {
        /// The ends of the edge.
        edge: [usize; 2],
        /// The position on the edge: 0 at its start, 1 at its end.
        share: S,
    },
}

/// Visits the corners of the part with heights ≥ 0, in order.
///
/// **Arguments** `heights`: one for each corner; 0 for those that count as on the plane.
#[inline(always)]
pub(crate) fn clip<S: Scalar>(heights: &[S], mut visit: impl FnMut(ClippedCorner<S>)) {
    let n = heights.len();
    for i in 0..n {
        let j = (i + 1) % n;
        let (from, to) = (&heights[i], &heights[j]);
        let zero = from.zero();
        if *from >= zero {
            visit(ClippedCorner::Kept(i));
        }
        if (*from > zero && *to < zero) || (*from < zero && *to > zero) {
            visit(ClippedCorner::Crossing {
                edge: [i, j],
                share: from.clone() / (from.clone() - to),
            });
        }
    }
}

/// Returns the corners of the part with heights ≥ 0, in order.
///
/// **Arguments** `heights`: as for [`clip`]; `between`: the point at a share of the way from one
/// corner to the next.
#[inline(always)]
pub(crate) fn clipped<P: Copy, S: Scalar>(
    corners: &[P],
    heights: &[S],
    between: impl Fn(P, P, S) -> P,
) -> Vec<P> {
    debug_assert_eq!(corners.len(), heights.len());
    let mut part = Vec::with_capacity(corners.len() + 2);
    clip(heights, |corner| {
        part.push(match corner {
            ClippedCorner::Kept(i) => corners[i],
            ClippedCorner::Crossing { edge, share } => {
                let [from, to] = edge.map(|k| corners[k]);
                between(from, to, share)
            }
        });
    });
    part
}
