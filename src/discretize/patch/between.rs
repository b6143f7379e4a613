//! The surfaces that stand between a patch that is cut and the others.
//!
//! **Not covered**: which part of the patch each of them hides something from.

use super::polygons::Past;
use crate::form_factor::Polygon;
use crate::scene::{Blockers, Scene};
use glam::DVec3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The search for what stands between one patch and others; each surface is prepared once.
#[derive(Debug)]
pub(crate) struct Between<'s> {
    scene: &'s Scene,
    patch: usize,
    blockers: Blockers<'s>,
    polygons: BTreeMap<usize, Arc<Polygon>>,
}

impl<'s> Between<'s> {
    /// The search for one patch of a scene.
    pub(crate) fn of(scene: &'s Scene, patch: usize) -> Self {
        Self {
            scene,
            patch,
            blockers: Blockers::of(scene),
            polygons: BTreeMap::new(),
        }
    }

    /// Whether anything can stand between two patches of the scene.
    pub(crate) const fn can_block(&self) -> bool {
        self.blockers.can_block()
    }

    /// Whether something stands between the patch and another one.
    pub(crate) fn is_blocked(&self, other: usize) -> bool {
        self.blockers.of_pair(self.patch, other).is_some()
    }

    /// The surfaces between the patch and another one, in order.
    pub(crate) fn surfaces(&self, other: usize) -> Vec<usize> {
        let surfaces = self.blockers.whole_surfaces_between(self.patch, other);
        surfaces.collect()
    }

    /// The polygons between the patch and another one; none if nothing is.
    pub(crate) fn past(&mut self, other: usize) -> Option<Past> {
        let surfaces = self.blockers.whole_surfaces_between(self.patch, other);
        let occluders: Vec<Arc<Polygon>> = surfaces
            .map(|surface| {
                let polygon = || Arc::new(Polygon::new(self.scene.surface(surface).shape()));
                Arc::clone(self.polygons.entry(surface).or_insert_with(polygon))
            })
            .collect();
        (!occluders.is_empty()).then(|| Past {
            occluders,
            touching: self.scene.noise_length(),
        })
    }

    /// The planes, by a point and the normal, of the surfaces found so far that stand on the plane
    /// of the patch.
    pub(crate) fn standing(&self) -> impl Iterator<Item = (DVec3, DVec3)> {
        let own = self.scene.patches()[self.patch].shape();
        let noise = self.scene.noise_length();
        let shapes = self.polygons.keys();
        let shapes = shapes.map(|surface| self.scene.surface(*surface).shape());
        let height = move |at: &DVec3| (*at - own.corners()[0]).dot(own.normal());
        let standing = shapes.filter(move |shape| {
            let mut corners = shape.corners().iter();
            corners.any(|corner| height(corner) <= noise)
        });
        standing.map(|shape| (shape.corners()[0], shape.normal()))
    }
}
