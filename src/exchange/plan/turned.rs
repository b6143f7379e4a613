//! Congruent pairs of rectangles along the axes of a turned frame.
//!
//! ```text
//!   y = (a₁·(x − o), …)           the coordinates of corners about their middle, to 106 bits
//!   lines                         groups of coordinates within some roundings; each its mean
//!   model                         the rectangle between the lines that its corners belong to
//!   offset                        most that a corner is off its model, along each axis
//! ```
//!
//! Models lie between few lines, exactly along the axes: their pairs fall into classes as those of
//! any axis-parallel rectangles do ([`Lattice`]). A class has the value of the model of its first
//! pair, whose bound is widened by what the offsets and the lattice's spread may change
//! (`perturbation`). Closed forms of axis-parallel rectangles evaluate it.
//!
//! **Not covered**: pairs of rectangles in different frames.

use super::congruence::Lattice;
use super::frames::{Frame, frames};
use crate::geometry::FlatBox;
use crate::numeric::{DoubleDouble, Scalar, real, tolerance};
use crate::scene::NamedPatch;
use glam::DVec3;

/// The rectangles along the axes of one frame, and the models that stand for them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TurnedFrame {
    /// The polygons, in order.
    pub(crate) members: Vec<usize>,
    /// The rectangles that stand for them, along the axes of the frame.
    pub(crate) models: Vec<FlatBox>,
    /// The largest distance of a corner from its model's along an axis.
    pub(crate) offset: f64,
}

impl TurnedFrame {
    /// The frames of the rectangles that are not along the coordinate axes, with their lattices.
    pub(crate) fn all_of(patches: &[NamedPatch]) -> Vec<(Self, Lattice)> {
        let is_turned = |polygon: &usize| {
            let shape = patches[*polygon].shape();
            shape.corners().len() == 4 && FlatBox::of(shape).is_none()
        };
        let found = frames(patches, (0..patches.len()).filter(is_turned));
        let turned = |(frame, members): &(Frame, Vec<usize>)| Self::of(frame, patches, members);
        found.iter().filter_map(turned).collect()
    }

    fn of(frame: &Frame, patches: &[NamedPatch], candidates: &[usize]) -> Option<(Self, Lattice)> {
        let corners = |polygon: &usize| patches[*polygon].shape().corners();
        // about the middle numbers are smaller, and rounded to finer steps
        let (middle, largest) = middle(candidates.iter().flat_map(corners));
        let in_frame = |polygon: &usize| {
            let places = corners(polygon).iter();
            let places = places.map(|corner| frame.coordinates(*corner, middle));
            places.collect::<Vec<_>>().try_into().ok()
        };
        let places: Vec<[[DoubleDouble; 3]; 4]> = candidates.iter().filter_map(in_frame).collect();
        let lines =
            [0, 1, 2].map(|axis| Lines::of(places.iter().flatten().map(|c| c[axis]), largest));
        let (mut members, mut models) = (Vec::new(), Vec::new());
        for (polygon, corners) in candidates.iter().zip(&places) {
            let normal = frame.direction(patches[*polygon].shape().normal());
            if let Some(model) = model(&lines, corners, normal) {
                members.push(*polygon);
                models.push(model);
            }
        }
        let boxes: Vec<Option<FlatBox>> = models.iter().copied().map(Some).collect();
        let lattice = Lattice::of_boxes(&boxes, largest)?;
        let offset = lines.iter().map(|lines| lines.offset).fold(0.0, f64::max);
        let turned = Self {
            members,
            models,
            offset,
        };
        Some((turned, lattice))
    }
}

/// The middle of the box around some points, and their largest coordinate.
fn middle<'p>(points: impl Iterator<Item = &'p DVec3>) -> (DVec3, f64) {
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (lower, upper) = points.fold(ends, |(lower, upper), p| (lower.min(*p), upper.max(*p)));
    let largest = lower.abs().max(upper.abs()).max_element();
    (lower + 0.5 * (upper - lower), largest)
}

/// Coordinates along one axis, in groups.
struct Lines {
    /// The smallest and the mean of each group, in order.
    groups: Vec<[f64; 2]>,
    /// The largest distance of a coordinate from the mean of its group.
    offset: f64,
}

impl Lines {
    /// The groups of coordinates that are equal within the rounding of the largest of the scene.
    fn of(coordinates: impl Iterator<Item = DoubleDouble>, largest: f64) -> Self {
        let mut all: Vec<DoubleDouble> = coordinates.collect();
        all.sort_by(|one, other| one.high().total_cmp(&other.high()));
        let (mut groups, mut offset) = (Vec::new(), 0.0_f64);
        let mut rest = all.as_slice();
        while let Some(first) = rest.first().map(|first| first.high()) {
            let is_near = |x: &DoubleDouble| x.high() - first <= tolerance::ALIGNMENT * largest;
            let (group, others) = rest.split_at(rest.partition_point(is_near).max(1));
            let above = group
                .iter()
                .map(|x| (*x - DoubleDouble::from(first)).to_f64());
            let mean = first + above.sum::<f64>() / real(group.len());
            groups.push([first, mean]);
            for x in group {
                offset = offset.max((*x - DoubleDouble::from(mean)).to_f64().abs());
            }
            rest = others;
        }
        Self { groups, offset }
    }

    /// The group of a coordinate.
    fn of_coordinate(&self, coordinate: DoubleDouble) -> usize {
        let place = self
            .groups
            .partition_point(|[first, _]| *first <= coordinate.high());
        place.saturating_sub(1)
    }

    fn mean(&self, line: usize) -> f64 {
        // −0 and 0 are one line
        self.groups[line][1] + 0.0
    }
}

/// The rectangle between the lines of these corners; none if they are no rectangle's.
fn model(
    lines: &[Lines; 3],
    corners: &[[DoubleDouble; 3]; 4],
    normal: [f64; 3],
) -> Option<FlatBox> {
    let corners = corners.map(|c| [0, 1, 2].map(|axis| lines[axis].of_coordinate(c[axis])));
    let [v0, v1, v2, v3] = corners;
    let along = |from: [usize; 3], to: [usize; 3]| {
        let mut axes = (0..3).filter(|axis| from[*axis] != to[*axis]);
        axes.next().filter(|_| axes.next().is_none())
    };
    let (u, v) = (along(v0, v1)?, along(v0, v3)?);
    let is_closed = along(v1, v2) == Some(v) && along(v3, v2) == Some(u);
    if u == v || !is_closed {
        return None;
    }
    let axis = 3 - u - v;
    let ends = |end: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|k| end(lines[k].mean(v0[k]), lines[k].mean(v2[k])))
    };
    Some(FlatBox {
        axis,
        faces_along: normal[axis] > 0.0,
        lower: ends(f64::min),
        upper: ends(f64::max),
    })
}
