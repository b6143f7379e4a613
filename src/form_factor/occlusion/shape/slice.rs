//! The sides of a boundary on each line, from chords in the region and in shadows, at one t.
//!
//! On each line, a stretch is a boundary if just one of its sides belongs to the region; lines on
//! which sides of two shadows coincide are settled by that, too. Each comparison that the outcome
//! rests on is the sign of a polynomial of degree 2 in t, and narrows the range of t to what is
//! between its nearest zeros on either side. What lies outside of the region, in another shadow or
//! past the end of its own side is compared with that alone.

use super::chord::chord;
use super::covers::{Cover, Segment, joined, places, segments};
use super::validity::{Place, Validity};
use crate::form_factor::occlusion::view::outer::{Outer, Piece};
use crate::form_factor::occlusion::view::pages::Part;
use crate::form_factor::occlusion::view::region::Region;
use smallvec::{SmallVec, smallvec};

/// A line, and what it bounds.
#[derive(Debug)]
pub(crate) struct Member {
    pub line: usize,
    /// The side of it on which the piece's region is.
    own: Option<f64>,
    /// The side of it on which each shadow is that it bounds.
    shadows: Vec<Option<f64>>,
    /// The misses that are known of its chords in the shadows, and in the piece's region.
    chords: Vec<Missed>,
}

/// The misses of a line and a region, with the ranges in which they are so.
#[derive(Debug, Clone, Default)]
struct Missed {
    /// The range in which the line misses the region.
    missed: Option<[f64; 2]>,
    /// Lines that the line crosses inside of the region, and where.
    inside: SmallVec<[(usize, [f64; 2]); 4]>,
}

impl Member {
    /// The lines around a piece and the shadows on it.
    pub(crate) fn all(outer: &Outer, piece: &Piece) -> Vec<Self> {
        let regions = outer.shadows.iter().chain([&piece.region]);
        let sides = regions.flat_map(Region::sides);
        let mut lines: Vec<usize> = sides.map(|half| half.line).collect();
        lines.sort_unstable();
        lines.dedup();
        let members = lines.into_iter().map(|line| Self {
            line,
            own: piece.region.side_of(line),
            shadows: outer.shadows.iter().map(|s| s.side_of(line)).collect(),
            chords: vec![Missed::default(); outer.shadows.len() + 1],
        });
        members.collect()
    }
}

/// A piece at one t, and what is found of its boundary.
pub(crate) struct Slice<'a> {
    pub outer: &'a Outer<'a>,
    pub piece: &'a Piece,
    /// The shadows that reach into the piece's region.
    pub active: &'a [usize],
    pub validity: Validity<'a>,
    pub segments: Vec<Segment>,
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

    /// The parts of a window of a line that lie in shadows which it does not bound; none if they
    /// leave nothing that counts.
    fn covers(&mut self, member: &mut Member, window: [Place; 2]) -> Option<SmallVec<[Cover; 4]>> {
        let mut covers: SmallVec<[Cover; 4]> = SmallVec::new();
        for name in self.active.iter().copied() {
            if member.shadows[name].is_some() {
                continue;
            }
            let Some(ends) = self.chord(member, name) else {
                continue;
            };
            match self.clipped(member, window, ends, name) {
                Some([low, high]) if low.line == window[0].line && high.line == window[1].line => {
                    // both sides are in this shadow all along
                    let counts = member.own.is_some() && self.piece.part == Part::InShadow;
                    return counts.then(|| smallvec![(window, None)]);
                }
                Some(ends) => covers.push((ends, None)),
                None => {}
            }
        }
        Some(covers)
    }

    /// Finds the segments on a line.
    pub(crate) fn on_line(&mut self, member: &mut Member) {
        let (line, count) = (member.line, member.shadows.len());
        let Some(base) = self.chord(member, count) else {
            return;
        };
        let mut own: SmallVec<[([Place; 2], usize); 2]> = SmallVec::new();
        for name in self.active.iter().copied() {
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
        let Some(covers) = self.covers(member, window) else {
            return;
        };
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
        let sides = (member.own, self.piece.part);
        self.segments.extend(segments(line, window, &covers, sides));
    }
}
