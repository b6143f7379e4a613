//! The poses of polygons between lines, and the symmetries that take one to another.
//!
//! ```text
//!   pose    the corners from the lower ends of the polygon's box, in numbers of differences
//!   form    the least of the images of a pose under the 48 symmetries
//! ```

use super::line_differences::Differences;
use super::symmetry::{SYMMETRIES, Symmetry};
use std::collections::HashMap;

/// Most corners of a polygon.
const MOST_CORNERS: usize = 16;

/// The corners of a polygon from the lower ends of its box, in numbers, from the least corner on.
type Shape = Vec<[i32; 3]>;

/// Two poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PosePair {
    /// The number of their least image.
    pub(crate) image: u32,
    /// The place of the first way to it, and the number of ways.
    pub(crate) ways: [u32; 2],
}

/// A way to an image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Way {
    pub(crate) symmetry: Symmetry,
    pub(crate) exchanged: bool,
}

/// A polygon between lines: its corners, and the ends of its box.
pub(crate) struct Outline {
    /// The corners from the lower ends, and from the upper ends, of the box.
    numbers: [Vec<[i32; 3]>; 2],
    pub(crate) lower: [usize; 3],
    pub(crate) upper: [usize; 3],
}

impl Outline {
    pub(crate) fn of(corners: &[[usize; 3]], differences: &Differences) -> Self {
        let end = |pick: fn(usize, usize) -> usize| {
            let ends = corners.iter().copied();
            let ends = ends.reduce(|a, b| [0, 1, 2].map(|axis| pick(a[axis], b[axis])));
            ends.unwrap_or_default()
        };
        let (lower, upper) = (end(usize::min), end(usize::max));
        let from = |ends: [usize; 3]| {
            let number = |c: &[usize; 3]| {
                [0, 1, 2].map(|axis| differences.number(axis, ends[axis], c[axis]))
            };
            corners.iter().map(number).collect()
        };
        Self {
            numbers: [from(lower), from(upper)],
            lower,
            upper,
        }
    }

    /// The shape of the image: its corners begin at the least.
    fn image(&self, symmetry: &Symmetry) -> Shape {
        let corner = |k: usize| {
            [0, 1, 2].map(|axis| {
                let own = symmetry.axes[axis];
                if symmetry.reflected[axis] {
                    -self.numbers[1][k][own]
                } else {
                    self.numbers[0][k][own]
                }
            })
        };
        let mut shape: Shape = (0..self.numbers[0].len()).map(corner).collect();
        if symmetry.is_reflection() {
            shape.reverse();
        }
        let least = (0..shape.len()).min_by_key(|k| shape[*k]).unwrap_or(0);
        shape.rotate_left(least);
        shape
    }
}

/// The poses that occur, and their images.
#[derive(Default)]
pub(crate) struct Poses {
    numbers: HashMap<Shape, u32>,
    /// The numbers of the images of each pose that occurs first in the scene.
    images: HashMap<u32, Vec<u32>>,
    /// The number of polygons of each form, the least image of a pose.
    counts: HashMap<u32, usize>,
    /// The poses that are kept.
    kept: Vec<u32>,
}

impl Poses {
    fn number(&mut self, shape: Shape) -> u32 {
        let next = u32::try_from(self.numbers.len()).unwrap_or(u32::MAX);
        *self.numbers.entry(shape).or_insert(next)
    }

    /// The pose of a polygon; none if it has too many corners.
    pub(crate) fn pose(&mut self, outline: &Outline) -> Option<u32> {
        let symmetries = Symmetry::all();
        if outline.numbers[0].len() > MOST_CORNERS {
            return None;
        }
        let pose = self.number(outline.image(&symmetries[0]));
        if !self.images.contains_key(&pose) {
            let images: Vec<Shape> = symmetries.iter().map(|g| outline.image(g)).collect();
            let images: Vec<u32> = images.into_iter().map(|shape| self.number(shape)).collect();
            self.images.insert(pose, images);
        }
        let form = self.form(pose);
        *self.counts.entry(form).or_default() += 1;
        Some(pose)
    }

    fn form(&self, pose: u32) -> u32 {
        let images = self.images.get(&pose);
        images
            .and_then(|images| images.iter().min().copied())
            .unwrap_or(pose)
    }

    /// The places among the poses that are kept: those of forms that occur more than once.
    pub(crate) fn repeated(&mut self, posed: Vec<Option<u32>>) -> Vec<Option<u32>> {
        let mut places: HashMap<u32, u32> = HashMap::new();
        let mut kept = Vec::new();
        let place = |pose: Option<u32>| {
            let pose = pose?;
            let count = self.counts.get(&self.form(pose)).copied().unwrap_or(0);
            (count > 1).then(|| {
                *places.entry(pose).or_insert_with(|| {
                    kept.push(pose);
                    u32::try_from(kept.len() - 1).unwrap_or(u32::MAX)
                })
            })
        };
        let placed = posed.into_iter().map(place).collect();
        self.kept = kept;
        placed
    }

    pub(crate) fn occurring(&self) -> usize {
        self.kept.len()
    }

    /// The least image of each pair of poses, and the ways there.
    pub(crate) fn pairs(&self) -> (Vec<PosePair>, Vec<Way>) {
        let symmetries = Symmetry::all();
        let (mut pairs, mut ways) = (Vec::new(), Vec::<Way>::new());
        let mut numbers: HashMap<[u32; 2], u32> = HashMap::new();
        for one in &self.kept {
            for other in &self.kept {
                let (one, other) = (&self.images[one], &self.images[other]);
                let image = |k: usize, exchanged: bool| {
                    if exchanged {
                        [other[k], one[k]]
                    } else {
                        [one[k], other[k]]
                    }
                };
                let all = || (0..SYMMETRIES).flat_map(|k| [(k, false), (k, true)]);
                let least = all().map(|(k, exchanged)| image(k, exchanged)).min();
                let least = least.unwrap_or_default();
                let start = ways.len();
                for (k, exchanged) in all() {
                    if image(k, exchanged) == least {
                        let symmetry = symmetries[k];
                        ways.push(Way {
                            symmetry,
                            exchanged,
                        });
                    }
                }
                let next = u32::try_from(numbers.len()).unwrap_or(u32::MAX);
                let of = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
                pairs.push(PosePair {
                    image: *numbers.entry(least).or_insert(next),
                    ways: [of(start), of(ways.len() - start)],
                });
            }
        }
        (pairs, ways)
    }
}
