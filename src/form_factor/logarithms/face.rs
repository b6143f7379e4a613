//! A polygon with its plane and its edges.

use crate::geometry::Patch;
use crate::numeric::SQUARED_EPSILON;
use glam::DVec3;

/// An edge: start, direction, length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub(super) start: DVec3,
    pub(super) along: DVec3,
    pub(super) length: f64,
}

impl Edge {
    pub(super) fn at(&self, s: f64) -> DVec3 {
        self.start + s * self.along
    }

    pub(super) fn distance(&self, point: DVec3) -> f64 {
        let foot = (point - self.start).dot(self.along).clamp(0.0, self.length);
        self.at(foot).distance(point)
    }
}

pub(super) struct Face {
    pub(super) corners: Vec<DVec3>,
    pub(super) edges: Vec<Edge>,
    pub(super) normal: DVec3,
    /// Heights below are rounding: so little of an edge is that low that the logarithm does not
    /// count.
    pub(super) least: f64,
}

impl Face {
    pub(super) fn new(patch: &Patch) -> Self {
        let corners = patch.corners().to_vec();
        let ends = corners.iter().cycle().skip(1);
        let edges = corners.iter().zip(ends).map(|(start, end)| {
            let edge = *end - *start;
            let length = edge.length();
            let along = edge / length;
            Edge {
                start: *start,
                along,
                length,
            }
        });
        Self {
            edges: edges.filter(|edge| edge.length > 0.0).collect(),
            least: patch.area().sqrt() * SQUARED_EPSILON,
            corners,
            normal: patch.normal(),
        }
    }

    pub(super) fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.corners[0])
    }

    /// The lowest and the highest corner of another one, over the plane of this one.
    pub(super) fn heights(&self, other: &Self) -> [f64; 2] {
        let heights = || other.corners.iter().map(|corner| self.height(*corner));
        [
            heights().fold(f64::INFINITY, f64::min),
            heights().fold(f64::NEG_INFINITY, f64::max),
        ]
    }

    /// The largest sum of magnitudes of the terms of such a height.
    pub(super) fn rise(&self, other: &Self) -> f64 {
        let terms = |corner: &DVec3| self.normal.abs().dot((*corner - self.corners[0]).abs());
        other.corners.iter().map(terms).fold(0.0, f64::max)
    }

    pub(super) fn extent(&self, other: &Self) -> f64 {
        let corners = self.corners.iter().chain(&other.corners);
        corners
            .map(|corner| corner.abs().max_element())
            .fold(f64::MIN_POSITIVE, f64::max)
    }
}
