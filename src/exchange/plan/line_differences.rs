//! The differences between the lines that bound axis-parallel rectangles.
//!
//! ```text
//!   sizes |b − a| over all axes, sorted; equal ones, up to a few roundings, share a number
//!   number(a, b) = −number(b, a)
//! ```
//!
//! **Not covered**: lines that no rectangle begins or ends at.

use crate::numeric::{tolerance, two_sum};

/// The two axes besides this one.
pub(crate) const fn others(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// The differences between the lines of each axis, numbered: equal ones alike, with a sign.
#[derive(Debug)]
pub(crate) struct Differences {
    /// `[axis][first · lines + second]`: the number of second − first, negative if second lies
    /// below.
    numbers: [Vec<i32>; 3],
    lines: [usize; 3],
    /// The distance by which differences of one number may differ.
    pub(crate) spread: f64,
}

impl Differences {
    /// Numbers the differences of the lines of each axis, which are sorted.
    ///
    /// **Arguments** `largest`: the largest coordinate that lines were computed of, if that is not
    /// a line.
    pub(crate) fn of(lines: &[Vec<f64>; 3], largest: f64) -> Self {
        let (starts, spread) = groups(lines, largest);
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
    pub(crate) fn number(&self, axis: usize, from: usize, to: usize) -> i32 {
        self.numbers[axis][from * self.lines[axis] + to]
    }
}

/// The smallest of each group of differences that count as equal, in order, and the spread of the
/// widest group.
fn groups(lines: &[Vec<f64>; 3], largest: f64) -> (Vec<f64>, f64) {
    let extent = lines
        .iter()
        .flatten()
        .fold(largest, |most: f64, x| most.max(x.abs()));
    // each with what rounding took from it
    let mut sizes = vec![(0.0, 0.0)];
    for lines in lines {
        for (k, line) in lines.iter().enumerate() {
            sizes.extend(lines[..k].iter().map(|below| two_sum(*line, -below)));
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
