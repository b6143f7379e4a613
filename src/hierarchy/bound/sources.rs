//! What a plane sees, with as few and as small weights as can be.
//!
//! ```text
//!   Σ_j b_j F_xj = Σ_j b_j Σ_edges φ_e = Σ_e (b_left − b_right) φ_e
//! ```
//!
//! An edge that two leaves share runs along one as it runs against the other: it counts once, with
//! the difference of their values, which is small inside of a patch. That holds where the points of
//! the plane are in front of both; of leaves whose planes cut through the patch, each is a source.

use super::edge::{Edge, Expanded};
use super::frame::Frame;
use super::leaf::Leaf;
use super::piece::Piece;
use super::seen::Seen;

use glam::{DVec2, DVec3};
use std::collections::{HashMap, HashSet};

/// A function on the plane, and the leaves whose values it counts with.
#[derive(Debug, Clone)]
pub(super) struct Source {
    /// The leaf whose value counts.
    pub(super) left: usize,
    /// The leaf whose value counts negatively.
    pub(super) right: Option<usize>,
    kind: Kind,
}

#[derive(Debug, Clone)]
enum Kind {
    Edge(Edge),
    /// A polygon before which only some points of the plane are.
    Polygon(Box<Seen>),
}

impl Source {
    /// The sources of the plane of a patch with these corners in it, which sees these leaves.
    pub(super) fn all<'l>(
        leaves: impl Iterator<Item = (usize, &'l Leaf)>,
        frame: &Frame,
        base: &[DVec2],
        noise: f64,
    ) -> Vec<Self> {
        let mut sources: Vec<Self> = Vec::new();
        let mut unshared: HashMap<[[u64; 3]; 2], usize> = HashMap::new();
        for (left, leaf) in leaves {
            let Some(seen) = Seen::of(&leaf.shape, &leaf.outline, frame, noise) else {
                continue;
            };
            let source = |kind| Self {
                left,
                right: None,
                kind,
            };
            match seen.is_before(base, noise) {
                Some(false) => {}
                None => sources.push(source(Kind::Polygon(Box::new(seen)))),
                Some(true) => {
                    for edge in seen.edges() {
                        let [start, end] = [edge.start, edge.end].map(key);
                        if let Some(shared) = unshared.remove(&[end, start]) {
                            sources[shared].right = Some(left);
                        } else {
                            unshared.insert([start, end], sources.len());
                            sources.push(source(Kind::Edge(*edge)));
                        }
                    }
                }
            }
        }
        sources
    }

    /// Its weight, for these values of the leaves less a reference, of which so much counts on
    /// either side.
    pub(super) fn weight(&self, values: &[f64], reference: f64, sides: [f64; 2]) -> f64 {
        let left = sides[0] * (values[self.left] - reference);
        let right = self.right.map(|right| values[right] - reference);
        left - right.map_or(0.0, |right| sides[1] * right)
    }

    /// What counts of either side, of parts by leaf.
    pub(super) fn sides(&self, shares: &[f64]) -> [f64; 2] {
        [
            shares[self.left],
            self.right.map_or(0.0, |right| shares[right]),
        ]
    }

    /// The function at a point.
    pub(super) fn factor(&self, point: DVec2) -> f64 {
        match &self.kind {
            Kind::Edge(edge) => edge.factor(point),
            Kind::Polygon(seen) => seen.factor(point),
        }
    }

    /// The function on a piece; `None` if it is too near.
    pub(super) fn expanded(&self, piece: &Piece, noise: f64) -> Option<Expanded> {
        match &self.kind {
            Kind::Edge(edge) => edge.expanded(piece),
            Kind::Polygon(seen) => Some(seen.expanded(piece, noise)),
        }
    }

    /// Bounds on the function on a piece.
    pub(super) fn range(&self, piece: &Piece) -> [f64; 2] {
        match &self.kind {
            Kind::Edge(edge) => edge.range(piece),
            Kind::Polygon(seen) => [0.0, seen.most(piece)],
        }
    }
}

/// The outlines of polygons, with every corner of another one that is in the middle of an edge, or
/// of half of it, and so on: so that neighbours of different sizes share edges.
pub(super) fn outlines(polygons: &[&[DVec3]]) -> Vec<Vec<DVec3>> {
    let corners: HashSet<[u64; 3]> = polygons
        .iter()
        .copied()
        .flatten()
        .map(|c| key(*c))
        .collect();
    let outline = |polygon: &&[DVec3]| {
        let mut outline = Vec::with_capacity(polygon.len());
        for (start, end) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            outline.push(*start);
            insert_between(*start, *end, &corners, &mut outline);
        }
        outline
    };
    polygons.iter().map(outline).collect()
}

fn insert_between(start: DVec3, end: DVec3, corners: &HashSet<[u64; 3]>, outline: &mut Vec<DVec3>) {
    let middle = 0.5 * (start + end);
    if middle == start || middle == end || !corners.contains(&key(middle)) {
        return;
    }
    insert_between(start, middle, corners, outline);
    outline.push(middle);
    insert_between(middle, end, corners, outline);
}

/// The bits of a point; one for 0.
fn key(point: DVec3) -> [u64; 3] {
    point.to_array().map(|x| (x + 0.0).to_bits())
}
