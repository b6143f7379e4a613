//! Outlines that share edges, put together to simple polygons.
//!
//! ```text
//!   two outlines may be put together if they share an edge, which runs in opposite ways in both
//! ```
//!
//! A region grows from a seed. Its outline is kept as a ring of corners; a neighbour joins if it
//! meets the ring along one chain of edges and at no other corner. So a region without an opening
//! ends as one polygon (a triangulation of a disc can be put together in any order: Danaraj and
//! Klee 1978), and one with openings as several, none of which has any. Corners count as shared
//! only if they are equal; on an outline, those that are straight are left out.
//!
//! **Not covered**: what may be put together, which the caller decides; corners in the middle of
//! another outline's edge.
//!
//! # Source
//! Danaraj, Klee, "Which spheres are shellable?", *Annals of Discrete Mathematics* 2 (1978), 33–52.

use crate::numeric::tolerance;
use glam::DVec3;
use std::collections::{HashMap, VecDeque};

/// Outlines by the numbers of their corners.
pub(super) struct Mesh {
    points: Vec<DVec3>,
    /// The corners of each outline.
    outlines: Vec<Vec<usize>>,
    /// The outline that runs along an edge.
    edges: HashMap<[usize; 2], usize>,
}

impl Mesh {
    pub(super) fn of<'c>(outlines: impl Iterator<Item = &'c [DVec3]>) -> Self {
        let mut numbers = HashMap::new();
        let mut points = Vec::new();
        let outlines = outlines.map(|corners| {
            let corners = corners.iter().map(|corner| {
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
            points,
            outlines,
            edges,
        }
    }

    fn neighbours(&self, outline: usize) -> impl Iterator<Item = usize> {
        let edges = ring(&self.outlines[outline]);
        edges.filter_map(|[from, to]| self.edges.get(&[to, from]).copied())
    }
}

/// The edges of an outline.
fn ring(outline: &[usize]) -> impl Iterator<Item = [usize; 2]> + '_ {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(from, to)| [*from, *to])
}

/// Outlines that make up a simple polygon.
pub(super) struct Region {
    /// The outlines, in the order of their indices.
    pub(super) members: Vec<usize>,
    /// The corner after each one, around the region.
    next: HashMap<usize, usize>,
}

impl Region {
    /// The region of a seed and of all that may join it; its members are taken.
    pub(super) fn grown(
        mesh: &Mesh,
        seed: usize,
        is_taken: &mut [bool],
        may_join: impl Fn(usize) -> bool,
    ) -> Self {
        let mut region = Self {
            members: vec![seed],
            next: ring(&mesh.outlines[seed])
                .map(|[from, to]| (from, to))
                .collect(),
        };
        is_taken[seed] = true;
        let mut open: VecDeque<usize> = VecDeque::new();
        if may_join(seed) {
            open.extend(mesh.neighbours(seed));
        }
        while let Some(next) = open.pop_front() {
            let may_join = !is_taken[next] && may_join(next);
            // one that does not fit yet comes back with its next neighbour
            if may_join && region.join(&mesh.outlines[next]) {
                is_taken[next] = true;
                region.members.push(next);
                open.extend(mesh.neighbours(next));
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

    /// The corners of the region in order, from the first corner of its first member that is on the
    /// ring, without those that are straight.
    pub(super) fn corners(&self, mesh: &Mesh) -> Option<Vec<DVec3>> {
        let mut corners = self
            .members
            .iter()
            .flat_map(|member| &mesh.outlines[*member]);
        let first = *corners.find(|corner| self.next.contains_key(corner))?;
        let mut outline = vec![mesh.points[first]];
        let mut corner = *self.next.get(&first)?;
        while corner != first {
            outline.push(mesh.points[corner]);
            corner = *self.next.get(&corner)?;
        }
        Some(without_straight_corners(&outline))
    }
}

/// The outline without corners that are straight to within the rounding of coordinates.
pub(super) fn without_straight_corners(outline: &[DVec3]) -> Vec<DVec3> {
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
