//! Edges of patches that nothing joins, and neighbours whose fronts disagree.
//!
//! In a room that closes, every stretch of every edge is an edge of another patch, too, and
//! neighbours run along it in opposite ways:
//!
//! ```text
//!   free      stretches of an edge that lie on no edge of another patch
//!   turned    two patches that share a whole edge and run along it the same way, where no third
//!             patch has it: the front of one of them is on the wrong side
//! ```
//!
//! Edges lie on each other where their ends are within the noise of the coordinates
//! ([`ScenePlanes`](super::planes::ScenePlanes)). A free edge is where light escapes, unless the
//! patch stands on another one or ends in the open on purpose.
//!
//! **Not covered**: edges that end on the inside of another patch, which count as free.

use super::Scene;
use super::planes::ScenePlanes;
use glam::DVec3;
use rayon::prelude::*;
use rstar::primitives::{GeomWithData, Rectangle as Box3};
use rstar::{AABB, RTree};

/// A stretch of an edge that no other patch shares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeEdge {
    /// The patch.
    pub patch: usize,
    /// The ends of the stretch, in the unit of the scene.
    pub ends: [DVec3; 2],
}

impl FreeEdge {
    /// The length of the stretch.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }
}

/// The joints of a scene's patches.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Joints {
    /// The stretches of edges that no other patch shares, in the order of the patches.
    pub free: Vec<FreeEdge>,
    /// Neighbours whose fronts disagree, the smaller index first.
    pub turned: Vec<[usize; 2]>,
}

/// An edge of a patch, in units of the scene's planes.
#[derive(Debug, Clone, Copy)]
struct Edge {
    patch: usize,
    from: DVec3,
    to: DVec3,
}

/// The part of an edge, from 0 to 1, along which another one runs, and whether the same way.
struct Shared {
    from: f64,
    to: f64,
    same_way: bool,
    patch: usize,
}

impl Edge {
    fn length(&self) -> f64 {
        self.from.distance(self.to)
    }

    /// The part along which another edge lies within `noise`, if it is longer than that.
    fn shared(&self, other: &Self, noise: f64) -> Option<Shared> {
        let (along, length) = (self.to - self.from, self.length());
        let place = |point: DVec3| (point - self.from).dot(along) / (length * length);
        let [start, end] = [place(other.from), place(other.to)];
        let (from, to) = (start.min(end).max(0.0), start.max(end).min(1.0));
        if (to - from) * length <= noise {
            return None;
        }
        // the other edge at the ends of the stretch: is it as far from this one as noise allows?
        let is_near = |at: f64| {
            let there = other.from.lerp(other.to, (at - start) / (end - start));
            there.distance(self.from.lerp(self.to, at)) <= noise
        };
        (is_near(from) && is_near(to)).then_some(Shared {
            from,
            to,
            same_way: start < end,
            patch: other.patch,
        })
    }
}

type Edges = RTree<GeomWithData<Box3<[f64; 3]>, usize>>;

impl Scene {
    /// Finds the edges that no other patch shares, and neighbours whose fronts disagree.
    ///
    /// **Accuracy** stretches shorter than the noise of the coordinates do not count.
    ///
    /// # Examples
    /// ```
    /// use infoscene::scene::Scene;
    /// let room = Scene::built_in("cube:2")?.joints();
    /// assert!(room.free.is_empty() && room.turned.is_empty());
    /// // two squares with one common edge: six edges are free
    /// assert_eq!(Scene::built_in("two-squares")?.joints().free.len(), 6);
    /// # Ok::<(), infoscene::scene::SceneError>(())
    /// ```
    #[must_use]
    pub fn joints(&self) -> Joints {
        let planes = self.planes();
        let edges = self.edges(planes);
        let noise = 2.0 * planes.noise();
        let boxed = edges.iter().enumerate().map(|(index, edge)| {
            let (low, high) = (edge.from.min(edge.to), edge.from.max(edge.to));
            GeomWithData::new(Box3::from_corners(low.to_array(), high.to_array()), index)
        });
        let tree = Edges::bulk_load(boxed.collect());
        let found: Vec<(Vec<FreeEdge>, Option<[usize; 2]>)> = edges
            .par_iter()
            .map(|edge| {
                let shared = shared(edge, &edges, &tree, noise);
                (
                    free(edge, &shared, noise, planes.unit()),
                    turned(edge, &shared, noise),
                )
            })
            .collect();
        let mut joints = Joints::default();
        for (free, turned) in found {
            joints.free.extend(free);
            joints.turned.extend(turned);
        }
        joints.turned.sort_unstable();
        joints.turned.dedup();
        joints
    }

    fn edges(&self, planes: &ScenePlanes) -> Vec<Edge> {
        let patches = self.patches().iter().enumerate();
        let edges = patches.flat_map(|(patch, named)| {
            let corners = planes.corners(named);
            let next = corners.clone().cycle().skip(1);
            corners
                .zip(next)
                .map(move |(from, to)| Edge { patch, from, to })
        });
        edges.collect()
    }
}

/// The stretches that other patches share, from one end to the other.
fn shared(edge: &Edge, edges: &[Edge], tree: &Edges, noise: f64) -> Vec<Shared> {
    let (low, high) = (
        edge.from.min(edge.to) - noise,
        edge.from.max(edge.to) + noise,
    );
    let near =
        tree.locate_in_envelope_intersecting(AABB::from_corners(low.to_array(), high.to_array()));
    let others = near.map(|found| &edges[found.data]);
    let others = others.filter(|other| other.patch != edge.patch);
    let mut shared: Vec<Shared> = others
        .filter_map(|other| edge.shared(other, noise))
        .collect();
    shared.sort_by(|one, other| {
        one.from
            .total_cmp(&other.from)
            .then(one.to.total_cmp(&other.to))
    });
    shared
}

/// The stretches that are left.
fn free(edge: &Edge, shared: &[Shared], noise: f64, unit: f64) -> Vec<FreeEdge> {
    let mut free = Vec::new();
    let mut reached = 0.0;
    let ends = shared.iter().map(|shared| (shared.from, shared.to));
    for (from, to) in ends.chain([(1.0, 1.0)]) {
        if (from - reached) * edge.length() > noise {
            let at = |place: f64| edge.from.lerp(edge.to, place) * unit;
            free.push(FreeEdge {
                patch: edge.patch,
                ends: [at(reached), at(from)],
            });
        }
        reached = f64::max(reached, to);
    }
    free
}

/// The neighbour that runs along the whole of an edge the same way, if it is the only one there.
fn turned(edge: &Edge, shared: &[Shared], noise: f64) -> Option<[usize; 2]> {
    let [only] = shared else {
        return None;
    };
    let is_whole = (only.to - only.from) * edge.length() >= edge.length() - noise;
    let pair = [edge.patch.min(only.patch), edge.patch.max(only.patch)];
    (is_whole && only.same_way).then_some(pair)
}
