//! The screens that stand between two patches, as few as hide the same.
//!
//! ```text
//!   hidden    every segment meets a body: of the groups of the two, or of the two (`hiding`)
//!   partial   the screens that enter the shaft, and that a line from i⁺ may meet first
//! ```
//!
//! **A line is cut if and only if it is cut where it first meets a screen.** So a screen that no
//! line from i⁺ meets before all others is left out; whichever end is taken, it is one and the same
//! for the whole pair. Left out are
//!
//! * faces of a solid of which all of i⁺ is behind, if lines from i⁺ start outside the solid: they
//!   come into it through a face in front of which they start;
//! * screens of which the part in front of both planes is hidden from i⁺ by bodies: every segment
//!   from i⁺ to it meets a body, and a screen of that body, before.
//!
//! Each of these lines has a screen that it meets first, which is not left out; lines that meet two
//! at once are of measure zero, or pass where screens touch, up to the noise of the coordinates.
//!
//! **Groups.** Facets of a wall that see nothing of another wall are settled together: what is
//! found of two groups is kept, in a table of their pairs.
//!
//! **Not covered**: how much is left ([`Polygon::exchange_area_past`]).
//!
//! [`Polygon::exchange_area_past`]: crate::form_factor::Polygon::exchange_area_past

use super::hiding::Hiding;
use super::screens::Screens;
use super::surfaces::Surfaces;
use crate::geometry::{Outline, Plane, Shaft, clipped};
use crate::scene::Scene;
use crate::scene::planes::ScenePlanes;
use glam::DVec3;

/// The part of a pair of patches that screens leave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Screened {
    /// All: nothing stands between.
    Nothing,
    /// The part past these screens.
    By(Vec<usize>),
    /// Nothing is left.
    Wholly,
}

/// The search for screens between patches, made ready.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Screening<'a> {
    surfaces: &'a Surfaces,
    screens: &'a Screens,
    planes: &'a ScenePlanes,
    hiding: Hiding<'a>,
    /// Whether all planes are exact: which side of them a corner is on is sure then.
    is_exact: bool,
}

impl<'a> Screening<'a> {
    /// The search among the screens of a scene, which are found once.
    pub(crate) fn of(scene: &'a Scene) -> Self {
        let (screens, planes) = (scene.screens(), scene.planes());
        Self {
            surfaces: scene.outlined(),
            screens,
            planes,
            hiding: Hiding {
                bodies: screens.bodies(),
                noise: planes.noise(),
            },
            is_exact: (0..screens.count())
                .all(|screen| screens.screen(screen).outline.plane().tilt <= 0.0),
        }
    }

    /// The part of two patches that screens leave.
    pub(crate) fn between(&self, first: usize, second: usize) -> Screened {
        let noise = self.planes.noise();
        let patches = [first.min(second), first.max(second)];
        let are_groups_hidden = self.are_groups_hidden(patches);
        if are_groups_hidden == Some(true) {
            return Screened::Wholly;
        }
        let [one, other] = patches.map(|patch| self.surfaces.outline(patch));
        if !(one.rises_above(other.plane(), noise) && other.rises_above(one.plane(), noise)) {
            return Screened::Nothing;
        }
        let near = self.near([one, other]);
        if near.is_empty() {
            return Screened::Nothing;
        }
        // the patches may be groups of their own
        let is_told = are_groups_hidden.is_some() && patches.iter().all(|p| self.is_group(*p));
        if !is_told && self.hiding.hides(one, other) {
            return Screened::Wholly;
        }
        let Some(shaft) = Shaft::between(one, other, noise) else {
            return Screened::Nothing;
        };
        let found = self.first_met(&shaft, [one, other], &near);
        if found.is_empty() {
            Screened::Nothing
        } else {
            Screened::By(found)
        }
    }

    /// Whether a patch is all of its group.
    fn is_group(&self, patch: usize) -> bool {
        let group = self.screens.group(self.screens.group_of(patch));
        group.corners() == self.surfaces.outline(patch).corners()
    }

    /// Whether the groups of two patches see nothing of each other, if verdicts are kept.
    fn are_groups_hidden(&self, patches: [usize; 2]) -> Option<bool> {
        let groups = patches.map(|patch| self.screens.group_of(patch));
        self.screens.verdict(groups, || {
            let [one, other] = groups.map(|group| self.screens.group(group));
            self.hiding.hides(one, other)
        })
    }

    /// The screens near the shaft whose planes cross it, in order.
    fn near(&self, ends: [&Outline; 2]) -> Vec<usize> {
        let corners = || ends.into_iter().flat_map(Outline::corners).copied();
        let crosses = |screen: &usize| {
            let shared = &self.planes.planes()[self.screens.screen(*screen).plane];
            shared.is_crossed_by(shared.range(corners()), self.planes.noise())
        };
        let near = self.screens.between(ends.map(Outline::bounds));
        let mut near: Vec<usize> = near.filter(crosses).collect();
        near.sort_unstable();
        near
    }

    /// The screens that enter the shaft and may be met first from one of its ends, the one from
    /// which these are fewer.
    fn first_met(&self, shaft: &Shaft, outlines: [&Outline; 2], near: &[usize]) -> Vec<usize> {
        let ends = shaft.corners();
        let enters = |screen: &usize| shaft.is_entered_by(&self.screens.screen(*screen).outline);
        if !self.is_exact {
            // what meets a line first may not be among those that are near
            return near.iter().copied().filter(enters).collect();
        }
        let planes = outlines.map(|outline| *outline.plane());
        let is_later =
            |screen: usize, end: usize| self.is_met_later(screen, (&ends[end], planes[end].normal));
        let is_kept = |screen: &usize| (0..2).any(|end| !is_later(*screen, end));
        let near = near.iter().copied().filter(is_kept).filter(enters);
        let near: Vec<usize> = near.collect();
        let met_from = |end: usize| -> Vec<usize> {
            let all = near.iter().copied();
            let mut met: Vec<usize> = all.filter(|screen| !is_later(*screen, end)).collect();
            let may_be_halved = outlines[end].pieces().len() == 1;
            if met.len() > 1 {
                met.retain(|screen| {
                    !self.is_hidden(*screen, shaft, &ends[end], planes, may_be_halved)
                });
            }
            met
        };
        let one = met_from(0);
        if one.len() < 2 {
            return one;
        }
        let other = met_from(1);
        if other.len() < one.len() { other } else { one }
    }

    /// Whether all of a screen that is in a shaft is hidden from one of its ends.
    fn is_hidden(
        &self,
        screen: usize,
        shaft: &Shaft,
        end: &[DVec3],
        planes: [Plane; 2],
        may_be_halved: bool,
    ) -> bool {
        let [piece] = self.screens.screen(screen).outline.pieces() else {
            return false;
        };
        let part = shaft.part_of(&in_front_of(piece, &planes));
        part.len() > 2 && self.hiding.are_hidden([end.to_vec(), part], may_be_halved)
    }

    /// Whether lines from a hull of corners to its front meet other screens before this one, a face
    /// of a solid.
    fn is_met_later(&self, screen: usize, from: (&[DVec3], DVec3)) -> bool {
        let face = self.screens.screen(screen).outline.plane();
        let solid = self.screens.bodies().solid_of(screen);
        solid.is_some_and(|solid| solid.meets_later(face, from, self.planes.noise()))
    }
}

/// The part of a convex polygon in front of some planes.
fn in_front_of(corners: &[DVec3], planes: &[Plane]) -> Vec<DVec3> {
    let mut part = corners.to_vec();
    for plane in planes {
        let heights: Vec<f64> = part.iter().map(|corner| plane.height(*corner)).collect();
        part = clipped(&part, &heights, DVec3::lerp);
    }
    part
}
