//! The boundary of a region that is seen from a point of a stretch, and how far it keeps its shape.
//!
//! Parts of P that are seen through one screen alone are convex: what is known of these tells which
//! shadows reach into a region at all, and which lines bound anything there. Where several shadows
//! do, the boundary is found on each of these lines.

use super::boundary::Arrangement;
use super::convex::{Convex, Known};
use super::covers::Segment;
use super::slice::{Member, Slice};
use super::validity::{NONE, Validity};
use crate::form_factor::occlusion::view::outer::{Outer, Piece};
use crate::form_factor::occlusion::view::pages::Part;
use crate::form_factor::occlusion::view::region::Region;
use crate::form_factor::occlusion::view::trace::Placed;
use smallvec::{SmallVec, smallvec};

/// A piece with the shadows on it, and what is known of their boundaries.
#[derive(Debug)]
pub(crate) struct Roster<'a> {
    outer: &'a Outer<'a>,
    piece: &'a Piece,
    /// The region, and what of it is in each of the shadows.
    region: Known<'a>,
    shadows: Vec<Known<'a>>,
    /// The lines around all these, once they are asked for.
    members: Option<Vec<Member>>,
}

impl<'a> Roster<'a> {
    pub(crate) fn of(outer: &'a Outer<'a>, piece: &'a Piece) -> Self {
        let convex = |shadow| Known::of(Convex::of(&outer.sight, &piece.region, shadow));
        Self {
            outer,
            piece,
            region: convex(None),
            shadows: outer.shadows.iter().map(|s| convex(Some(s))).collect(),
            members: None,
        }
    }

    /// The boundary at t; none if something cannot be told there.
    pub(crate) fn arrange(&mut self, range: [f64; 2], t: f64) -> Option<Arrangement> {
        let sight = &self.outer.sight;
        let lines = 0..sight.traces.len();
        let placed: SmallVec<[Placed; 16]> = lines.map(|line| sight.placed(line, t)).collect();
        let mut validity = Validity {
            sight,
            placed: &placed,
            t,
            range,
            is_certain: true,
        };
        let is_all = self.shadows.is_empty() && self.piece.part == Part::Lit;
        let Region { cones, halves } = &self.piece.region;
        if is_all || cones.len() > 1 || !halves.is_empty() {
            let whole = self.region.at(&placed, t);
            if let Some(found) = whole.filter(|found| is_all || found.segments.is_empty()) {
                return Some(found.within(range));
            }
        }
        let mut active: SmallVec<[usize; 8]> = SmallVec::new();
        for (name, shadow) in self.shadows.iter_mut().enumerate() {
            match shadow.at(&placed, t) {
                Some(found) if found.segments.is_empty() => validity.within(found.range),
                _ => active.push(name),
            }
        }
        let known = match (self.piece.part, active.as_slice()) {
            (Part::InShadow, []) => {
                return Some(Arrangement {
                    segments: Vec::new(),
                    range: validity.range,
                });
            }
            (Part::InShadow, [name]) => self.shadows[*name].at(&placed, t),
            (Part::Lit, []) => self.region.at(&placed, t),
            _ => None,
        };
        if let Some(found) = known {
            return Some(found.within(validity.range));
        }
        let lines = self.lines(&mut validity, &active);
        self.bounded(validity, &active, &lines)
    }

    /// Whether each line bounds the region or what is in one of the shadows, as far as that is
    /// known.
    fn lines(&mut self, validity: &mut Validity, active: &[usize]) -> SmallVec<[bool; 64]> {
        let (placed, t) = (validity.placed, validity.t);
        let mut lines: SmallVec<[bool; 64]> = smallvec![false; placed.len()];
        let shadows = active.iter().map(|name| &self.outer.shadows[*name]);
        let own = (self.piece.part == Part::Lit).then_some(&self.piece.region);
        let found = self.shadows.iter_mut().enumerate();
        let found = found.filter(|(name, _)| active.contains(name));
        let found = found.map(|(_, shadow)| shadow);
        let known = own.map(|_| &mut self.region);
        for (region, known) in shadows.chain(own).zip(found.chain(known)) {
            if let Some(found) = known.at(placed, t) {
                validity.within(found.range);
                for segment in &found.segments {
                    lines[segment.line] = true;
                }
            } else {
                for half in region.sides().chain(self.piece.region.sides()) {
                    lines[half.line] = true;
                }
            }
        }
        lines
    }

    /// The boundary past some of the shadows, from the chords of some lines.
    fn bounded(
        &mut self,
        validity: Validity,
        active: &[usize],
        lines: &[bool],
    ) -> Option<Arrangement> {
        let mut slice = Slice {
            outer: self.outer,
            piece: self.piece,
            active,
            validity,
            segments: Vec::new(),
        };
        let members = self
            .members
            .get_or_insert_with(|| Member::all(self.outer, self.piece));
        for member in members {
            if !lines[member.line] {
                continue;
            }
            if slice.validity.placed[member.line].is_line {
                slice.on_line(member);
            } else {
                // level for a moment: it may be met beside
                let trace = &self.outer.sight.traces[member.line];
                slice.validity.is_certain &= trace.is_level;
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
