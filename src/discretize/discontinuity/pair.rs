//! A patch that sees another one past polygons that stand between.

use crate::discretize::error::DiscretizeError;
use crate::discretize::patch::between::Between;
use crate::form_factor::{Occluders, Polygon, point_form_factor_past};
use crate::geometry::{Patch, is_inside};
use crate::numeric::Bounded;
use crate::scene::{Occlusion, Scene};
use glam::DVec3;

/// A receiver and a source, and the polygons that stand between them.
#[derive(Debug, Clone, PartialEq)]
pub struct OccludedPair {
    pub(super) receiver: Patch,
    pub(super) source: Patch,
    pub(super) blockers: Vec<Patch>,
    names: Vec<String>,
    polygons: Vec<Polygon>,
    source_polygon: Polygon,
    touching: f64,
}

/// Lengths below this share of the pair's size are 0: (a) corners carry ε of it, and planes through
/// them some thousand times that where edges are short.
const NOISE: f64 = 1e-11;

impl OccludedPair {
    /// The receiver, the source and polygons, which block from both sides; those that hide nothing
    /// may be among them.
    ///
    /// **Arguments** `receiver`, `source`: patches that see each other with their fronts, in one
    /// unit of length with the `blockers`, of any number and either orientation.
    /// **Returns** the pair, in which only what rounding moves counts as touching.
    #[must_use]
    pub fn new(receiver: Patch, source: Patch, blockers: Vec<Patch>) -> Self {
        let names = (0..blockers.len()).map(|index| format!("blocker {index}"));
        Self {
            names: names.collect(),
            polygons: blockers.iter().map(Polygon::new).collect(),
            source_polygon: Polygon::new(&source),
            receiver,
            source,
            blockers,
            touching: 0.0,
        }
    }

    /// Two patches of a scene, receiver and source, with all that may stand between them; nothing
    /// if occlusion is ignored.
    ///
    /// **Arguments** the indices of two different patches, receiver first, each without others
    /// lying in it.
    /// **Returns** the pair with the names of its blockers, in which coordinates within the scene's
    /// noise count as touching.
    ///
    /// # Errors
    /// [`DiscretizeError::Scene`] if a patch does not exist or has others lying in it;
    /// [`DiscretizeError::AgainstItself`].
    pub fn of(
        scene: &Scene,
        [receiver, source]: [usize; 2],
        occlusion: Occlusion,
    ) -> Result<Self, DiscretizeError> {
        if receiver == source {
            return Err(DiscretizeError::AgainstItself { patch: receiver });
        }
        let shape = |patch| Ok::<_, DiscretizeError>(scene.whole_patch(patch)?.shape().clone());
        let surfaces = match occlusion {
            Occlusion::Ignore => Vec::new(),
            _ => Between::of(scene, receiver).surfaces(source),
        };
        let between = || surfaces.iter().map(|surface| scene.surface(*surface));
        let blockers = between().map(|surface| surface.shape().clone());
        let pair = Self::new(shape(receiver)?, shape(source)?, blockers.collect());
        Ok(Self {
            names: between().map(|surface| surface.name().to_owned()).collect(),
            touching: scene.noise_length(),
            ..pair
        })
    }

    /// The name of a blocker.
    #[must_use]
    pub fn blocker_name(&self, index: usize) -> Option<&str> {
        self.names.get(index).map(String::as_str)
    }

    /// The form factor from a point of the receiver's plane to the source, past the blockers.
    ///
    /// **Arguments** `point`: in the receiver's plane, of coordinates up to 1e60; it need not lie
    /// in the receiver.
    /// **Returns** a number in `[0, 1]`, dimensionless, with a bound on its error.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`], as
    /// [`point_form_factor_past`](crate::form_factor::point_form_factor_past).
    pub fn seen_from(&self, point: DVec3) -> Result<Bounded, DiscretizeError> {
        let polygons: Vec<&Polygon> = self.polygons.iter().collect();
        self.form_factor(point, &polygons)
    }

    /// The form factor from a point of the receiver's plane to the source, as if nothing were
    /// between.
    ///
    /// **Arguments** and **Returns** as of [`seen_from`](Self::seen_from).
    ///
    /// # Errors
    /// As [`seen_from`](Self::seen_from).
    pub fn seen_unblocked(&self, point: DVec3) -> Result<Bounded, DiscretizeError> {
        self.form_factor(point, &[])
    }

    fn form_factor(&self, point: DVec3, past: &[&Polygon]) -> Result<Bounded, DiscretizeError> {
        let occluders = Occluders {
            polygons: past,
            touching: self.touching,
        };
        let normal = self.receiver.normal();
        Ok(point_form_factor_past(
            point,
            normal,
            &self.source_polygon,
            &occluders,
        )?)
    }

    /// Whether a point of the receiver's plane is inside the receiver.
    #[must_use]
    pub fn is_on_receiver(&self, point: DVec3) -> bool {
        is_inside(point, &self.receiver)
    }

    /// The height of a point over the receiver.
    pub(super) fn height(&self, point: DVec3) -> f64 {
        (point - self.receiver.corners()[0]).dot(self.receiver.normal())
    }

    /// The height of a point over the source.
    pub(super) fn height_over_source(&self, point: DVec3) -> f64 {
        (point - self.source.corners()[0]).dot(self.source.normal())
    }

    /// The largest distance of two corners of receiver and source.
    pub(super) fn size(&self) -> f64 {
        let corners = || self.receiver.corners().iter().chain(self.source.corners());
        let apart = corners().map(|corner| corner.distance(self.receiver.corners()[0]));
        2.0 * apart.fold(0.0, f64::max)
    }

    /// The length up to which corners, edges and planes count as meeting.
    pub(super) fn noise(&self) -> f64 {
        self.touching + NOISE * self.size()
    }
}
