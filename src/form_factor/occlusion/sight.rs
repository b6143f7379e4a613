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

use super::setting::{Face, Setting};
use super::share::Share;
use glam::{DVec2, DVec3};

/// One side of a line: `sign · (α·ξ − c) ≥ 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HalfPlane {
    pub line: usize,
    pub sign: f64,
}

/// A convex face, seen from y.
#[derive(Debug, Clone)]
pub(super) struct Cone {
    pub corners: Vec<usize>,
    /// The half-planes of the sides from each corner to the next.
    pub sides: Vec<HalfPlane>,
}

/// The intersection of cones and half-planes.
#[derive(Debug, Clone, Default)]
pub(super) struct Region {
    pub cones: Vec<Cone>,
    pub halves: Vec<HalfPlane>,
}

impl Region {
    pub(super) fn sides(&self) -> impl Iterator<Item = &HalfPlane> {
        self.cones
            .iter()
            .flat_map(|cone| &cone.sides)
            .chain(&self.halves)
    }

    /// Whether two sides leave nothing of the region but a piece of a line.
    pub(super) fn is_flat(&self) -> bool {
        let mut sides = self.sides();
        sides.any(|side| {
            self.sides()
                .any(|o| o.line == side.line && o.sign * side.sign < 0.0)
        })
    }

    /// Whether a line is one of those around the region, and which side of it that is on.
    pub(super) fn side_of(&self, line: usize) -> Option<f64> {
        self.sides()
            .find(|half| half.line == line)
            .map(|half| half.sign)
    }
}

/// A line in P's plane, as seen from y.
#[derive(Debug, Clone)]
pub(super) struct Trace {
    /// The normal of the plane of sight, `n0 + t n1`.
    pub normal: [DVec3; 2],
    /// The constant α, and γ = `γ0 + t γ1`, of an edge in P's plane.
    pub edge: Option<(DVec2, [f64; 2])>,
    /// The edges' line in space; none for a plane that holds the stretch.
    space: Option<usize>,
    /// Whether the plane holds the stretch.
    is_fixed: bool,
    /// The normal of the line in P's plane but for a positive factor, linear in t, and its size.
    pub planar: [DVec2; 2],
    pub planar_size: f64,
    /// The size of the plane's normal.
    pub size: f64,
    /// Whether the plane of sight is level all along, so that it meets P's plane nowhere.
    pub is_level: bool,
}

impl Trace {
    fn new(
        normal: [DVec3; 2],
        edge: Option<(DVec2, [f64; 2])>,
        space: Option<usize>,
        is_fixed: bool,
    ) -> Self {
        let planar = match edge {
            Some((alpha, _)) => [alpha, DVec2::ZERO],
            None => normal.map(DVec3::truncate),
        };
        let planar_size = planar[0].length() + planar[1].length();
        let size = normal[0].length() + normal[1].length();
        Self {
            normal,
            edge,
            space,
            is_fixed,
            planar,
            planar_size,
            size,
            is_level: edge.is_none() && planar_size <= LEVEL * size,
        }
    }
}

/// A line at one t: `α·X = γ`, its place nearest to y and its direction, the positive side on the
/// left.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed {
    pub alpha: DVec2,
    pub gamma: f64,
    pub origin: DVec2,
    pub direction: DVec2,
    /// Whether it is a line at all, and not at infinity.
    pub is_line: bool,
}

/// A stretch y(t) and the lines of sight from it.
#[derive(Debug, Clone)]
pub(super) struct Sight<'a> {
    setting: &'a Setting,
    pub start: DVec3,
    pub along: DVec3,
    /// Whether the stretch lies in P's plane.
    pub is_level: bool,
    pub traces: Vec<Trace>,
    /// Where each line in space is among the traces, and whether it was turned round.
    known: Vec<Option<(usize, f64)>>,
    heights: Vec<[f64; 2]>,
}

impl<'a> Sight<'a> {
    pub(super) fn new(setting: &'a Setting, start: DVec3, along: DVec3, is_level: bool) -> Self {
        Self {
            setting,
            start,
            along,
            is_level,
            traces: Vec::new(),
            known: vec![None; setting.lines.len()],
            heights: Vec::new(),
        }
    }

    /// The cone of a face: the half-planes of its sides, which its points are in from a y with
    /// `sign` −1 in front of it.
    pub(super) fn cone(&mut self, face: &Face, sign: f64) -> Cone {
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
    pub(super) fn through(&mut self, normal: DVec3) -> HalfPlane {
        let (line, sign) = self.fixed(normal);
        HalfPlane { line, sign }
    }

    fn trace(&mut self, space: usize) -> (usize, f64) {
        if let Some(known) = self.known[space] {
            return known;
        }
        let ends = self.setting.lines[space].ends;
        let [a, b] = ends.map(|corner| self.setting.corners[corner] - self.start);
        // a × (b − a): of short edges far away a × b would lose digits
        let normal = [a.cross(b - a), (b - a).cross(self.along)];
        let edge = (a.z + self.start.z == 0.0 && b.z + self.start.z == 0.0).then(|| {
            let run = (b - a).truncate();
            let gamma = [a.truncate().perp_dot(run), normal[1].z];
            (DVec2::new(run.y, -run.x), gamma)
        });
        let middle = normal[0] + 0.5 * normal[1];
        let length = middle.length();
        let is_fixed = middle.dot(self.along).abs() <= self.setting.touching * length;
        let through = edge.filter(|(alpha, [gamma, slope])| {
            self.is_level && gamma.abs() + slope.abs() <= self.setting.touching * alpha.length()
        });
        let found = if let Some((alpha, _)) = through {
            self.fixed(alpha.normalize().extend(0.0))
        } else if is_fixed && !(self.is_level && edge.is_some()) {
            self.fixed(middle / length)
        } else {
            self.traces
                .push(Trace::new(normal, edge, Some(space), false));
            (self.traces.len() - 1, 1.0)
        };
        self.known[space] = Some(found);
        found
    }

    fn fixed(&mut self, normal: DVec3) -> (usize, f64) {
        for (line, trace) in self.traces.iter().enumerate() {
            if trace.is_fixed && trace.normal[0].cross(normal).length() <= self.setting.touching {
                return (line, trace.normal[0].dot(normal).signum());
            }
        }
        self.traces
            .push(Trace::new([normal, DVec3::ZERO], None, None, true));
        (self.traces.len() - 1, 1.0)
    }

    /// Measures the heights of corners over the planes of sight of all lines.
    pub(super) fn measure(&mut self) {
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
    pub(super) fn ends_of_height(&self, line: usize, corner: usize) -> [f64; 2] {
        self.heights[line * self.setting.corners.len() + corner]
    }

    /// The corner of space that two lines have in common.
    pub(super) fn common(&self, one: usize, other: usize) -> Option<DVec3> {
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
    pub(super) fn misses(&self, cone: &Cone, face: &Face, way: f64) -> bool {
        let corners = face
            .corners()
            .map(|corner| self.setting.corners[corner] - self.start);
        let corners: Vec<DVec3> = corners.collect();
        cone.sides.iter().any(|half| {
            let trace = &self.traces[half.line];
            if self.is_level && trace.edge.is_some() {
                // no plane of sight
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

    /// A piece of the stretch on which nothing is certain but that `|W| ≤ |v| ∫_P dx/r`, which is
    /// largest in a disc around y: at most `2 √(π A_P)`.
    pub(super) fn unsettled(&self, width: f64) -> Share {
        Share {
            truncation: self.setting.most * self.along.length() * width,
            ..Share::default()
        }
    }

    /// A gap in which W is taken as it is beside it: it changes by at most K times the width.
    ///
    /// The integrand `n·(v × (y − x))/r²` changes by at most `3 |v|²/r²` and the lines of the
    /// boundary sweep over at most their speed times their length; r is at least h.
    pub(super) fn bridge(&self, from: f64, to: f64) -> Share {
        let width = to - from;
        let height = self.point(from).z.min(self.point(to).z);
        let unsettled = self.unsettled(width);
        if width <= 0.0 {
            return Share::default();
        }
        let speed = self.along.length();
        let reach = self.setting.most;
        let lines = self.traces.iter().enumerate().map(|(line, trace)| {
            let (alpha, _) = self.line_at(line, from);
            let change = match trace.edge {
                Some((_, [_, slope])) => slope.abs(),
                None => {
                    let [_, slope] = trace.normal;
                    let normal = trace.normal[0] + from * slope;
                    slope.truncate().length() * reach
                        + height * slope.z.abs()
                        + self.along.z.abs() * normal.z.abs()
                }
            };
            change / alpha.length()
        });
        let swept: f64 = lines.filter(|speed| speed.is_finite()).sum();
        let change = speed * (swept * reach + 3.0 * speed * reach * reach / height) / height;
        let truncation = (change * width * width).min(unsettled.truncation);
        Share {
            truncation: if truncation.is_nan() {
                unsettled.truncation
            } else {
                truncation
            },
            ..unsettled
        }
    }

    /// A line at t.
    pub(super) fn placed(&self, line: usize, t: f64) -> Placed {
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
    pub(super) fn form(&self, line: usize) -> [DVec3; 2] {
        let trace = &self.traces[line];
        match trace.edge {
            Some((alpha, gamma)) if self.is_level => {
                [alpha.extend(gamma[0]), DVec3::new(0.0, 0.0, gamma[1])]
            }
            None if self.is_level => trace.normal.map(|n| n.truncate().extend(0.0)),
            _ => trace.normal,
        }
    }

    pub(super) fn point(&self, t: f64) -> DVec3 {
        self.start + t * self.along
    }

    /// Height of the stretch, `h0 + t h1`.
    fn height(&self) -> [f64; 2] {
        [self.start.z, self.along.z]
    }

    /// The line `α·X = γ` at t.
    pub(super) fn line_at(&self, line: usize, t: f64) -> (DVec2, f64) {
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

/// The slope below which a plane counts as level.
const LEVEL: f64 = 1e-14;
