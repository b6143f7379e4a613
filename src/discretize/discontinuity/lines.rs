//! The lines of discontinuity of a receiver, put together and told by what is seen beside them.
//!
//! Lines that several generators have in common are one. Each is cut where another one crosses it;
//! the form factors from points beside the middle of each piece tell what it parts.

use super::candidate::{Candidate, Generator};
use super::pair::OccludedPair;
use super::ranges::Ranges;
use super::section::Section;
use crate::discretize::error::DiscretizeError;
use glam::DVec3;

/// The part of the source that points beside a line see.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum View {
    /// Nothing.
    Dark,
    /// A part of what they would see without blockers.
    Partial,
    /// All that they would see without blockers.
    Lit,
}

/// The kind of a line of discontinuity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// Nothing is seen on one side, a part on the other.
    Umbra,
    /// All is seen on one side, a part on the other.
    Lit,
    /// Nothing is seen on one side and all on the other, as at a contact shadow.
    Sharp,
    /// A part is seen on both sides.
    Penumbra,
}

impl LineKind {
    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Umbra => "umbra",
            Self::Lit => "lit",
            Self::Sharp => "sharp",
            Self::Penumbra => "penumbra",
        }
    }
}

/// A line of discontinuity: a segment of the receiver across which what is seen of the source
/// changes its form.
#[derive(Debug, Clone, PartialEq)]
pub struct DiscontinuityLine {
    /// The ends, on the receiver.
    pub ends: [DVec3; 2],
    /// The views beside it: on the left as one goes from the first end to the second, seen from
    /// the receiver's front, and on the right.
    pub sides: [View; 2],
    /// The pairs of corner and edge, or the planes, that make it, one or more.
    pub generators: Vec<Generator>,
}

impl DiscontinuityLine {
    /// The kind, by what is seen beside it.
    #[must_use]
    pub fn kind(&self) -> LineKind {
        let is_beside = |view| self.sides.contains(&view);
        match (is_beside(View::Dark), is_beside(View::Lit)) {
            (true, true) => LineKind::Sharp,
            (true, false) => LineKind::Umbra,
            (false, true) => LineKind::Lit,
            (false, false) => LineKind::Penumbra,
        }
    }

    /// The length.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }
}

/// Candidates on one line.
struct Group {
    section: Section,
    parts: Vec<(Ranges, Generator)>,
}

/// Lines nearer than this, of the pair's size, are one.
const SAME_LINE: f64 = 1e-9;

/// The distance from a line at which is told what is seen beside it, of the pair's size: far more
/// than rounding, and the sliver that is seen there, 1e-10 of the whole, is too.
const BESIDE: f64 = 1e-5;

impl OccludedPair {
    /// The lines of discontinuity of the receiver.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a form factor from a point is refused.
    ///
    /// # Examples
    /// ```
    /// use glam::DVec3;
    /// use infoscene::discretize::{LineKind, OccludedPair};
    /// use infoscene::geometry::Patch;
    /// let level = |x: [f64; 2], y: [f64; 2], z: f64| {
    ///     let corner = |x, y| DVec3::new(x, y, z);
    ///     let [a, b] = x.map(|x| y.map(|y| corner(x, y)));
    ///     Patch::try_new(vec![a[0], b[0], b[1], a[1]])
    /// };
    /// let unit = [0.0, 1.0];
    /// let (floor, ceiling) = (level(unit, unit, 0.0)?, level(unit, unit, 1.0)?);
    /// let half = level([0.5, 9.0], [-8.0, 9.0], 0.2)?;
    /// let pair = OccludedPair::new(floor, ceiling.reversed(), vec![half]);
    /// let lines = pair.lines()?;
    /// // (c − h)/(1 − h) and c/(1 − h), straight across the floor
    /// let mut at: Vec<(f64, LineKind)> = lines.iter().map(|l| (l.ends[0].x, l.kind())).collect();
    /// at.sort_by(|a, b| a.0.total_cmp(&b.0));
    /// assert!((at[0].0 - 0.375).abs() < 1e-12 && (at[1].0 - 0.625).abs() < 1e-12);
    /// assert_eq!((at[0].1, at[1].1, at.len()), (LineKind::Lit, LineKind::Umbra, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn lines(&self) -> Result<Vec<DiscontinuityLine>, DiscretizeError> {
        let mut candidates = self.sight_lines();
        candidates.extend(self.trace_lines());
        let groups = self.grouped(candidates);
        let mut lines = Vec::new();
        for (index, group) in groups.iter().enumerate() {
            let others = groups.iter().enumerate();
            let others = others.filter(|(other, _)| *other != index);
            let mut places: Vec<f64> = others
                .filter_map(|(_, other)| group.section.meets(&other.section))
                .collect();
            let ranges = group.parts.iter().flat_map(|(ranges, _)| ranges.iter());
            places.extend(ranges.flatten());
            self.add_pieces(group, &places, &mut lines)?;
        }
        Ok(lines)
    }

    /// Whether edges of two blockers may be seen in one with a third edge along curves, which are
    /// not among the lines.
    #[must_use]
    pub const fn may_have_curves(&self) -> bool {
        self.blockers.len() > 1
    }

    /// The candidates, those on one line together.
    fn grouped(&self, candidates: Vec<Candidate>) -> Vec<Group> {
        let near = SAME_LINE * self.size() + self.noise();
        let mut groups: Vec<Group> = Vec::new();
        for candidate in candidates {
            let Candidate {
                section,
                ranges,
                generator,
            } = candidate;
            let ends: Vec<DVec3> = ranges.iter().flatten().map(|s| section.point(s)).collect();
            let is_on = |group: &&mut Group| {
                let line = &group.section;
                ends.iter()
                    .all(|end| line.distance_in_receiver(*end) <= near)
            };
            match groups.iter_mut().find(is_on) {
                Some(group) => {
                    let place = |s| group.section.flat(section.point(s)).x;
                    let moved = ranges.iter().map(|range| {
                        let [from, to] = range.map(place);
                        [from.min(to), from.max(to)]
                    });
                    let moved = Ranges::union(moved.collect(), self.noise());
                    group.parts.push((moved, generator));
                }
                None => groups.push(Group {
                    section,
                    parts: vec![(ranges, generator)],
                }),
            }
        }
        groups
    }

    /// Adds the pieces of a group between places, those with the same views beside them as one.
    fn add_pieces(
        &self,
        group: &Group,
        places: &[f64],
        lines: &mut Vec<DiscontinuityLine>,
    ) -> Result<(), DiscretizeError> {
        let noise = self.noise();
        let section = &group.section;
        let ranges = group.parts.iter().flat_map(|(ranges, _)| ranges.iter());
        let all = Ranges::union(ranges.collect(), noise);
        let mut last: Option<(f64, DiscontinuityLine)> = None;
        for [from, to] in all.cut_at(places, noise) {
            let middle = 0.5 * (from + to);
            let Some(sides) = self.views(section, middle, to - from)? else {
                continue;
            };
            let parts = group.parts.iter();
            let made = parts.filter(|(ranges, _)| {
                let mut ranges = ranges.iter();
                ranges.any(|[from, to]| from <= middle && middle <= to)
            });
            let generators = made.map(|(_, generator)| *generator);
            match &mut last {
                Some((end, line)) if line.sides == sides && from - *end <= noise => {
                    *end = to;
                    line.ends[1] = section.point(to);
                    for generator in generators {
                        if !line.generators.contains(&generator) {
                            line.generators.push(generator);
                        }
                    }
                }
                _ => {
                    let line = DiscontinuityLine {
                        ends: [section.point(from), section.point(to)],
                        sides,
                        generators: generators.collect(),
                    };
                    lines.extend(last.replace((to, line)).map(|(_, line)| line));
                }
            }
        }
        lines.extend(last.map(|(_, line)| line));
        Ok(())
    }

    /// The views on either side of a place of a line; none if it is on the receiver's outline, or
    /// if nothing, or all, is seen on both sides.
    fn views(
        &self,
        section: &Section,
        place: f64,
        length: f64,
    ) -> Result<Option<[View; 2]>, DiscretizeError> {
        let left = self.receiver.normal().cross(section.along);
        let aside = (BESIDE * self.size()).min(0.1 * length);
        let points = [aside, -aside].map(|aside| section.point(place) + aside * left);
        if !points.iter().all(|point| self.is_on_receiver(*point)) {
            return Ok(None);
        }
        let mut sides = [View::Partial; 2];
        for (side, point) in sides.iter_mut().zip(points) {
            let seen = self.seen_from(point)?;
            let bare = self.seen_unblocked(point)?;
            if seen.value <= seen.error {
                *side = View::Dark;
            } else if bare.value - seen.value <= bare.error + seen.error {
                *side = View::Lit;
            }
        }
        let is_line = sides[0] != sides[1] || sides[0] == View::Partial;
        Ok(is_line.then_some(sides))
    }
}

impl Section {
    /// The place at which another line of the receiver's plane meets this one.
    fn meets(&self, other: &Self) -> Option<f64> {
        let normal = self.along.cross(other.along);
        let square = normal.length_squared();
        let apart = other.origin - self.origin;
        (square > 0.0).then(|| apart.cross(other.along).dot(normal) / square)
    }

    /// The distance of a point of the receiver's plane from the line.
    fn distance_in_receiver(&self, point: DVec3) -> f64 {
        (point - self.origin).cross(self.along).length()
    }
}
