//! The planes of a scene's surfaces, each once, and the noise of their corners.
//!
//! Surfaces whose corners lie within the noise of one plane share it, whichever way they face. A
//! shared plane is put through three corners that are far apart, so that a wall of small patches
//! has a plane as well known as the wall, not as one patch of it. Overlap, blockers, convex rooms
//! and the plan of exchange all ask the planes and the noise that stand here.
//!
//! ```text
//!   noise = 64 ε · (largest coordinate)
//!         + 8 · (largest deviation of a corner from its patch's plane)
//! ```
//!
//! ([`tolerance::TOUCHING`], [`tolerance::DEPTH_PER_DEVIATION`].) Below this length touching cannot
//! be told from penetrating, nor a corner in a plane from one above it. One length serves all:
//!
//! ```text
//!   corner      rotated and shifted, a corner is off by 6 ε of the largest coordinate at most
//!   plane       put through three such corners, it leaves the others within 30 ε on either side
//!   height      of one corner over it: 2 · 6 ε more at most for planes that are the same, and
//!               4 ε of rounding
//!   depth       of one body in another: twice the corners' 6 ε beside what the planes leave
//! ```
//!
//! so that 64 ε holds all of them. Exact scenes have smaller residues and no features of 1e-14 of
//! their size, so that the choice decides nothing there.
//!
//! Where the scene has a [resolution](Scene::resolution), the noise is
//! [`tolerance::RESOLVED_NOISE`] times that, and surfaces are gathered otherwise (`growth`): the
//! plane of a small panel is tilted by what its corners are off, and heights far from it say
//! nothing unless they exceed that, too ([`Plane::sure_height`]).
//!
//! **Not covered**: the planes that can see each other (the plan of exchange compares them).

mod growth;
mod shared;

use super::{NamedPatch, Scene};
use crate::geometry::Plane;
use crate::numeric::tolerance;
use glam::DVec3;
use rayon::prelude::*;
pub(crate) use shared::SharedPlane;
use shared::{centred, own_plane, through_far_corners};
use std::collections::HashMap;

/// The length below which coordinates say nothing.
fn noise(largest: f64, deviation: f64, resolution: f64) -> f64 {
    let rounding = tolerance::TOUCHING * largest;
    if resolution > 0.0 {
        rounding + tolerance::RESOLVED_NOISE * resolution
    } else {
        rounding + tolerance::DEPTH_PER_DEVIATION * deviation
    }
}

/// The plane that a surface lies in, and whether it faces as the plane does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Placed {
    pub plane: usize,
    pub along: bool,
}

/// The planes of all patches and obstructions.
///
/// Heights and lengths are in units of [`unit`](Self::unit).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ScenePlanes {
    unit: f64,
    noise: f64,
    planes: Vec<SharedPlane>,
    /// The plane of each patch, then of each obstruction.
    plane_of: Vec<Placed>,
}

impl ScenePlanes {
    /// Gathers the surfaces of a scene in planes.
    pub(crate) fn of(scene: &Scene) -> Self {
        let surfaces: Vec<&NamedPatch> = scene.surfaces().collect();
        let largest = surfaces
            .iter()
            .flat_map(|surface| surface.shape().corners())
            .map(|corner| corner.abs().max_element())
            .fold(0.0, f64::max);
        // at most 2 after division; a patch has an area, so that something is not 0
        let unit = largest.log2().floor().exp2();
        let own: Vec<SharedPlane> = surfaces
            .par_iter()
            .map(|surface| own_plane(surface, unit))
            .collect();
        let deviation = own.iter().map(|own| own.high).fold(0.0, f64::max);
        let resolution = scene.resolution() / unit;
        let mut planes = Self {
            unit,
            noise: noise(largest / unit, deviation, resolution),
            planes: Vec::new(),
            plane_of: vec![
                Placed {
                    plane: 0,
                    along: true
                };
                surfaces.len()
            ],
        };
        if resolution > 0.0 {
            planes.grow(&surfaces, &own, tolerance::SQRT_3 * resolution);
        } else {
            planes.gather(&surfaces, &own);
        }
        planes
    }

    /// Gathers surfaces whose corners are off by `delta`.
    fn grow(&mut self, surfaces: &[&NamedPatch], own: &[SharedPlane], delta: f64) {
        let panels = surfaces.iter().zip(own).enumerate();
        let panels = panels.map(|(surface, (patch, plane))| {
            let corners = self.corners(patch).collect();
            let width = patch.shape().width() / self.unit;
            growth::Panel::new(surface, plane.clone(), corners, [width, delta])
        });
        for (members, shared) in growth::grown(panels.collect(), self.noise, delta) {
            self.place(&members, shared, own);
        }
    }

    /// The power of two by which coordinates are divided.
    pub(crate) const fn unit(&self) -> f64 {
        self.unit
    }

    /// The length below which coordinates say nothing, in units of [`unit`](Self::unit).
    pub(crate) const fn noise(&self) -> f64 {
        self.noise
    }

    /// The length below which coordinates say nothing, in the scene's own unit of length.
    pub(crate) const fn noise_length(&self) -> f64 {
        self.noise * self.unit
    }

    /// Each plane once.
    pub(crate) fn planes(&self) -> &[SharedPlane] {
        &self.planes
    }

    /// The plane of a surface; obstructions are numbered after the patches.
    pub(crate) fn plane_of(&self, surface: usize) -> Placed {
        self.plane_of[surface]
    }

    /// The plane of a surface, facing as the surface does.
    pub(crate) fn facing(&self, surface: usize) -> Plane {
        let Placed { plane, along } = self.plane_of[surface];
        let plane = self.planes[plane].plane;
        if along { plane } else { plane.reversed() }
    }

    /// The corners of a surface, in units of [`unit`](Self::unit).
    pub(crate) fn corners<'a>(
        &self,
        surface: &'a NamedPatch,
    ) -> impl Iterator<Item = DVec3> + Clone + use<'a> {
        let unit = self.unit;
        surface
            .shape()
            .corners()
            .iter()
            .map(move |corner| *corner / unit)
    }

    /// Tells, for each plane, whether patches lie on both sides of it, so that a surface in it can
    /// stand between two.
    pub(crate) fn splits(&self, patches: &[NamedPatch]) -> Vec<bool> {
        let all = patches.iter().flat_map(|patch| self.corners(patch));
        let mut corners: Vec<DVec3> = all.collect();
        if self.planes.len() > FEW_PLANES {
            corners.sort_unstable_by_key(|corner| corner.to_array().map(f64::to_bits));
            corners.dedup();
        }
        let between = |shared: &SharedPlane| {
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            corners.chunks(CORNERS_AT_ONCE).any(|corners| {
                let [least, most] = shared.range(corners.iter().copied());
                (low, high) = (low.min(least), high.max(most));
                shared.is_crossed_by([low, high], self.noise)
            })
        };
        self.planes.par_iter().map(between).collect()
    }

    /// Gathers surfaces in planes: those that agree roughly are tried as one plane. If they are
    /// not, those that agree closely are put in the first plane that fits.
    ///
    /// Surfaces that lie in one plane but are not gathered only cost time.
    fn gather(&mut self, surfaces: &[&NamedPatch], own: &[SharedPlane]) {
        let all: Vec<usize> = (0..surfaces.len()).collect();
        for members in buckets(&all, own, ROUGHLY) {
            if let Some(shared) = self.common(surfaces, &members, own) {
                self.place(&members, shared, own);
                continue;
            }
            for members in buckets(&members, own, CLOSELY) {
                for members in self.fitting(surfaces, &members, own) {
                    let corners = || members.iter().flat_map(|m| self.corners(surfaces[*m]));
                    let shared = self.common(surfaces, &members, own);
                    let shared = shared.unwrap_or_else(|| centred(own[members[0]].plane, corners));
                    self.place(&members, shared, own);
                }
            }
        }
    }

    /// The plane of a surface, or of several through corners of theirs, if they lie in one.
    fn common(
        &self,
        surfaces: &[&NamedPatch],
        members: &[usize],
        own: &[SharedPlane],
    ) -> Option<SharedPlane> {
        if let [single] = members {
            return Some(own[*single].clone());
        }
        let corners = || members.iter().flat_map(|m| self.corners(surfaces[*m]));
        through_far_corners(corners).filter(|shared| shared.thickness() <= self.noise)
    }

    /// Surfaces gathered around those that come first: within half the noise of their planes.
    fn fitting(
        &self,
        surfaces: &[&NamedPatch],
        members: &[usize],
        own: &[SharedPlane],
    ) -> Vec<Vec<usize>> {
        let mut gathered: Vec<Vec<usize>> = Vec::new();
        for member in members {
            let fits = |others: &&mut Vec<usize>| {
                let plane = &own[others[0]].plane;
                let mut corners = self.corners(surfaces[*member]);
                corners.all(|corner| plane.height(corner).abs() <= 0.5 * self.noise)
            };
            match gathered.iter_mut().find(fits) {
                Some(others) => others.push(*member),
                None => gathered.push(vec![*member]),
            }
        }
        gathered
    }

    fn place(&mut self, members: &[usize], shared: SharedPlane, own: &[SharedPlane]) {
        for member in members {
            self.plane_of[*member] = Placed {
                plane: self.planes.len(),
                along: own[*member].plane.normal.dot(shared.plane.normal) > 0.0,
            };
        }
        self.planes.push(shared);
    }
}

/// The largest number of planes for which it does not pay to look for equal corners.
const FEW_PLANES: usize = 64;

/// A plane with corners on both sides is found out after this many.
const CORNERS_AT_ONCE: usize = 64;

/// Planes that agree to six digits are tried as one.
const ROUGHLY: f64 = 1e6;

/// Planes that agree to twelve digits are tried in turn.
const CLOSELY: f64 = 1_099_511_627_776.0; // 2⁴⁰

/// Surfaces whose normals and distances round to the same, in the order of the first of them.
fn buckets(members: &[usize], own: &[SharedPlane], per_unit: f64) -> Vec<Vec<usize>> {
    let mut place_of: HashMap<[i64; 4], usize> = HashMap::new();
    let mut found: Vec<Vec<usize>> = Vec::new();
    for member in members {
        let plane = &own[*member].plane;
        let normal = unoriented(plane.normal);
        let distance = plane.origin.dot(normal);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "numbers up to 4 · 2⁴⁰, and any rounding serves"
        )]
        let key = [normal.x, normal.y, normal.z, distance].map(|x| (x * per_unit).round() as i64);
        let place = *place_of.entry(key).or_insert_with(|| {
            found.push(Vec::new());
            found.len() - 1
        });
        found[place].push(*member);
    }
    found
}

/// The normal or its opposite, so that two surfaces that face away from each other agree.
fn unoriented(normal: DVec3) -> DVec3 {
    let size = normal.abs();
    let largest = if size.x >= size.y && size.x >= size.z {
        normal.x
    } else if size.y >= size.z {
        normal.y
    } else {
        normal.z
    };
    normal * largest.signum()
}
