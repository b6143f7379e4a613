//! Convex bodies of a scene: solids whose faces are screens, and single convex screens.
//!
//! ```text
//!   solid   screens joined along whole edges, each behind the planes of all others; edges that
//!           nothing joins lie in one plane, with the solid on one side (what stands on a floor has
//!           no bottom)
//!   sheet   one convex screen that is of no solid
//! ```
//!
//! A line that meets the inside of a solid passes two places of its boundary, and at most one of
//! them lies in the plane that is left open; so it meets a screen. From outside it comes in through
//! a side that it starts in front of: faces of which it starts behind are met later
//! ([`Body::meets_later`]).
//!
//! **Not covered**: solids whose faces are joined in the middle of edges, or face inward: their
//! screens count as sheets.

use super::boxes::{BoxHull, Boxes, boxed};
use crate::geometry::{Outline, Plane, bounds};
use glam::DVec3;
use std::collections::HashMap;

/// The convex bodies of a scene, in a tree of boxes.
#[derive(Debug, Default)]
pub(crate) struct Bodies {
    bodies: Vec<Body>,
    tree: Boxes,
    /// The solid that each screen is a face of.
    solid_of: Vec<Option<usize>>,
}

/// A convex body: what is behind all its sides; a sheet lies in its plane.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Body {
    /// The planes of the sides, fronts outward.
    sides: Vec<Plane>,
    /// Whether the last side has no face.
    is_open: bool,
    /// The plane of a sheet.
    sheet: Option<Plane>,
    bounds: [DVec3; 2],
}

type Edge = [[u64; 3]; 2];

impl Bodies {
    /// The bodies of these outlines, in the order of their first surfaces.
    pub(crate) fn of(outlines: &[&Outline], noise: f64) -> Self {
        let mut sides: HashMap<Edge, Vec<usize>> = HashMap::new();
        for (surface, outline) in outlines.iter().enumerate() {
            for edge in edges(outline) {
                sides.entry(edge).or_default().push(surface);
            }
        }
        let behind = |one: usize, other: usize| {
            let corners = outlines[other].corners().iter();
            let plane = outlines[one].plane();
            corners.copied().all(|corner| plane.height(corner) <= noise)
        };
        let joined = |surface: usize, edge: &Edge| {
            let [from, to] = *edge;
            let others = sides.get(&[to, from]).map_or(&[][..], Vec::as_slice);
            match others {
                [other] if behind(surface, *other) && behind(*other, surface) => Some(*other),
                _ => None,
            }
        };
        let mut known = vec![false; outlines.len()];
        let mut bodies = Vec::new();
        let mut solid_of = vec![None; outlines.len()];
        for first in 0..outlines.len() {
            if known[first] {
                continue;
            }
            known[first] = true;
            let (mut members, mut free, mut next) = (vec![first], Vec::new(), 0);
            while let Some(surface) = members.get(next).copied() {
                next += 1;
                for (edge, from) in edges(outlines[surface]).zip(outlines[surface].corners()) {
                    match joined(surface, &edge) {
                        None => free.push(*from),
                        Some(other) if !known[other] => {
                            known[other] = true;
                            members.push(other);
                        }
                        Some(_) => {}
                    }
                }
            }
            let faces: Vec<&Outline> = members.iter().map(|m| outlines[*m]).collect();
            if let Some(solid) = Body::solid(&faces, &free, noise) {
                for member in members {
                    solid_of[member] = Some(bodies.len());
                }
                bodies.push(solid);
            } else {
                bodies.extend(faces.into_iter().filter_map(Body::sheet));
            }
        }
        let boxes = bodies.iter().enumerate();
        let tree = boxed(boxes.map(|(body, found)| (body, found.bounds)));
        Self {
            bodies,
            tree,
            solid_of,
        }
    }

    /// The solid that a screen is a face of.
    pub(super) fn solid_of(&self, screen: usize) -> Option<&Body> {
        self.solid_of[screen].map(|body| &self.bodies[body])
    }

    /// The bodies whose boxes a segment meets.
    pub(crate) fn near(&self, [from, to]: [DVec3; 2]) -> impl Iterator<Item = &Body> {
        let line = BoxHull::of([&[from; 2], &[to; 2]]);
        let found = self.tree.locate_with_selection_function(line);
        found.map(|boxed| &self.bodies[boxed.data])
    }
}

/// The directed edges of an outline, by the bits of their ends.
fn edges(outline: &Outline) -> impl Iterator<Item = Edge> {
    let corners = outline.corners();
    // −0 is 0
    let bits = |corner: DVec3| (corner + DVec3::ZERO).to_array().map(f64::to_bits);
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(move |(from, to)| [*from, *to].map(bits))
}

impl Body {
    /// The solid of these faces, if they are one.
    ///
    /// **Arguments** `free`: the first corners of edges that nothing joins.
    fn solid(faces: &[&Outline], free: &[DVec3], noise: f64) -> Option<Self> {
        let corners = || faces.iter().flat_map(|face| face.corners()).copied();
        let mut sides: Vec<Plane> = Vec::new();
        for face in faces {
            if corners().any(|corner| face.plane().height(corner) > noise) {
                return None;
            }
            let is_known = |side: &Plane| {
                let mut own = face.corners().iter();
                own.all(|corner| side.height(*corner).abs() <= noise)
            };
            if !sides.iter().any(is_known) {
                sides.push(*face.plane());
            }
        }
        let is_open = !free.is_empty();
        if is_open {
            sides.push(open_side(free, corners(), noise)?);
        }
        // fewer bound no body
        (sides.len() > 3).then(|| Self {
            sides,
            is_open,
            sheet: None,
            bounds: bounds(corners()),
        })
    }

    /// A surface as a sheet, if it is convex.
    fn sheet(face: &Outline) -> Option<Self> {
        let [corners] = face.pieces() else {
            return None;
        };
        let normal = face.plane().normal;
        let next = corners.iter().cycle().skip(1);
        let side = |(from, to): (&DVec3, &DVec3)| {
            let outward = (*to - *from).cross(normal).try_normalize()?;
            Some(Plane::new(outward, *from))
        };
        let sides: Option<Vec<Plane>> = corners.iter().zip(next).map(side).collect();
        Some(Self {
            sides: sides?,
            is_open: false,
            sheet: Some(*face.plane()),
            bounds: *face.bounds(),
        })
    }

    /// Whether every segment from one convex hull of corners to another one is cut: all between
    /// corners meet the body, up to `noise`, and the hulls lie outside.
    ///
    /// From a point outside, what a convex body hides behind it is convex: so all of the second
    /// hull is hidden from a corner of the first one if its corners are, and the same with the two
    /// exchanged.
    pub(super) fn cuts_all(&self, [ones, others]: [&[DVec3]; 2], noise: f64) -> bool {
        let cut = |from: &DVec3| others.iter().all(|to| self.cuts([*from, *to], noise));
        self.is_beside([ones, others], noise) && ones.iter().all(cut)
    }

    /// The sides that have a face, and the one that has none.
    fn closed_and_open(&self) -> (&[Plane], Option<&Plane>) {
        match self.sides.split_last() {
            Some((open, closed)) if self.is_open => (closed, Some(open)),
            _ => (&self.sides, None),
        }
    }

    /// Whether the hull of some corners is outside a solid, but for what it shares with its sides.
    fn is_outside(&self, corners: &[DVec3], noise: f64) -> bool {
        self.sides.iter().any(|side| is_over(side, corners, noise))
    }

    /// Whether both hulls are outside a solid, or on different sides of a sheet.
    pub(super) fn is_beside(&self, ends: [&[DVec3]; 2], noise: f64) -> bool {
        let Some(plane) = &self.sheet else {
            return ends.iter().all(|end| self.is_outside(end, noise));
        };
        let planes = [*plane, plane.reversed()];
        let [one, other] = ends.map(|end| planes.map(|plane| is_over(&plane, end, noise)));
        one[0] && other[1] || one[1] && other[0]
    }

    /// Whether the hull of some corners lies in the plane of a sheet, or in that of a side of a
    /// solid and not outside of others: segments from it meet the body there, whether it hides or
    /// not.
    pub(super) fn is_touched_by(&self, corners: &[DVec3], noise: f64) -> bool {
        let lies_in = |plane: &Plane| {
            let mut heights = corners.iter().map(|corner| plane.height(*corner));
            heights.all(|height| height.abs() <= noise)
        };
        match &self.sheet {
            Some(plane) => lies_in(plane),
            None => self.sides.iter().any(lies_in) && !self.is_outside(corners, noise),
        }
    }

    /// Whether all lines that leave some corners' hull to its front and meet a face of this solid
    /// meet another face of it before: the hull is outside, behind the face, and behind the open
    /// side.
    ///
    /// What lies in a side is outside if it faces outward; its lines start inside, if it does not.
    pub(super) fn meets_later(&self, face: &Plane, from: (&[DVec3], DVec3), noise: f64) -> bool {
        let (corners, normal) = from;
        let is_behind = |side: &Plane| corners.iter().all(|c| side.height(*c) <= noise);
        let is_outside = |side: &Plane| {
            let is_in_front = corners.iter().all(|c| side.height(*c) >= -noise);
            is_in_front && (!is_behind(side) || side.normal.dot(normal) > 0.0)
        };
        let (closed, open) = self.closed_and_open();
        is_behind(face) && open.is_none_or(is_behind) && closed.iter().any(is_outside)
    }

    /// Whether a segment meets the body, or passes it by no more than `noise`.
    pub(super) fn cuts(&self, [from, to]: [DVec3; 2], noise: f64) -> bool {
        if let Some(plane) = &self.sheet {
            let [above, below] = [from, to].map(|end| plane.height(end));
            if above.min(below) > noise || above.max(below) < -noise {
                return false;
            }
            // an end on the plane, up to noise, is where it is met
            let at = (above / (above - below)).clamp(0.0, 1.0);
            let met = from.lerp(to, at);
            let mut sides = self.sides.iter();
            return sides.all(|side| side.height(met) <= noise);
        }
        let (mut start, mut end) = (0.0_f64, 1.0_f64);
        for side in &self.sides {
            let [first, last] = [from, to].map(|end| side.height(end) - noise);
            if first >= 0.0 && last >= 0.0 {
                return false;
            }
            let at = first / (first - last);
            if first > 0.0 {
                start = start.max(at);
            } else if last > 0.0 {
                end = end.min(at);
            }
        }
        start < end
    }
}

/// Whether a hull of corners is in front of a plane, touching it at most.
fn is_over(plane: &Plane, corners: &[DVec3], noise: f64) -> bool {
    let heights = || corners.iter().map(|corner| plane.height(*corner));
    heights().all(|height| height >= -noise) && heights().any(|height| height > noise)
}

/// The side that a solid is open on: the plane of all its free corners, front outward.
fn open_side(
    free: &[DVec3],
    corners: impl Iterator<Item = DVec3> + Clone,
    noise: f64,
) -> Option<Plane> {
    let origin = free[0];
    let farthest = |distance: &dyn Fn(&DVec3) -> f64| {
        let far = |one: &&DVec3, other: &&DVec3| distance(one).total_cmp(&distance(other));
        free.iter().max_by(far).copied()
    };
    let along = farthest(&|corner| corner.distance_squared(origin))? - origin;
    let aside = farthest(&|corner| (*corner - origin).cross(along).length_squared())? - origin;
    let plane = Plane::new(along.cross(aside).try_normalize()?, origin);
    if free
        .iter()
        .any(|corner| plane.height(*corner).abs() > noise)
    {
        return None;
    }
    let sides = [plane, plane.reversed()];
    let is_outward = |side: &Plane| corners.clone().all(|corner| side.height(corner) <= noise);
    sides.into_iter().find(is_outward)
}
