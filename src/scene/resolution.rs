//! The resolution of a scene: the length below which its coordinates say nothing.
//!
//! ```text
//!   r                      every coordinate is right to ± r
//!   δ = √3 r               so a corner is off by δ at most
//!   noise = 8 δ            what reaches over, behind or into something by less counts as touching
//!   plane: within 4 δ      corners of one plane lie between two planes so far apart
//! ```
//!
//! Scenes made in a program, and the built-in ones, are exact: r = 0. A file gives a candidate,
//! half a unit of its last decimal; but decimals are no proof of rounding, as a cube with corners 0
//! and 1 has none. So the scene asks whether anything *misses* on that scale:
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
//! convex rooms, parts of a base. The coordinates stay as they are. What their inaccuracy can
//! change of an exchange area is a bound of its own ([`ScenePairs::resolution_error`]).
//!
//! **Not covered**: resolutions that differ from surface to surface.
//!
//! [`ScenePairs::resolution_error`]: crate::exchange::ScenePairs::resolution_error

use super::cracks::EdgeTree;
use super::planes::ScenePlanes;
use super::visibility::surfaces::Prepared;
use super::{NamedPatch, Scene, SceneError};
use crate::numeric::tolerance;
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
        if is_bent || resolved.planes_miss(rounding) || self.corners_miss(2.0 * candidate, rounding)
        {
            resolved
        } else {
            self
        }
    }

    /// The smallest width of a surface.
    fn narrowest(&self) -> f64 {
        let widths = self.surfaces().map(|surface| surface.shape().width());
        // what has no area has no plane to miss
        widths
            .filter(|width| *width > 0.0)
            .fold(f64::INFINITY, f64::min)
    }

    /// The length that roundings of `f64` explain.
    fn rounding(&self) -> f64 {
        let corners = self
            .surfaces()
            .flat_map(|surface| surface.shape().corners());
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
        let edges = EdgeTree::of(self.surfaces().map(|surface| surface.shape()));
        self.surfaces().enumerate().any(|(index, surface)| {
            let corners = surface.shape().given_corners();
            let n = corners.len();
            (0..n).any(|place| {
                let corner = corners[place];
                let own = [n - 1, 1].map(|step| corners[(place + step) % n] - corner);
                edges
                    .near(corner, index, nearby)
                    .any(|edge| edge.distance > rounding && !edge.was_meant(corner, own, rounding))
            })
        })
    }

    /// A resolution at which a condition holds that does not hold now, if one would do that is far
    /// below the width of every surface: four times the smallest of those tried, each a quarter of
    /// the one before.
    pub(crate) fn mending_resolution(&self, holds: impl Fn(&Self) -> bool) -> Option<f64> {
        let mends = |resolution: f64| holds(&self.clone().resolved(resolution));
        let mut found = None;
        let largest = LARGEST_MEND * self.narrowest();
        let mut next = largest;
        while next > self.rounding().max(self.resolution) && mends(next) {
            found = Some(next);
            next *= 0.25;
        }
        // what is no longer in the way may still gape, or be covered twice
        found.map(|least| (4.0 * least).min(largest))
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
        let misses = self.corner_joints().into_iter().flatten();
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
            "coordinates are taken as ± {length:e}: {bent} bent surfaces count as plane, \
             {coplanar} as lying in a plane with others, {touching} corners as lying on the edges \
             beside them; a resolution of 0 takes them as exact"
        )
    }
}
