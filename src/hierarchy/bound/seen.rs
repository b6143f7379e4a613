//! The polygons that the points of a plane see, and their form factors as functions on the plane.
//!
//! A form factor is the sum of its edges' terms ([`Edge`]). For its remainder there is a second
//! *bound*: the kernel `a b/(π r⁴)` of the area has Gegenbauer's polynomials, and with heights a
//! over the plane and b over the polygon's,
//!
//! ```text
//!   |remainder| ≤ (A a_max/(π r⁶)) (20 b/r + 10) d³/(1 − 2 d/r)          r: the least distance
//! ```
//!
//! Whichever is less holds.
//!
//! **Not covered**: as of [`edge`](super::edge).

use super::edge::{Edge, Expanded};
use super::frame::Frame;
use super::jet::Jet;
use super::piece::Piece;
use crate::geometry::{Patch, clipped};
use glam::{DVec2, DVec3};
use smallvec::SmallVec;
use std::f64::consts::PI;

/// The part of a polygon above a plane.
#[derive(Debug, Clone)]
pub(super) struct Seen {
    start: DVec3,
    edges: SmallVec<[Edge; 4]>,
    normal: DVec3,
    area: f64,
    centre: DVec3,
    radius: f64,
    highest: f64,
}

impl Seen {
    /// The part of a shape above a plane, with an outline of more corners than it; heights within
    /// `noise` count as none. `None` if nothing is above.
    pub(super) fn of(shape: &Patch, outline: &[DVec3], frame: &Frame, noise: f64) -> Option<Self> {
        let place = |corner: &DVec3| {
            let mut at = frame.place(*corner);
            if at.z.abs() <= noise {
                at.z = 0.0;
            }
            at
        };
        let corners: Vec<DVec3> = outline.iter().map(place).collect();
        let heights: Vec<f64> = corners.iter().map(|corner| corner.z).collect();
        let highest = heights.iter().copied().fold(0.0, f64::max);
        if highest <= 0.0 {
            return None;
        }
        let mut corners = clipped(&corners, &heights, |a, b, share: f64| {
            (a + (b - a) * share).with_z(0.0)
        });
        corners.dedup();
        let n = corners.len();
        let edge = |i: usize| Edge::new(corners[i], corners[(i + 1) % n]);
        let low = corners.iter().copied().reduce(DVec3::min)?;
        let centre = 0.5 * (low + corners.iter().copied().reduce(DVec3::max)?);
        let radius = corners.iter().map(|corner| corner.distance(centre));
        Some(Self {
            start: *corners.first()?,
            edges: (0..n).filter_map(edge).collect(),
            normal: frame.turned(shape.normal()),
            area: shape.area(),
            centre,
            radius: radius.fold(0.0, f64::max),
            highest,
        })
    }

    /// The height of a point of the plane above the polygon's plane.
    fn height(&self, point: DVec2) -> f64 {
        (point.extend(0.0) - self.start).dot(self.normal)
    }

    /// Whether points of the plane are all in front of the polygon, to within `noise`; none of them
    /// is if that is `Some(false)`.
    pub(super) fn is_before(&self, points: &[DVec2], noise: f64) -> Option<bool> {
        let mut heights = points.iter().map(|point| self.height(*point));
        let is_above = heights.clone().all(|height| height >= -noise);
        let is_below = heights.all(|height| height <= noise);
        match (is_above, is_below) {
            (_, true) => Some(false),
            (true, _) => Some(true),
            _ => None,
        }
    }

    /// The edges.
    pub(super) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The form factor from a point.
    pub(super) fn factor(&self, point: DVec2) -> f64 {
        if self.height(point) <= 0.0 {
            return 0.0;
        }
        self.edges.iter().map(|edge| edge.factor(point)).sum()
    }

    /// The form factor on a piece. Somewhere in its range, if the piece reaches farther than
    /// `noise` through the polygon's plane, near which that is small, or is too near.
    pub(super) fn expanded(&self, piece: &Piece, noise: f64) -> Expanded {
        self.smooth(piece, noise).unwrap_or_else(|| {
            let half = 0.5 * self.most(piece);
            Expanded {
                jet: Jet::constant(half),
                cubic: 0.0,
                flat: half,
            }
        })
    }

    /// The form factor on a piece, all of it before the polygon to within `noise`; `None` if the
    /// polygon is too near, or the piece reaches through its plane.
    fn smooth(&self, piece: &Piece, noise: f64) -> Option<Expanded> {
        let heights = piece.corners.iter().map(|corner| self.height(*corner));
        let (low, high) = heights.fold((f64::MAX, f64::MIN), |(low, high), height| {
            (low.min(height), high.max(height))
        });
        if high <= noise {
            return Some(Expanded::default());
        }
        if low < -noise {
            return None;
        }
        let mut sum = Expanded::default();
        for edge in &self.edges {
            let part = edge.expanded(piece)?;
            sum.jet.add(1.0, &part.jet);
            sum.cubic += part.cubic;
        }
        sum.cubic = sum.cubic.min(self.cubic_of_area(piece));
        Some(sum)
    }

    /// A bound on the form factor on a piece.
    pub(super) fn most(&self, piece: &Piece) -> f64 {
        let centres = piece.centre.extend(0.0).distance(self.centre);
        let distance = centres - self.radius - piece.radius;
        if distance <= 0.0 {
            return 1.0;
        }
        let heights = piece.corners.iter().map(|corner| self.height(*corner));
        let [up, down] =
            [self.highest, heights.fold(0.0, f64::max)].map(|h| (h / distance).min(1.0));
        (self.area * up * down / (PI * distance * distance)).min(1.0)
    }

    /// The bound on the remainder from the kernel over the area; infinite nearby.
    fn cubic_of_area(&self, piece: &Piece) -> f64 {
        let distance = piece.centre.extend(0.0).distance(self.centre) - self.radius;
        let near = 2.0 * piece.radius;
        if distance <= 1.5 * near {
            return f64::INFINITY;
        }
        let cosine = (self.height(piece.centre) / distance).min(1.0);
        let square = distance * distance;
        let kernel = self.area * self.highest.min(distance) / (PI * square * square * square);
        kernel * (20.0 * cosine + 10.0) / (1.0 - near / distance)
    }
}
