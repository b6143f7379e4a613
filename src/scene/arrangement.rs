//! How the surfaces of a scene lie to each other: their planes, each once, and the noise of their corners.
//!
//! Surfaces whose corners lie within the noise of one plane share it. It is put through three corners of theirs that
//! are far apart, so that a wall of small patches has a plane as well known as the wall, not as one patch of it.
//!
//! ```text
//!   noise = 64 ε · (largest coordinate) + 8 · (largest deviation of a corner from its patch's plane)
//! ```
//!
//! ([`tolerance::TOUCHING`], [`tolerance::DEPTH_PER_DEVIATION`]): below it, touching cannot be told from penetrating.
//! All coordinates here are divided by a power of two near the largest one.

use super::NamedPatch;
use crate::geometry::{Outline, Plane};
use crate::numeric::{parallel_map, tolerance};
use glam::DVec3;
use std::collections::HashMap;

/// A plane and the heights between which the corners in it lie.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SharedPlane {
    pub plane: Plane,
    pub low: f64,
    pub high: f64,
}

impl SharedPlane {
    /// Can what lies in this plane enter a body that reaches between these heights over it?
    pub fn is_crossed_by(&self, [low, high]: [f64; 2], noise: f64) -> bool {
        self.high - low > noise && high - self.low > noise
    }

    /// Least and largest height over this plane.
    pub fn range(&self, points: impl IntoIterator<Item = DVec3>) -> [f64; 2] {
        let heights = points.into_iter().map(|point| self.plane.height(point));
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| {
            [low.min(height), high.max(height)]
        })
    }
}

/// The patches of a scene and what only obstructs, with their planes.
#[derive(Debug)]
pub(super) struct Arrangement<'a> {
    /// The patches, then the obstructions.
    pub surfaces: Vec<&'a NamedPatch>,
    /// How many of them are patches.
    pub patches: usize,
    /// The power of two by which coordinates are divided.
    pub unit: f64,
    /// In units of `unit`.
    pub noise: f64,
    /// Each plane once, whichever way the surfaces in it face.
    pub planes: Vec<SharedPlane>,
    /// The plane of each surface, and whether it faces as the plane does.
    pub places: Vec<(usize, bool)>,
}

impl<'a> Arrangement<'a> {
    pub fn new(patches: &'a [NamedPatch], obstructions: &'a [NamedPatch]) -> Self {
        let surfaces: Vec<&NamedPatch> = patches.iter().chain(obstructions).collect();
        let largest = surfaces
            .iter()
            .flat_map(|surface| surface.shape.corners())
            .map(|corner| corner.abs().max_element())
            .fold(0.0, f64::max);
        // at most 2 after division; a patch has an area, so that something is not 0
        let unit = largest.log2().floor().exp2();
        let own = parallel_map(surfaces.len(), &|surface| {
            own_plane(surfaces[surface], unit)
        });
        let deviation = own.iter().map(|own| own.high).fold(0.0, f64::max);
        let noise =
            tolerance::TOUCHING * (largest / unit) + tolerance::DEPTH_PER_DEVIATION * deviation;
        let mut arrangement = Self {
            places: vec![(0, true); surfaces.len()],
            patches: patches.len(),
            planes: Vec::new(),
            surfaces,
            unit,
            noise,
        };
        arrangement.share(own);
        arrangement
    }

    /// The corners of a surface, in units of `unit`.
    pub fn corners(&self, surface: usize) -> impl Iterator<Item = DVec3> {
        let corners = self.surfaces[surface].shape.corners().iter();
        corners.map(|corner| *corner / self.unit)
    }

    /// The plane of a surface, facing as it does.
    pub fn plane(&self, surface: usize) -> Plane {
        let (plane, along) = self.places[surface];
        let plane = self.planes[plane].plane;
        if along { plane } else { plane.reversed() }
    }

    /// A surface as convex pieces in its plane.
    pub fn outline(&self, surface: usize) -> Outline {
        Outline::new(
            &self.surfaces[surface].shape,
            self.unit,
            self.plane(surface),
        )
    }

    /// For each plane: are there patches on both sides of it, so that what lies in it can be between two?
    pub fn splits(&self) -> Vec<bool> {
        let mut corners: Vec<DVec3> = (0..self.patches).flat_map(|p| self.corners(p)).collect();
        if self.planes.len() > FEW_PLANES {
            corners.sort_unstable_by_key(|corner| corner.to_array().map(f64::to_bits));
            corners.dedup();
        }
        parallel_map(self.planes.len(), &|plane| {
            let shared = &self.planes[plane];
            let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
            corners.chunks(CORNERS_AT_ONCE).any(|corners| {
                let [least, most] = shared.range(corners.iter().copied());
                (low, high) = (low.min(least), high.max(most));
                shared.is_crossed_by([low, high], self.noise)
            })
        })
    }

    /// Gathers surfaces in planes: first roughly, by rounded normals and distances, then within noise. Surfaces that lie in
    /// one plane but are not gathered only cost time.
    fn share(&mut self, own: Vec<SharedPlane>) {
        let mut rough: HashMap<[i64; 4], usize> = HashMap::new();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (surface, SharedPlane { plane, .. }) in own.iter().enumerate() {
            let normal = unoriented(plane.normal);
            let distance = plane.origin.dot(normal);
            #[allow(
                clippy::cast_possible_truncation,
                reason = "numbers up to 4e6, and any rounding serves"
            )]
            let key =
                [normal.x, normal.y, normal.z, distance].map(|x| (x * ROUGHLY).round() as i64);
            let group = *rough.entry(key).or_insert_with(|| {
                groups.push(Vec::new());
                groups.len() - 1
            });
            groups[group].push(surface);
        }
        for members in groups {
            let corners = || members.iter().flat_map(|member| self.corners(*member));
            let shared = if members.len() > 1 {
                through_far_corners(corners).filter(|shared| shared.high - shared.low <= self.noise)
            } else {
                None
            };
            if let Some(shared) = shared {
                for member in members {
                    let along = own[member].plane.normal.dot(shared.plane.normal) > 0.0;
                    self.places[member] = (self.planes.len(), along);
                }
                self.planes.push(shared);
            } else {
                for member in members {
                    self.places[member] = (self.planes.len(), true);
                    self.planes.push(own[member].clone());
                }
            }
        }
    }
}

/// Up to here it does not pay to look for equal corners.
const FEW_PLANES: usize = 64;

/// A plane with corners on both sides is found out after this many.
const CORNERS_AT_ONCE: usize = 64;

/// Planes that agree to six digits are tried as one.
const ROUGHLY: f64 = 1e6;

/// A surface's plane through the middle of its corners' heights.
fn own_plane(surface: &NamedPatch, unit: f64) -> SharedPlane {
    let corners = surface.shape.corners().iter().map(|corner| *corner / unit);
    let plane = Plane {
        normal: surface.shape.normal(),
        origin: surface.shape.corners()[0] / unit,
    };
    centred(plane, corners)
}

fn centred(plane: Plane, corners: impl Iterator<Item = DVec3>) -> SharedPlane {
    let mut shared = SharedPlane {
        plane,
        low: 0.0,
        high: 0.0,
    };
    let [low, high] = shared.range(corners);
    let half = 0.5 * (high - low);
    shared.plane.origin += 0.5 * (low + high) * plane.normal;
    (shared.low, shared.high) = (-half, half);
    shared
}

/// The plane through a corner, the one farthest from it, and the one farthest from the line through both.
fn through_far_corners<C: Iterator<Item = DVec3>>(corners: impl Fn() -> C) -> Option<SharedPlane> {
    let farthest = |distance: &dyn Fn(DVec3) -> f64| {
        let mut best = (-1.0, DVec3::ZERO);
        for corner in corners() {
            let found = distance(corner);
            if found > best.0 {
                best = (found, corner);
            }
        }
        best.1
    };
    let origin = corners().next()?;
    let along = farthest(&|corner| corner.distance_squared(origin)) - origin;
    let aside = farthest(&|corner| (corner - origin).cross(along).length_squared()) - origin;
    let normal = along.cross(aside).try_normalize()?;
    Some(centred(Plane { normal, origin }, corners()))
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
