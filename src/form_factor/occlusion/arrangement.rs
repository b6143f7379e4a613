//! The boundary of a region that is seen from a point of a stretch, and how far it keeps its shape.
//!
//! On each line, a stretch is a boundary if just one of its sides belongs to the region; lines on
//! which sides of two shadows coincide are settled by that, too. The boundary is found at one t, by
//! comparing places on lines; each comparison that the outcome rests on is the sign of a polynomial
//! of degree 2 in t, and narrows the range of t for which the boundary has the same corners and
//! sides to what is between its nearest zeros on either side. What lies outside of the region, in
//! another shadow or past the end of its own side is compared with that alone.

use super::chord::Chord;
use super::outer::{Outer, Part, Piece};
use super::sight::{Placed, Region};
use super::validity::{NONE, Place, Validity};
use smallvec::SmallVec;

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
    /// What is known of its chords: those of the shadows, and of the piece's region.
    chords: Vec<Option<Chord>>,
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
            chords: vec![None; outer.shadows.len() + 1],
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

impl Slice<'_> {
    /// The chord of a line in a shadow, or after these in the region: its ends, if it has any, and
    /// the range in which it is so.
    fn chord(&mut self, member: &mut Member, name: usize) -> Option<([Place; 2], [f64; 2])> {
        let t = self.validity.t;
        let is_here = |chord: &Chord| chord.range[0] < t && t < chord.range[1];
        let chord = if let Some(known) = member.chords[name].filter(is_here) {
            known
        } else {
            let shadows = &self.outer.shadows;
            let region = shadows.get(name).unwrap_or(&self.piece.region);
            let found = Chord::of(region, member.line, &self.validity);
            self.validity.is_certain &= found.is_some();
            member.chords[name] = found;
            found?
        };
        let Some([low, high]) = chord.ends else {
            self.validity.within(chord.range);
            return None;
        };
        let place = |other, end| self.validity.place(member.line, other, end);
        Some(([place(low, 0), place(high, 1)], chord.range))
    }

    /// Finds the segments on a line.
    fn on_line(&mut self, member: &mut Member) {
        let (line, count) = (member.line, member.shadows.len());
        let Some((base, base_range)) = self.chord(member, count) else {
            return;
        };
        let mut own: SmallVec<[Cover; 2]> = SmallVec::new();
        let mut own_range = [0.0f64, 1.0f64];
        for name in 0..count {
            if let Some(side) = member.shadows[name]
                && let Some((ends, range)) = self.chord(member, name)
            {
                own.push((ends, Some(side)));
                own_range = [own_range[0].max(range[0]), own_range[1].min(range[1])];
            }
        }
        // a line that bounds one shadow alone matters along the side of that
        let only = match own.as_slice() {
            [] if member.own.is_none() => return,
            [(ends, _)] if member.own.is_none() => Some(*ends),
            _ => None,
        };
        let mut window = base;
        if let Some([low, high]) = only {
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
            let Some((ends, range)) = self.chord(member, name) else {
                continue;
            };
            let [low, high] = ends;
            if high.at <= window[0].at {
                self.validity.separates(line, [window[0].line, high.line]);
            } else if low.at >= window[1].at {
                self.validity.separates(line, [low.line, window[1].line]);
            } else if low.at <= window[0].at && high.at >= window[1].at {
                // both sides are in this shadow all along
                self.validity.within(range);
                self.validity.follow(line, &[low, window[0]]);
                self.validity.follow(line, &[window[1], high]);
                if member.own.is_some() && self.piece.part == Part::InShadow {
                    self.validity.within(base_range);
                    self.validity.follow(line, &window);
                    self.sweep(member, window, &[(window, None)]);
                } else {
                    self.validity.turns(line, window[0].line);
                    self.validity.turns(line, window[1].line);
                }
                return;
            } else {
                self.validity.within(range);
                covers.push((ends, None));
            }
        }
        self.validity.within(base_range);
        self.validity.within(own_range);
        for end in [0, 1] {
            if let Some(only) = only {
                self.validity.ordered(line, base[end].line, only[end].line);
            }
        }
        self.validity.follow(line, &window);
        let mut covers = joined(line, window, covers, &mut self.validity);
        for (ends, side) in own {
            // what is in its own shadow alone is so from end to end
            covers.push((if only.is_some() { window } else { ends }, side));
        }
        if only.is_none() {
            for ([low, high], _) in &covers {
                self.validity.follow(line, &[window[0], *high]);
                self.validity.follow(line, &[*low, window[1]]);
            }
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

/// The union of chords that each cover a part of a window, both sides of the line.
fn joined(
    line: usize,
    window: [Place; 2],
    mut covers: SmallVec<[Cover; 4]>,
    validity: &mut Validity,
) -> SmallVec<[Cover; 4]> {
    covers.sort_by(|one, other| one.0[0].at.total_cmp(&other.0[0].at));
    let mut joined: SmallVec<[Cover; 4]> = SmallVec::new();
    for (ends, _) in covers {
        let [low, high] = ends;
        validity.follow(line, &[window[0], low, window[1]]);
        validity.follow(line, &[window[0], high, window[1]]);
        match joined.last_mut() {
            Some((last, _)) => {
                validity.ordered(line, last[0].line, low.line);
                validity.ordered(line, last[1].line, low.line);
                if low.at > last[1].at {
                    joined.push((ends, None));
                    continue;
                }
                validity.ordered(line, last[1].line, high.line);
                if high.at > last[1].at {
                    last[1] = high;
                }
            }
            None => joined.push((ends, None)),
        }
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
