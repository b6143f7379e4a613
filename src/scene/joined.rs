//! Neighbours in one plane joined into polygons, as undoing a triangulation takes.
//!
//! ```text
//!   two patches are joined if   they share an edge, which runs in opposite ways in both,
//!                               all corners lie in one plane, and the fronts on the same side,
//!                               they have the same material and are pieces of the same object,
//!                               and what they make up together is a simple polygon
//! ```
//!
//! A region grows from its largest patch, as `regions` tells.
//!
//! Form factors of the polygons are what those of their pieces add up to (additivity).
//!
//! **Not covered**: patches that lie in another one or have others lying in them, rows that are
//! summed, and obstructions: all stay as they are.

use super::regions::{Mesh, Region};
use super::{NamedPatch, Scene, SceneError};
use crate::geometry::Patch;
use crate::numeric::tolerance;
use glam::DVec3;

impl Scene {
    /// The scene with neighbours in one plane joined, and for each new patch those that it is made
    /// of, in order. It has the place and the name of the first of them.
    ///
    /// # Errors
    /// [`SceneError`] only if the scene itself is at fault.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let (joined, members) = Scene::built_in("cube:4")?.joined()?;
    /// assert_eq!((joined.patches().len(), members[0].len()), (6, 16));
    /// assert_eq!(joined.patches()[0].shape().corners().len(), 4);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    pub fn joined(&self) -> Result<(Self, Vec<Vec<usize>>), SceneError> {
        let mut parts: Vec<(Vec<usize>, Patch)> = Vec::new();
        let shapes = || self.patches.iter().map(NamedPatch::shape);
        let mesh = Mesh::of(shapes().map(Patch::given_corners));
        let is_free = free(self);
        let mut is_taken = vec![false; self.patches.len()];
        let mut by_size: Vec<usize> = (0..self.patches.len()).collect();
        let area = |index: &usize| self.patches[*index].shape.area();
        // the plane of the largest is best known
        by_size.sort_by(|one, other| area(other).total_cmp(&area(one)));
        for seed in by_size {
            if is_taken[seed] {
                continue;
            }
            let may_join = |other| is_free[other] && self.continues(seed, other);
            let region = Region::grown(&mesh, seed, &mut is_taken, may_join);
            match self.polygon_of(&region, &mesh) {
                Some(shape) => parts.push((region.members, shape)),
                None => {
                    let alone = region.members.into_iter();
                    let shape = |index: usize| self.patches[index].shape.clone();
                    parts.extend(alone.map(|index| (vec![index], shape(index))));
                }
            }
        }
        parts.sort_unstable_by_key(|(members, _)| members[0]);
        let (members, shapes): (Vec<Vec<usize>>, Vec<Patch>) = parts.into_iter().unzip();
        Ok((self.of_members(&members, shapes)?, members))
    }

    /// The scene of these shapes, each in place of its members.
    fn of_members(&self, members: &[Vec<usize>], shapes: Vec<Patch>) -> Result<Self, SceneError> {
        let firsts = || members.iter().map(|members| members[0]);
        let patches = firsts().zip(shapes).map(|(first, shape)| NamedPatch {
            shape,
            ..self.patches[first].clone()
        });
        let rows: Vec<usize> = firsts().map(|first| self.groups[first]).collect();
        let mut kept = rows.clone();
        kept.sort_unstable();
        kept.dedup();
        let mut empty_rows = self.empty_rows.clone();
        for (earlier, empty) in empty_rows.iter_mut().enumerate() {
            empty.row = earlier + kept.partition_point(|row| *row < empty.row);
        }
        // who has a base, or is one, is alone
        let place = |old: usize| members.partition_point(|members| members[0] < old);
        let bases = firsts().map(|first| self.bases[first].map(place)).collect();
        let scene = Self::try_new(patches.collect())?.with_groups(&rows)?;
        Ok(Self {
            bases,
            resolution: self.resolution,
            ..scene.with_empty_rows(empty_rows)?
        }
        .with_obstructions(self.obstructions.clone()))
    }

    /// The polygon of a region.
    fn polygon_of(&self, region: &Region, mesh: &Mesh) -> Option<Patch> {
        if let [alone] = region.members[..] {
            return Some(self.patches[alone].shape.clone());
        }
        Patch::within(region.corners(mesh)?, self.resolution).ok()
    }

    /// Whether a patch continues another one: in its plane, of the same stuff.
    fn continues(&self, seed: usize, other: usize) -> bool {
        let [one, two] = [seed, other].map(|index| &self.patches[index]);
        if one.material != two.material || object(one) != object(two) {
            return false;
        }
        let (plane, corners) = (&one.shape, two.shape.corners());
        let origin = plane.corners()[0];
        let extent = |corners: &[DVec3]| {
            let distances = corners.iter().map(|corner| corner.distance(origin));
            distances.fold(0.0, f64::max)
        };
        let allowed = tolerance::PLANARITY * extent(corners).max(extent(plane.corners()));
        let allowed = allowed.max(self.part_noise());
        let height = |corner: &DVec3| (*corner - origin).dot(plane.normal()).abs();
        two.shape.normal().dot(plane.normal()) > 0.0
            && corners.iter().all(|corner| height(corner) <= allowed)
    }
}

/// The patches that are rows of their own, and neither a base nor in one.
fn free(scene: &Scene) -> Vec<bool> {
    let mut patches_of = vec![0; scene.group_count()];
    for group in &scene.groups {
        patches_of[*group] += 1;
    }
    let groups = scene.groups.iter();
    let mut is_free: Vec<bool> = groups.map(|group| patches_of[*group] == 1).collect();
    for (part, base) in scene.bases.iter().enumerate() {
        if let Some(base) = base {
            is_free[part] = false;
            is_free[*base] = false;
        }
    }
    is_free
}

/// The names of what a patch is a piece of, or its own without the number after it.
fn object(patch: &NamedPatch) -> (&[String], Option<&str>) {
    if !patch.wholes.is_empty() {
        return (&patch.wholes, None);
    }
    let name = patch.name();
    let own = match name.rsplit_once(' ') {
        Some((object, number)) if number.parse::<usize>().is_ok() => object,
        _ => name,
    };
    (&[], Some(own))
}
