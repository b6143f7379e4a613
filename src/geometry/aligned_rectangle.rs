//! Rectangles with edges along the coordinate axes, ready to be placed beside others.

use super::{Rectangle, SplitAxis};
use crate::numeric::DoubleDouble;

/// A rectangle whose edges u and v run along coordinate axes: what its place beside another needs, made once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlignedRectangle {
    /// The corner `v0`.
    pub(super) origin: [f64; 3],
    /// The corner `v2`, rounded as [`Rectangle::corners`] rounds it.
    opposite: [f64; 3],
    /// The edges' coordinates: one along u's axis, one along v's, 0 along the normal's.
    pub(super) sides: [f64; 3],
    /// The coordinate axes along which u, v and the normal run.
    pub(super) axes: [usize; 3],
    /// 1 for those that run along theirs, −1 for those that run against it.
    pub(super) signs: [f64; 3],
}

impl AlignedRectangle {
    /// Is the other one in a parallel plane, or in the same?
    #[must_use]
    pub const fn is_parallel_to(&self, other: &Self) -> bool {
        self.axes[2] == other.axes[2]
    }

    /// Are the corners `v0` and `v2` of `other` known without rounding from `v0` of this one?
    #[must_use]
    pub fn places_exactly(&self, other: &Self) -> bool {
        let mut lost = 0.0;
        for corner in [&other.origin, &other.opposite] {
            for (x, origin) in corner.iter().zip(&self.origin) {
                lost += DoubleDouble::difference(*x, *origin).low().abs();
            }
        }
        lost == 0.0
    }
}

impl Rectangle {
    /// The same, ready to be placed beside others; `None` unless the edges run along the coordinate axes.
    #[must_use]
    pub fn aligned(&self) -> Option<AlignedRectangle> {
        let [u, v] = self.axes()?;
        let edges = SplitAxis::ALL.map(|axis| self.edge(axis).to_array());
        let (along_u, along_v) = (edges[0][u], edges[1][v]);
        let mut sides = [0.0; 3];
        (sides[u], sides[v]) = (along_u, along_v);
        // the normal's axis follows u's and v's as z follows x and y, or runs against that
        let handedness = if (v + 3 - u) % 3 == 1 { 1.0 } else { -1.0 };
        let signs = [along_u.signum(), along_v.signum()];
        Some(AlignedRectangle {
            origin: self.origin().to_array(),
            opposite: self.corners()[2].to_array(),
            sides,
            axes: [u, v, 3 - u - v],
            signs: [signs[0], signs[1], handedness * signs[0] * signs[1]],
        })
    }
}
