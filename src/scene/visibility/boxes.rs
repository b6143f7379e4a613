//! Trees of numbered boxes, and the hull of two boxes to look them up by.
//!
//! **Not covered**: what is in the boxes.

use glam::DVec3;
use rstar::primitives::{GeomWithData, Rectangle as Box3};
use rstar::{AABB, RTree, RTreeObject, SelectionFunction};

pub(super) type Boxes = RTree<GeomWithData<Box3<[f64; 3]>, usize>>;

/// The convex hull of two boxes, for trees of boxes.
///
/// It is the union of the boxes between the two, whose sides move linearly; so a box meets it if
/// six linear inequalities have a common solution from 0 to 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoxHull {
    from: [[f64; 3]; 2],
    to: [[f64; 3]; 2],
}

impl BoxHull {
    pub(super) fn of([from, to]: [&[DVec3; 2]; 2]) -> Self {
        let arrays = |ends: &[DVec3; 2]| ends.map(|corner| corner.to_array());
        let (from, to) = (arrays(from), arrays(to));
        Self { from, to }
    }

    fn meets(&self, place: &AABB<[f64; 3]>) -> bool {
        let (low, high) = (place.lower(), place.upper());
        let (mut start, mut end) = (0.0_f64, 1.0_f64);
        // keeps of [start, end] where a + (b − a) t ≤ 0
        let mut keep = |a: f64, b: f64| {
            if a <= 0.0 && b <= 0.0 {
                return;
            }
            let root = a / (a - b);
            if a > 0.0 && b > 0.0 {
                (start, end) = (1.0, 0.0);
            } else if a > 0.0 {
                start = start.max(root);
            } else {
                end = end.min(root);
            }
        };
        for axis in 0..3 {
            keep(low[axis] - self.from[1][axis], low[axis] - self.to[1][axis]);
            keep(
                self.from[0][axis] - high[axis],
                self.to[0][axis] - high[axis],
            );
        }
        // roundings of the roots
        start <= end + 8.0 * f64::EPSILON
    }
}

impl<T: RTreeObject<Envelope = AABB<[f64; 3]>>> SelectionFunction<T> for BoxHull {
    fn should_unpack_parent(&self, envelope: &AABB<[f64; 3]>) -> bool {
        self.meets(envelope)
    }

    fn should_unpack_leaf(&self, leaf: &T) -> bool {
        self.meets(&leaf.envelope())
    }
}

/// The tree of numbered boxes.
pub(super) fn boxed(boxes: impl Iterator<Item = (usize, [DVec3; 2])>) -> Boxes {
    let boxes = boxes.map(|(number, ends)| {
        let [low, high] = ends.map(|corner| corner.to_array());
        GeomWithData::new(Box3::from_corners(low, high), number)
    });
    RTree::bulk_load(boxes.collect())
}
