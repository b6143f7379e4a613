//! The frame of a pair: two polygons and those between them, with what they have in common.
//!
//! ```text
//!   P lies in z = 0 and faces up; Q and the screens are cut off at P's plane, P and the screens at
//!   Q's; all in units of a power of two near the size of the pair
//! ```
//!
//! Everything is cut into convex faces. Corners that coincide are one corner, and edges on one
//! straight line lie on one [`Line`]: that the edges of neighbours cancel, and that several edges
//! meet in a corner, is then known and need not be computed.
//!
//! Corners are rounded once, from 106 bits, as they are put into the frame.

use super::frame::{Frame, Plane, Set};
use crate::form_factor::Polygon;
use crate::form_factor::occlusion::occluders::Occluders;
use crate::geometry::{are_apart, convex_pieces};
use crate::numeric::{DoubleDouble, Scalar, power_of_two_below};
use glam::DVec3;
use std::f64::consts::PI;

/// A straight line that edges lie on.
#[derive(Debug, Clone)]
pub(crate) struct Line {
    /// The corners that the line is put through.
    pub ends: [usize; 2],
    /// All corners on it.
    pub through: Vec<usize>,
    /// The largest distance of edges on the line from their exact places.
    pub displaced: f64,
}

/// A side of a face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side {
    pub line: usize,
    /// Whether the side runs as its line does.
    pub is_along: bool,
    /// The corners that it runs from and to.
    pub corners: [usize; 2],
}

/// A convex polygon, counter-clockwise seen from its front.
#[derive(Debug, Clone)]
pub(crate) struct Face {
    pub sides: Vec<Side>,
    pub normal: DVec3,
    /// The plane's `normal·x`.
    pub offset: f64,
}

impl Face {
    pub(crate) fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.offset
    }

    pub(crate) fn corners(&self) -> impl Iterator<Item = usize> + Clone {
        self.sides.iter().map(|side| side.corners[0])
    }
}

/// Two polygons and the screens between them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Setting {
    pub corners: Vec<DVec3>,
    /// The largest distance of each corner from its exact place.
    pub moved: Vec<f64>,
    pub lines: Vec<Line>,
    /// The parts of P, in z = 0.
    pub first: Vec<Face>,
    /// The parts of Q.
    pub second: Vec<Face>,
    pub screens: Vec<Face>,
    /// The distance up to which things count as meeting.
    pub touching: f64,
    /// The largest of the displacements.
    pub displaced: f64,
    /// A bound on what faces hide that are too thin to be kept.
    pub lost: f64,
    /// The most that ∫ dx/r can be over P, from any point: `2 √(π A_P)`.
    pub most: f64,
    /// The unit of length.
    pub unit: f64,
}

impl Setting {
    pub(crate) fn of([first, second]: [&Polygon; 2], occluders: &Occluders) -> Self {
        let frame = Frame::of(first);
        let placed = |polygon: &Polygon| -> Vec<[DoubleDouble; 3]> {
            let corners = polygon.shape.corners.iter();
            corners.map(|corner| frame.place(*corner).0).collect()
        };
        let (floor, ceiling) = (placed(first), placed(second));
        let ends = floor.iter().chain(&ceiling).flatten();
        let reach = ends.fold(0.0f64, |reach, value| reach.max(value.to_f64().abs()));
        let unit = power_of_two_below(reach);
        let rounding = 64.0 * f64::EPSILON * (reach / unit);
        let mut setting = Self {
            touching: rounding.max(occluders.touching / unit),
            most: 2.0 * (PI * first.area()).sqrt() / unit,
            unit,
            ..Self::default()
        };
        let set = |corner: [DoubleDouble; 3]| Set {
            place: DVec3::from_array(corner.map(|value| value.to_f64() / unit)),
            displaced: DVec3::from_array(corner.map(|value| value.low() / unit)).length(),
        };
        let scaled = |corners: Vec<[DoubleDouble; 3]>| corners.into_iter().map(set).collect();
        let (mut floor, ceiling): (Vec<Set>, Vec<Set>) = (scaled(floor), scaled(ceiling));
        for corner in &mut floor {
            corner.displaced += corner.place.z.abs();
            corner.place.z = 0.0;
        }
        let up = Plane {
            normal: DVec3::Z,
            offset: 0.0,
        };
        let normal = frame.turned(second.precise_normal).to_doubles();
        let down = Plane {
            normal,
            offset: normal.dot(ceiling[0].place),
        };
        setting.first = setting.faces(&floor, DVec3::Z, &[down]);
        setting.second = setting.faces(&ceiling, normal, &[up]);
        for screen in occluders.polygons {
            let corners: Vec<Set> = scaled(placed(screen));
            let normal = frame.turned(screen.precise_normal).to_doubles();
            let faces = setting.faces(&corners, normal, &[up, down]);
            setting.screens.extend(faces);
        }
        setting.leave_out_what_is_beside();
        setting.find_through();
        setting
    }

    /// Leaves out the screens that no line of sight meets.
    fn leave_out_what_is_beside(&mut self) {
        let ([first, ..], [second, ..]) = (&self.first[..], &self.second[..]) else {
            return;
        };
        let normals = [first.normal, second.normal];
        let corners = |faces: &[Face]| -> Vec<DVec3> {
            let corners = faces.iter().flat_map(Face::corners);
            corners.map(|corner| self.corners[corner]).collect()
        };
        let ends = [corners(&self.first), corners(&self.second)];
        let mut screens = std::mem::take(&mut self.screens);
        screens.retain(|screen| {
            let [first, second] = normals;
            let screen_corners = corners(std::slice::from_ref(screen));
            let normals = [screen.normal, first, second];
            let [a, b] = &ends;
            !are_apart([a, b], &screen_corners, normals, self.touching)
        });
        self.screens = screens;
    }

    /// The convex faces of a polygon in front of some planes.
    fn faces(&mut self, corners: &[Set], normal: DVec3, planes: &[Plane]) -> Vec<Face> {
        let places: Vec<DVec3> = corners.iter().map(|corner| corner.place).collect();
        let set = |place: DVec3| {
            let known = corners.iter().find(|corner| corner.place == place);
            let displaced = known.map_or(0.0, |corner| corner.displaced);
            Set { place, displaced }
        };
        let pieces = convex_pieces(&places, normal).into_iter();
        let mut pieces: Vec<Vec<Set>> = pieces
            .map(|piece| piece.into_iter().map(set).collect())
            .collect();
        for plane in planes {
            for piece in std::mem::take(&mut pieces) {
                let moved = plane.nearest(&piece, self.touching);
                match plane.front_of(&piece, self.touching) {
                    Some(front) => pieces.push(front),
                    None => self.lost += 2.0 * moved * perimeter(&piece),
                }
            }
        }
        let pieces = pieces.into_iter();
        pieces
            .filter_map(|piece| self.face(&piece, normal))
            .collect()
    }

    fn face(&mut self, corners: &[Set], normal: DVec3) -> Option<Face> {
        let mut names: Vec<usize> = corners.iter().map(|c| self.corner(*c)).collect();
        names.dedup();
        while names.len() > 1 && names.first() == names.last() {
            names.pop();
        }
        if names.len() < 3 {
            self.lost += 2.0 * self.displaced * perimeter(corners);
            return None;
        }
        let n = names.len();
        let sides = (0..n).map(|i| self.side([names[i], names[(i + 1) % n]]));
        let sides: Vec<Side> = sides.collect();
        let offset = normal.dot(self.corners[names[0]]);
        Some(Face {
            sides,
            normal,
            offset,
        })
    }

    /// The name of a corner.
    fn corner(&mut self, corner: Set) -> usize {
        let Set { place, displaced } = corner;
        let is_here = |known: &DVec3| (*known - place).abs().max_element() <= self.touching;
        let name = if let Some(name) = self.corners.iter().position(is_here) {
            let moved = displaced + self.corners[name].distance(place);
            self.moved[name] = self.moved[name].max(moved);
            name
        } else {
            self.corners.push(place);
            self.moved.push(displaced);
            self.corners.len() - 1
        };
        self.displaced = self.displaced.max(self.moved[name]);
        name
    }

    /// A side, on a line that is known or new.
    fn side(&mut self, corners: [usize; 2]) -> Side {
        let [from, to] = corners.map(|corner| self.corners[corner]);
        let along = to - from;
        for (name, line) in self.lines.iter_mut().enumerate() {
            let [start, end] = line.ends.map(|corner| self.corners[corner]);
            let known = end - start;
            // the longer of the two tells where the line runs
            let (origin, direction, others) = if known.length_squared() >= along.length_squared() {
                (start, known.normalize(), [from, to])
            } else {
                (from, along.normalize(), [start, end])
            };
            let is_on =
                |point: &DVec3| (*point - origin).cross(direction).length() <= self.touching;
            if others.iter().all(is_on) {
                let is_along = known.dot(along) > 0.0;
                if along.length_squared() > known.length_squared() {
                    line.ends = if is_along {
                        corners
                    } else {
                        [corners[1], corners[0]]
                    };
                }
                return Side {
                    line: name,
                    is_along,
                    corners,
                };
            }
        }
        self.lines.push(Line {
            ends: corners,
            through: Vec::new(),
            displaced: 0.0,
        });
        Side {
            line: self.lines.len() - 1,
            is_along: true,
            corners,
        }
    }

    /// Finds the corners on each line.
    fn find_through(&mut self) {
        for line in &mut self.lines {
            let [start, end] = line.ends.map(|corner| self.corners[corner]);
            let direction = (end - start).normalize();
            for (corner, point) in self.corners.iter().enumerate() {
                let beside = (*point - start).cross(direction).length();
                if beside <= self.touching {
                    line.through.push(corner);
                    line.displaced = line.displaced.max(beside + self.moved[corner]);
                }
            }
        }
    }
}

fn perimeter(corners: &[Set]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(next)
        .map(|(from, to)| from.place.distance(to.place))
        .sum()
}
