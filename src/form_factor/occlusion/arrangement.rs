//! The boundary of a region that is seen from a point of a stretch, and how far it keeps its shape.
//!
//! On each line, a stretch is a boundary if just one of its sides belongs to the region; lines on
//! which sides of two shadows coincide are settled by that, too. The boundary is found at one t, by
//! comparing places on lines; each comparison that the outcome rests on is the sign of a polynomial
//! of degree 2 in t, and narrows the range of t for which the boundary has the same corners and
//! sides to what is between its nearest zeros on either side. What lies outside of the region, in
//! another shadow or past the end of its own side is compared with that alone.

use super::chord::chord;
use super::outer::{Outer, Part, Piece};
use super::sight::{Placed, Region};
use super::validity::{NONE, Place, Validity};
use smallvec::{SmallVec, smallvec};

/// A side of the boundary: a piece of a line between its crossings with two others, the region on
/// its left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Segment {
    pub line: usize,
    pub from: usize,
    pub to: usize,
}

/// A boundary, and the range of t in which it is one.
#[derive(Debug, Clone)]
pub(super) struct Arrangement {
    pub segments: Vec<Segment>,
    pub range: [f64; 2],
}

impl Arrangement {
    /// Whether each corner at which a side ends is one at which a side begins.
    pub(super) fn is_closed_by_name(&self) -> bool {
        let name = |line: usize, other: usize| [line.min(other), line.max(other)];
        let named = |which: fn(&Segment) -> usize| {
            let names = self.segments.iter().map(|s| name(s.line, which(s)));
            let mut names: SmallVec<[[usize; 2]; 16]> = names.collect();
            names.sort_unstable();
            names
        };
        named(|segment| segment.from) == named(|segment| segment.to)
    }
}

/// The lines around a piece and the shadows on it.
#[derive(Debug)]
pub(super) struct Roster<'a> {
    outer: &'a Outer<'a>,
    piece: &'a Piece,
    members: Vec<Member>,
}

/// A line, and what it bounds.
#[derive(Debug)]
struct Member {
    line: usize,
    /// The side of it on which the piece's region is.
    own: Option<f64>,
    /// The side of it on which each shadow is that it bounds.
    shadows: Vec<Option<f64>>,
    /// What is known of its chords in the shadows, and in the piece's region.
    chords: Vec<Known>,
}

/// What was found of a line and a region, with the ranges in which it is so.
#[derive(Debug, Clone, Default)]
struct Known {
    /// Where the line misses the region.
    missed: Option<[f64; 2]>,
    /// Lines that the line crosses inside of the region, and where.
    inside: SmallVec<[(usize, [f64; 2]); 4]>,
}

/// A part of a line, and the side of it that is in shadow there; none for both.
type Cover = ([Place; 2], Option<f64>);

impl<'a> Roster<'a> {
    pub(super) fn of(outer: &'a Outer<'a>, piece: &'a Piece) -> Self {
        let regions = outer.shadows.iter().chain([&piece.region]);
        let sides = regions.flat_map(Region::sides);
        let mut lines: Vec<usize> = sides.map(|half| half.line).collect();
        lines.sort_unstable();
        lines.dedup();
        let members = lines.into_iter().map(|line| Member {
            line,
            own: piece.region.side_of(line),
            shadows: outer.shadows.iter().map(|s| s.side_of(line)).collect(),
            chords: vec![Known::default(); outer.shadows.len() + 1],
        });
        Self {
            outer,
            piece,
            members: members.collect(),
        }
    }

    /// The boundary at t; none if something cannot be told there.
    pub(super) fn arrange(&mut self, range: [f64; 2], t: f64) -> Option<Arrangement> {
        let sight = &self.outer.sight;
        let lines = 0..sight.traces.len();
        let placed: Vec<Placed> = lines.map(|line| sight.placed(line, t)).collect();
        let mut slice = Slice {
            outer: self.outer,
            piece: self.piece,
            validity: Validity {
                sight,
                placed: &placed,
                t,
                range,
                is_certain: true,
            },
            segments: Vec::new(),
        };
        for member in &mut self.members {
            if placed[member.line].is_line {
                slice.on_line(member);
            } else {
                // level for a moment: it may be met beside
                slice.validity.is_certain &= sight.traces[member.line].is_level;
            }
            if !slice.validity.is_certain {
                return None;
            }
        }
        let Slice {
            segments, validity, ..
        } = slice;
        // a side without end is none of a part of P
        let is_bounded = |segment: &Segment| segment.from != NONE && segment.to != NONE;
        segments.iter().all(is_bounded).then_some(Arrangement {
            segments,
            range: validity.range,
        })
    }
}

/// A piece at one t, and what is found of its boundary.
struct Slice<'a> {
    outer: &'a Outer<'a>,
    piece: &'a Piece,
    validity: Validity<'a>,
    segments: Vec<Segment>,
}

impl<'a> Slice<'a> {
    /// The region of a shadow, or after these of the piece.
    fn region(&self, name: usize) -> &'a Region {
        let shadows = &self.outer.shadows;
        shadows.get(name).unwrap_or(&self.piece.region)
    }

    /// The ends of the chord of a line in such a region, if it has any.
    fn chord(&mut self, member: &mut Member, name: usize) -> Option<[Place; 2]> {
        let known = &mut member.chords[name].missed;
        if let Some(range) = known.filter(|range| self.is_in(*range)) {
            self.validity.within(range);
            return None;
        }
        let region = self.region(name);
        let found = self
            .validity
            .widest(|validity| chord(region, member.line, validity));
        self.validity.is_certain &= found.is_some();
        let (ends, range) = found?;
        if ends.is_none() {
            *known = Some(range);
            self.validity.within(range);
        }
        ends
    }

    /// The crossing of a line and another stays in such a region.
    fn stays(&mut self, member: &mut Member, other: usize, name: usize) {
        let region = self.region(name);
        let inside = &mut member.chords[name].inside;
        let place = inside.iter().position(|(known, _)| *known == other);
        if let Some(place) = place {
            let (_, range) = inside[place];
            if self.is_in(range) {
                self.validity.within(range);
                return;
            }
            inside.remove(place);
        }
        let line = member.line;
        let found = self.validity.widest(|validity| {
            validity.contains(line, other, region);
        });
        self.validity.is_certain &= found.is_some();
        if let Some(((), range)) = found {
            inside.push((other, range));
            self.validity.within(range);
        }
    }

    fn is_in(&self, range: [f64; 2]) -> bool {
        range[0] < self.validity.t && self.validity.t < range[1]
    }

    /// The part of a window of a line in a region, from the ends of its chord there; none if that
    /// is elsewhere.
    fn clipped(
        &mut self,
        member: &mut Member,
        window: [Place; 2],
        [low, high]: [Place; 2],
        name: usize,
    ) -> Option<[Place; 2]> {
        let line = member.line;
        if high.at <= window[0].at {
            self.validity.separates(line, [window[0].line, high.line]);
            return None;
        }
        if low.at >= window[1].at {
            self.validity.separates(line, [low.line, window[1].line]);
            return None;
        }
        let ends = [
            if low.at > window[0].at {
                low
            } else {
                window[0]
            },
            if high.at < window[1].at {
                high
            } else {
                window[1]
            },
        ];
        for end in ends {
            self.stays(member, end.line, name);
            self.validity.follow(line, &[window[0], end, window[1]]);
        }
        Some(ends)
    }

    /// Finds the segments on a line.
    fn on_line(&mut self, member: &mut Member) {
        let (line, count) = (member.line, member.shadows.len());
        let Some(base) = self.chord(member, count) else {
            return;
        };
        let mut own: SmallVec<[([Place; 2], usize); 2]> = SmallVec::new();
        for name in 0..count {
            if member.shadows[name].is_some() {
                own.extend(self.chord(member, name).map(|ends| (ends, name)));
            }
        }
        // a line that bounds one shadow alone matters along the side of that
        let only = match own.as_slice() {
            [] if member.own.is_none() => return,
            [(ends, name)] if member.own.is_none() => Some((*ends, *name)),
            _ => None,
        };
        let mut window = base;
        if let Some(([low, high], _)) = only {
            if low.at > window[0].at {
                window[0] = low;
            }
            if high.at < window[1].at {
                window[1] = high;
            }
            if window[0].at >= window[1].at {
                self.validity.separates(line, window.map(|end| end.line));
                return;
            }
        }
        let mut covers: SmallVec<[Cover; 4]> = SmallVec::new();
        for name in 0..count {
            if member.shadows[name].is_some() {
                continue;
            }
            let Some(ends) = self.chord(member, name) else {
                continue;
            };
            match self.clipped(member, window, ends, name) {
                Some([low, high]) if low.line == window[0].line && high.line == window[1].line => {
                    // both sides are in this shadow all along
                    covers = smallvec![(window, None)];
                    if member.own.is_none() || self.piece.part == Part::Lit {
                        return;
                    }
                    break;
                }
                Some(ends) => covers.push((ends, None)),
                None => {}
            }
        }
        for end in window {
            self.stays(member, end.line, count);
            if let Some((_, name)) = only {
                self.stays(member, end.line, name);
            }
        }
        self.validity.follow(line, &window);
        let mut covers = joined(line, covers, &mut self.validity);
        for (ends, name) in own {
            let ends = if only.is_some() {
                // what is in its own shadow alone is so from end to end
                Some(window)
            } else {
                self.clipped(member, window, ends, name)
            };
            covers.extend(ends.map(|ends| (ends, member.shadows[name])));
        }
        if only.is_none() {
            self.validity.follow(line, &places(window, &covers));
        }
        self.sweep(member, window, &covers);
    }

    /// The segments in a window of a line, from what is in shadow beside it.
    fn sweep(&mut self, member: &Member, window: [Place; 2], covers: &[Cover]) {
        let belongs = |at: f64, side: f64| {
            if member.own.is_some_and(|own| own * side < 0.0) {
                return false;
            }
            let mut covers = covers.iter();
            let is_covered = covers.any(|([from, to], only)| {
                from.at < at && at < to.at && only.is_none_or(|only| only * side > 0.0)
            });
            is_covered == (self.piece.part == Part::InShadow)
        };
        let mut open: Option<(f64, Place)> = None;
        let mut found: SmallVec<[Segment; 4]> = SmallVec::new();
        for pair in places(window, covers).windows(2) {
            if pair[1].at <= pair[0].at {
                continue;
            }
            let at = 0.5 * (pair[0].at + pair[1].at);
            let sides = [belongs(at, 1.0), belongs(at, -1.0)];
            let state = f64::from(u8::from(sides[0])) - f64::from(u8::from(sides[1]));
            if open.is_some_and(|(known, _)| known * state <= 0.0) {
                found.extend(segment(member.line, open.take(), pair[0]));
            }
            if open.is_none() && state != 0.0 {
                open = Some((state, pair[0]));
            }
        }
        found.extend(segment(member.line, open, window[1]));
        self.segments.extend(found);
    }
}

/// The ends of a window and of what covers it, in order.
fn places(window: [Place; 2], covers: &[Cover]) -> SmallVec<[Place; 8]> {
    let [low, high] = window;
    let inner = covers.iter().flat_map(|(ends, _)| *ends);
    let inner = inner.filter(|place| place.at > low.at && place.at < high.at);
    let mut places: SmallVec<[Place; 8]> = [low, high].into_iter().chain(inner).collect();
    places.sort_by(|one, other| one.at.total_cmp(&other.at));
    places
}

/// The union of what covers parts of a line, both sides of it.
fn joined(
    line: usize,
    mut covers: SmallVec<[Cover; 4]>,
    validity: &mut Validity,
) -> SmallVec<[Cover; 4]> {
    covers.sort_by(|one, other| one.0[0].at.total_cmp(&other.0[0].at));
    let mut joined: SmallVec<[Cover; 4]> = SmallVec::new();
    for ([low, high], _) in covers {
        if let Some((last, _)) = joined.last_mut() {
            validity.ordered(line, last[0].line, low.line);
            validity.ordered(line, last[1].line, low.line);
            if low.at <= last[1].at {
                validity.ordered(line, last[1].line, high.line);
                if high.at > last[1].at {
                    last[1] = high;
                }
                continue;
            }
        }
        joined.push(([low, high], None));
    }
    joined
}

/// A segment that is open to the right or to the left, up to its end.
fn segment(line: usize, open: Option<(f64, Place)>, end: Place) -> Option<Segment> {
    let (state, start) = open?;
    let (from, to) = if state > 0.0 {
        (start.line, end.line)
    } else {
        (end.line, start.line)
    };
    Some(Segment { line, from, to })
}
