//! The lines along the axes of a frame that the corners of polygons lie on, within rounding.
//!
//! ```text
//!   y = (a₁·(x − o), …)       the coordinates of corners about their middle, to 106 bits
//!   line                      a group of coordinates within some roundings, at their mean
//!   offset                    most that a coordinate is off its line
//! ```

use super::frames::Frame;
use crate::numeric::{DoubleDouble, Scalar, real, tolerance};
use crate::scene::NamedPatch;
use glam::DVec3;

/// The lines along the three axes, and the corners between them.
pub(crate) struct Lines {
    axes: [AxisLines; 3],
    /// The lines of each corner of each polygon.
    pub(crate) corners: Vec<Vec<[usize; 3]>>,
    /// The largest coordinate of the polygons as they stand in the scene.
    pub(crate) largest: f64,
}

impl Lines {
    /// The lines of these polygons.
    pub(crate) fn of(frame: &Frame, patches: &[NamedPatch], polygons: &[usize]) -> Self {
        let corners = |polygon: &usize| patches[*polygon].shape().corners();
        // about the middle numbers are smaller, and rounded to finer steps
        let (middle, largest) = middle(polygons.iter().flat_map(corners));
        let places: Vec<Vec<[DoubleDouble; 3]>> = polygons
            .iter()
            .map(|polygon| {
                let places = corners(polygon).iter();
                let places = places.map(|corner| frame.coordinates(*corner, middle));
                places.collect()
            })
            .collect();
        let axes =
            [0, 1, 2].map(|axis| AxisLines::of(places.iter().flatten().map(|c| c[axis]), largest));
        let line = |c: &[DoubleDouble; 3]| [0, 1, 2].map(|axis| axes[axis].of_coordinate(c[axis]));
        let corners = places
            .iter()
            .map(|corners| corners.iter().map(line).collect());
        Self {
            corners: corners.collect(),
            axes,
            largest,
        }
    }

    /// The place of a line.
    pub(crate) fn place(&self, axis: usize, line: usize) -> f64 {
        self.axes[axis].mean(line)
    }

    /// The places of all lines of an axis, in order.
    pub(crate) fn places(&self, axis: usize) -> Vec<f64> {
        let lines = 0..self.axes[axis].groups.len();
        lines.map(|line| self.place(axis, line)).collect()
    }

    /// Number of pairs of lines of one axis.
    pub(crate) fn pairs(&self) -> usize {
        self.axes.iter().map(|axis| axis.groups.len().pow(2)).sum()
    }

    /// The largest distance of a coordinate from its line.
    pub(crate) fn offset(&self) -> f64 {
        self.axes.iter().map(|axis| axis.offset).fold(0.0, f64::max)
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
struct AxisLines {
    /// The smallest and the mean of each group, in order.
    groups: Vec<[f64; 2]>,
    /// The largest distance of a coordinate from the mean of its group.
    offset: f64,
}

impl AxisLines {
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
