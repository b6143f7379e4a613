//! Pairs of patches that see nothing of each other, as one convex body is between them.
//!
//! ```text
//!   hidden  ⇐  some body cuts every segment from a corner of i⁺ to a corner of j⁺
//! ```
//!
//! with i⁺ and j⁺ as in [`blockers`](crate::scene::Blockers), and the bodies of
//! [`Bodies`]. They are looked for along the segment between the middles of the two. The exchange
//! area of such a pair is 0: as what enters by no more than the noise of the coordinates takes
//! nothing away, a slit no wider lets nothing through.
//!
//! **Not covered**: pairs that several bodies hide together.

use super::bodies::Bodies;
use super::surfaces::Surfaces;
use crate::geometry::Shaft;
use crate::scene::Scene;
use glam::DVec3;

/// The search for bodies that hide patches from each other, made ready.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hiding<'a> {
    surfaces: &'a Surfaces,
    bodies: &'a Bodies,
    noise: f64,
}

impl<'a> Hiding<'a> {
    /// The search among the bodies of a scene, which are found once.
    pub(crate) fn of(scene: &'a Scene) -> Self {
        Self {
            surfaces: scene.outlined(),
            bodies: scene.bodies(),
            noise: scene.planes().noise(),
        }
    }

    /// Tells whether it is certain that two patches, which see each other otherwise, see nothing
    /// of each other.
    pub(crate) fn hides(&self, first: usize, second: usize) -> bool {
        let [one, other] = [first.min(second), first.max(second)];
        let [one, other] = [one, other].map(|patch| self.surfaces.outline(patch));
        let noise = self.noise;
        if !(one.rises_above(other.plane(), noise) && other.rises_above(one.plane(), noise)) {
            return false;
        }
        let middles = [one, other].map(|outline| outline.bounds()[0].midpoint(outline.bounds()[1]));
        let mut shaft: Option<[Vec<DVec3>; 2]> = None;
        self.bodies.near(middles).any(|body| {
            // cheapest first: the middles are near the middle of most pairs
            if !body.cuts(middles, noise) {
                return false;
            }
            if shaft.is_none() {
                shaft = Shaft::between(one, other, noise).map(|shaft| shaft.corners());
            }
            let ends = shaft.as_ref();
            ends.is_some_and(|[ones, others]| body.cuts_all([ones, others], noise))
        })
    }
}
