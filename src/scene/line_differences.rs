//! Axis-parallel rectangles, and the differences between the lines that bound them.

use super::NamedPatch;
use crate::numeric::tolerance;

/// The two axes besides this one.
pub(super) const fn others(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// A rectangle with edges exactly along the axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct FlatBox {
    /// The axis along its normal.
    pub(super) axis: usize,
    /// Does its front face the upper end of that axis?
    pub(super) faces_up: bool,
    pub(super) lower: [f64; 3],
    pub(super) upper: [f64; 3],
}

impl FlatBox {
    /// The patch as such a rectangle, if it is one.
    pub(super) fn of(patch: &NamedPatch) -> Option<Self> {
        let corners: [[f64; 3]; 4] = patch
            .shape
            .corners()
            .iter()
            .map(glam::DVec3::to_array)
            .collect::<Vec<_>>()
            .try_into()
            .ok()?;
        let ends = |axis: usize, best: fn(f64, f64) -> f64| {
            // −0 and 0 are one line
            corners
                .iter()
                .map(|c| c[axis])
                .reduce(best)
                .map(|x| x + 0.0)
        };
        let mut lower = [0.0; 3];
        let mut upper = [0.0; 3];
        for axis in 0..3 {
            lower[axis] = ends(axis, f64::min)?;
            upper[axis] = ends(axis, f64::max)?;
        }
        let is_flat = |axis: &usize| lower[*axis].total_cmp(&upper[*axis]).is_eq();
        let axis = (0..3).find(is_flat)?;
        // neighbouring corners differ along one axis only, and end where the rectangle ends
        let same = |a: f64, b: f64| (a - b).abs() <= 0.0;
        for (corner, next) in (0..4).map(|k| (corners[k], corners[(k + 1) % 4])) {
            let moves = others(axis).map(|k| !same(corner[k], next[k]));
            let ends = others(axis).map(|k| same(corner[k], lower[k]) || same(corner[k], upper[k]));
            if moves[0] == moves[1] || ends != [true; 2] {
                return None;
            }
        }
        Some(Self {
            axis,
            faces_up: patch.shape.normal()[axis] > 0.0,
            lower,
            upper,
        })
    }
}

/// The differences between the lines of each axis, numbered: equal ones alike, with a sign.
#[derive(Debug)]
pub(super) struct Differences {
    /// `[axis][first · lines + second]`: the number of second − first, negative if second lies
    /// below.
    numbers: [Vec<i32>; 3],
    lines: [usize; 3],
    /// The distance by which differences of one number may differ.
    pub(super) spread: f64,
}

impl Differences {
    /// Numbers the differences of the lines of each axis, which are sorted.
    pub(super) fn of(lines: &[Vec<f64>; 3]) -> Self {
        let (starts, spread) = groups(lines);
        let number = |size: f64| starts.partition_point(|start| *start <= size) - 1;
        let signed = |from: f64, to: f64| {
            let number = i32::try_from(number((to - from).abs())).unwrap_or(i32::MAX);
            if to < from { -number } else { number }
        };
        let table = |axis: usize| {
            let lines: &Vec<f64> = &lines[axis];
            let row = |from: &f64| {
                lines
                    .iter()
                    .map(|to| signed(*from, *to))
                    .collect::<Vec<_>>()
            };
            lines.iter().flat_map(row).collect()
        };
        Self {
            numbers: [0, 1, 2].map(table),
            lines: [0, 1, 2].map(|axis| lines[axis].len()),
            spread,
        }
    }

    /// The number of the difference of two lines of an axis.
    pub(super) fn number(&self, axis: usize, from: usize, to: usize) -> i32 {
        self.numbers[axis][from * self.lines[axis] + to]
    }
}

/// The smallest of each group of differences that count as equal, in order, and the spread of the
/// widest group.
fn groups(lines: &[Vec<f64>; 3]) -> (Vec<f64>, f64) {
    let extent = lines
        .iter()
        .flatten()
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    // each with what rounding took from it
    let mut sizes = vec![(0.0, 0.0)];
    for lines in lines {
        for (k, line) in lines.iter().enumerate() {
            sizes.extend(
                lines[..k]
                    .iter()
                    .map(|below| exact_difference(*line, *below)),
            );
        }
    }
    sizes.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    let mut starts: Vec<f64> = Vec::new();
    let (mut least, mut most) = (0.0_f64, 0.0_f64);
    let mut spread: f64 = 0.0;
    for (size, lost) in sizes {
        match starts.last() {
            Some(start) if size - start <= tolerance::ALIGNMENT * extent => {
                let offset = (size - start) + lost;
                (least, most) = (least.min(offset), most.max(offset));
            }
            _ => {
                starts.push(size);
                (least, most) = (lost, lost);
            }
        }
        spread = spread.max(most - least);
    }
    (starts, spread)
}

/// The rounded difference `upper − lower`, and what rounding took from it (Knuth).
fn exact_difference(upper: f64, lower: f64) -> (f64, f64) {
    let size = upper - lower;
    let taken = upper - size;
    (size, (upper - (size + taken)) + (taken - lower))
}
