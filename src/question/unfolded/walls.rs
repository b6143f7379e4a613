//! The walls of a scene: neighbours in one plane, fronts on the same side.

use super::edges::{Edge, left_over, part_of, shared};
use crate::geometry::{Patch, convex_pieces};
use crate::scene::Scene;
use glam::{DVec2, DVec3};

/// The largest sine of the angle between planes that count as one.
const FLAT: f64 = 1e-6;

/// Neighbours in one plane, with axes u to the right and v upwards as their fronts are seen.
pub(super) struct Wall {
    /// The patches.
    pub(super) patches: Vec<usize>,
    /// The edges that lie between no two of the patches.
    pub(super) border: Vec<Edge>,
    /// The patches cut into convex polygons.
    pub(super) pieces: Vec<Vec<DVec3>>,
    pub(super) area: f64,
    pub(super) normal: DVec3,
    origin: DVec3,
    u: DVec3,
    v: DVec3,
}

impl Wall {
    fn new(scene: &Scene, patches: Vec<usize>, noise: f64) -> Self {
        let shapes = || patches.iter().map(|patch| scene.patches()[*patch].shape());
        let first = scene.patches()[patches[0]].shape();
        let (origin, normal) = (first.corners()[0], first.normal());
        let [u, v] = axes(normal);
        let pieces = shapes().flat_map(|shape| convex_pieces(shape.corners(), shape.normal()));
        Self {
            border: border(&shapes().collect::<Vec<_>>(), noise),
            pieces: pieces.collect(),
            area: shapes().map(Patch::area).sum(),
            normal,
            origin,
            u,
            v,
            patches,
        }
    }

    /// A point by its coordinates u and v.
    pub(super) fn flat(&self, point: DVec3) -> DVec2 {
        let offset = point - self.origin;
        DVec2::new(self.u.dot(offset), self.v.dot(offset))
    }

    /// The longest part of the border at which another wall begins, and how much of the border is
    /// on its line.
    pub(super) fn hinge(&self, other: &Self, noise: f64) -> Option<(Edge, f64)> {
        let pairs = self
            .border
            .iter()
            .flat_map(|edge| other.border.iter().map(move |other| (*edge, *other)));
        let shared = pairs.filter_map(|(edge, other)| {
            let places = shared(edge, other, noise)?;
            Some(part_of(edge, places))
        });
        let shared: Vec<Edge> = shared.collect();
        let length = |edge: &Edge| edge[0].distance(edge[1]);
        let longest = shared
            .iter()
            .max_by(|one, other| length(one).total_cmp(&length(other)))?;
        let along = (longest[1] - longest[0]).normalize();
        let is_beside =
            |edge: &&Edge| (edge[0] - longest[0]).cross(along).length() <= noise.max(FLAT);
        let on_line = shared.iter().filter(is_beside).map(length).sum();
        Some((*longest, on_line))
    }
}

/// The walls of a scene, in the order of their first patches.
pub(super) fn walls(scene: &Scene, noise: f64) -> Vec<Wall> {
    let patches = scene.patches();
    let mut is_taken = vec![false; patches.len()];
    let mut walls = Vec::new();
    for seed in 0..patches.len() {
        if is_taken[seed] {
            continue;
        }
        is_taken[seed] = true;
        let mut members = vec![seed];
        let mut next = 0;
        while let Some(member) = members.get(next).copied() {
            for other in seed + 1..patches.len() {
                let continues = !is_taken[other]
                    && is_continued(patches[member].shape(), patches[other].shape(), noise);
                if continues {
                    is_taken[other] = true;
                    members.push(other);
                }
            }
            next += 1;
        }
        members.sort_unstable();
        walls.push(Wall::new(scene, members, noise));
    }
    walls
}

/// Is the other patch in the plane of this one, and its neighbour?
fn is_continued(patch: &Patch, other: &Patch, noise: f64) -> bool {
    let (normal, origin) = (patch.normal(), patch.corners()[0]);
    let is_parallel = normal.dot(other.normal()) > 0.0
        && normal.cross(other.normal()).length() <= FLAT
        && (other.corners()[0] - origin).dot(normal).abs() <= noise;
    is_parallel
        && edges(patch).any(|edge| edges(other).any(|other| shared(edge, other, noise).is_some()))
}

fn edges(patch: &Patch) -> impl Iterator<Item = Edge> {
    let corners = patch.corners();
    (0..corners.len()).map(move |k| [corners[k], corners[(k + 1) % corners.len()]])
}

/// The edges of polygons in one plane that lie between no two of them.
fn border(shapes: &[&Patch], noise: f64) -> Vec<Edge> {
    let mut border = Vec::new();
    for (index, shape) in shapes.iter().enumerate() {
        for edge in edges(shape) {
            let others = shapes
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != index);
            let others = others.flat_map(|(_, other)| edges(other));
            let taken = others.filter_map(|other| shared(edge, other, noise));
            border.extend(left_over(edge, taken.collect(), noise));
        }
    }
    border
}

/// Axes to the right and upwards in a plane, as its front is seen: z is up on a wall, y on a floor.
fn axes(normal: DVec3) -> [DVec3; 2] {
    let rise = DVec3::Z.reject_from_normalized(normal);
    let v = rise
        .try_normalize()
        .filter(|_| rise.length() > FLAT)
        .unwrap_or_else(|| DVec3::Y.reject_from_normalized(normal).normalize());
    [v.cross(normal), v]
}
