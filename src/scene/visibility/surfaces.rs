//! The surfaces of a scene, prepared once for all questions about their relative positions.
//!
//! Planes, outlines and boxes are found when they are first asked for and kept with the scene.
//! Every surface is in one of two trees of boxes: *candidates* lie in a plane that has patches on
//! both sides, and nothing else can stand between two patches; the search for blockers passes over
//! all others.
//!
//! **Not covered**: the answers (overlap, blockers, convex rooms).

use super::boxes::{BoxHull, Boxes, boxed};
use super::screens::Screens;
use crate::geometry::{Outline, bounds};
use crate::scene::planes::ScenePlanes;
use crate::scene::{NamedPatch, Scene};
use glam::DVec3;
use rayon::prelude::*;
use rstar::AABB;
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
    splitting: OnceLock<Vec<usize>>,
    surfaces: OnceLock<Surfaces>,
    screens: OnceLock<Screens>,
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
            let all = outlines.iter().enumerate();
            let kept = all.filter(|(k, _)| splits[planes.plane_of(*k).plane] == are_candidates);
            boxed(kept.map(|(surface, outline)| (surface, *outline.bounds())))
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

    /// The candidates whose boxes meet the hull of two boxes.
    fn candidates_between(&self, hull: &BoxHull) -> impl Iterator<Item = usize> {
        let found = self.candidates.locate_with_selection_function(*hull);
        found.map(|boxed| boxed.data)
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

    /// The surfaces whose boxes meet the hull of two boxes, unless it is known that they lie in a
    /// plane with all patches on one side.
    pub(crate) fn candidates_between(self, ends: [&[DVec3; 2]; 2]) -> Vec<usize> {
        match self {
            Self::Indexed(surfaces) => surfaces.candidates_between(&BoxHull::of(ends)).collect(),
            Self::Scanned(scene) => {
                let [[low, high], [lowest, highest]] = ends;
                scanned(scene, [low.min(*lowest), high.max(*highest)])
            }
        }
    }
}

/// The surfaces whose boxes meet a box, each looked at.
fn scanned(scene: &Scene, [low, high]: [DVec3; 2]) -> Vec<usize> {
    let planes = scene.planes();
    let meets = |surface: &NamedPatch| {
        let [least, most] = bounds(planes.corners(surface));
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

    /// The planes with patches on both sides, found once.
    pub(crate) fn splitting_planes(&self) -> &[usize] {
        self.prepared.0.splitting.get_or_init(|| {
            let splits = self.splits();
            (0..splits.len()).filter(|plane| splits[*plane]).collect()
        })
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

    /// The screens of all surfaces, found once.
    pub(crate) fn screens(&self) -> &Screens {
        let screens = &self.prepared.0.screens;
        screens.get_or_init(|| Screens::of(self))
    }
}
