//! The places of walls on a page: unfolded about the edges that they share.
//!
//! Each net grows from a wall that is a floor, or the largest one: the wall with the longest edge
//! along one that is placed is turned into the page about that edge, unless it would lie on
//! another one. What is left over begins a net of its own.

use super::edges::Edge;
use super::packing::{Bounds, around, shifts};
use super::walls::Wall;
use glam::{DVec2, DVec3};

/// The least rise of the normal of a floor.
const LEVEL: f64 = 0.999;
/// The noise by which edges of equal length may differ.
const ALIKE: f64 = 100.0;

/// A turn and a shift that bring a wall onto the page.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    turn: DVec2,
    shift: DVec2,
}

impl Place {
    /// The place of the first wall of a net: its longest edge runs across the page, or up.
    fn first(wall: &Wall) -> Self {
        let along = wall.border.iter().map(|edge| {
            let [from, to] = edge.map(|end| wall.flat(end));
            to - from
        });
        let by_length = |one: &DVec2, other: &DVec2| one.length().total_cmp(&other.length());
        let longest = along.max_by(by_length).unwrap_or(DVec2::X);
        let axis = if longest.x.abs() >= longest.y.abs() {
            DVec2::X * longest.x.signum()
        } else {
            DVec2::Y * longest.y.signum()
        };
        Self {
            turn: turn(longest, axis),
            shift: DVec2::ZERO,
        }
    }

    /// The place of a point of a wall.
    pub(super) fn of(&self, wall: &Wall, point: DVec3) -> DVec2 {
        self.shift + self.turn.rotate(wall.flat(point))
    }

    /// The place of a wall that brings an edge onto these points of the page.
    fn at(wall: &Wall, edge: Edge, page: [DVec2; 2]) -> Self {
        let [from, to] = edge.map(|end| wall.flat(end));
        let turn = turn(to - from, page[1] - page[0]);
        Self {
            turn,
            shift: page[0] - turn.rotate(from),
        }
    }
}

/// The turn that brings one direction onto another, as its cosine and its sine.
fn turn(from: DVec2, to: DVec2) -> DVec2 {
    let conjugate = DVec2::new(from.x, -from.y);
    to.rotate(conjugate).normalize()
}

/// Walls with their places; those that have none yet.
struct Page<'w> {
    walls: &'w [Wall],
    hinges: Vec<Vec<(usize, Edge, f64)>>,
    places: Vec<Option<Place>>,
    noise: f64,
}

/// The place of each wall.
pub(super) fn places(walls: &[Wall], noise: f64) -> Vec<Place> {
    let hinges = walls.iter().enumerate().map(|(index, wall)| {
        let others = walls
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index);
        let hinges = others.filter_map(|(other, there)| {
            let (edge, length) = wall.hinge(there, noise)?;
            Some((other, edge, length))
        });
        hinges.collect()
    });
    let mut page = Page {
        walls,
        hinges: hinges.collect(),
        places: vec![None; walls.len()],
        noise,
    };
    let mut nets = Vec::new();
    while let Some(root) = page.root() {
        nets.push(page.net(root));
    }
    page.set_apart(&nets);
    page.places.into_iter().flatten().collect()
}

impl Page<'_> {
    /// The wall with which the next net begins.
    fn root(&self) -> Option<usize> {
        let left = (0..self.walls.len()).filter(|wall| self.places[*wall].is_none());
        let rank = |wall: &usize| {
            let Wall { normal, area, .. } = self.walls[*wall];
            (normal.z > LEVEL, area)
        };
        left.reduce(|best, wall| {
            let (ours, theirs) = (rank(&best), rank(&wall));
            let is_better = theirs.0 & !ours.0 || (theirs.0 == ours.0 && theirs.1 > ours.1);
            if is_better { wall } else { best }
        })
    }

    /// Grows a net from a wall, and returns its walls.
    fn net(&mut self, root: usize) -> Vec<usize> {
        self.places[root] = Some(Place::first(&self.walls[root]));
        let mut net = vec![root];
        while let Some((wall, place)) = self.next(&net) {
            self.places[wall] = Some(place);
            net.push(wall);
        }
        net
    }

    /// The wall with the longest hinge to a net that finds room beside it.
    fn next(&self, net: &[usize]) -> Option<(usize, Place)> {
        let hinges = net.iter().flat_map(|placed| {
            let hinges = self.hinges[*placed].iter();
            hinges.map(|(wall, edge, length)| (*placed, *wall, *edge, *length))
        });
        let mut open: Vec<_> = hinges
            .filter(|(_, wall, ..)| self.places[*wall].is_none())
            .collect();
        // lengths that differ by noise are equal; of these the wall that was placed first, and of
        // its neighbours the last, as walls come floor, ceiling, left, right, front, back
        let length = |length: f64| (length / (ALIKE * self.noise)).round();
        let order = |placed: usize| net.iter().position(|wall| *wall == placed);
        open.sort_by(|one, other| {
            let by_length = length(other.3).total_cmp(&length(one.3));
            let by_order = order(one.0).cmp(&order(other.0));
            by_length.then(by_order).then(other.1.cmp(&one.1))
        });
        open.into_iter().find_map(|(placed, wall, edge, _)| {
            let there = self.places[placed]?;
            let page = edge.map(|end| there.of(&self.walls[placed], end));
            let place = Place::at(&self.walls[wall], edge, page);
            let has_room = self.has_room(wall, place, net) && !self.is_in_hole(wall, place, placed);
            has_room.then_some((wall, place))
        })
    }

    fn has_room(&self, wall: usize, place: Place, net: &[usize]) -> bool {
        let ours = self.pieces(wall, place);
        net.iter().all(|other| {
            let Some(there) = self.places[*other] else {
                return true;
            };
            let theirs = self.pieces(*other, there);
            ours.iter()
                .all(|one| theirs.iter().all(|other| are_apart(one, other, self.noise)))
        })
    }

    /// Does a wall lie in a hole of the one beside it?
    fn is_in_hole(&self, wall: usize, place: Place, beside: usize) -> bool {
        let Some(there) = self.places[beside] else {
            return false;
        };
        let corners = self.pieces(wall, place).into_iter().flatten();
        let [low, high] = around(corners);
        let middle = low.midpoint(high);
        let border = self.walls[beside].border.iter();
        let border = border.map(|edge| edge.map(|end| there.of(&self.walls[beside], end) - middle));
        let border: Vec<[DVec2; 2]> = border.collect();
        let directions = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
        let meets = |direction: &DVec2| border.iter().any(|edge| is_met(*edge, *direction));
        directions.iter().all(meets)
    }

    fn pieces(&self, wall: usize, place: Place) -> Vec<Vec<DVec2>> {
        let wall = &self.walls[wall];
        let on_page = |piece: &Vec<DVec3>| piece.iter().map(|c| place.of(wall, *c)).collect();
        wall.pieces.iter().map(on_page).collect()
    }

    /// Sets the nets beside each other.
    fn set_apart(&mut self, nets: &[Vec<usize>]) {
        let bounds = |wall: &usize| {
            let place = self.places[*wall];
            let pieces = place.map(|place| self.pieces(*wall, place));
            around(pieces.into_iter().flatten().flatten())
        };
        let bounds: Vec<Vec<Bounds>> = nets
            .iter()
            .map(|net| net.iter().map(bounds).collect())
            .collect();
        for (net, shift) in nets.iter().zip(shifts(&bounds)) {
            for wall in net {
                if let Some(place) = &mut self.places[*wall] {
                    place.shift += shift;
                }
            }
        }
    }
}

/// Does a ray from the origin meet an edge?
fn is_met(edge: [DVec2; 2], direction: DVec2) -> bool {
    let [from, to] = edge.map(|end| direction.perp_dot(end));
    let [near, far] = edge.map(|end| direction.dot(end));
    (from > 0.0) != (to > 0.0) && near + (far - near) * from / (from - to) > 0.0
}

/// Does a line along an edge of one of two convex polygons part them?
fn are_apart(one: &[DVec2], other: &[DVec2], noise: f64) -> bool {
    let parts = |one: &[DVec2], other: &[DVec2]| {
        (0..one.len()).any(|k| {
            let (from, to) = (one[k], one[(k + 1) % one.len()]);
            let outwards = -(to - from).perp().normalize_or_zero();
            let nearest = other.iter().map(|c| outwards.dot(*c - from));
            outwards != DVec2::ZERO && nearest.fold(f64::INFINITY, f64::min) >= -noise
        })
    };
    parts(one, other) || parts(other, one)
}
