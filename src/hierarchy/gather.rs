//! The last gather: radiosity at a point, from all that it sees.
//!
//! ```text
//!   B1(x) = E + R Σ_j F(x → P_j) B_j        j: the sources of the links of the leaf of x
//! ```
//!
//! A source whose leaves differ by more than the point can bear is looked at part by part:
//!
//! ```text
//!   F σ_j h_j/d  ≤  δ H/√n        n: links of the leaf
//! ```
//!
//! B1 is smooth where B is, and its error is that of the received light alone, which averages over
//! all that is seen: it is far below the error of the mesh.
//!
//! **Not covered**: a bound; [`ErrorBound::gathered`](super::ErrorBound::gathered) has one.

use super::HierarchyError;
use super::link_factor::Visibility;
use super::refinement::Refinement;
use crate::numeric::real;
use glam::DVec3;
use std::f64::consts::SQRT_2;

/// The share δ of the irradiance that sources may miss together.
const SHARE: f64 = 1e-3;

impl Refinement<'_> {
    /// The radiosity at a point of a leaf, gathered once more.
    ///
    /// **Returns** a value of the unit of the emittances, at least 0. **Accuracy** an estimate:
    /// of the leaves' means it has at most a fifth of the error, by
    /// `the_last_gather_is_far_better_than_the_mesh`.
    ///
    /// # Errors
    /// [`HierarchyError::FormFactor`] if coordinates leave the range of `f64`.
    pub fn gathered(&self, leaf: usize, point: DVec3) -> Result<f64, HierarchyError> {
        let element = &self.tree().elements()[leaf];
        let lighting = self.lighting();
        let reflectance = lighting.reflectance(element.patch());
        let emittance = lighting.emittance(element.patch());
        if reflectance <= 0.0 {
            return Ok(emittance);
        }
        let around = std::iter::successors(Some(leaf), |e| self.tree().elements()[*e].parent());
        let around: Vec<usize> = around.collect();
        let links: usize = around.iter().map(|e| self.links().of(*e).len()).sum();
        let expected = self.solution().received.irradiance[leaf];
        let gather = Gather {
            room: self,
            leaf,
            point,
            allowed: SHARE * expected.max(0.0) / real(links).sqrt(),
        };
        let mut irradiance = 0.0;
        for receiver in around {
            let links = self.links().of(receiver).iter();
            for (link, sight) in links.zip(self.links().sights_of(receiver)) {
                irradiance += gather.from(link.source as usize, sight)?;
            }
        }
        Ok(emittance + reflectance * irradiance)
    }
}

/// A point that gathers.
struct Gather<'r> {
    room: &'r Refinement<'r>,
    leaf: usize,
    point: DVec3,
    /// What a source may miss.
    allowed: f64,
}

impl Gather<'_> {
    /// The irradiance by an element.
    fn from(&self, source: usize, sight: &Visibility) -> Result<f64, HierarchyError> {
        let elements = self.room.tree().elements();
        let (element, normal) = (&elements[source], elements[self.leaf].shape().normal());
        let factor = self
            .room
            .factors()
            .from_point(self.point, normal, element, sight)?;
        let miss = factor * self.room.solution().deviation[source] * SQRT_2 * element.radius();
        if element.is_leaf() || miss <= self.allowed * self.point.distance(element.centre()) {
            return Ok(factor * self.room.solution().radiosity[source]);
        }
        element
            .children()
            .map(|child| self.from(child, sight))
            .sum()
    }
}
