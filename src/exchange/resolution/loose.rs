//! A polygon whose corners may move, and what that can change of its exchange with another one.

use crate::geometry::{Patch, clipped, mean};
use crate::numeric::compensated_sum;
use glam::DVec3;
use std::f64::consts::PI;

/// Pieces of an edge, each with a distance of its own.
const PIECES: u32 = 4;

/// Polygons that are apart by so many of their radii are taken as a whole.
const FAR: f64 = 2.0;

/// A piece of an edge.
#[derive(Debug, Clone, Copy)]
struct Piece {
    middle: DVec3,
    half: DVec3,
    ribbon: f64,
}

/// A polygon whose corners may move.
#[derive(Debug, Clone)]
pub(super) struct Loose {
    corners: Vec<DVec3>,
    normal: DVec3,
    /// Outward unit vectors across the edges that have all of the polygon on one side.
    sides: Vec<(DVec3, f64)>,
    pieces: Vec<Piece>,
    /// The pieces of edges along which there are cracks, with the area of these.
    cracks: Vec<Piece>,
    centre: DVec3,
    radius: f64,
    pub(super) area: f64,
    pub(super) ribbons: f64,
    delta: f64,
    /// The largest slope of the plane that moved corners make.
    tilt: f64,
}

impl Loose {
    pub(super) fn of(patch: &Patch, delta: f64, widths: &[f64]) -> Self {
        let (corners, normal) = (patch.corners().to_vec(), patch.normal());
        let centre = mean(&corners);
        let radius = corners.iter().map(|corner| corner.distance(centre));
        let ends = || corners.iter().zip(corners.iter().cycle().skip(1));
        let side = |(from, to): (&DVec3, &DVec3)| {
            let out = (*to - *from).cross(normal).normalize_or_zero();
            let offset = out.dot(*from - centre);
            let over = corners.iter().map(|c| out.dot(*c - centre) - offset);
            // up to rounding: a side a little farther out is a side, too
            let over = over.fold(0.0, f64::max);
            (over <= delta).then_some((out, offset + over))
        };
        let piece = |(from, to): (&DVec3, &DVec3)| {
            let (from, along) = (*from, *to - *from);
            let ribbon = delta * (along.length() + delta);
            (0..PIECES).map(move |k| Piece {
                middle: from + along * ((f64::from(k) + 0.5) / f64::from(PIECES)),
                half: along * (0.5 / f64::from(PIECES)),
                ribbon: ribbon / f64::from(PIECES),
            })
        };
        let pieces: Vec<Piece> = ends().flat_map(piece).collect();
        let widths = widths.iter().flat_map(|width| [*width; PIECES as usize]);
        let cracks = pieces.iter().zip(widths).map(|(piece, width)| Piece {
            ribbon: 2.0 * piece.half.length() * width,
            ..*piece
        });
        Self {
            cracks: cracks.filter(|crack| crack.ribbon > 0.0).collect(),
            sides: ends().filter_map(side).collect(),
            radius: radius.fold(0.0, f64::max),
            area: patch.area(),
            ribbons: compensated_sum(pieces.iter().map(|piece| piece.ribbon)),
            tilt: 4.0 * delta / patch.width(),
            pieces,
            centre,
            normal,
            delta,
            corners,
        }
    }

    fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.centre)
    }

    /// A lower bound on the distance of a point.
    fn distance(&self, point: DVec3) -> f64 {
        let out = self
            .sides
            .iter()
            .map(|(out, offset)| out.dot(point - self.centre) - offset);
        out.fold(0.0, f64::max).hypot(self.height(point))
    }

    /// The largest height of another polygon over this one's plane, at least 0.
    pub(super) fn overtopped_by(&self, other: &Self) -> f64 {
        let heights = other.corners.iter().map(|corner| self.height(*corner));
        heights.fold(0.0, f64::max)
    }

    /// Whether all of another polygon is behind this one's plane, wherever the corners of both are.
    pub(super) fn is_in_front_of(&self, other: &Self) -> bool {
        other.corners.iter().all(|corner| {
            let open = self.delta + other.delta + self.tilt * corner.distance(self.centre);
            self.height(*corner) < -open
        })
    }

    /// The area of what is nearer to another polygon than `reach`, at most.
    fn area_near(&self, other: &Self, reach: f64) -> f64 {
        let mut left = self.corners.clone();
        let plane = [other.normal, -other.normal].map(|normal| (normal, 0.0));
        for (out, offset) in plane.iter().chain(&other.sides) {
            let depth = |c: &DVec3| offset + reach - out.dot(*c - other.centre);
            let depths: Vec<f64> = left.iter().map(depth).collect();
            left = clipped(&left, &depths, DVec3::lerp);
        }
        let Some(first) = left.first() else {
            return 0.0;
        };
        let doubled: DVec3 = left
            .windows(2)
            .map(|pair| (pair[0] - *first).cross(pair[1] - *first))
            .sum();
        0.5 * doubled.length()
    }

    /// The form factor to this polygon of what is no nearer and no higher over it, at most.
    fn share(&self, distance: f64, height: f64) -> f64 {
        if distance <= 0.0 {
            return 1.0;
        }
        let cosine = (height / distance).clamp(0.0, 1.0);
        let area = self.area + self.ribbons;
        (area * cosine / (PI * distance * distance)).min(1.0)
    }

    /// The rays of this polygon that meet the ribbon of a piece of another one's edge, as an
    /// exchange area.
    fn crossed_by(&self, piece: &Piece, reach: f64) -> f64 {
        let distance = self.distance(piece.middle) - piece.half.length() - reach;
        let rise = piece.half.dot(self.normal).abs();
        let open = reach + self.tilt * (piece.middle.distance(self.centre) + reach);
        let height = self.height(piece.middle) + rise + open;
        if height <= 0.0 {
            return 0.0;
        }
        piece.ribbon * self.share(distance, height)
    }

    /// The rays of this polygon that meet cracks along another one's edges.
    pub(super) fn lost_to(&self, other: &Self) -> f64 {
        let reach = self.delta + other.delta;
        let cracks = other.cracks.iter();
        cracks.map(|crack| self.crossed_by(crack, reach)).sum()
    }

    /// `c_ij` of this polygon and another one, when this one moves.
    pub(super) fn change(&self, other: &Self) -> f64 {
        let reach = self.delta + other.delta;
        let apart = self.centre.distance(other.centre);
        let gap = apart - self.radius - other.radius - reach;
        if gap > FAR * self.radius.max(other.radius) {
            let far = reach + other.tilt * (apart + self.radius);
            return self.ribbons * other.share(gap, other.overtopped_by(self) + far);
        }
        let swept = self
            .pieces
            .iter()
            .map(|piece| other.crossed_by(piece, reach));
        let swept: f64 = swept.sum();
        if gap > 0.0 {
            return swept;
        }
        let near = other.pieces.iter();
        let near = near.filter(|piece| self.distance(piece.middle) - piece.half.length() <= reach);
        let ribbons: f64 = near.map(|piece| piece.ribbon).sum();
        let slope = 1.0_f64.hypot(other.tilt);
        swept + slope * (other.area_near(self, reach) + ribbons)
    }

    /// The polygon with corners that may be off by more.
    pub(super) fn looser(&self, more: f64) -> Self {
        let factor = (self.delta + more) / self.delta;
        let ribbons = self.ribbons * factor * factor;
        Self {
            pieces: self
                .pieces
                .iter()
                .map(|piece| Piece {
                    ribbon: piece.ribbon * factor * factor,
                    ..*piece
                })
                .collect(),
            delta: self.delta + more,
            tilt: self.tilt * factor,
            ribbons,
            ..self.clone()
        }
    }
}
