//! Patches grouped by plane, and planes that see nothing of each other.
//!
//! ```text
//!   h is in front of g   ⇔   some corner of h has n_g · (x − o_g) > 16 ε · extent
//! ```
//!
//! If h is not in front of g, or g not in front of h, no patch of one exchanges anything with a patch of the other:
//! all their pairs are left out without a look at any of them. Heights up to [`tolerance::ALIGNMENT`] of the largest
//! coordinate are rounding of the input.
//!
//! **Not covered**: more than [`MOST_PLANES`] planes; then only pairs in one plane are left out here.

use super::NamedPatch;
use crate::numeric::tolerance;
use glam::DVec3;
use std::collections::HashMap;

/// Up to so many planes all pairs of them are compared: the table takes their square in bytes.
pub(super) const MOST_PLANES: usize = 2048;

/// Two normals or positions nearer than this are looked at together; only how many planes are compared depends on it.
const BUCKETS: f64 = 1_099_511_627_776.0; // 2⁴⁰

/// What the patches of two planes can exchange.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sight {
    /// It takes a look at the pairs.
    Open,
    /// Nothing: both lie in one plane.
    Coplanar,
    /// Nothing: one lies behind the other.
    BackFacing,
}

/// The planes of a scene.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Planes {
    /// The plane of each patch.
    of: Vec<u32>,
    /// The patches of each plane, in order.
    members: Vec<Vec<usize>>,
    /// `sight[g · planes + h]`; empty beyond [`MOST_PLANES`].
    sight: Vec<Sight>,
}

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
        let sight = if planes.len() <= MOST_PLANES {
            // what lies in a patch is in front of nothing that the patch is not in front of
            let whole = |patch: usize| {
                let is_whole = roots[patch] == patch;
                if is_whole { corners(patch) } else { &[] }
            };
            compare(&planes, &members, whole, flat)
        } else {
            Vec::new()
        };
        Self { of, members, sight }
    }

    pub(super) const fn count(&self) -> usize {
        self.members.len()
    }

    /// Is it known which planes see nothing of each other?
    pub(super) const fn are_compared(&self) -> bool {
        !self.sight.is_empty()
    }

    pub(super) fn of_patch(&self, patch: usize) -> usize {
        self.of[patch] as usize
    }

    /// What two planes can exchange.
    pub(super) fn sight(&self, first: usize, second: usize) -> Sight {
        if first == second {
            Sight::Coplanar
        } else if self.sight.is_empty() {
            Sight::Open
        } else {
            self.sight[first * self.count() + second]
        }
    }

    /// Numbers of pairs left out: in one plane, behind each other.
    pub(super) fn pairs_left_out(&self) -> [usize; 2] {
        let mut left_out = [0, 0];
        for (first, patches) in self.members.iter().enumerate() {
            left_out[0] += patches.len() * (patches.len() - 1) / 2;
            if self.sight.is_empty() {
                continue;
            }
            for (second, others) in self.members.iter().enumerate().skip(first + 1) {
                let pairs = patches.len() * others.len();
                match self.sight(first, second) {
                    Sight::Open => {}
                    Sight::Coplanar => left_out[0] += pairs,
                    Sight::BackFacing => left_out[1] += pairs,
                }
            }
        }
        left_out
    }
}

/// What each plane can exchange with each other one.
fn compare<'p>(
    planes: &[Plane],
    members: &[Vec<usize>],
    corners: impl Fn(usize) -> &'p [DVec3],
    flat: f64,
) -> Vec<Sight> {
    let count = planes.len();
    // is something of `other` above, or more than rounding off, the plane?
    let any = |plane: &Plane, other: usize, is: fn(f64) -> f64| {
        let all = members[other].iter().flat_map(|patch| corners(*patch));
        all.into_iter()
            .any(|corner| is(plane.height(*corner)) > flat)
    };
    let in_front: Vec<bool> = (0..count * count)
        .map(|pair| any(&planes[pair / count], pair % count, |height| height))
        .collect();
    let sight = |pair: usize| {
        let (first, second) = (pair / count, pair % count);
        if in_front[pair] && in_front[second * count + first] {
            Sight::Open
        } else if any(&planes[first.min(second)], first.max(second), f64::abs) {
            Sight::BackFacing
        } else {
            Sight::Coplanar
        }
    };
    (0..count * count).map(sight).collect()
}
