//! Lines of sight through a point that moves along an edge, and what bounds them.
//!
//! ```text
//!   y(t) = y0 + t v,  t from 0 to 1,  height h(t) over P's plane;    x = y + X,  X = h ξ
//!   the plane of y and an edge from a to b has the normal n(t) = (a − y) × (b − y), linear in t
//!   it meets P's plane in the line  α·ξ = c  with  α = (n_x, n_y), c = n_z
//! ```
//!
//! For an edge in P's plane the line is that edge, whatever y is: `α·X = γ` with a constant α and a
//! γ that is linear in t, n = (h α, γ). Planes that hold the whole stretch have a constant normal;
//! those that coincide are one line.

use super::region::{Cone, HalfPlane};
use super::setting::{Face, Setting};
use super::trace::{LEVEL, Middle, Placed, Stretch, Trace};
use glam::{DVec2, DVec3};

/// A stretch y(t) and the lines of sight from it.
#[derive(Debug, Clone)]
pub(crate) struct Sight<'a> {
    pub setting: &'a Setting,
    /// The line that the stretch is on.
    line: usize,
    stretch: Stretch,
    /// The distance by which the stretch leaves planes that are taken to hold it.
    pub leaves: f64,
    pub start: DVec3,
    pub along: DVec3,
    /// Whether the stretch lies in P's plane.
    pub is_level: bool,
    pub traces: Vec<Trace>,
    /// The place of each line in space among the traces, and whether it was turned round.
    known: Vec<Option<(usize, f64)>>,
    heights: Vec<[f64; 2]>,
}

impl<'a> Sight<'a> {
    pub(crate) fn new(setting: &'a Setting, line: usize, stretch: Stretch, is_level: bool) -> Self {
        Self {
            setting,
            line,
            leaves: 0.0,
            start: stretch.start,
            along: stretch.along,
            stretch,
            is_level,
            traces: Vec::new(),
            known: vec![None; setting.lines.len()],
            heights: Vec::new(),
        }
    }

    /// The cone of a face: the half-planes of its sides, which its points are in from a y with
    /// `sign` −1 in front of it.
    pub(crate) fn cone(&mut self, face: &Face, sign: f64) -> Cone {
        let sides = face.sides.iter();
        let sides = sides
            .map(|side| {
                let (line, turn) = self.trace(side.line);
                let run = if side.is_along { 1.0 } else { -1.0 };
                HalfPlane {
                    line,
                    sign: sign * run * turn,
                }
            })
            .collect();
        Cone {
            corners: face.corners().collect(),
            sides,
        }
    }

    /// The half-plane of points to which a normal of a plane through the stretch points.
    ///
    /// **Arguments** `error`: of the normal.
    pub(crate) fn through(&mut self, normal: DVec3, error: f64) -> HalfPlane {
        let (line, sign) = self.fixed(normal, [error, 0.0]);
        HalfPlane { line, sign }
    }

    fn trace(&mut self, space: usize) -> (usize, f64) {
        if let Some(known) = self.known[space] {
            return known;
        }
        let ends = self.setting.lines[space].ends;
        let [a, b] = ends.map(|corner| self.setting.corners[corner]);
        let trace = Trace::of_edge(&self.stretch, [a, b], space);
        let setting = self.setting;
        let touching = setting.touching;
        let middle = trace.normal[0] + 0.5 * trace.normal[1];
        let length = middle.length();
        // how far the stretch leaves the plane
        let leaves = middle.dot(self.along).abs() / length;
        let is_level_edge = self.is_level && trace.edge.is_some();
        let through = trace.edge.filter(|(alpha, [gamma, slope])| {
            self.is_level && gamma.abs() + slope.abs() <= touching * alpha.length()
        });
        let found = if let Some((alpha, [gamma, slope])) = through {
            let error = (gamma.abs() + slope.abs()) / alpha.length() / self.along.length();
            let normal = alpha.normalize().extend(0.0);
            self.fixed(normal, [f64::EPSILON + error, 0.0])
        } else if leaves <= touching && !is_level_edge {
            self.leaves = self.leaves.max(leaves);
            let unit = middle / length;
            let edge = b - a;
            // what the rounding of corners turns the plane by
            let turned = 4.0 * (setting.displaced + f64::EPSILON) * edge.length() / length;
            let turned = turned.min(ONE_PLANE);
            let sine = edge.cross(self.along).length() / (edge.length() * self.along.length());
            if sine <= PARALLEL {
                let lines = [self.line.min(space), self.line.max(space)];
                let lines = lines.map(|line| self.setting.lines[line].ends);
                let ends = lines.map(|ends| ends.map(|corner| self.setting.corners[corner]));
                let normal = Trace::plane_of(ends);
                let normal = normal.dot(unit).signum() * normal;
                let normal = if normal.is_finite() { normal } else { unit };
                self.fixed(normal, [2.0 * f64::EPSILON, turned])
            } else {
                let [start, slope] = trace.error;
                let error = (start + 0.5 * slope + 0.5 * leaves * edge.length()) / length;
                self.fixed(unit, [2.0 * f64::EPSILON + error, turned])
            }
        } else {
            self.traces.push(trace);
            (self.traces.len() - 1, 1.0)
        };
        self.known[space] = Some(found);
        found
    }

    /// The line of a plane that holds the stretch, and whether that has the other side on its left.
    ///
    /// Where the stretch lies in P's plane, all such planes meet that in the line of the stretch.
    fn fixed(&mut self, mut normal: DVec3, [mut error, turned]: [f64; 2]) -> (usize, f64) {
        let slope = normal.truncate().length();
        if self.is_level && slope > LEVEL {
            normal = (normal.truncate() / slope).extend(0.0);
            error = error / slope + f64::EPSILON;
        }
        let touching = self.setting.touching;
        for (line, trace) in self.traces.iter_mut().enumerate() {
            if !trace.is_fixed {
                continue;
            }
            let apart = trace.normal[0].cross(normal).length();
            if apart <= touching.max(turned).max(trace.turned) {
                let sign = trace.normal[0].dot(normal).signum();
                if turned < trace.turned {
                    // the one of which more is known
                    let error = trace.error[0].max(error);
                    *trace = Trace::fixed(sign * normal, [error, turned]);
                }
                trace.error[0] = trace.error[0].max(error + apart);
                return (line, sign);
            }
        }
        self.traces.push(Trace::fixed(normal, [error, turned]));
        (self.traces.len() - 1, 1.0)
    }

    /// y in the middle of a panel.
    pub(crate) fn middle(&self, t: f64, half: f64) -> Middle {
        self.stretch.middle(t, half)
    }

    /// Measures the heights of corners over the planes of sight of all lines.
    pub(crate) fn measure(&mut self) {
        self.heights.clear();
        for trace in &self.traces {
            let [from, slope] = trace.normal;
            let last = from + slope;
            let none = self.setting.touching * from.length().max(last.length());
            self.heights
                .extend(self.setting.corners.iter().map(|corner| {
                    let place = *corner - self.start;
                    let ends = [from.dot(place), last.dot(place - self.along)];
                    if ends[0].abs().max(ends[1].abs()) <= none {
                        [0.0; 2]
                    } else {
                        ends
                    }
                }));
        }
    }

    /// The heights of a corner over the plane of sight of a line, at both ends of the stretch; 0
    /// if it lies in it all along.
    pub(crate) fn ends_of_height(&self, line: usize, corner: usize) -> [f64; 2] {
        self.heights[line * self.setting.corners.len() + corner]
    }

    /// The corner of space that two lines have in common.
    pub(crate) fn common(&self, one: usize, other: usize) -> Option<DVec3> {
        let lines = &self.setting.lines;
        let through = |line: usize| self.traces[line].space.map(|space| &lines[space].through);
        let (one, other) = (through(one)?, through(other)?);
        let corner = one.iter().find(|corner| other.contains(corner))?;
        Some(self.setting.corners[*corner])
    }

    /// Whether a face is outside of one of a cone's sides, from all of the stretch.
    ///
    /// **Arguments** `way`: 1 for what is seen by looking at the face, −1 for what the lines of
    /// sight meet that come from there.
    pub(crate) fn misses(&self, cone: &Cone, face: &Face, way: f64) -> bool {
        let corners = face
            .corners()
            .map(|corner| self.setting.corners[corner] - self.start);
        let corners: Vec<DVec3> = corners.collect();
        cone.sides.iter().any(|half| {
            let trace = &self.traces[half.line];
            if self.is_level && (trace.edge.is_some() || trace.is_fixed) {
                // a line in P's plane, no plane of sight
                return false;
            }
            let [from, slope] = trace.normal;
            let ends = corners.iter().flat_map(|corner| {
                let last = *corner - self.along;
                [from.dot(*corner), (from + slope).dot(last)]
            });
            let mut least = 0.0f64;
            let mut most = f64::NEG_INFINITY;
            for height in ends.map(|height| half.sign * way * height) {
                (least, most) = (least.min(height), most.max(height));
            }
            most <= 0.0 && least < 0.0
        })
    }

    /// A line at t.
    pub(crate) fn placed(&self, line: usize, t: f64) -> Placed {
        let (alpha, gamma) = self.line_at(line, t);
        let length = alpha.length();
        let trace = &self.traces[line];
        let normal = trace.normal[0] + t * trace.normal[1];
        Placed {
            alpha,
            gamma,
            origin: alpha * (gamma / (length * length)),
            direction: DVec2::new(alpha.y, -alpha.x) / length,
            is_line: trace.edge.is_some() || length > LEVEL * normal.length(),
        }
    }

    /// The line's `(α, γ)` but for a positive factor, linear in t.
    pub(crate) fn form(&self, line: usize) -> [DVec3; 2] {
        let trace = &self.traces[line];
        match trace.edge {
            Some((alpha, gamma)) if self.is_level => {
                [alpha.extend(gamma[0]), DVec3::new(0.0, 0.0, gamma[1])]
            }
            None if self.is_level => trace.normal.map(|n| n.truncate().extend(0.0)),
            _ => trace.normal,
        }
    }

    pub(crate) fn point(&self, t: f64) -> DVec3 {
        self.start + t * self.along
    }

    /// Height of the stretch, `h0 + t h1`.
    fn height(&self) -> [f64; 2] {
        [self.start.z, self.along.z]
    }

    /// The line `α·X = γ` at t.
    pub(crate) fn line_at(&self, line: usize, t: f64) -> (DVec2, f64) {
        let trace = &self.traces[line];
        match trace.edge {
            Some((alpha, [gamma, slope])) => (alpha, gamma + t * slope),
            None => {
                let normal = trace.normal[0] + t * trace.normal[1];
                let [height, rise] = self.height();
                (normal.truncate(), (height + t * rise) * normal.z)
            }
        }
    }
}

/// The largest angle between planes that count as one, as corners near the stretch are rounded.
const ONE_PLANE: f64 = 1e-12;

/// Edges at less than this angle are seen in the plane between them.
const PARALLEL: f64 = 1e-6;
