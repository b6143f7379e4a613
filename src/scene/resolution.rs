//! The resolution of a scene: the length below which its coordinates say nothing.
//!
//! ```text
//!   r                      every coordinate is right to ± r
//!   δ = √3 r               so a corner is off by δ at most
//!   noise = 8 δ            what reaches over, behind or into something by less counts as touching
//!   plane: within 4 δ      corners of one plane lie between two planes so far apart
//! ```
//!
//! Scenes made in a program, and the built-in ones, are exact: r = 0. A file gives a candidate, half
//! a unit of its last decimal; but decimals are no proof of rounding, as a cube with corners 0 and 1
//! has none. So the scene asks whether anything *misses* on that scale:
//!
//! ```text
//!   a face    is bent                         beyond the rounding of f64
//!   a plane   is left by surfaces in it       that are not exactly parallel
//!   a corner  lies beside an edge             that runs along none of its own edges exactly, nor
//!                                             ends short of the corner in its own direction
//! ```
//!
//! If nothing does, the scene is exact, whatever its decimals. Gaps between exactly parallel planes
//! or edges are no misses: a plate 1e-6 above a wall was put there. The resolution is never larger
//! than a small part of the narrowest surface ([`tolerance::RESOLVED`]).
//!
//! All that is judged by comparing coordinates is judged on this scale: planes, overlap, blockers,
//! convex rooms, parts of a base. The coordinates stay as they are. What their inaccuracy can change
//! of an exchange area is a bound of its own ([`ScenePairs::resolution_error`]).
//!
//! **Not covered**: resolutions that differ from surface to surface.
//!
//! [`ScenePairs::resolution_error`]: crate::exchange::ScenePairs::resolution_error

use super::planes::ScenePlanes;
use super::visibility::surfaces::Prepared;
use super::{NamedPatch, Scene, SceneError};
use crate::geometry::Patch;
use crate::numeric::tolerance;
use glam::DVec3;
use rstar::primitives::{GeomWithData, Line};
use rstar::{PointDistance, RTree};
use std::fmt;

/// The largest resolution, relative to the width of the narrowest surface, that a refusal names as
/// its mend: what is off by more was put there.
const LARGEST_MEND: f64 = 1e-3;

impl Scene {
    /// The length by which each coordinate may be off; 0 if they are exact.
    #[must_use]
    pub const fn resolution(&self) -> f64 {
        self.resolution
    }

    /// The scene with coordinates that are known to ± `resolution`; 0 takes them as exact.
    ///
    /// # Errors
    /// [`SceneError::Resolution`] unless it is a number ≥ 0, far enough below the width of every
    /// surface for the noise to be below it.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let cube = Scene::built_in("cube:2")?;
    /// assert_eq!(cube.resolution(), 0.0);
    /// assert_eq!(cube.clone().with_resolution(1e-6)?.resolution(), 1e-6);
    /// assert!(cube.with_resolution(0.5).is_err());
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn with_resolution(self, resolution: f64) -> Result<Self, SceneError> {
        let width = self.narrowest();
        let largest = width / tolerance::RESOLVED_NOISE;
        if !(resolution >= 0.0 && resolution < largest) {
            return Err(SceneError::Resolution {
                resolution,
                largest,
            });
        }
        Ok(self.resolved(resolution))
    }

    fn resolved(mut self, resolution: f64) -> Self {
        if resolution > 0.0 {
            for surface in self.patches.iter_mut().chain(&mut self.obstructions) {
                surface.shape.flatten(resolution);
            }
        }
        Self {
            resolution,
            prepared: Prepared::default(),
            ..self
        }
    }

    /// The scene whose coordinates were written with so much as half a unit in the last place: they
    /// are known to that if surfaces miss each other on this scale, else they are exact.
    pub(crate) fn with_last_place(self, half_unit: f64) -> Self {
        let width = self.narrowest();
        let candidate = half_unit.min(tolerance::RESOLVED * width);
        if self.surfaces().any(|surface| surface.shape().moved() > 0.0) {
            return self.resolved(candidate);
        }
        let rounding = self.rounding();
        // coordinates too coarse for the surfaces were not rounded to them
        if candidate <= rounding || half_unit >= width / tolerance::RESOLVED_NOISE {
            return self;
        }
        let is_bent = |surface: &NamedPatch| surface.shape().bend() > rounding;
        let is_bent = self.surfaces().any(is_bent);
        let resolved = self.clone().resolved(candidate);
        if is_bent || resolved.planes_miss(rounding) || self.corners_miss(2.0 * candidate, rounding) {
            resolved
        } else {
            self
        }
    }

    /// The smallest width of a surface.
    fn narrowest(&self) -> f64 {
        let widths = self.surfaces().map(|surface| surface.shape().width());
        // what has no area has no plane to miss
        widths.filter(|width| *width > 0.0).fold(f64::INFINITY, f64::min)
    }

    /// The length that roundings of `f64` explain.
    fn rounding(&self) -> f64 {
        let corners = self.surfaces().flat_map(|surface| surface.shape().corners());
        let sizes = corners.map(|corner| corner.abs().max_element());
        tolerance::TOUCHING * sizes.fold(0.0, f64::max)
    }

    /// Whether surfaces lie in one plane at this resolution that are neither in one to the last bit
    /// nor exactly parallel.
    fn planes_miss(&self, rounding: f64) -> bool {
        let planes: &ScenePlanes = self.planes();
        let unit = planes.unit();
        let mut first: Vec<Option<&NamedPatch>> = vec![None; planes.planes().len()];
        for (index, surface) in self.surfaces().enumerate() {
            let plane = planes.plane_of(index).plane;
            if planes.planes()[plane].thickness() * unit <= rounding {
                continue;
            }
            let Some(other) = first[plane] else {
                first[plane] = Some(surface);
                continue;
            };
            let [one, two] = [surface.shape(), other.shape()];
            let sine = one.normal().cross(two.normal()).length();
            if sine > rounding / one.width().min(two.width()) {
                return true;
            }
        }
        false
    }

    /// Whether a corner lies beside an edge or a corner of another surface, off it by more than
    /// rounding and less than corners can be that are both off, and no edge there is parallel.
    fn corners_miss(&self, off: f64, rounding: f64) -> bool {
        let nearby = tolerance::SQRT_3 * off;
        let edges = Edges::of(self.surfaces().map(|surface| surface.shape()));
        self.surfaces().enumerate().any(|(index, surface)| {
            let corners = surface.shape().given_corners();
            let n = corners.len();
            (0..n).any(|place| {
                let corner = corners[place];
                let own = [n - 1, 1].map(|step| corners[(place + step) % n] - corner);
                edges.near(corner, index, nearby).any(|edge| {
                    edge.distance > rounding && !edge.was_meant(corner, own, rounding)
                })
            })
        })
    }

    /// A resolution at which a condition holds that does not hold now, if one would do that is far
    /// below the width of every surface: the smallest of those tried, each a quarter of the one
    /// before.
    pub(crate) fn mending_resolution(&self, holds: impl Fn(&Self) -> bool) -> Option<f64> {
        let mends = |resolution: f64| holds(&self.clone().resolved(resolution));
        let mut found = None;
        let mut next = LARGEST_MEND * self.narrowest();
        while next > self.rounding().max(self.resolution) && mends(next) {
            found = Some(next);
            next *= 0.25;
        }
        found
    }

    /// The surfaces that this resolution takes as bent, coplanar or touching, counted; `None` if
    /// coordinates are exact.
    #[must_use]
    pub fn resolved_surfaces(&self) -> Option<ResolvedSurfaces> {
        if self.resolution <= 0.0 {
            return None;
        }
        let (planes, rounding) = (self.planes(), self.rounding());
        let is_thick = |surface: &usize| {
            let shared = &planes.planes()[planes.plane_of(*surface).plane];
            shared.thickness() * planes.unit() > rounding
        };
        let misses = self.joints().into_iter().flatten();
        Some(ResolvedSurfaces {
            length: self.resolution,
            bent: self
                .surfaces()
                .filter(|surface| surface.shape().moved() > rounding)
                .count(),
            coplanar: (0..self.surfaces().count()).filter(is_thick).count(),
            touching: misses.filter(|joint| joint.aside > rounding).count(),
        })
    }

    /// The joints at the corners of each patch.
    fn joints(&self) -> Vec<Vec<Joint>> {
        let nearby = tolerance::BEND * self.resolution;
        let shapes = || self.patches.iter().map(NamedPatch::shape);
        let edges = Edges::of(shapes());
        let joint = |index: usize, corner: DVec3| {
            let near: Vec<NearEdge> = edges.near(corner, index, nearby).collect();
            let distances = near.iter().map(|edge| edge.distance);
            let aside = distances.fold(f64::INFINITY, f64::min);
            Joint {
                aside: if near.is_empty() { 0.0 } else { aside },
                near,
            }
        };
        let of_patch = |(index, shape): (usize, &Patch)| {
            let corners = shape.given_corners().iter();
            corners.map(|corner| joint(index, *corner)).collect()
        };
        shapes().enumerate().map(of_patch).collect()
    }

    /// The widths of the cracks along the edges of each patch: what its corners lie off the edges
    /// beside them and off the plane that the patch shares, what other corners lie off the edge, and
    /// what the patch was moved by when it was put flat. Corners farther off than a plane explains
    /// ([`tolerance::BEND`]) leave a gap, and no crack.
    pub(crate) fn cracks(&self) -> Vec<Vec<f64>> {
        let (planes, joints) = (self.planes(), self.joints());
        let shapes = || self.patches.iter().map(NamedPatch::shape);
        let none = |shape: &Patch| vec![0.0_f64; shape.corners().len()];
        let mut widths: Vec<Vec<f64>> = shapes().map(none).collect();
        for (shape, joints) in shapes().zip(&joints) {
            for (corner, joint) in shape.given_corners().iter().zip(joints) {
                // a corner at the end of an edge is no joint of it
                let beside = joint.near.iter().filter(|edge| !edge.ends.contains(corner));
                for edge in beside {
                    let width = &mut widths[edge.surface][edge.place];
                    *width = width.max(edge.distance);
                }
            }
        }
        for (index, (shape, joints)) in shapes().zip(&joints).enumerate() {
            let (shared, unit) = (planes.facing(index), planes.unit());
            let corners = shape.given_corners().iter().zip(shape.corners());
            let off = corners.zip(joints).map(|((given, flat), joint)| {
                let height = unit * shared.height(*flat / unit).abs();
                given.distance(*flat) + height + joint.aside
            });
            let off: Vec<f64> = off.collect();
            for (place, width) in widths[index].iter_mut().enumerate() {
                *width += off[place].max(off[(place + 1) % off.len()]);
            }
        }
        widths
    }
}

/// Surfaces that a resolution takes as bent, coplanar or touching.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ResolvedSurfaces {
    /// The length by which each coordinate may be off.
    pub length: f64,
    /// The number of surfaces that are bent, and count as plane.
    pub bent: usize,
    /// The number of surfaces that count as lying in one plane with others, which they leave.
    pub coplanar: usize,
    /// The number of corners that count as lying on an edge or a corner beside them.
    pub touching: usize,
}

impl fmt::Display for ResolvedSurfaces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            length,
            bent,
            coplanar,
            touching,
        } = self;
        write!(
            f,
            "coordinates are taken as ± {length:e}: {bent} bent surfaces count as plane, {coplanar} as \
             lying in a plane with others, {touching} corners as lying on the edges beside them; a \
             resolution of 0 takes them as exact"
        )
    }
}

/// A corner of a patch, and the edges of others that it lies beside.
struct Joint {
    near: Vec<NearEdge>,
    /// The distance of the nearest; 0 if none is near.
    aside: f64,
}

/// The edges of surfaces, by place.
struct Edges(RTree<GeomWithData<Line<[f64; 3]>, [usize; 2]>>);

/// An edge near a point.
struct NearEdge {
    surface: usize,
    /// The place of the edge among those of the surface.
    place: usize,
    ends: [DVec3; 2],
    distance: f64,
}

impl NearEdge {
    /// Whether the distance of a corner with these edges is that of exactly parallel edges, or the
    /// corner would come to lie on the edge if one of the two were longer or shorter.
    fn was_meant(&self, corner: DVec3, own: [DVec3; 2], rounding: f64) -> bool {
        let [from, to] = self.ends;
        let along = to - from;
        let share = (corner - from).dot(along) / along.length_squared();
        let offset = corner - (from + along * share.clamp(0.0, 1.0));
        let are_parallel = |one: DVec3, two: DVec3| {
            let [one_length, two_length] = [one.length(), two.length()];
            let sine = one.cross(two).length() / (one_length * two_length);
            sine * one_length.min(two_length) <= rounding
        };
        own.iter().any(|own| are_parallel(*own, along) || are_parallel(*own, offset))
            || are_parallel(along, offset)
    }
}

impl Edges {
    fn of<'s>(shapes: impl Iterator<Item = &'s Patch>) -> Self {
        let edges = shapes.enumerate().flat_map(|(index, shape)| {
            let corners = shape.given_corners();
            let next = corners.iter().cycle().skip(1);
            let ends = corners.iter().zip(next).enumerate();
            ends.map(move |(place, (from, to))| {
                GeomWithData::new(Line::new(from.to_array(), to.to_array()), [index, place])
            })
        });
        Self(RTree::bulk_load(edges.collect()))
    }

    /// The edges of other surfaces within a distance of a point.
    fn near(&self, point: DVec3, own: usize, distance: f64) -> impl Iterator<Item = NearEdge> + '_ {
        let near = self.0.locate_within_distance(point.to_array(), distance * distance);
        let near = near.filter(move |edge| edge.data[0] != own);
        near.map(move |edge| NearEdge {
            surface: edge.data[0],
            place: edge.data[1],
            ends: [edge.geom().from, edge.geom().to].map(DVec3::from_array),
            distance: edge.geom().distance_2(&point.to_array()).sqrt(),
        })
    }
}
