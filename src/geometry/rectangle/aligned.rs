//! Rectangles with edges along the coordinate axes: recognised, bounded, and ready to be placed
//! beside others.

use crate::geometry::{Patch, Rectangle, SplitAxis};
use crate::numeric::DoubleDouble;
use glam::DVec3;

/// A rectangle whose edges u and v run along coordinate axes: what its place beside another needs,
/// made once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AlignedRectangle {
    /// The corner `v0`.
    pub(crate) origin: [f64; 3],
    /// The corner `v2`, rounded as [`Rectangle::corners`] rounds it.
    opposite: [f64; 3],
    /// The edges' coordinates: one along u's axis, one along v's, 0 along the normal's.
    pub(crate) sides: [f64; 3],
    /// The coordinate axes along which u, v and the normal run.
    pub(crate) axes: [usize; 3],
    /// 1 for those that run along theirs, −1 for those that run against it.
    pub(crate) signs: [f64; 3],
}

impl AlignedRectangle {
    /// Tells whether the other rectangle is in a parallel plane, or in the same.
    #[must_use]
    pub const fn is_parallel_to(&self, other: &Self) -> bool {
        self.axes[2] == other.axes[2]
    }

    /// Tells whether the corners `v0` and `v2` of `other` are known without rounding from `v0` of
    /// this one.
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
    /// The coordinate axes along which the edges run, as indices; `None` if they do not.
    #[must_use]
    pub fn axes(&self) -> Option<[usize; 2]> {
        let along = |edge: DVec3| match edge.to_array().map(|x| x.abs() > 0.0) {
            [true, false, false] => Some(0),
            [false, true, false] => Some(1),
            [false, false, true] => Some(2),
            _ => None,
        };
        let [u, v] = SplitAxis::ALL.map(|axis| self.edge(axis));
        Some([along(u)?, along(v)?])
    }

    /// The rectangle, ready to be placed beside others; `None` unless its edges run along the
    /// coordinate axes.
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

/// A box that is flat along one coordinate axis: a rectangle whose corners lie exactly at its ends.
///
/// An [`AlignedRectangle`] is known by three of its corners, and the fourth may be off by a
/// rounding; here it is not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatBox {
    /// The coordinate axis along the normal.
    pub axis: usize,
    /// Whether the normal points along this axis (else against it).
    pub faces_along: bool,
    /// The smallest coordinates.
    pub lower: [f64; 3],
    /// The largest coordinates.
    pub upper: [f64; 3],
}

impl FlatBox {
    /// The box that a patch is; `None` if it is not exactly one.
    ///
    /// **Arguments** `patch`: of any number of corners and any orientation.
    /// **Returns** a box whose ends are the patch's coordinates themselves, unrounded; one of its
    /// three lengths is 0, the others are positive.
    #[must_use]
    pub fn of(patch: &Patch) -> Option<Self> {
        let [u, v] = Rectangle::try_from(patch).ok()?.axes()?;
        let corners: [DVec3; 4] = patch.corners().try_into().ok()?;
        let [v0, v1, v2, v3] = corners.map(|corner| corner.to_array());
        let mut opposite = v0;
        (opposite[u], opposite[v]) = (v1[u], v3[v]);
        let mut gaps = v2.iter().zip(&opposite).map(|(x, end)| (x - end).abs());
        if gaps.any(|gap| gap > 0.0) {
            return None;
        }
        // −0 and 0 are one line
        let ends = |end: fn(f64, f64) -> f64| [0, 1, 2].map(|k| end(v0[k], v2[k]) + 0.0);
        let axis = 3 - u - v;
        Some(Self {
            axis,
            faces_along: patch.normal()[axis] > 0.0,
            lower: ends(f64::min),
            upper: ends(f64::max),
        })
    }

    /// The corners, counter-clockwise seen from the front.
    pub(crate) fn corners(&self) -> Vec<DVec3> {
        let (u, v) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let corner = |is_high: [bool; 2]| {
            let mut place = self.lower;
            for (axis, is_high) in [u, v].into_iter().zip(is_high) {
                if is_high {
                    place[axis] = self.upper[axis];
                }
            }
            DVec3::from_array(place)
        };
        let around = [[false, false], [true, false], [true, true], [false, true]];
        let mut corners: Vec<DVec3> = around.map(corner).to_vec();
        if !self.faces_along {
            corners.reverse();
        }
        corners
    }
}
