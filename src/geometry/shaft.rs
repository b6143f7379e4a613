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
//! **The test.** Two convex bodies C and K penetrate each other by
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
//!
//! Reference: Gilbert, Johnson, "Distance functions and their application to robot path planning in
//! the presence of obstacles", *IEEE Journal of Robotics and Automation* 1 (1985), 21–30, for the
//! difference body.

use super::Patch;
use crate::geometry::polygon::clip::clipped;
use crate::geometry::polygon::convex_pieces::convex_pieces;
use glam::DVec3;

/// A plane with a front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Unit normal, towards the front.
    pub normal: DVec3,
    /// A point of the plane.
    pub origin: DVec3,
    /// The slope over the exact plane that cannot be excluded; 0 where corners are exact.
    pub tilt: f64,
}

impl Plane {
    /// The plane through a point with this unit normal.
    #[must_use]
    pub const fn new(normal: DVec3, origin: DVec3) -> Self {
        Self {
            normal,
            origin,
            tilt: 0.0,
        }
    }

    /// Height of a point over the plane, positive in front.
    #[must_use]
    pub fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal)
    }

    /// Height of a point over the plane as far as it is sure: nearer to 0 by what the tilt leaves
    /// open.
    #[must_use]
    pub fn sure_height(&self, point: DVec3) -> f64 {
        let height = self.height(point);
        if self.tilt <= 0.0 {
            return height;
        }
        let open = self.tilt * point.distance(self.origin);
        height.signum() * (height.abs() - open).max(0.0)
    }

    /// The plane with its front on the other side.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            normal: -self.normal,
            ..*self
        }
    }
}

/// A patch as convex pieces in a plane, its coordinates divided by a common unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    corners: Vec<DVec3>,
    pieces: Vec<Vec<DVec3>>,
    plane: Plane,
    bounds: [DVec3; 2],
}

impl Outline {
    /// The patch in units of `unit`, in the plane given (in these units, facing as the patch does).
    ///
    /// **Arguments** `unit`: a power of two near the largest coordinate, so that products neither
    /// over- nor underflow.
    #[must_use]
    pub fn new(patch: &Patch, unit: f64, plane: Plane) -> Self {
        let corners: Vec<DVec3> = patch.corners().iter().map(|c| *c / unit).collect();
        let bounds = [
            corners.iter().copied().fold(DVec3::INFINITY, DVec3::min),
            corners
                .iter()
                .copied()
                .fold(DVec3::NEG_INFINITY, DVec3::max),
        ];
        Self {
            pieces: convex_pieces(&corners, patch.normal()),
            corners,
            plane,
            bounds,
        }
    }

    /// The corners of the patch, in its order.
    #[must_use]
    pub fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// Convex polygons without overlap that make up the patch.
    #[must_use]
    pub fn pieces(&self) -> &[Vec<DVec3>] {
        &self.pieces
    }

    /// The plane it lies in.
    #[must_use]
    pub const fn plane(&self) -> &Plane {
        &self.plane
    }

    /// The smallest and the largest coordinates.
    #[must_use]
    pub const fn bounds(&self) -> &[DVec3; 2] {
        &self.bounds
    }

    /// Tells whether a corner rises above a plane by more than `noise`.
    #[must_use]
    pub fn rises_above(&self, plane: &Plane, noise: f64) -> bool {
        self.pieces
            .iter()
            .flatten()
            .any(|corner| plane.sure_height(*corner) > noise)
    }

    /// The pieces' parts in front of a plane; pieces that do not rise above it by more than `noise`
    /// are left out.
    fn above(&self, plane: &Plane, noise: f64) -> Vec<Vec<DVec3>> {
        let pieces = self.pieces.iter();
        pieces
            .filter_map(|piece| above(piece, plane, noise))
            .collect()
    }

    /// Tells whether two patches that lie in one plane overlap, by more than `noise` in every
    /// direction of the plane.
    #[must_use]
    pub fn overlaps(&self, other: &Self, noise: f64) -> bool {
        let normal = self.plane.normal;
        let pieces = self.pieces.iter();
        let mut pairs = pieces.flat_map(|own| other.pieces.iter().map(move |its| (own, its)));
        pairs.any(|(own, its)| {
            let sides = edges(own).chain(edges(its));
            let mut directions = sides.map(|edge| edge.cross(normal));
            !directions.any(|direction| parts(direction, own, &[], its, noise))
        })
    }
}

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
            first.rises_above(&second.plane, noise) && second.rises_above(&first.plane, noise);
        rises.then(|| Self {
            ends: [
                first.above(&second.plane, noise),
                second.above(&first.plane, noise),
            ],
            normals: [first.plane.normal, second.plane.normal],
            noise,
        })
    }

    /// The smallest and the largest coordinates.
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        let corners = || self.ends.iter().flatten().flatten().copied();
        [
            corners().fold(DVec3::INFINITY, DVec3::min),
            corners().fold(DVec3::NEG_INFINITY, DVec3::max),
        ]
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
        third.pieces.iter().any(|piece| {
            ends().any(|(a, b)| {
                if is_pierced(a, b, piece, &third.plane, self.noise) {
                    return true;
                }
                let planes = [third.plane.normal, self.normals[0], self.normals[1]];
                !directions(a, b, piece, planes).any(|n| parts(n, a, b, piece, self.noise))
            })
        })
    }
}

/// Tells whether a plane parts a convex polygon `k` from the hull of `a` and `b`, with a gap of
/// more than `gap`.
///
/// **Arguments** `normals`: of the planes of `k`, `a` and `b`.
pub(crate) fn are_apart([a, b]: [&[DVec3]; 2], k: &[DVec3], normals: [DVec3; 3], gap: f64) -> bool {
    directions(a, b, k, normals).any(|direction| parts(direction, a, b, k, -gap))
}

/// The part of a convex polygon in front of a plane; `None` if it does not rise above it by more
/// than `noise`.
fn above(piece: &[DVec3], plane: &Plane, noise: f64) -> Option<Vec<DVec3>> {
    let heights = piece.iter().map(|corner| plane.sure_height(*corner));
    let heights: Vec<f64> = heights.collect();
    if !heights.iter().any(|height| *height > noise) {
        return None;
    }
    // what dips no deeper than noise is left alone: cutting it would only add roundings
    if !heights.iter().any(|height| *height < -noise) {
        return Some(piece.to_vec());
    }
    Some(clipped(piece, &heights, DVec3::lerp))
}

fn edges(polygon: &[DVec3]) -> impl Iterator<Item = DVec3> + Clone {
    let n = polygon.len();
    (0..n).map(move |i| polygon[(i + 1) % n] - polygon[i])
}

/// The directions in which the depth of `k` in the hull of `a ∪ b` can be smallest, the likely ones
/// first: the normals of the three planes; of the planes through an edge of `a` or `b` and a corner
/// of the other; the cross products of the edges of `k` with the edges of the hull, which are edges
/// of `a`, of `b`, or run from one to the other.
fn directions<'a>(
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
fn is_pierced(a: &[DVec3], b: &[DVec3], k: &[DVec3], plane: &Plane, noise: f64) -> bool {
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
const SHORTEST_VECTOR: f64 = 1e-150;

/// Tells whether a plane across `direction`, on either side, parts `k` from `a ∪ b`, but for
/// `noise`.
fn parts(direction: DVec3, a: &[DVec3], b: &[DVec3], k: &[DVec3], noise: f64) -> bool {
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
