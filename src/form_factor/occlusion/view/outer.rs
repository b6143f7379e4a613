//! The outer integrals: stretches of edges along which what is seen may end.
//!
//! ```text
//!   A_P F = (1/2π) Σ_g Σ_k s_k ∫_g dy · ∮_{∂R_k(y)} ln|x − y| dx
//!   R_k(y) = A_k(y) without the shadows U(y), or the part of A_k(y) in them
//! ```
//!
//! From a point x of P, a stretch g is a boundary of what is seen if just one of its sides is.
//! Which one depends on the side of the faces through g on which x lies: these faces stand around g
//! like the pages of a book, and x looks past them. A face of Q among them is what is to be seen,
//! the others are in the way; where there is none of Q, Q is behind, on both sides.

use super::pages::{Page, Part, Wanted, sectors, spread, states};
use super::region::Region;
use super::setting::{Face, Setting};
use super::sight::Sight;
use super::trace::Stretch;
use glam::DVec3;

/// A set of points of P whose boundary is integrated over.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    pub region: Region,
    pub part: Part,
    pub sign: f64,
}

/// A stretch of an edge, with all that is seen from it.
#[derive(Debug, Clone)]
pub(crate) struct Outer<'a> {
    pub sight: Sight<'a>,
    pub shadows: Vec<Region>,
    pub pieces: Vec<Piece>,
    /// The largest distance of the stretch from its exact place.
    pub displaced: f64,
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
    line: usize,
    origin: DVec3,
    direction: DVec3,
    contacts: Vec<Contact>,
    /// Screens that the line is not in the plane of.
    others: Vec<&'a Face>,
    /// Whether the line lies in the plane of Q.
    is_in_second: bool,
}

/// All stretches of two faces past the screens.
pub(crate) fn outers<'a>(
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
            line,
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
        if let Some(last) = breaks.last_mut() {
            *last = high;
        }
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
        let line = setting.lines[self.line].ends;
        let line = line.map(|corner| setting.corners[corner]);
        let length = line[0].distance(line[1]);
        let stretch = Stretch::of(line, [from / length, to / length]);
        let (stretch, lowered) = stretch.levelled(setting.touching);
        let displaced = setting.lines[self.line].displaced + lowered;
        let (start, along) = (stretch.start, stretch.along);
        // an edge that stands on P's plane, up to the rounding of its ends
        if along.truncate().length() <= setting.displaced.max(2.0 * f64::EPSILON) {
            return None;
        }
        let middle = 0.5 * (from + to);
        let contacts = || {
            let contacts = self.contacts.iter();
            contacts.filter(|contact| contact.range[0] < middle && middle < contact.range[1])
        };
        let is_on_second = contacts().any(|contact| contact.is_second);
        let is_level = start.z == 0.0 && along.z == 0.0;
        if !is_on_second && (is_level || self.is_in_second) {
            return None;
        }
        let mut sight = Sight::new(setting, self.line, stretch, is_level);
        let base = self.base(&mut sight, is_on_second)?;
        let pages = self.pages(contacts());
        let mut pieces = self.pieces(&mut sight, &base, (&pages, is_on_second), wanted);
        if pieces.is_empty() {
            return None;
        }
        let shadows = self.shadows(&mut sight, &base, is_on_second);
        if shadows.is_empty() {
            pieces.retain(|piece| piece.part == Part::Lit);
        }
        sight.measure();
        let displaced = displaced + sight.leaves;
        (!pieces.is_empty()).then_some(Outer {
            sight,
            shadows,
            pieces,
            displaced,
        })
    }

    /// P, or what of it sees Q through the stretch if that is not on an edge of Q; none if nothing
    /// does.
    fn base(&self, sight: &mut Sight<'a>, is_on_second: bool) -> Option<Region> {
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
        Some(base)
    }

    /// The faces that touch the stretch, around it.
    fn pages<'c>(&self, contacts: impl Iterator<Item = &'c Contact>) -> Vec<Page> {
        let (east, north) = self.across();
        let pages = contacts.flat_map(|contact| {
            let inward = contact.inward.into_iter().flatten();
            inward.map(|inward| Page {
                angle: inward.dot(north).atan2(inward.dot(east)),
                is_second: contact.is_second,
            })
        });
        pages.collect()
    }

    /// The parts of a region between the planes of the pages, with what counts there.
    fn pieces(
        &self,
        sight: &mut Sight<'a>,
        base: &Region,
        (pages, is_on_second): (&[Page], bool),
        wanted: Wanted,
    ) -> Vec<Piece> {
        let touching = self.setting.touching;
        let spread = spread(pages, touching);
        let corners = self.ends[0].corners();
        let corners = corners.map(|corner| self.setting.corners[corner] - sight.start);
        let corners: Vec<DVec3> = corners.collect();
        let mut pieces = Vec::new();
        for (angle, bounds) in sectors(pages, &corners, self.across(), touching) {
            let mut region = base.clone();
            let bounds = bounds.into_iter();
            let bounds = bounds.map(|normal| sight.through(normal, spread));
            region.halves.extend(bounds);
            if region.is_flat() {
                continue;
            }
            for (part, sign) in states(pages, angle, is_on_second, wanted) {
                if sign != 0.0 {
                    pieces.push(Piece {
                        region: region.clone(),
                        part,
                        sign,
                    });
                }
            }
        }
        pieces
    }

    /// The shadows of the other screens, cast from the stretch, and those of screens beyond.
    fn shadows(&self, sight: &mut Sight<'a>, base: &Region, is_on_second: bool) -> Vec<Region> {
        let [first, second] = self.ends;
        let centre = sight.point(0.5);
        let misses_base = |sight: &Sight, screen: &Face, way: f64| {
            base.cones
                .iter()
                .any(|cone| sight.misses(cone, screen, way))
        };
        let shadow = |cone| Region {
            cones: vec![cone],
            ..Region::default()
        };
        let mut shadows = Vec::new();
        for screen in &self.others {
            let side = screen.height(centre).signum();
            let below = sight.cone(screen, -side);
            if !sight.misses(&below, first, 1.0) && !misses_base(sight, screen, 1.0) {
                shadows.push(shadow(below));
            }
            if !is_on_second {
                let above = sight.cone(screen, side);
                if !sight.misses(&above, second, -1.0) && !misses_base(sight, screen, -1.0) {
                    shadows.push(shadow(above));
                }
            }
        }
        shadows
    }

    /// Two directions across the line, which with it form a right-handed frame.
    fn across(&self) -> (DVec3, DVec3) {
        let east = self.direction.any_orthonormal_vector();
        (east, self.direction.cross(east))
    }
}
