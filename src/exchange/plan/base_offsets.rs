//! Parts that lie off the plane of their base, within what is accepted.
//!
//! A base lacks the projection of its parts on its plane. Where the exchange area of a part is
//! subtracted from that of its base, the bound is widened by what the offset between the two may
//! change ([`shift_allowance`]). Offsets up to the rounding of the coordinates count as none.

use super::perturbation::shift_allowance;
use crate::geometry::{Patch, distance_from_plane};
use crate::numeric::tolerance;
use crate::scene::Scene;

/// The distances of polygons from the planes of their bases.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BaseOffsets {
    distances: Vec<f64>,
    /// All polygons, if one of the distances is not 0.
    shapes: Vec<Patch>,
}

impl BaseOffsets {
    /// Measures the patches of these indices.
    pub(crate) fn of(scene: &Scene, indices: &[usize]) -> Self {
        let shape = |index: usize| scene.patches()[index].shape();
        let distance = |index: &usize| {
            let base = scene.base_of(*index)?;
            let distance = distance_from_plane(shape(*index), shape(base));
            let corners = shape(*index).corners().iter();
            let extent = corners.map(|c| c.abs().max_element()).fold(0.0, f64::max);
            (distance > tolerance::ALIGNMENT * extent).then_some(distance)
        };
        let distances: Vec<Option<f64>> = indices.iter().map(distance).collect();
        let shapes = if distances.iter().all(Option::is_none) {
            Vec::new()
        } else {
            indices.iter().map(|index| shape(*index).clone()).collect()
        };
        Self {
            distances: distances
                .into_iter()
                .map(Option::unwrap_or_default)
                .collect(),
            shapes,
        }
    }

    /// A bound on the change of a part's exchange area with another polygon when the part is moved
    /// into its base's plane.
    pub(crate) fn allowance(&self, part: usize, other: usize) -> f64 {
        if self.distances[part] > 0.0 {
            shift_allowance(
                self.distances[part],
                &self.shapes[part],
                &self.shapes[other],
            )
        } else {
            0.0
        }
    }
}
