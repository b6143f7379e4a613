//! An outline that touches itself, divided: one that is bridged around openings.
//!
//! ```text
//!   1 2 3 4 1 5 6 7 8 5      a square 1 2 3 4 with an opening 5 6 7 8, and the bridge 1–5
//! ```
//!
//! An edge that is run along out and back bounds nothing; what is left must enclose what lies on
//! its left once, and what lies on its right not at all, and its edges must meet at their ends
//! only. Any number of openings, bridged to each other or to the outline, openings that touch it in
//! a corner, and islands in openings are of that kind; an outline that crosses itself is not.
//!
//! Diagonals inside are drawn, the shortest first, as long as they cross nothing; the triangles
//! between them are merged again along their common edges, the longest first, as long as the union
//! is a polygon. All corners are the outline's own.
//!
//! **Not covered**: a bridge with a corner on one of its ways only; speed beyond some hundred
//! corners (the work grows with their cube).

use super::ears::EarClipper;
use super::outline::reduced;
use crate::geometry::{GeometryError, Patch};
use crate::numeric::tolerance;
use glam::{DVec2, DVec3};
use std::collections::{BTreeSet, HashMap, HashSet};
use std::f64::consts::TAU;

/// An outline seen along its mean normal.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FlatOutline {
    /// The corners in space, in units of the diameter, from the first.
    local: Vec<DVec3>,
    /// The corners on the mean plane.
    flat: Vec<DVec2>,
    /// The first corner at the place of each one.
    places: Vec<usize>,
}

impl FlatOutline {
    /// The outline with these corners, all of them finite.
    pub(crate) fn of(corners: &[DVec3]) -> Self {
        let origin = corners.first().copied().unwrap_or_default();
        let distances = corners.iter().map(|corner| corner.distance(origin));
        // in units of the diameter, so that products stay in range
        let unit = distances.fold(0.0, f64::max);
        let local: Vec<DVec3> = corners.iter().map(|c| (*c - origin) / unit).collect();
        let doubled: DVec3 = local.windows(2).map(|pair| pair[0].cross(pair[1])).sum();
        let normal = doubled.normalize_or(DVec3::Z);
        let across = normal.any_orthonormal_vector();
        let up = normal.cross(across);
        let flat = local.iter().map(|c| DVec2::new(c.dot(across), c.dot(up)));
        Self {
            places: first_places(corners),
            flat: flat.collect(),
            local,
        }
    }

    /// The corners on the mean plane, in units of the diameter.
    pub(crate) fn flattened(&self) -> Vec<DVec3> {
        self.flat.iter().map(|corner| corner.extend(0.0)).collect()
    }

    /// Whether the outline encloses an area once, whatever runs out and back.
    pub(crate) fn is_clear(&self) -> bool {
        let boundary = self.boundary();
        let pairs = boundary.iter().enumerate();
        let mut pairs = pairs.flat_map(|(i, one)| boundary[i + 1..].iter().map(move |b| (one, b)));
        !boundary.is_empty()
            && !pairs.any(|(one, other)| self.meet(*one, *other))
            && boundary
                .iter()
                .all(|edge| self.winding(*edge, &boundary) == 1)
    }

    /// The edges that are not run along out and back, by the places of their ends.
    fn boundary(&self) -> Vec<[usize; 2]> {
        let next = self.places.iter().cycle().skip(1);
        let edges = || self.places.iter().zip(next.clone()).map(|(a, b)| [*a, *b]);
        let mut open: HashMap<[usize; 2], usize> = HashMap::new();
        for [from, to] in edges() {
            match open.get_mut(&[to, from]).filter(|count| **count > 0) {
                Some(back) => *back -= 1,
                None => *open.entry([from, to]).or_insert(0) += 1,
            }
        }
        let mut is_left = |edge: &[usize; 2]| {
            let count = open.get_mut(edge).filter(|count| **count > 0);
            count.map(|count| *count -= 1).is_some()
        };
        edges().filter(|edge| is_left(edge)).collect()
    }

    /// Whether two edges meet elsewhere than at a common end.
    fn meet(&self, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> bool {
        let at = |place: usize| self.flat[place];
        let common = [(a, b, c, d), (a, b, d, c), (b, a, c, d), (b, a, d, c)];
        let mut common = common.into_iter().filter(|(end, _, other, _)| end == other);
        if let Some((end, p, _, q)) = common.next() {
            let [p, q] = [at(p) - at(end), at(q) - at(end)];
            return turn(at(end), at(end) + p, at(end) + q) == 0.0 && p.dot(q) > 0.0;
        }
        let [a, b, c, d] = [a, b, c, d].map(at);
        let along = b - a;
        let [s, e] = [(c - a).dot(along), (d - a).dot(along)];
        if s.max(e) < 0.0 || s.min(e) > along.length_squared() {
            return false;
        }
        let same_side = |p: f64, q: f64| (p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0);
        !same_side(turn(a, b, c), turn(a, b, d)) && !same_side(turn(c, d, a), turn(c, d, b))
    }

    /// The number of times that the boundary winds around what is left of the middle of an edge.
    fn winding(&self, edge: [usize; 2], boundary: &[[usize; 2]]) -> i32 {
        let ends = |edge: [usize; 2]| edge.map(|place| self.flat[place]);
        let [a, b] = ends(edge);
        // the ray to the right must not run along the edge
        let is_steep = (b - a).y.abs() >= (b - a).x.abs();
        let turned = |p: DVec2| if is_steep { p } else { DVec2::new(p.y, -p.x) };
        let [a, b] = [a, b].map(turned);
        let middle = 0.5 * (a + b);
        let crossings = boundary.iter().map(|other| {
            let [c, d] = ends(*other).map(turned);
            let is_met = if *other == edge {
                // from the left, if it runs upwards
                b.y > a.y
            } else {
                (c.y > middle.y) != (d.y > middle.y)
                    && middle.x < c.x + (middle.y - c.y) * (d.x - c.x) / (d.y - c.y)
            };
            if !is_met {
                0
            } else if d.y > c.y {
                1
            } else {
                -1
            }
        });
        crossings.sum()
    }

    /// The triangles between diagonals that cross nothing, as places of corners, counter-clockwise;
    /// more corners where some are on one line.
    fn division(&self) -> Vec<Vec<usize>> {
        let boundary = self.boundary();
        let length = |[a, b]: [usize; 2]| self.flat[a].distance(self.flat[b]);
        let corners: BTreeSet<usize> = boundary.iter().flatten().copied().collect();
        let pairs = corners
            .iter()
            .flat_map(|a| corners.range(a + 1..).map(|b| [*a, *b]));
        let mut candidates: Vec<[usize; 2]> = pairs.collect();
        candidates.sort_by(|one, other| length(*one).total_cmp(&length(*other)));
        let mut edges = boundary.clone();
        for [a, b] in candidates {
            // the longest edges are the last, and most likely in the way
            let is_free = edges.iter().rev().all(|edge| !self.meet(*edge, [a, b]));
            if is_free && self.winding([a, b], &boundary) == 1 {
                edges.extend([[a, b], [b, a]]);
            }
        }
        self.faces(&edges)
    }

    /// The outlines on the left of edges, each of which is run along once.
    fn faces(&self, edges: &[[usize; 2]]) -> Vec<Vec<usize>> {
        let direction = |[a, b]: [usize; 2]| self.flat[b] - self.flat[a];
        let next = |[from, at]: [usize; 2]| {
            let back = direction([at, from]);
            // the first one clockwise from the way back
            let turn = |edge: &&[usize; 2]| {
                let angle = direction(**edge).angle_to(back);
                if angle > 0.0 { angle } else { angle + TAU }
            };
            let ways = edges.iter().filter(|edge| edge[0] == at && edge[1] != from);
            ways.min_by(|one, other| turn(one).total_cmp(&turn(other)))
        };
        let mut is_done: HashSet<[usize; 2]> = HashSet::new();
        let mut faces = Vec::new();
        for start in edges {
            let mut face = Vec::new();
            let mut edge = Some(start);
            while let Some(found) = edge.filter(|edge| is_done.insert(**edge)) {
                face.push(found[0]);
                edge = next(*found);
            }
            if !face.is_empty() {
                faces.push(face);
            }
        }
        faces
    }

    /// The triangles that make up a simple outline, as indices of corners, counter-clockwise.
    ///
    /// Of the ears those come first that have all else in front of them, in space.
    pub(crate) fn triangles(&self) -> Vec<[usize; 3]> {
        EarClipper::new(&self.flat, turn).triangles(|clipper| {
            let of_hull =
                |place: &usize| self.has_in_front(clipper.left(), clipper.triangle(*place));
            let ear = clipper.ears().find(of_hull);
            ear.or_else(|| clipper.ears().next())
        })
    }

    /// The triangles that make up an outline that [is clear](Self::is_clear), as indices of
    /// corners, counter-clockwise.
    pub(crate) fn triangles_between(&self) -> Vec<[usize; 3]> {
        let faces = self.division().into_iter();
        let triangles = faces.flat_map(|face| {
            let corners: Vec<DVec2> = face.iter().map(|place| self.flat[*place]).collect();
            let triangles = EarClipper::new(&corners, turn).triangles(|left| left.ears().next());
            let places = triangles.into_iter();
            let places = places.map(|triangle| triangle.map(|corner| face[corner]));
            places.collect::<Vec<_>>()
        });
        triangles.collect()
    }

    /// Whether all remaining corners are in front of the plane of a triangle.
    fn has_in_front(&self, left: &[usize], triangle: [usize; 3]) -> bool {
        let [a, b, c] = triangle.map(|k| self.local[k]);
        let normal = (b - a).cross(c - a);
        left.iter()
            .filter(|k| !triangle.contains(k))
            .all(|k| (self.local[*k] - a).dot(normal) >= 0.0)
    }

    /// Simple polygons that make up the outline.
    ///
    /// **Arguments** `corners`: those that the outline is of; `patch`: a polygon, or why it is
    /// none.
    ///
    /// # Errors
    /// The errors of `patch` for a triangle.
    pub(crate) fn pieces(
        &self,
        corners: &[DVec3],
        patch: &dyn Fn(Vec<DVec3>) -> Result<Patch, GeometryError>,
    ) -> Result<Vec<Patch>, GeometryError> {
        let of = |places: &[usize]| patch(places.iter().map(|place| corners[*place]).collect());
        let mut pieces = Vec::new();
        let mut diagonals = Vec::new();
        for piece in self.division() {
            let next = piece.iter().cycle().skip(1);
            diagonals.extend(piece.iter().zip(next).map(|(a, b)| [*a, *b]));
            let shape = of(&piece)?;
            pieces.push((piece, shape));
        }
        let length = |[a, b]: [usize; 2]| self.local[a].distance(self.local[b]);
        diagonals.retain(|[a, b]| a < b);
        diagonals.sort_by(|one, other| length(*other).total_cmp(&length(*one)));
        for [a, b] in diagonals {
            let with = |edge: [usize; 2]| {
                pieces
                    .iter()
                    .position(|(of, _)| place_of(of, edge).is_some())
            };
            let (Some(first), Some(second)) = (with([a, b]), with([b, a])) else {
                continue;
            };
            if first == second {
                continue;
            }
            let around = union(&pieces[first].0, &pieces[second].0, [a, b]);
            if let Ok(whole) = of(&around) {
                pieces[first.min(second)] = (around, whole);
                pieces.remove(first.max(second));
            }
        }
        Ok(pieces.into_iter().map(|(_, piece)| piece).collect())
    }
}

/// The outline around polygons that share edges, bridged around what they leave open; none if they
/// do not hang together.
pub(crate) fn united(polygons: &[&[DVec3]]) -> Option<Vec<DVec3>> {
    let corners = polygons.concat();
    let places = first_places(&corners);
    let mut start = 0;
    let outlines = polygons.iter().map(|polygon| {
        start += polygon.len();
        places[start - polygon.len()..start].to_vec()
    });
    let mut outlines: Vec<Vec<usize>> = outlines.collect();
    let mut whole = outlines.pop()?;
    while !outlines.is_empty() {
        let shared = outlines.iter().enumerate().find_map(|(index, outline)| {
            let next = outline.iter().cycle().skip(1);
            let mut edges = outline.iter().zip(next).map(|(a, b)| [*b, *a]);
            let edge = edges.find(|edge| place_of(&whole, *edge).is_some())?;
            Some((index, edge))
        });
        let (index, edge) = shared?;
        whole = union(&whole, &outlines.remove(index), edge);
    }
    Some(whole.into_iter().map(|place| corners[place]).collect())
}

/// The index of the first corner at each one's place.
fn first_places(corners: &[DVec3]) -> Vec<usize> {
    let mut first = HashMap::new();
    let places = corners.iter().enumerate().map(|(index, corner)| {
        // zero has no sign here
        let key = (*corner + DVec3::ZERO).to_array().map(f64::to_bits);
        *first.entry(key).or_insert(index)
    });
    places.collect()
}

/// The place at which an outline runs along an edge.
fn place_of(outline: &[usize], [from, to]: [usize; 2]) -> Option<usize> {
    let next = outline.iter().cycle().skip(1);
    outline
        .iter()
        .zip(next)
        .position(|(a, b)| [*a, *b] == [from, to])
}

/// The outline around two that run along an edge, the second one backwards.
fn union(one: &[usize], other: &[usize], [from, to]: [usize; 2]) -> Vec<usize> {
    let [mut one, mut other] = [one.to_vec(), other.to_vec()];
    for (outline, edge) in [(&mut one, [from, to]), (&mut other, [to, from])] {
        let start = place_of(outline, edge).unwrap_or(0);
        // from the end of the edge to its start
        let end = (start + 1) % outline.len();
        outline.rotate_left(end);
    }
    one.extend(other.get(1..other.len() - 1).unwrap_or_default());
    reduced(&one, |a, _, c| a == c)
}

/// Twice the area of a triangle, positive if it runs counter-clockwise; 0 for one that is flat to
/// within the tolerance of planarity, in units of the outline's diameter.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let doubled = (b - a).perp_dot(c - a);
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    if doubled.abs() <= tolerance::PLANARITY * longest {
        0.0
    } else {
        doubled
    }
}
