//! The surfaces of a scene, prepared once for all questions about their relative positions.
//!
//! Planes, outlines and boxes are found when they are first asked for and kept with the scene.
//! Every surface is in one of two trees of boxes: *candidates* lie in a plane that has patches on
//! both sides, and nothing else can stand between two patches; the search for blockers passes over
//! all others.
//!
//! **Not covered**: the answers (overlap, blockers, convex rooms).

use crate::geometry::Outline;
use crate::scene::Scene;
use crate::scene::planes::ScenePlanes;
use glam::DVec3;
use rayon::prelude::*;
use rstar::primitives::{GeomWithData, Rectangle as Box3};
use rstar::{AABB, RTree};
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
        let outline = |surface: usize| {
            let shape = scene.surface(surface).shape();
            Outline::new(shape, planes.unit(), planes.facing(surface))
        };
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

    /// The outline of a surface; obstructions are numbered after the patches.
    pub(crate) fn outline(&self, surface: usize) -> &Outline {
        &self.outlines[surface]
    }

    /// The candidates whose boxes meet a box.
    pub(crate) fn candidates_near(&self, room: [DVec3; 2]) -> impl Iterator<Item = usize> {
        near(&self.candidates, room)
    }

    /// All surfaces whose boxes meet a box.
    pub(crate) fn near(&self, room: [DVec3; 2]) -> impl Iterator<Item = usize> {
        near(&self.candidates, room).chain(near(&self.others, room))
    }
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

    /// Tells, for each plane, whether patches lie on both sides of it.
    pub(crate) fn splits(&self) -> &[bool] {
        let splits = &self.prepared.0.splits;
        splits.get_or_init(|| self.planes().splits(&self.patches))
    }

    /// The outlines and boxes of all surfaces, found once.
    pub(crate) fn outlined(&self) -> &Surfaces {
        let surfaces = &self.prepared.0.surfaces;
        surfaces.get_or_init(|| Surfaces::of(self))
    }
}
