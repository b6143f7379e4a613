//! Patches as the convex pieces that shafts run between.

use super::parting::{edges, parts};
use crate::geometry::polygon::clip::clipped;
use crate::geometry::polygon::convex_pieces::convex_pieces;
use crate::geometry::{Patch, Plane, bounds};
use glam::DVec3;

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
        Self {
            pieces: convex_pieces(&corners, patch.normal()),
            bounds: bounds(corners.iter().copied()),
            corners,
            plane,
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
    pub(super) fn above(&self, plane: &Plane, noise: f64) -> Vec<Vec<DVec3>> {
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
