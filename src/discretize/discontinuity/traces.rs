//! Traces of planes: where a polygon is seen edge-on, and where it stands on the receiver.
//!
//! In the plane of a blocker a point x of the receiver sees it as a line, and the source as one or
//! more segments. Something changes at x if the blocker hides a part of these that nothing else
//! hides. Along the line this can change only where two corners are seen in one; between such
//! places one point tells, and at a point the directions between corners do.

use super::candidate::{Candidate, Generator};
use super::pair::OccludedPair;
use super::ranges::Ranges;
use super::section::{Section, ordered, snapped};
use crate::geometry::{Patch, clipped, convex_pieces};
use glam::{DVec2, DVec3};

/// The part of a scene in the plane of a blocker, in front of receiver and source.
struct EdgeOn {
    /// Convex pieces of the blocker.
    own: Vec<Vec<DVec2>>,
    source: Vec<[DVec2; 2]>,
    others: Vec<[DVec2; 2]>,
}

impl OccludedPair {
    /// The lines in which the planes of source and blockers meet the receiver, where they matter.
    pub(super) fn trace_lines(&self) -> Vec<Candidate> {
        let noise = self.noise();
        let section = |polygon: &Patch| {
            Section::through(&self.receiver, polygon.normal(), polygon.corners()[0])
        };
        let mut found = Vec::new();
        if let Some(section) = section(&self.source) {
            found.push(Candidate {
                ranges: section.chord(&self.receiver, noise),
                section,
                generator: Generator::Plane { of: None },
            });
        }
        for (index, blocker) in self.blockers.iter().enumerate() {
            let Some(section) = section(blocker) else {
                continue;
            };
            let chord = self.front_of_source(&section, section.chord(&self.receiver, noise));
            let contact = self.contact(&section, blocker).within(&chord, noise);
            let rest = chord.without(&contact, noise);
            let trace = self.edge_on(&section, index).seen(&rest, noise);
            let blocker = index;
            let of = Some(index);
            for (ranges, generator) in [
                (contact, Generator::Contact { blocker }),
                (trace, Generator::Plane { of }),
            ] {
                if ranges != Ranges::default() {
                    found.push(Candidate {
                        section,
                        ranges,
                        generator,
                    });
                }
            }
        }
        found
    }

    /// The ranges in which a blocker meets the receiver's plane.
    fn contact(&self, section: &Section, blocker: &Patch) -> Ranges {
        let noise = self.noise();
        let mut ranges = Vec::new();
        for piece in convex_pieces(blocker.corners(), blocker.normal()) {
            let heights = snapped(&piece, |corner| self.height(corner), noise);
            let above = clipped(&piece, &heights, |a: DVec3, b, share| a.lerp(b, share));
            let on = above.iter().filter(|c| self.height(**c).abs() <= noise);
            let places = on.map(|corner| section.flat(*corner).x);
            let lowest = places.clone().reduce(f64::min);
            ranges.extend(
                lowest
                    .zip(places.reduce(f64::max))
                    .map(|(a, b)| ordered(a, b)),
            );
        }
        Ranges::union(ranges, noise)
    }

    fn edge_on(&self, section: &Section, own: usize) -> EdgeOn {
        let noise = self.noise();
        let blocker = &self.blockers[own];
        let pieces = convex_pieces(blocker.corners(), blocker.normal()).into_iter();
        let between = |a: DVec3, b: DVec3, share: f64| a.lerp(b, share);
        let pieces = pieces.filter_map(|piece| {
            let heights = snapped(&piece, |corner| self.height(corner) - noise, 0.0);
            let piece = clipped(&piece, &heights, between);
            let heights = snapped(&piece, |c| self.height_over_source(c) - noise, 0.0);
            let piece = clipped(&piece, &heights, between);
            let flat = piece.iter().map(|corner| section.flat(*corner));
            (piece.len() > 2).then(|| flat.collect())
        });
        let above = |segment: [DVec2; 2]| {
            let heights = segment.map(|end| end.y - noise);
            let part = clipped(&segment, &heights, |a, b, share| a.lerp(b, share));
            Some([*part.first()?, *part.last()?]).filter(|[a, b]| a.distance(*b) > noise)
        };
        let source = section.crossed(&self.source, noise).into_iter();
        let others = self.blockers.iter().enumerate();
        let others = others.filter(|(index, _)| *index != own);
        let others = others.flat_map(|(_, other)| section.crossed(other, noise));
        let others = others.filter_map(|segment| above(self.flat_in_view(section, segment)?));
        EdgeOn {
            own: pieces.collect(),
            source: source.filter_map(above).collect(),
            others: others.collect(),
        }
    }
}

impl EdgeOn {
    fn corners(&self) -> Vec<DVec2> {
        let segments = self.source.iter().chain(&self.others).flatten();
        self.own.iter().flatten().chain(segments).copied().collect()
    }

    /// The part of the ranges from which the blocker hides some of the source.
    fn seen(&self, ranges: &Ranges, noise: f64) -> Ranges {
        if self.own.is_empty() || self.source.is_empty() {
            return Ranges::default();
        }
        let corners = self.corners();
        let mut places = Vec::new();
        for (k, p) in corners.iter().enumerate() {
            for q in &corners[..k] {
                if (q.y - p.y).abs() > noise {
                    places.push(p.x - p.y * (q.x - p.x) / (q.y - p.y));
                }
            }
        }
        let pieces = ranges.cut_at(&places, noise).into_iter();
        let seen = pieces.filter(|[from, to]| self.hides_from(0.5 * (from + to), &corners));
        Ranges::union(seen.collect(), noise)
    }

    /// Does the blocker hide a part of the source from a place that nothing else hides?
    fn hides_from(&self, place: f64, corners: &[DVec2]) -> bool {
        // lines of sight x = place + slope t
        let slopes = corners.iter().map(|corner| (corner.x - place) / corner.y);
        let mut slopes: Vec<f64> = slopes.collect();
        slopes.sort_by(f64::total_cmp);
        slopes.windows(2).any(|pair| {
            let slope = 0.5 * (pair[0] + pair[1]);
            let height = |[a, b]: [DVec2; 2]| {
                let [from, to] = [a, b].map(|end| end.x - place - slope * end.y);
                let crosses = (from < 0.0) != (to < 0.0);
                crosses.then(|| a.y + (b.y - a.y) * from / (from - to))
            };
            let first = |segments: &mut dyn Iterator<Item = [DVec2; 2]>| {
                segments.filter_map(height).reduce(f64::min)
            };
            let outline = self.own.iter().flat_map(|piece| {
                let next = piece.iter().cycle().skip(1);
                piece.iter().zip(next).map(|(a, b)| [*a, *b])
            });
            let source = first(&mut self.source.iter().copied());
            let own = first(&mut { outline });
            let other = first(&mut self.others.iter().copied());
            match (own, source) {
                (Some(own), Some(source)) => {
                    own < source && other.is_none_or(|other| other > source)
                }
                _ => false,
            }
        })
    }
}
