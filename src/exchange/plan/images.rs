//! Congruent pairs of any polygons: translates and mirror images along the axes of one frame.
//!
//! ```text
//!   lines      groups of coordinates along an axis, whose differences are numbered
//!   pose       the corners of a polygon from the lower ends of its box, in numbers
//!   class      poses of both and the numbers between the ends of their boxes on the three axes:
//!              the least over the 48 symmetries of the frame and over both orders
//! ```
//!
//! Few poses occur where polygons repeat. Which symmetries take two of them to their least image is
//! found once for each pair of poses, mostly one; the class of a pair of polygons is then the least
//! over these of three numbers of relations, one of each axis.
//!
//! Polygons whose shape occurs once are left out, and so is a scene whose pairs hardly repeat:
//! memory is of order n and the classes.
//!
//! **Not covered**: rotations that are no symmetry of the frame; pairs that a lattice covers.

use super::frames::{Frame, frames};
use super::line_differences::Differences;
use super::lines::Lines;
use super::poses::{Outline, PosePair, Poses, Way};
use crate::scene::NamedPatch;
use glam::DVec3;
use std::collections::HashMap;

/// Most entries of a table: so many, and so many per polygon.
const TABLE: [usize; 2] = [1 << 12, 64];

/// Most poses of few polygons.
const FEW_POSES: usize = 16;

/// A class of pairs: the images of both poses, and a relation on each axis.
pub(crate) type Key = [u32; 4];

/// The polygons of a scene that repeat, in numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Images {
    /// The pose and the spans along the axes of each polygon that repeats.
    placed: Vec<Option<Placed>>,
    poses: usize,
    /// The least image of two poses, and the ways to it: `[first · poses + second]`.
    pairs: Vec<PosePair>,
    ways: Vec<Way>,
    spans: usize,
    /// The relation of two spans of one axis: `[first · spans + second]`.
    relations: Vec<u32>,
    /// The numbers of a relation when its axis is reflected, when the two are exchanged, and both.
    turned: Vec<[u32; 3]>,
    /// The corners of each polygon in the frame.
    pub(crate) models: Vec<Vec<DVec3>>,
    /// The distance by which coordinates of congruent pairs may differ, after a motion.
    pub(crate) spread: f64,
}

/// A polygon that repeats.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Placed {
    pose: u32,
    spans: [u32; 3],
}

impl Images {
    /// The polygons that repeat along the axes of the frame of most of `uncovered`; none if they
    /// hardly do.
    pub(crate) fn of(patches: &[NamedPatch], uncovered: &[usize]) -> Option<Self> {
        let found = frames(patches, uncovered.iter().copied())
            .into_iter()
            .next();
        let frame = found.map_or_else(Frame::straight, |(frame, _)| frame);
        let all: Vec<usize> = (0..patches.len()).collect();
        let lines = Lines::of(&frame, patches, &all);
        let most = TABLE[0].max(TABLE[1] * patches.len());
        if lines.pairs() > most {
            return None;
        }
        let places = [0, 1, 2].map(|axis| lines.places(axis));
        let differences = Differences::of(&places, lines.largest);
        let outlines: Vec<Outline> = (0..patches.len())
            .map(|polygon| Outline::of(&lines.corners[polygon], &differences))
            .collect();
        let mut poses = Poses::default();
        let posed: Vec<Option<u32>> = outlines.iter().map(|outline| poses.pose(outline)).collect();
        let posed = poses.repeated(posed);
        let count = poses.occurring();
        if count == 0
            || count.max(FEW_POSES).pow(2) > FEW_POSES.pow(2).max(patches.len().pow(2) / 4)
        {
            return None;
        }
        let (pairs, ways) = poses.pairs();
        let mut spans = Spans::default();
        let placed: Vec<Option<Placed>> = posed
            .iter()
            .zip(&outlines)
            .map(|(pose, outline)| {
                Some(Placed {
                    pose: (*pose)?,
                    spans: spans.of(outline),
                })
            })
            .collect();
        if spans.list.len().pow(2) > most {
            return None;
        }
        let (relations, turned) = spans.relations(&differences);
        let model = |corners: &Vec<[usize; 3]>| {
            let corner = |c: &[usize; 3]| [0, 1, 2].map(|axis| places[axis][c[axis]]);
            corners
                .iter()
                .map(|c| DVec3::from_array(corner(c)))
                .collect()
        };
        Some(Self {
            poses: count,
            pairs,
            ways,
            spans: spans.list.len(),
            relations,
            turned,
            models: lines.corners.iter().map(model).collect(),
            placed,
            // each of the two is off its model; the corners of one pose are within the spread of
            // those of the pose's first polygon from either end of their boxes, its images within
            // that of each other, and the boxes of a pair have relations within another spread
            spread: 2.0 * lines.offset() + 6.0 * differences.spread,
        })
    }

    /// The class of a pair: pairs of one class are congruent. It does not depend on the order of
    /// the two.
    pub(crate) fn key(&self, first: usize, second: usize) -> Option<Key> {
        let (one, other) = (self.placed[first]?, self.placed[second]?);
        let pair = self.pairs[one.pose as usize * self.poses + other.pose as usize];
        let relation = |axis: usize| {
            self.relations[one.spans[axis] as usize * self.spans + other.spans[axis] as usize]
        };
        let relations = [relation(0), relation(1), relation(2)];
        let [start, count] = pair.ways.map(|n| n as usize);
        let images = self.ways[start..start + count].iter().map(|way| {
            [0, 1, 2].map(|axis| {
                let relation = relations[way.symmetry.axes[axis]];
                let turned = &self.turned[relation as usize];
                match (way.symmetry.reflected[axis], way.exchanged) {
                    (false, false) => relation,
                    (true, false) => turned[0],
                    (false, true) => turned[1],
                    (true, true) => turned[2],
                }
            })
        });
        let [a, b, c] = images.min()?;
        Some([pair.image, a, b, c])
    }
}

/// The spans of boxes along the axes.
#[derive(Default)]
struct Spans {
    list: Vec<(usize, [usize; 2])>,
    numbers: HashMap<(usize, [usize; 2]), u32>,
}

impl Spans {
    fn of(&mut self, outline: &Outline) -> [u32; 3] {
        [0, 1, 2].map(|axis| {
            let span = (axis, [outline.lower[axis], outline.upper[axis]]);
            *self.numbers.entry(span).or_insert_with(|| {
                self.list.push(span);
                u32::try_from(self.list.len() - 1).unwrap_or(u32::MAX)
            })
        })
    }

    /// The relations of all spans of one axis, and what they turn into.
    fn relations(&self, differences: &Differences) -> (Vec<u32>, Vec<[u32; 3]>) {
        let mut numbers: HashMap<[i32; 2], u32> = HashMap::new();
        let mut turned: Vec<[u32; 3]> = Vec::new();
        let mut relations = Vec::with_capacity(self.list.len().pow(2));
        for (axis, [low, high]) in &self.list {
            for (other_axis, [other_low, other_high]) in &self.list {
                if axis != other_axis {
                    relations.push(0);
                    continue;
                }
                let low = differences.number(*axis, *low, *other_low);
                let high = differences.number(*axis, *high, *other_high);
                relations.push(relation(&mut numbers, &mut turned, [low, high]));
            }
        }
        (relations, turned)
    }
}

/// The number of a relation, given with its images when it is new.
fn relation(
    numbers: &mut HashMap<[i32; 2], u32>,
    turned: &mut Vec<[u32; 3]>,
    [low, high]: [i32; 2],
) -> u32 {
    if let Some(number) = numbers.get(&[low, high]) {
        return *number;
    }
    let mut number = |key: [i32; 2]| {
        let next = u32::try_from(numbers.len()).unwrap_or(u32::MAX);
        *numbers.entry(key).or_insert(next)
    };
    let own = number([low, high]);
    let (reflected, exchanged) = (number([-high, -low]), number([-low, -high]));
    let both = number([high, low]);
    turned.resize(numbers.len(), [0; 3]);
    turned[own as usize] = [reflected, exchanged, both];
    turned[reflected as usize] = [own, both, exchanged];
    turned[exchanged as usize] = [both, own, reflected];
    turned[both as usize] = [exchanged, reflected, own];
    own
}
