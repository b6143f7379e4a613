//! The surfaces of a scene, prepared once for all questions about their relative positions.
//!
//! Planes, outlines and boxes are found when they are first asked for and kept with the scene.
//! Every surface is in one of two trees of boxes: *candidates* lie in a plane that has patches on
//! both sides, and nothing else can stand between two patches; the search for blockers passes over
//! all others.
//!
//! **Not covered**: the answers (overlap, blockers, convex rooms).

use crate::geometry::Outline;
use crate::scene::planes::ScenePlanes;
use crate::scene::{NamedPatch, Scene};
use glam::DVec3;
use rayon::prelude::*;
use rstar::primitives::{GeomWithData, Rectangle as Box3};
use rstar::{AABB, RTree};
use std::borrow::Cow;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// The planes, outlines and boxes kept with a scene, each found when it is first asked for.
#[derive(Clone, Default)]
pub(crate) struct Prepared(Arc<Parts>);

#[derive(Default)]
struct Parts {
    planes: OnceLock<ScenePlanes>,
    splits: OnceLock<Vec<bool>>,
    surfaces: OnceLock<Surfaces>,
}

/// Equal scenes have equal surfaces, found or not.
impl PartialEq for Prepared {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl fmt::Debug for Prepared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Prepared")
    }
}

type Boxes = RTree<GeomWithData<Box3<[f64; 3]>, usize>>;

/// The outlines of patches and obstructions, and where they are.
#[derive(Debug)]
pub(crate) struct Surfaces {
    outlines: Vec<Outline>,
    candidates: Boxes,
    others: Boxes,
}

impl Surfaces {
    fn of(scene: &Scene) -> Self {
        let (planes, splits) = (scene.planes(), scene.splits());
        let count = scene.surfaces().count();
        let outline = |surface| scene.outline(surface);
        let outlines: Vec<Outline> = (0..count).into_par_iter().map(outline).collect();
        let boxes = |are_candidates: bool| {
            let boxed = outlines.iter().enumerate().map(|(surface, outline)| {
                let [low, high] = outline.bounds().map(|corner| corner.to_array());
                GeomWithData::new(Box3::from_corners(low, high), surface)
            });
            let kept = boxed.filter(|b| splits[planes.plane_of(b.data).plane] == are_candidates);
            RTree::bulk_load(kept.collect())
        };
        let [candidates, others] = [true, false].map(boxes);
        Self {
            outlines,
            candidates,
            others,
        }
    }

    /// The candidates whose boxes meet a box.
    fn candidates_near(&self, room: [DVec3; 2]) -> Vec<usize> {
        near(&self.candidates, room).collect()
    }

    /// All surfaces whose boxes meet a box.
    fn near(&self, room: [DVec3; 2]) -> Vec<usize> {
        let candidates = near(&self.candidates, room);
        candidates.chain(near(&self.others, room)).collect()
    }
}

/// The way in which surfaces are found: where many questions come, trees pay; a single one looks
/// at every surface once.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Search<'a> {
    Indexed(&'a Surfaces),
    Scanned(&'a Scene),
}

impl<'a> Search<'a> {
    /// The outline of a surface; obstructions are numbered after the patches.
    pub(crate) fn outline(self, surface: usize) -> Cow<'a, Outline> {
        match self {
            Self::Indexed(surfaces) => Cow::Borrowed(&surfaces.outlines[surface]),
            Self::Scanned(scene) => Cow::Owned(scene.outline(surface)),
        }
    }

    /// The surfaces whose boxes meet a box.
    pub(crate) fn near(self, room: [DVec3; 2]) -> Vec<usize> {
        match self {
            Self::Indexed(surfaces) => surfaces.near(room),
            Self::Scanned(scene) => scanned(scene, room),
        }
    }

    /// The surfaces whose boxes meet a box, and that can stand between two patches with these
    /// corners.
    pub(crate) fn candidates_near(
        self,
        room: [DVec3; 2],
        corners: impl Iterator<Item = DVec3> + Clone,
    ) -> Vec<usize> {
        let scene = match self {
            Self::Indexed(surfaces) => return surfaces.candidates_near(room),
            Self::Scanned(scene) => scene,
        };
        let planes = scene.planes();
        let is_between = |surface: &usize| {
            let plane = &planes.planes()[planes.plane_of(*surface).plane];
            plane.is_crossed_by(plane.range(corners.clone()), planes.noise())
        };
        scanned(scene, room)
            .into_iter()
            .filter(is_between)
            .collect()
    }
}

/// The surfaces whose boxes meet a box, each looked at.
fn scanned(scene: &Scene, [low, high]: [DVec3; 2]) -> Vec<usize> {
    let planes = scene.planes();
    let meets = |surface: &NamedPatch| {
        let corners = || planes.corners(surface);
        let least = corners().fold(DVec3::INFINITY, DVec3::min);
        let most = corners().fold(DVec3::NEG_INFINITY, DVec3::max);
        least.cmple(high).all() && most.cmpge(low).all()
    };
    let surfaces = scene.surfaces().enumerate();
    surfaces
        .filter(|(_, surface)| meets(surface))
        .map(|(index, _)| index)
        .collect()
}

fn near(boxes: &Boxes, room: [DVec3; 2]) -> impl Iterator<Item = usize> {
    let [low, high] = room.map(|corner| corner.to_array());
    let found = boxes.locate_in_envelope_intersecting(AABB::from_corners(low, high));
    found.map(|boxed| boxed.data)
}

impl Scene {
    /// The planes of all surfaces, found once.
    pub(crate) fn planes(&self) -> &ScenePlanes {
        let planes = &self.prepared.0.planes;
        planes.get_or_init(|| ScenePlanes::of(self))
    }

    /// The number of planes that surfaces lie in, each counted once whichever way they face.
    #[must_use]
    pub fn plane_count(&self) -> usize {
        self.planes().planes().len()
    }

    /// The length below which coordinates say nothing: two places closer than this are taken as
    /// one.
    #[must_use]
    pub fn noise_length(&self) -> f64 {
        self.planes().noise_length()
    }

    /// Tells, for each plane, whether patches lie on both sides of it.
    pub(crate) fn splits(&self) -> &[bool] {
        let splits = &self.prepared.0.splits;
        splits.get_or_init(|| self.planes().splits(&self.patches))
    }

    /// The outline of one surface.
    fn outline(&self, surface: usize) -> Outline {
        let planes = self.planes();
        let shape = self.surface(surface).shape();
        Outline::new(shape, planes.unit(), planes.facing(surface))
    }

    /// The outlines and boxes of all surfaces, found once.
    pub(crate) fn outlined(&self) -> &Surfaces {
        let surfaces = &self.prepared.0.surfaces;
        surfaces.get_or_init(|| Surfaces::of(self))
    }
}
