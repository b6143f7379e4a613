//! The outer integrals: stretches of edges along which what is seen may end.
//!
//! ```text
//!   A_P F = (1/2π) Σ_g Σ_k s_k ∫_g dy · ∮_{∂R_k(y)} ln|x − y| dx
//!   R_k(y) = A_k(y) without the shadows U(y), or the part of A_k(y) in them
//! ```
//!
//! From a point x of P, a stretch g is a boundary of what is seen if just one of its sides is. Which
//! one depends on the side of the faces through g on which x lies: these faces stand around g like
//! the pages of a book, and x looks past them. A face of Q among them is what is to be seen, the
//! others are in the way; where there is none of Q, Q is behind, on both sides.

use super::setting::{Face, Setting};
use super::sight::{Region, Sight};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The set whose exchange is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wanted {
    /// The part that is hidden, of all that would be seen.
    Hidden,
    /// The part that is seen.
    Seen,
}

/// The part of a region that counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    InShadow,
    Lit,
}

/// A set of points of P whose boundary is integrated over.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub region: Region,
    pub part: Part,
    pub sign: f64,
}

/// A stretch of an edge, with all that is seen from it.
#[derive(Debug, Clone)]
pub(super) struct Outer<'a> {
    pub sight: Sight<'a>,
    pub shadows: Vec<Region>,
    pub pieces: Vec<Piece>,
}

/// A page of the book: a face through the stretch.
#[derive(Debug, Clone, Copy)]
struct Page {
    angle: f64,
    is_second: bool,
}

/// The range of a line in which a face touches it.
struct Contact {
    range: [f64; 2],
    /// Directions into the face; both sides where the line is inside.
    inward: [Option<DVec3>; 2],
    is_side: bool,
    is_second: bool,
}

/// A line with what touches it.
struct Book<'a> {
    setting: &'a Setting,
    ends: [&'a Face; 2],
    origin: DVec3,
    direction: DVec3,
    contacts: Vec<Contact>,
    /// Screens that the line is not in the plane of.
    others: Vec<&'a Face>,
    /// Whether it lies in the plane of Q.
    is_in_second: bool,
}

/// All stretches of two faces past the screens.
pub(super) fn outers<'a>(
    setting: &'a Setting,
    ends: [&'a Face; 2],
    wanted: Wanted,
) -> Vec<Outer<'a>> {
    let mut found = Vec::new();
    for line in 0..setting.lines.len() {
        let book = Book::of(setting, ends, line);
        for [from, to] in book.stretches() {
            found.extend(book.outer(from, to, wanted));
        }
    }
    found
}

impl<'a> Book<'a> {
    fn of(setting: &'a Setting, ends: [&'a Face; 2], line: usize) -> Self {
        let [start, end] = setting.lines[line].ends.map(|c| setting.corners[c]);
        let mut book = Self {
            setting,
            ends,
            origin: start,
            direction: (end - start).normalize(),
            contacts: Vec::new(),
            others: Vec::new(),
            is_in_second: false,
        };
        let screens = setting.screens.iter().map(|face| (face, false));
        for (face, is_second) in screens.chain([(ends[1], true)]) {
            let side = face.sides.iter().find(|side| side.line == line);
            let is_in_plane = || {
                let heights = [start, end].map(|point| face.height(point).abs());
                heights[0].max(heights[1]) <= setting.touching
            };
            if let Some(side) = side {
                let along = side
                    .corners
                    .map(|corner| book.place(setting.corners[corner]));
                let run = if side.is_along { 1.0 } else { -1.0 };
                book.contacts.push(Contact {
                    range: [along[0].min(along[1]), along[0].max(along[1])],
                    inward: [Some(run * face.normal.cross(book.direction)), None],
                    is_side: true,
                    is_second,
                });
                book.is_in_second |= is_second;
            } else if is_in_plane() {
                book.is_in_second |= is_second;
                let aside = face.normal.cross(book.direction);
                if let Some(range) = book.inside(face) {
                    book.contacts.push(Contact {
                        range,
                        inward: [Some(aside), Some(-aside)],
                        is_side: false,
                        is_second,
                    });
                }
            } else if !is_second {
                book.others.push(face);
            }
        }
        book
    }

    fn place(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.direction)
    }

    /// The range of the line inside a face in whose plane it lies.
    fn inside(&self, face: &Face) -> Option<[f64; 2]> {
        let corners = &self.setting.corners;
        let [mut low, mut high] = [f64::NEG_INFINITY, f64::INFINITY];
        for side in &face.sides {
            let [from, to] = side.corners.map(|corner| corners[corner]);
            let inward = face.normal.cross(to - from).normalize();
            let (height, slope) = ((self.origin - from).dot(inward), self.direction.dot(inward));
            if slope.abs() * self.setting.touching.sqrt() <= self.setting.touching {
                if height <= self.setting.touching {
                    return None;
                }
                continue;
            }
            let at = -height / slope;
            if slope > 0.0 {
                low = low.max(at);
            } else {
                high = high.min(at);
            }
        }
        (high - low > self.setting.touching).then_some([low, high])
    }

    /// The stretches of the line that sides of Q or of screens cover, along which the same faces
    /// touch it, all others staying on one side.
    fn stretches(&self) -> Vec<[f64; 2]> {
        let touching = self.setting.touching;
        let sides = || self.contacts.iter().filter(|contact| contact.is_side);
        let low = sides()
            .map(|side| side.range[0])
            .fold(f64::INFINITY, f64::min);
        let high = sides()
            .map(|side| side.range[1])
            .fold(f64::NEG_INFINITY, f64::max);
        let mut breaks = vec![low, high];
        let mut add = |at: f64| {
            if at > low && at < high {
                breaks.push(at);
            }
        };
        for contact in &self.contacts {
            contact.range.into_iter().for_each(&mut add);
        }
        for face in &self.others {
            let (height, slope) = (face.height(self.origin), face.normal.dot(self.direction));
            // the plane is crossed somewhere, since the line is not in it; parallels far away
            let at = -height / slope;
            if at.is_finite() {
                add(at);
            }
        }
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|next, last| *next - *last <= touching);
        let pairs = breaks.windows(2).map(|pair| [pair[0], pair[1]]);
        pairs
            .filter(|[from, to]| {
                let middle = 0.5 * (from + to);
                sides().any(|side| side.range[0] < middle && middle < side.range[1])
            })
            .collect()
    }

    fn outer(&self, from: f64, to: f64, wanted: Wanted) -> Option<Outer<'a>> {
        let setting = self.setting;
        let point = |at: f64| {
            let mut point = self.origin + at * self.direction;
            if point.z.abs() <= setting.touching {
                point.z = 0.0;
            }
            point
        };
        let (start, end) = (point(from), point(to));
        let along = end - start;
        if along.truncate().length() <= setting.displaced {
            return None;
        }
        let middle = 0.5 * (from + to);
        let contacts = || {
            let contacts = self.contacts.iter();
            contacts.filter(|contact| contact.range[0] < middle && middle < contact.range[1])
        };
        let is_on_second = contacts().any(|contact| contact.is_second);
        let is_level = start.z == 0.0 && end.z == 0.0;
        if !is_on_second && (is_level || self.is_in_second) {
            return None;
        }
        let mut sight = Sight::new(setting, start, along, is_level);
        let (east, north) = self.across();
        let pages = contacts().flat_map(|contact| {
            let inward = contact.inward.into_iter().flatten();
            inward.map(|inward| Page {
                angle: inward.dot(north).atan2(inward.dot(east)),
                is_second: contact.is_second,
            })
        });
        let pages: Vec<Page> = pages.collect();
        let [first, second] = self.ends;
        let mut base = Region {
            cones: vec![sight.cone(first, -1.0)],
            ..Region::default()
        };
        if !is_on_second {
            base.cones.push(sight.cone(second, 1.0));
            let [below, above] = [&base.cones[0], &base.cones[1]];
            if sight.misses(above, first, 1.0) || sight.misses(below, second, -1.0) {
                return None;
            }
        }
        let mut pieces = Vec::new();
        for (angle, bounds) in self.sectors(&pages, start) {
            let mut region = base.clone();
            region
                .halves
                .extend(bounds.into_iter().map(|normal| sight.through(normal)));
            if region.is_flat() {
                continue;
            }
            for (part, sign) in states(&pages, angle, is_on_second, wanted) {
                if sign != 0.0 {
                    pieces.push(Piece {
                        region: region.clone(),
                        part,
                        sign,
                    });
                }
            }
        }
        if pieces.is_empty() {
            return None;
        }
        let mut shadows = Vec::new();
        let centre = start + 0.5 * along;
        let misses_base = |sight: &Sight, screen: &Face, way: f64| {
            base.cones
                .iter()
                .any(|cone| sight.misses(cone, screen, way))
        };
        let shadow = |cone| Region {
            cones: vec![cone],
            ..Region::default()
        };
        for screen in &self.others {
            let side = screen.height(centre).signum();
            let below = sight.cone(screen, -side);
            if !sight.misses(&below, first, 1.0) && !misses_base(&sight, screen, 1.0) {
                shadows.push(shadow(below));
            }
            if !is_on_second {
                let above = sight.cone(screen, side);
                if !sight.misses(&above, second, -1.0) && !misses_base(&sight, screen, -1.0) {
                    shadows.push(shadow(above));
                }
            }
        }
        if shadows.is_empty() {
            pieces.retain(|piece| piece.part == Part::Lit);
        }
        sight.measure();
        (!pieces.is_empty()).then_some(Outer {
            sight,
            shadows,
            pieces,
        })
    }

    /// Two directions across the line, which with it form a right-handed frame.
    fn across(&self) -> (DVec3, DVec3) {
        let east = self.direction.any_orthonormal_vector();
        (east, self.direction.cross(east))
    }

    /// The sectors around the line in which points of P lie, between the planes of pages: an angle
    /// in each, and the inward normals of what bounds it.
    fn sectors(&self, pages: &[Page], start: DVec3) -> Vec<(f64, Vec<DVec3>)> {
        let (east, north) = self.across();
        let corners = self.ends[0]
            .corners()
            .map(|corner| self.setting.corners[corner] - start);
        let corners: Vec<DVec3> = corners.collect();
        let touching = self.setting.touching;
        let direction = |angle: f64| angle.cos() * east + angle.sin() * north;
        let mut planes: Vec<f64> = pages.iter().map(|page| page.angle.rem_euclid(PI)).collect();
        planes.sort_by(f64::total_cmp);
        planes.dedup_by(|next, last| (*next - *last).abs() < 1e-12);
        let mut angles = planes.clone();
        angles.extend(planes.iter().map(|angle| angle + PI));
        angles.extend(planes.first().map(|first| first + TAU));
        let between = angles.windows(2).map(|pair| {
            let bounds = if planes.len() == 1 {
                vec![direction(pair[0] + 0.5 * PI)]
            } else {
                vec![direction(pair[0] + 0.5 * PI), direction(pair[1] - 0.5 * PI)]
            };
            (0.5 * (pair[0] + pair[1]), bounds)
        });
        let is_met = |(_, bounds): &(f64, Vec<DVec3>)| {
            let met = |normal: &DVec3| corners.iter().any(|corner| corner.dot(*normal) > touching);
            bounds.iter().all(met)
        };
        let mut met: Vec<(f64, Vec<DVec3>)> = between.filter(is_met).collect();
        for (_, bounds) in &mut met {
            let cuts = |normal: &DVec3| corners.iter().any(|c| c.dot(*normal) < -touching);
            bounds.retain(cuts);
        }
        met
    }
}

/// The parts that count for a point at an angle, with their signs.
fn states(pages: &[Page], angle: f64, is_on_second: bool, wanted: Wanted) -> [(Part, f64); 2] {
    // the turn from the point to each page, by way of the left or of the right
    let side = |is_left: bool| {
        let turns = pages.iter().map(move |page| {
            let turn = if is_left {
                angle - page.angle
            } else {
                page.angle - angle
            };
            (turn.rem_euclid(TAU), page.is_second)
        });
        turns.filter(|(turn, _)| *turn > 0.0 && *turn < PI)
    };
    let count = |holds: bool| if holds { 1.0 } else { 0.0 };
    let state = |is_left: bool| {
        if !is_on_second {
            let is_hidden = side(is_left).next().is_some();
            return [1.0, count(is_hidden)];
        }
        let seen = side(is_left).find(|(_, is_second)| *is_second);
        let Some((depth, _)) = seen else {
            return [0.0, 0.0];
        };
        let is_hidden = side(is_left).any(|(turn, is_second)| !is_second && turn < depth);
        [1.0, count(is_hidden)]
    };
    let ([left, left_hidden], [right, right_hidden]) = (state(true), state(false));
    let (whole, hidden) = (left - right, left_hidden - right_hidden);
    match wanted {
        Wanted::Hidden => [(Part::InShadow, whole), (Part::Lit, hidden)],
        Wanted::Seen => [(Part::InShadow, 0.0), (Part::Lit, whole - hidden)],
    }
}
