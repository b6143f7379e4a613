//! The solid between two patches, and whether a third one enters it.
//!
//! ```text
//!   i⁺  = the part of i in front of j's plane,  j⁺ = the part of j in front of i's plane
//!   S   = interior of the union of all segments from i⁺ to j⁺
//! ```
//!
//! `k` takes something from what i and j exchange if and only if it meets `S`. For convex i and j
//! `S` is the interior of the convex hull of `i⁺ ∪ j⁺`; a point of k in it lies on a segment
//! between inner points of both, and so do all points nearby, so that pairs of points of positive
//! measure do not see each other. If k meets the hull's boundary only, they have measure zero.
//! Concave polygons are taken as their convex pieces.
//!
//! **The test.** A k enters S if and only if no plane parts them; `parting` derives how deep it is
//! in S.
//!
//! **Noise.** If every corner is off by at most δ, the depth is off by at most 2δ, however small
//! the patches are and however far apart. So a k whose depth is at most the `noise` given counts as
//! touching, and this is the only tolerance. Directions that are not quite the minimising one only
//! make the depth found too large, by rounding errors of a few ε of the coordinates; noise is meant
//! to be chosen above them. What is guaranteed:
//!
//! * a k that enters S by more than `noise` (and rounding errors) is found;
//! * a k that would not enter S if every corner were moved by less than half of what `noise` leaves
//!   above rounding errors is not.
//!
//! A patch that rises over the other one's plane by no more than `noise` counts as lying in it; a
//! shaft that is thinner than `noise` cannot be entered.

mod outline;
mod parting;

use self::parting::{SHORTEST_VECTOR, directions, edges, is_pierced, parts};
use super::Plane;
use crate::geometry::bounds;
use crate::geometry::polygon::clip::clipped;
use glam::DVec3;

pub use outline::Outline;
pub(crate) use parting::are_apart;

/// The solid between two patches that exchange something.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    ends: [Vec<Vec<DVec3>>; 2],
    normals: [DVec3; 2],
    noise: f64,
}

impl Shaft {
    /// The shaft between two patches; `None` if they exchange nothing: no part of one is in front
    /// of the other's plane by more than `noise`, or the other way round.
    #[must_use]
    pub fn between(first: &Outline, second: &Outline, noise: f64) -> Option<Self> {
        let rises =
            first.rises_above(second.plane(), noise) && second.rises_above(first.plane(), noise);
        rises.then(|| Self {
            ends: [
                first.above(second.plane(), noise),
                second.above(first.plane(), noise),
            ],
            normals: [first.plane().normal, second.plane().normal],
            noise,
        })
    }

    /// The smallest and the largest coordinates.
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        bounds(self.ends.iter().flatten().flatten().copied())
    }

    /// The corners of the two ends, `i⁺` and `j⁺`.
    #[must_use]
    pub fn corners(&self) -> [Vec<DVec3>; 2] {
        let corners = |end: &Vec<Vec<DVec3>>| end.iter().flatten().copied().collect();
        self.ends.each_ref().map(corners)
    }

    /// The part of a convex polygon in the shaft, but for what is beyond it by `noise` or where the
    /// ends are not convex; the part is empty, or none that has an area, if the polygon passes the
    /// shaft.
    #[must_use]
    pub(crate) fn part_of(&self, piece: &[DVec3]) -> Vec<DVec3> {
        let mut part = piece.to_vec();
        let ([first], [second]) = (&self.ends[0][..], &self.ends[1][..]) else {
            return part;
        };
        let corners = || first.iter().chain(second);
        for (edged, other) in [(first, second), (second, first)] {
            let sides = edged.iter().zip(edges(edged));
            let sides =
                sides.flat_map(|(from, edge)| other.iter().map(move |apex| (from, edge, apex)));
            for (from, edge, apex) in sides {
                let normal = edge.cross(*apex - *from);
                let length = normal.length();
                if length < SHORTEST_VECTOR {
                    continue;
                }
                let plane = Plane::new(normal / length, *from);
                let is_beyond = |plane: &Plane| corners().all(|c| plane.height(*c) <= self.noise);
                let outward = [plane, plane.reversed()].into_iter().find(is_beyond);
                let Some(outward) = outward else {
                    continue;
                };
                let depth = |corner: &DVec3| self.noise - outward.height(*corner);
                let depths: Vec<f64> = part.iter().map(depth).collect();
                if depths.iter().any(|depth| *depth < 0.0) {
                    part = clipped(&part, &depths, DVec3::lerp);
                }
            }
        }
        part
    }

    /// Tells whether a third patch enters the shaft by more than `noise`.
    #[must_use]
    pub fn is_entered_by(&self, third: &Outline) -> bool {
        let [first, second] = &self.ends;
        let ends = || {
            first
                .iter()
                .flat_map(|a| second.iter().map(move |b| (a, b)))
        };
        third.pieces().iter().any(|piece| {
            ends().any(|(a, b)| {
                if is_pierced(a, b, piece, third.plane(), self.noise) {
                    return true;
                }
                let planes = [third.plane().normal, self.normals[0], self.normals[1]];
                !directions(a, b, piece, planes).any(|n| parts(n, a, b, piece, self.noise))
            })
        })
    }
}
