//! Congruent pairs of axis-parallel rectangles, found by counting instead of by computing.
//!
//! Rectangles of a regular or symmetric division lie between few lines. All differences of lines
//! are numbered once, equal ones alike; the relative position of two rectangles is then given by a
//! few such numbers:
//!
//! ```text
//!   perpendicular   depth of each over the other's plane, relation of their spans on the common
//!                   axis
//!   parallel        distance, relations of the spans on either axis
//! ```
//!
//! Pairs with the same numbers, up to a reflection of an axis, an exchange of the axes and an
//! exchange of the two, are congruent: they have the same exchange area. Differences equal up to a
//! few roundings of the coordinates are numbered alike, too; [`Lattice::spread`] says how far apart
//! such are.
//!
//! The lattice serves any axis-parallel rectangles and looks each of the n² pairs of patches up.
//! The grid on a box has an engine of its own (`discretize/grid/classes`), which multiplies
//! relations along the axes and needs n³ classes for n cells an edge, no comparison of pairs. The
//! test `the_grid_of_six_cells_is_the_scene_cube_6` sets one against the other.
//!
//! **Not covered**: other polygons (`turned`, `images`), and scenes with so many lines that the
//! tables would outgrow the pairs.

use super::line_differences::{Differences, others};
use crate::geometry::FlatBox;
use crate::scene::NamedPatch;
use std::collections::{BTreeMap, HashMap};
use std::hash::Hash;

/// Most entries of a table of pairs of lines, or of spans: so many, and so many per patch.
const TABLE: [usize; 2] = [1 << 16, 64];

/// Largest number of classes.
const MOST_CLASSES: usize = 1 << 23;

/// Numbers in the order in which they first come.
#[derive(Debug)]
struct Numbering<K>(HashMap<K, u32>);

impl<K: Hash + Eq> Numbering<K> {
    fn new() -> Self {
        Self(HashMap::new())
    }

    fn number(&mut self, key: K) -> u32 {
        let next = u32::try_from(self.0.len()).unwrap_or(u32::MAX);
        *self.0.entry(key).or_insert(next)
    }

    fn count(&self) -> usize {
        self.0.len()
    }
}

/// An axis-parallel rectangle, in numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cell {
    /// The axis along its normal.
    axis: usize,
    /// The plane and the side it faces.
    plane: usize,
    /// The spans along the three axes; the one along the normal means nothing.
    spans: [usize; 3],
}

/// Groups congruent pairs of axis-parallel rectangles.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lattice {
    cells: Vec<Option<Cell>>,
    spans: usize,
    /// The relation of two spans of one axis, up to reflection: `[first · spans + second]`.
    relations: Vec<u32>,
    relation_count: usize,
    planes: usize,
    /// The position of a span above a plane of its axis: `[plane · spans + span]`.
    depths: Vec<u32>,
    depth_count: usize,
    /// The distance of two planes of one axis: `[first · planes + second]`.
    distances: Vec<u32>,
    distance_count: usize,
    spread: f64,
}

/// One axis of a rectangle while tables are made: numbers of its lower and upper line.
type Lines = [usize; 2];

impl Lattice {
    /// The lattice of a scene, if its tables are small beside its pairs.
    pub(crate) fn of(patches: &[NamedPatch]) -> Option<Self> {
        let boxes = patches.iter().map(|patch| FlatBox::of(patch.shape()));
        Self::of_boxes(&boxes.collect::<Vec<_>>(), 0.0)
    }

    /// The lattice of these rectangles, if its tables are small beside their pairs.
    ///
    /// **Arguments** `largest`: the largest coordinate that the rectangles were computed of, if
    /// that is not theirs.
    pub(crate) fn of_boxes(boxes: &[Option<FlatBox>], largest: f64) -> Option<Self> {
        let mut lines: [Vec<f64>; 3] = [Vec::new(), Vec::new(), Vec::new()];
        for flat in boxes.iter().flatten() {
            for (axis, lines) in lines.iter_mut().enumerate() {
                lines.extend([flat.lower[axis], flat.upper[axis]]);
            }
        }
        for lines in &mut lines {
            lines.sort_by(f64::total_cmp);
            lines.dedup();
        }
        let most = TABLE[0].max(TABLE[1] * boxes.len());
        let pairs_of_lines: usize = lines.iter().map(|lines| lines.len().pow(2)).sum();
        if pairs_of_lines == 0 || pairs_of_lines > most {
            return None;
        }
        let differences = Differences::of(&lines, largest);
        Tables::default().fill(boxes, &lines, &differences, most)
    }

    /// The distance by which coordinates of congruent pairs may differ; 0 if all differences of
    /// lines are exact.
    pub(crate) const fn spread(&self) -> f64 {
        self.spread
    }

    /// One more than the largest class.
    pub(crate) const fn classes(&self) -> usize {
        self.relation_count * self.depth_count * self.depth_count
            + self.distance_count * self.relation_count * self.relation_count
    }

    /// The class of a pair: pairs of one class are congruent. It does not depend on the order of
    /// the two.
    pub(crate) fn class(&self, first: usize, second: usize) -> Option<usize> {
        let (first, second) = (self.cells[first].as_ref()?, self.cells[second].as_ref()?);
        let relation = |axis: usize| {
            let (one, other) = (first.spans[axis], second.spans[axis]);
            [
                self.relations[one * self.spans + other],
                self.relations[other * self.spans + one],
            ]
        };
        let numbers = |[a, b, c]: [u32; 3], counts: [usize; 2]| {
            (a as usize * counts[0] + b as usize) * counts[1] + c as usize
        };
        if first.axis == second.axis {
            let [u, v] = others(first.axis).map(relation);
            // either axis may come first, and either rectangle
            let distances = [
                self.distances[first.plane * self.planes + second.plane],
                self.distances[second.plane * self.planes + first.plane],
            ];
            let key = |way: usize| [distances[way], u[way].min(v[way]), u[way].max(v[way])];
            let offset = self.relation_count * self.depth_count * self.depth_count;
            let counts = [self.relation_count; 2];
            return Some(offset + numbers(key(0).min(key(1)), counts));
        }
        let depth =
            |of: &Cell, over: &Cell| self.depths[over.plane * self.spans + of.spans[over.axis]];
        let depths = [depth(first, second), depth(second, first)];
        let [there, back] = relation(3 - first.axis - second.axis);
        let key = [there, depths[0], depths[1]].min([back, depths[1], depths[0]]);
        Some(numbers(key, [self.depth_count; 2]))
    }
}

/// The spans and planes that the tables are about.
#[derive(Debug, Default)]
struct Tables {
    spans: Vec<(usize, Lines)>,
    planes: Vec<(usize, usize, bool)>,
}

impl Tables {
    /// Numbers the span and the plane of each rectangle.
    fn cells(&mut self, boxes: &[Option<FlatBox>], lines: &[Vec<f64>; 3]) -> Vec<Option<Cell>> {
        let line = |axis: usize, at: f64| lines[axis].partition_point(|line| *line < at);
        let (mut span_numbers, mut plane_numbers) = (BTreeMap::new(), BTreeMap::new());
        let mut cell = |flat: &FlatBox| {
            let mut spans = [0; 3];
            for axis in others(flat.axis) {
                let ends = [flat.lower, flat.upper].map(|ends| line(axis, ends[axis]));
                spans[axis] = numbered(&mut self.spans, &mut span_numbers, (axis, ends));
            }
            let at = line(flat.axis, flat.lower[flat.axis]);
            let plane = (flat.axis, at, flat.faces_along);
            Cell {
                axis: flat.axis,
                plane: numbered(&mut self.planes, &mut plane_numbers, plane),
                spans,
            }
        };
        boxes
            .iter()
            .map(|flat| flat.as_ref().map(&mut cell))
            .collect()
    }

    /// The lattice of these rectangles, if no table has more than `most` entries.
    fn fill(
        mut self,
        boxes: &[Option<FlatBox>],
        lines: &[Vec<f64>; 3],
        differences: &Differences,
        most: usize,
    ) -> Option<Lattice> {
        let cells = self.cells(boxes, lines);
        let (spans, planes) = (self.spans.len(), self.planes.len());
        if spans.max(planes).pow(2) > most {
            return None;
        }
        let (relations, relation_count) = table(&self.spans, &self.spans, |one, other| {
            relation(differences, one, other)
        });
        let (depths, depth_count) = table(&self.planes, &self.spans, |plane, span| {
            depth(differences, plane, span)
        });
        let (distances, distance_count) = table(&self.planes, &self.planes, |one, other| {
            distance(differences, one, other)
        });
        let pairs = cells.len() * cells.len() / 2;
        let lattice = Lattice {
            cells,
            spans,
            relations,
            relation_count,
            planes,
            depths,
            depth_count,
            distances,
            distance_count,
            spread: differences.spread,
        };
        (lattice.classes() <= MOST_CLASSES.min(pairs.max(TABLE[0]))).then_some(lattice)
    }
}

/// The number of an item in a list, to which it is added if it is new.
fn numbered<T: Ord + Copy>(list: &mut Vec<T>, known: &mut BTreeMap<T, usize>, item: T) -> usize {
    *known.entry(item).or_insert_with(|| {
        list.push(item);
        list.len() - 1
    })
}

/// A number for each combination that has a key, equal keys alike; 0 for those without.
fn table<A, B, K: Hash + Eq>(
    rows: &[A],
    columns: &[B],
    key: impl Fn(&A, &B) -> Option<K>,
) -> (Vec<u32>, usize) {
    let mut numbering = Numbering::new();
    let mut numbers = Vec::with_capacity(rows.len() * columns.len());
    for row in rows {
        for column in columns {
            numbers.push(key(row, column).map_or(0, |key| numbering.number(key)));
        }
    }
    (numbers, numbering.count().max(1))
}

/// The relation of two spans: both lengths and the differences of the ends, the smaller of the two
/// reflections.
fn relation(
    differences: &Differences,
    (axis, [low, high]): &(usize, Lines),
    (other_axis, [other_low, other_high]): &(usize, Lines),
) -> Option<[i32; 4]> {
    if axis != other_axis {
        return None;
    }
    let number = |from: &usize, to: &usize| differences.number(*axis, *from, *to);
    let [low_ends, high_ends] = [number(low, other_low), number(high, other_high)];
    let ends = [low_ends, high_ends].min([-high_ends, -low_ends]);
    Some([
        number(low, high),
        number(other_low, other_high),
        ends[0],
        ends[1],
    ])
}

/// Heights of a span's ends over a plane, the lower first.
fn depth(
    differences: &Differences,
    (axis, line, faces_along): &(usize, usize, bool),
    (span_axis, [low, high]): &(usize, Lines),
) -> Option<[i32; 2]> {
    if axis != span_axis {
        return None;
    }
    let [low, high] = [low, high].map(|end| differences.number(*axis, *line, *end));
    Some(if *faces_along {
        [low, high]
    } else {
        [-high, -low]
    })
}

/// The height of either plane over the other.
fn distance(
    differences: &Differences,
    (axis, line, faces_along): &(usize, usize, bool),
    (other_axis, other_line, other_faces_along): &(usize, usize, bool),
) -> Option<[i32; 2]> {
    if axis != other_axis {
        return None;
    }
    let height = differences.number(*axis, *line, *other_line);
    let signed = |height: i32, up: bool| if up { height } else { -height };
    Some([
        signed(height, *faces_along),
        signed(-height, *other_faces_along),
    ])
}
