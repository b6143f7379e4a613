//! Neighbours in one plane joined into polygons, as undoing a triangulation takes.
//!
//! ```text
//!   two patches are joined if   they share an edge, which runs in opposite ways in both,
//!                               all corners lie in one plane, and the fronts on the same side,
//!                               they have the same material and are pieces of the same object,
//!                               and what they make up together is a simple polygon
//! ```
//!
//! A region grows from its largest patch. Its outline is kept as a ring of corners; a neighbour
//! joins if it meets the ring along one chain of edges and at no other corner. So a region without
//! an opening ends as one polygon (a triangulation of a disc can be put together in any order:
//! Danaraj and Klee 1978), and one with openings as several, none of which has any. Corners count
//! as shared only if they are equal; on an outline, those that are straight are left out.
//!
//! Form factors of the polygons are what those of their pieces add up to (additivity).
//!
//! **Not covered**: patches that lie in another one or have others lying in them, rows that are
//! summed, and obstructions: all stay as they are.
//!
//! # Source
//! Danaraj, Klee, "Which spheres are shellable?", *Annals of Discrete Mathematics* 2 (1978), 33–52.

use super::{NamedPatch, Scene, SceneError};
use crate::geometry::Patch;
use crate::numeric::tolerance;
use glam::DVec3;
use std::collections::{HashMap, VecDeque};

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
        let mesh = Mesh::of(self);
        let mut is_taken = vec![false; self.patches.len()];
        for seed in mesh.by_size() {
            if is_taken[seed] {
                continue;
            }
            let region = Region::grown(&mesh, seed, &mut is_taken);
            match region.polygon(&mesh) {
                Some(shape) => parts.push((region.members, shape)),
                None => {
                    let alone = region.members.into_iter();
                    parts.extend(alone.map(|index| (vec![index], mesh.shape(index).clone())));
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
}

/// The patches of a scene by the numbers of their corners.
struct Mesh<'s> {
    scene: &'s Scene,
    points: Vec<DVec3>,
    /// The corners of each patch.
    outlines: Vec<Vec<usize>>,
    /// The patch that runs along an edge.
    edges: HashMap<[usize; 2], usize>,
    /// Whether each patch may be joined with others.
    is_free: Vec<bool>,
}

impl<'s> Mesh<'s> {
    fn of(scene: &'s Scene) -> Self {
        let mut numbers = HashMap::new();
        let mut points = Vec::new();
        let outlines = scene.patches.iter().map(|patch| {
            let corners = patch.shape.given_corners().iter().map(|corner| {
                // zero has no sign here
                let key = (*corner + DVec3::ZERO).to_array().map(f64::to_bits);
                *numbers.entry(key).or_insert_with(|| {
                    points.push(*corner);
                    points.len() - 1
                })
            });
            corners.collect()
        });
        let outlines: Vec<Vec<usize>> = outlines.collect();
        let mut edges = HashMap::new();
        for (index, outline) in outlines.iter().enumerate() {
            for edge in ring(outline) {
                edges.entry(edge).or_insert(index);
            }
        }
        Self {
            is_free: free(scene),
            scene,
            points,
            outlines,
            edges,
        }
    }

    fn shape(&self, patch: usize) -> &'s Patch {
        &self.scene.patches[patch].shape
    }

    /// The patches, the largest first: its plane is the best known.
    fn by_size(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.outlines.len()).collect();
        let area = |index: &usize| self.shape(*index).area();
        order.sort_by(|one, other| area(other).total_cmp(&area(one)));
        order
    }

    /// Whether a patch continues another one: in its plane, of the same stuff.
    fn continues(&self, seed: usize, other: usize) -> bool {
        let [one, two] = [seed, other].map(|index| &self.scene.patches[index]);
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
        let allowed = allowed.max(self.scene.part_noise());
        let height = |corner: &DVec3| (*corner - origin).dot(plane.normal()).abs();
        two.shape.normal().dot(plane.normal()) > 0.0
            && corners.iter().all(|corner| height(corner) <= allowed)
    }
}

/// The edges of an outline.
fn ring(outline: &[usize]) -> impl Iterator<Item = [usize; 2]> + '_ {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(from, to)| [*from, *to])
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

/// Patches that make up a simple polygon.
struct Region {
    /// In the order of their indices.
    members: Vec<usize>,
    /// The corner after each one, around the region.
    next: HashMap<usize, usize>,
}

impl Region {
    /// The region of a seed and of all that may join it; its members are taken.
    fn grown(mesh: &Mesh<'_>, seed: usize, is_taken: &mut [bool]) -> Self {
        let mut region = Self {
            members: vec![seed],
            next: ring(&mesh.outlines[seed])
                .map(|[from, to]| (from, to))
                .collect(),
        };
        is_taken[seed] = true;
        let neighbours = |patch: usize| {
            let edges = ring(&mesh.outlines[patch]);
            edges.filter_map(|[from, to]| mesh.edges.get(&[to, from]).copied())
        };
        let mut open: VecDeque<usize> = VecDeque::new();
        if mesh.is_free[seed] {
            open.extend(neighbours(seed));
        }
        while let Some(patch) = open.pop_front() {
            let may_join = mesh.is_free[patch] && !is_taken[patch] && mesh.continues(seed, patch);
            // one that does not fit yet comes back with its next neighbour
            if may_join && region.join(&mesh.outlines[patch]) {
                is_taken[patch] = true;
                region.members.push(patch);
                open.extend(neighbours(patch));
            }
        }
        region.members.sort_unstable();
        region
    }

    /// Adds an outline if it meets the ring along one chain of edges and nowhere else.
    fn join(&mut self, outline: &[usize]) -> bool {
        let is_shared = |[from, to]: [usize; 2]| self.next.get(&to) == Some(&from);
        let shared: Vec<bool> = ring(outline).map(is_shared).collect();
        let n = shared.len();
        let begins = (0..n).filter(|place| shared[*place] && !shared[(place + n - 1) % n]);
        if begins.count() != 1 {
            return false;
        }
        let on_chain = |place: usize| shared[place] || shared[(place + n - 1) % n];
        let on_ring = |place: usize| self.next.contains_key(&outline[place]);
        if (0..n).any(|place| on_ring(place) && !on_chain(place)) {
            return false;
        }
        for place in (0..n).filter(|place| shared[*place] && shared[(place + n - 1) % n]) {
            self.next.remove(&outline[place]);
        }
        for (edge, _) in ring(outline).zip(shared).filter(|(_, shared)| !shared) {
            self.next.insert(edge[0], edge[1]);
        }
        true
    }

    /// The polygon of the region, from the first corner of its first member that is on the ring.
    fn polygon(&self, mesh: &Mesh<'_>) -> Option<Patch> {
        if let [alone] = self.members[..] {
            return Some(mesh.shape(alone).clone());
        }
        let mut corners = self.members.iter().flat_map(|patch| &mesh.outlines[*patch]);
        let first = *corners.find(|corner| self.next.contains_key(corner))?;
        let mut outline = vec![mesh.points[first]];
        let mut corner = *self.next.get(&first)?;
        while corner != first {
            outline.push(mesh.points[corner]);
            corner = *self.next.get(&corner)?;
        }
        Patch::within(without_straight_corners(&outline), mesh.scene.resolution).ok()
    }
}

/// The outline without corners that are straight to within the rounding of coordinates.
fn without_straight_corners(outline: &[DVec3]) -> Vec<DVec3> {
    let sizes = outline.iter().map(|corner| corner.abs().max_element());
    let rounding = tolerance::ALIGNMENT * sizes.fold(0.0, f64::max);
    let is_straight = |[a, b, c]: [DVec3; 3]| {
        let along = c - a;
        let height = (b - a).cross(along).length();
        height <= rounding * along.length() && (b - a).dot(c - b) > 0.0
    };
    let mut kept: Vec<DVec3> = Vec::with_capacity(outline.len());
    for (place, corner) in outline.iter().enumerate() {
        let next = outline[(place + 1) % outline.len()];
        let before = kept.last().or(outline.last());
        if before.is_none_or(|before| !is_straight([*before, *corner, next])) {
            kept.push(*corner);
        }
    }
    kept
}
