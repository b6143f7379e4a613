//! Patches grouped by plane.
//!
//! A patch lies in a plane if none of its corners is farther from it than [`tolerance::ALIGNMENT`]
//! of the largest coordinate, which is rounding of the input, and faces the same way.

use super::NamedPatch;
use crate::numeric::tolerance;
use glam::DVec3;
use std::collections::HashMap;

/// Two normals or positions nearer than this are looked at together; only how many planes are
/// compared depends on it.
const BUCKETS: f64 = 1_099_511_627_776.0; // 2⁴⁰

/// The planes of a scene.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Planes {
    /// The plane of each patch.
    of: Vec<u32>,
    /// The patches of each plane, in order.
    members: Vec<Vec<usize>>,
    planes: Vec<Plane>,
    /// Heights up to this one are rounding.
    noise: f64,
}

#[derive(Debug, Clone, PartialEq)]
struct Plane {
    normal: DVec3,
    origin: DVec3,
}

impl Plane {
    fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.origin)
    }
}

impl Planes {
    /// The planes of patches; a patch whose root is another one lies in that one, and in its plane.
    pub(super) fn of(patches: &[NamedPatch], roots: &[usize]) -> Self {
        let corners = |patch: usize| patches[patch].shape.corners();
        let extent = (0..patches.len())
            .flat_map(corners)
            .map(|corner| corner.abs().max_element())
            .fold(f64::MIN_POSITIVE, f64::max);
        let flat = tolerance::ALIGNMENT * extent;
        let mut planes: Vec<Plane> = Vec::new();
        let mut buckets: HashMap<[i64; 4], Vec<usize>> = HashMap::new();
        let mut of = vec![u32::MAX; patches.len()];
        for (patch, named) in patches.iter().enumerate() {
            if roots[patch] != patch {
                continue;
            }
            let normal = named.shape.normal();
            let origin = corners(patch)[0];
            let distance = normal.dot(origin) / extent;
            #[allow(clippy::cast_possible_truncation, reason = "at most 2 · 2⁴⁰")]
            let bucket = [normal.x, normal.y, normal.z, distance]
                .map(|number| (number * BUCKETS).round() as i64);
            let known = buckets.entry(bucket).or_default();
            let is_in = |plane: &usize| {
                let plane = &planes[*plane];
                let in_plane = |corner: &DVec3| plane.height(*corner).abs() <= flat;
                normal.dot(plane.normal) > 0.0 && corners(patch).iter().all(in_plane)
            };
            let plane = if let Some(plane) = known.iter().copied().find(is_in) {
                plane
            } else {
                known.push(planes.len());
                planes.push(Plane { normal, origin });
                planes.len() - 1
            };
            of[patch] = u32::try_from(plane).unwrap_or(u32::MAX);
        }
        let mut members = vec![Vec::new(); planes.len()];
        for patch in 0..patches.len() {
            of[patch] = of[roots[patch]];
            members[of[patch] as usize].push(patch);
        }
        Self {
            of,
            members,
            planes,
            noise: flat,
        }
    }

    pub(super) const fn count(&self) -> usize {
        self.members.len()
    }

    pub(super) fn of_patch(&self, patch: usize) -> usize {
        self.of[patch] as usize
    }

    /// The patches of a plane, in order.
    pub(super) fn patches(&self, plane: usize) -> &[usize] {
        &self.members[plane]
    }

    /// The height of a point over a plane.
    pub(super) fn height(&self, plane: usize, point: DVec3) -> f64 {
        self.planes[plane].height(point)
    }

    /// The height up to which a point may be in a plane.
    pub(super) const fn noise(&self) -> f64 {
        self.noise
    }
}
