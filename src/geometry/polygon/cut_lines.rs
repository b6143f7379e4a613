//! A polygon and the parallel lines that cut it.
//!
//! ```text
//!   axis u:   lines parallel to v0 → v_last, from the side of v0 to that of v1
//!   axis v:   lines parallel to v0 → v1, towards v_last
//!   position of a point x:   t = (g·x − min g·v)/(max g·v − min g·v)
//!                            g in the plane, across the lines
//! ```
//!
//! In a parallelogram v0 is at 0 and the far edge at 1 on both axes. Heights that agree to
//! [`SAME_LINE`] count as equal.
//!
//! **Not covered**: curved cuts; lines at another angle; a polygon whose corner v0 is straight.

use super::clip::clipped;
use super::convexity::is_convex;
use crate::geometry::{GeometryError, Patch, SplitAxis, check_part, triangulated};
use glam::DVec3;

/// Positions nearer than this are one line.
const SAME_LINE: f64 = 1e-13;

/// The least sine of the angle at v0, and the largest between a line and a plane that counts as
/// parallel to it.
const SMALLEST_ANGLE: f64 = 1e-9;
const PARALLEL: f64 = 1e-12;

/// A polygon with a family of parallel lines across it, each with its relative position from 0 to
/// 1.
#[derive(Debug, Clone, PartialEq)]
pub struct CutLines {
    corners: Vec<DVec3>,
    /// The position of each corner.
    positions: Vec<f64>,
    /// Convex pieces, as indices of corners.
    pieces: Vec<Vec<usize>>,
    /// Unit vectors along the lines and across them.
    along: DVec3,
    across: DVec3,
    /// The distance between lines 0 and 1.
    breadth: f64,
    area: f64,
}

impl CutLines {
    /// The lines across an axis of a polygon.
    ///
    /// # Errors
    /// [`GeometryError::StraightCorner`] if the edges at v0 span no plane.
    ///
    /// # Examples
    /// ```
    /// use infoscene::geometry::{CutLines, Patch, SplitAxis};
    /// use glam::DVec3;
    /// let triangle = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::Y])?;
    /// let lines = CutLines::try_new(&triangle, SplitAxis::U)?;
    /// // the lines x = t: of the area, 1 − (1 − t)² lies before
    /// assert!((lines.share(0.0, 0.5) - 0.75).abs() < 1e-15);
    /// # Ok::<(), infoscene::geometry::GeometryError>(())
    /// ```
    pub fn try_new(patch: &Patch, axis: SplitAxis) -> Result<Self, GeometryError> {
        let corners = patch.corners();
        let n = corners.len();
        let [u, v] = [corners[1], corners[n - 1]].map(|end| (end - corners[0]).normalize());
        let sine = u.cross(v).length();
        if sine < SMALLEST_ANGLE {
            return Err(GeometryError::StraightCorner { sine });
        }
        let (towards, along) = match axis {
            SplitAxis::U => (u, v),
            SplitAxis::V => (v, u),
        };
        let across = along.cross(patch.normal()).normalize();
        Ok(Self::spanned(
            patch,
            along,
            across * across.dot(towards).signum(),
        ))
    }

    /// The lines along a direction, positions growing to its right as seen from the front.
    ///
    /// **Arguments** `direction`: of any length; its part in the polygon's plane counts.
    ///
    /// # Errors
    /// [`GeometryError::StraightCorner`] if it is perpendicular to the plane.
    pub fn parallel_to(patch: &Patch, direction: DVec3) -> Result<Self, GeometryError> {
        let normal = patch.normal();
        let along = direction - direction.dot(normal) * normal;
        let sine = along.length() / direction.length();
        if sine.is_nan() || sine < SMALLEST_ANGLE {
            return Err(GeometryError::StraightCorner { sine });
        }
        let along = along.normalize();
        Ok(Self::spanned(patch, along, along.cross(normal)))
    }

    /// The lines along one unit vector in the plane, in order along another.
    fn spanned(patch: &Patch, along: DVec3, across: DVec3) -> Self {
        let corners = patch.corners().to_vec();
        let (n, normal) = (corners.len(), patch.normal());
        let heights = corners.iter().map(|c| (*c - corners[0]).dot(across));
        let heights: Vec<f64> = heights.collect();
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let breadth = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max) - lowest;
        let mut positions: Vec<f64> = Vec::with_capacity(n);
        for height in heights {
            let position = (height - lowest) / breadth;
            let mut known = [0.0, 1.0].iter().chain(&positions);
            let same = known.find(|known| (position - **known).abs() <= SAME_LINE);
            positions.push(same.copied().unwrap_or(position));
        }
        let pieces = if is_convex(&corners, normal, PARALLEL) {
            vec![(0..n).collect()]
        } else {
            let triangles = triangulated(&corners, normal);
            triangles.iter().map(|triangle| triangle.to_vec()).collect()
        };
        Self {
            positions,
            pieces,
            along,
            across,
            breadth,
            area: patch.area(),
            corners,
        }
    }

    /// The position of the line through a point.
    #[must_use]
    pub fn position(&self, point: DVec3) -> f64 {
        self.positions[0] + (point - self.corners[0]).dot(self.across) / self.breadth
    }

    /// The distance between lines 0 and 1.
    #[must_use]
    pub const fn breadth(&self) -> f64 {
        self.breadth
    }

    /// Convex polygons that make up the part between two positions.
    ///
    /// # Errors
    /// [`GeometryError::PositionOutOfRange`] unless `0 ≤ from < to ≤ 1`; [`GeometryError::NoArea`]
    /// or [`GeometryError::NotPlanar`] if it is too thin for the rounding of its corners.
    pub fn part(&self, from: f64, to: f64) -> Result<Vec<Patch>, GeometryError> {
        check_part(from, to)?;
        let mut parts = Vec::new();
        let mut nothing = None;
        for piece in &self.pieces {
            let outline = piece.iter().map(|i| (self.corners[*i], self.positions[*i]));
            let above = part_where(|t| t - from, &outline.collect::<Vec<_>>());
            let between = part_where(|t| to - t, &above);
            if between.len() < 3 {
                continue;
            }
            match Patch::try_new(between.into_iter().map(|(corner, _)| corner).collect()) {
                Ok(part) => parts.push(part),
                // a sliver of a triangle may come to nothing, the whole part may not
                Err(error @ GeometryError::NoArea { .. }) => nothing = Some(error),
                Err(error) => return Err(error),
            }
        }
        match nothing {
            Some(error) if parts.is_empty() => Err(error),
            _ => Ok(parts),
        }
    }

    /// The segments of a line that lie in the polygon.
    #[must_use]
    pub fn chords(&self, position: f64) -> Vec<[DVec3; 2]> {
        let n = self.corners.len();
        let crossing = |i: usize| {
            let k = (i + 1) % n;
            let (from, to) = (self.positions[i], self.positions[k]);
            // half open, so that a line through a corner crosses one of its edges
            ((from < position) != (to < position)).then(|| {
                let share = (position - from) / (to - from);
                self.corners[i] + (self.corners[k] - self.corners[i]) * share
            })
        };
        let mut crossings: Vec<DVec3> = (0..n).filter_map(crossing).collect();
        crossings.sort_by(|a, b| a.dot(self.along).total_cmp(&b.dot(self.along)));
        let pairs = crossings.chunks_exact(2);
        pairs.map(|pair| [pair[0], pair[1]]).collect()
    }

    /// The share of the area that lies between two positions.
    #[must_use]
    pub fn share(&self, from: f64, to: f64) -> f64 {
        self.between(from, to) / self.between(0.0, 1.0)
    }

    /// The derivative of the share before a line by its position.
    #[must_use]
    pub fn share_rate(&self, position: f64) -> f64 {
        self.length(position) * self.breadth / self.area
    }

    /// The positions inside `(0, 1)` at which an edge runs along a line, so that the chord jumps.
    #[must_use]
    pub fn steps(&self) -> Vec<f64> {
        let next = self.positions.iter().cycle().skip(1);
        let edges = self.positions.iter().zip(next);
        let level = edges.filter(|(a, b)| (**a - **b).abs() <= 0.0 && **a > 0.0 && **a < 1.0);
        level.map(|(a, _)| *a).collect()
    }

    /// The position of the line that lies in a plane, if the lines are parallel to it and it meets
    /// the polygon's.
    #[must_use]
    pub fn in_plane(&self, origin: DVec3, normal: DVec3) -> Option<f64> {
        let slope = self.across.dot(normal) * self.breadth;
        let leaves = self.along.dot(normal).abs();
        if leaves > PARALLEL || slope.abs() <= SMALLEST_ANGLE * self.breadth {
            return None;
        }
        // from the corner nearest to the plane
        let heights = self.corners.iter().map(|c| (*c - origin).dot(normal));
        let nearest = heights.zip(&self.positions);
        let (height, position) = nearest.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))?;
        let position = position - height / slope;
        (SAME_LINE..=1.0 - SAME_LINE)
            .contains(&position)
            .then_some(position)
    }

    fn length(&self, position: f64) -> f64 {
        let chords = self.chords(position);
        chords.iter().map(|[from, to]| from.distance(*to)).sum()
    }

    /// ∫ chord dt: linear between corners, where the middle is right.
    fn between(&self, from: f64, to: f64) -> f64 {
        let inside = self.positions.iter().filter(|t| **t > from && **t < to);
        let mut ends: Vec<f64> = [from, to].into_iter().chain(inside.copied()).collect();
        ends.sort_by(f64::total_cmp);
        let pieces = ends.windows(2);
        pieces
            .map(|pair| (pair[1] - pair[0]) * self.length(0.5 * (pair[0] + pair[1])))
            .sum()
    }
}

/// The part of a convex outline where `height`, a function of the position, is ≥ 0; each corner
/// comes with its position.
fn part_where(height: impl Fn(f64) -> f64, outline: &[(DVec3, f64)]) -> Vec<(DVec3, f64)> {
    let heights: Vec<f64> = outline.iter().map(|(_, t)| height(*t)).collect();
    clipped(outline, &heights, |(corner, t), (next, next_t), share| {
        (corner + (next - corner) * share, t + (next_t - t) * share)
    })
}
