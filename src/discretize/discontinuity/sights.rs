//! Lines of sight through a vertex and an edge.
//!
//! All lines of sight through a vertex v in the plane of v and an edge are a pencil: what they meet
//! is cast through v onto the receiver,
//!
//! ```text
//!   s(p) = s_v + (s_p − s_v) t_v/(t_v − t_p)
//! ```
//!
//! so that the places from which v is seen in line with the edge, and those from which something
//! hides it, are ranges of the line.

use super::candidate::{Candidate, Feature, Generator};
use super::contact::{WayPast, way_past};
use super::pair::OccludedPair;
use super::ranges::Ranges;
use super::section::{Section, edges, snapped};
use crate::geometry::clipped;
use glam::{DVec2, DVec3};

/// A vertex and an edge, each with the polygon that it is of: the source, or a blocker's index.
struct Sight {
    vertex: (Option<usize>, usize, DVec3),
    edge: (Option<usize>, usize, [DVec3; 2]),
}

impl OccludedPair {
    /// The lines on which a vertex and an edge are seen in one, one of them of a blocker at least.
    pub(super) fn sight_lines(&self) -> Vec<Candidate> {
        let noise = self.noise();
        let polygons = || {
            let blockers = self.blockers.iter().enumerate();
            let blockers = blockers.map(|(index, blocker)| (Some(index), blocker));
            std::iter::once((None, &self.source)).chain(blockers)
        };
        let mut found = Vec::new();
        for (owner, polygon) in polygons() {
            for (corner, vertex) in polygon.corners().iter().enumerate() {
                if self.height(*vertex) <= noise || !self.is_between(owner, *vertex) {
                    continue;
                }
                for (other, outline) in polygons().filter(|(other, _)| *other != owner) {
                    let edges = edges(outline).enumerate();
                    found.extend(edges.filter_map(|(index, edge)| {
                        let edge = self.in_view(other, edge)?;
                        self.candidate(&Sight {
                            vertex: (owner, corner, *vertex),
                            edge: (other, index, edge),
                        })
                    }));
                }
            }
        }
        found
    }

    /// Is a corner of the source, or in front of it?
    fn is_between(&self, owner: Option<usize>, point: DVec3) -> bool {
        owner.is_none() || self.height_over_source(point) > self.noise()
    }

    /// The part of an edge in front of the receiver, and of the source if it is a blocker's.
    fn in_view(&self, owner: Option<usize>, edge: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let noise = self.noise();
        let part = |edge: [DVec3; 2], height: &dyn Fn(DVec3) -> f64| {
            let heights = snapped(&edge, height, noise);
            let is_above = heights.iter().any(|height| *height > 0.0);
            let cut = clipped(&edge, &heights, |a: DVec3, b, share| a.lerp(b, share));
            let first = *cut.first()?;
            let last = cut.iter().max_by(|a, b| {
                let [a, b] = [a, b].map(|corner| corner.distance(first));
                a.total_cmp(&b)
            })?;
            (is_above && first.distance(*last) > noise).then_some([first, *last])
        };
        let seen = part(edge, &|corner| self.height(corner))?;
        match owner {
            None => Some(seen),
            Some(_) => part(seen, &|corner| self.height_over_source(corner)),
        }
    }

    fn candidate(&self, sight: &Sight) -> Option<Candidate> {
        let noise = self.noise();
        let ((owner, corner, vertex), (other, edge_index, [a, b])) = (sight.vertex, sight.edge);
        let normal = (a - vertex).cross(b - vertex);
        if normal.length() <= noise * a.distance(b) {
            return None;
        }
        let section = Section::through(&self.receiver, normal, vertex)?;
        let eye = section.flat(vertex);
        let edge = [section.flat(a), section.flat(b)];
        let mut ranges = self.front_of_source(&section, section.chord(&self.receiver, noise));
        let reached = match (owner, other) {
            (None, _) => cast_below(eye, edge, noise).into_iter().collect(),
            (_, None) => cast_above(eye, edge, noise).into_iter().collect(),
            _ => cast(eye, edge, noise),
        };
        ranges = ranges.within(&Ranges::union(reached, noise), noise);
        if owner.is_some() && other.is_some() {
            let seen = section.crossed(&self.source, noise).into_iter();
            let seen = seen.flat_map(|segment| cast(eye, segment, noise)).collect();
            ranges = ranges.within(&Ranges::union(seen, noise), noise);
        }
        let mut ends = Vec::new();
        for (index, blocker) in self.blockers.iter().enumerate() {
            if ranges == Ranges::default() {
                return None;
            }
            if [owner, other].contains(&Some(index)) {
                continue;
            }
            let mut hidden = Vec::new();
            for segment in section.crossed(blocker, noise) {
                let Some(segment) = self.flat_in_view(&section, segment) else {
                    continue;
                };
                let cast = cast(eye, segment, noise);
                if lies_along(segment, edge, noise) {
                    ends.extend(cast.into_iter().flatten());
                } else {
                    hidden.extend(cast);
                }
            }
            ranges = ranges.without(&Ranges::union(hidden, noise), noise);
        }
        let pieces = ranges.cut_at(&ends, noise).into_iter();
        let open = pieces.filter(|piece| !self.is_hidden_at(&section, *piece, eye, edge));
        let ranges = Ranges::union(open.collect(), noise);
        (ranges != Ranges::default()).then_some(Candidate {
            section,
            ranges,
            generator: Generator::Sight {
                vertex: Feature::new(owner, corner),
                edge: Feature::new(other, edge_index),
            },
        })
    }

    /// The part of the ranges that lies in front of the source.
    pub(super) fn front_of_source(&self, section: &Section, ranges: Ranges) -> Ranges {
        let noise = self.noise();
        let parts = ranges.iter().filter_map(|range| {
            let ends = range.map(|place| section.point(place));
            let heights = snapped(&ends, |end| self.height_over_source(end), noise);
            let part = clipped(&range, &heights, |a, b, share| a + (b - a) * share);
            let is_in_front = heights.iter().any(|height| *height > 0.0);
            let lowest = part.iter().copied().reduce(f64::min)?;
            let highest = part.iter().copied().reduce(f64::max)?;
            is_in_front.then_some([lowest, highest])
        });
        Ranges::union(parts.collect(), noise)
    }

    /// The part of a segment of the plane in front of receiver and source.
    pub(super) fn flat_in_view(
        &self,
        section: &Section,
        segment: [DVec2; 2],
    ) -> Option<[DVec2; 2]> {
        // any blocker will do
        let ends = self.in_view(Some(0), segment.map(|end| section.lifted(end)))?;
        Some(ends.map(|end| section.flat(end)))
    }

    /// Does the line of sight of a piece find no way past the vertex or the edge, with blockers all
    /// around it, or is the vertex a straight corner?
    fn is_hidden_at(
        &self,
        section: &Section,
        [from, to]: [f64; 2],
        eye: DVec2,
        [a, b]: [DVec2; 2],
    ) -> bool {
        let place = DVec2::new(0.5 * (from + to), 0.0);
        let sight = eye - place;
        let along = b - a;
        let turn = sight.perp_dot(along);
        let touch = a + along * ((place - a).perp_dot(sight) / along.perp_dot(sight));
        let direction = section.lifted(eye) - section.lifted(place);
        let noise = self.noise();
        let way = |at: DVec2| {
            let at = section.lifted(at);
            if self.height_over_source(at) <= noise {
                return WayPast::Other;
            }
            way_past(&self.blockers, at, direction, 10.0 * noise)
        };
        way(eye) != WayPast::Other || (turn.abs() > 0.0 && way(touch) == WayPast::None)
    }
}

/// The range onto which a segment is cast through a point higher than it; its parts above the point
/// count for nothing, nor does one that runs through it.
fn cast_below(eye: DVec2, segment: [DVec2; 2], noise: f64) -> Option<[f64; 2]> {
    part_cast(eye, segment, noise, |t| eye.y - t)
}

/// The range from which a segment is seen behind a point lower than it.
fn cast_above(eye: DVec2, segment: [DVec2; 2], noise: f64) -> Option<[f64; 2]> {
    part_cast(eye, segment, noise, |t| t - eye.y)
}

fn cast(eye: DVec2, segment: [DVec2; 2], noise: f64) -> Vec<[f64; 2]> {
    let parts = [cast_below, cast_above].map(|part| part(eye, segment, noise));
    parts.into_iter().flatten().collect()
}

fn part_cast(
    eye: DVec2,
    segment: [DVec2; 2],
    noise: f64,
    depth: impl Fn(f64) -> f64,
) -> Option<[f64; 2]> {
    let [a, b] = segment;
    let along = (b - a).try_normalize()?;
    if (eye - a).perp_dot(along).abs() <= noise {
        return None;
    }
    let heights = [a, b].map(|end| depth(end.y) - noise);
    let part = clipped(&segment, &heights, |a: DVec2, b, share| a.lerp(b, share));
    let places = part
        .iter()
        .map(|p| eye.x + (p.x - eye.x) * eye.y / (eye.y - p.y));
    let lowest = places.clone().reduce(f64::min)?;
    Some([lowest, places.reduce(f64::max)?])
}

/// Does a segment run along the line of another?
fn lies_along(segment: [DVec2; 2], [a, b]: [DVec2; 2], noise: f64) -> bool {
    let along = (b - a).normalize_or_zero();
    segment
        .iter()
        .all(|end| (*end - a).perp_dot(along).abs() <= 10.0 * noise)
}
