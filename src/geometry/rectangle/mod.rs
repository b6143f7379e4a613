//! Rectangles: recognised from a patch, cut into parts, placed beside each other.
//!
//! [`Rectangle`] itself is here. `placement` has the place of a second rectangle in the frame of a
//! first one, `span` and `offsets` a side of each on one axis and their distances; `aligned` has
//! rectangles with edges along the coordinate axes, whose places are known without rounding.
//!
//! For corners `v0 v1 v2 v3`, axis u runs along `v0 → v1` and axis v along `v0 → v3`;
//! positions on an axis are relative, 0 at `v0` and 1 at the far side.

pub(crate) mod aligned;
pub(crate) mod offsets;
pub(crate) mod placement;
pub(crate) mod span;

use super::{GeometryError, Patch, check_part};
use crate::numeric::tolerance;
use glam::DVec3;

/// One of the two edge directions of a rectangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SplitAxis {
    /// Along `v0 → v1`.
    U,
    /// Along `v0 → v3`.
    V,
}

impl SplitAxis {
    /// The two axes, u first.
    pub const ALL: [Self; 2] = [Self::U, Self::V];

    /// `"u"` or `"v"`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::U => "u",
            Self::V => "v",
        }
    }
}

/// A corner and the two perpendicular edges that leave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    origin: DVec3,
    edges: [DVec3; 2],
}

impl Rectangle {
    /// The rectangle with corner `origin` and edges `u` and `v`; its front is towards `u × v`.
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`], [`GeometryError::NoArea`],
    /// [`GeometryError::NotARectangle`] if the edges are not perpendicular.
    pub fn try_new(origin: DVec3, u: DVec3, v: DVec3) -> Result<Self, GeometryError> {
        Self::try_from(&Patch::try_new(vec![
            origin,
            origin + u,
            origin + u + v,
            origin + v,
        ])?)
    }

    /// The corner `v0`.
    #[must_use]
    pub const fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The edge along an axis, from `v0`.
    #[must_use]
    pub const fn edge(&self, axis: SplitAxis) -> DVec3 {
        self.edges[axis as usize]
    }

    /// Unit normal, towards the front.
    #[must_use]
    pub fn normal(&self) -> DVec3 {
        self.edges[0].normalize().cross(self.edges[1].normalize())
    }

    /// Area, in squared units of length.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.edges[0].length() * self.edges[1].length()
    }

    /// The four corners `v0 v1 v2 v3`.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 4] {
        let [u, v] = self.edges;
        [
            self.origin,
            self.origin + u,
            self.origin + u + v,
            self.origin + v,
        ]
    }

    /// The part between two relative positions on an axis.
    ///
    /// # Errors
    /// [`GeometryError::PositionOutOfRange`] unless `0 ≤ from < to ≤ 1`.
    pub fn part(&self, axis: SplitAxis, from: f64, to: f64) -> Result<Self, GeometryError> {
        check_part(from, to)?;
        let edge = self.edge(axis);
        let mut part = *self;
        part.origin += edge * from;
        part.edges[axis as usize] = edge * (to - from);
        Ok(part)
    }

    /// Cut across an axis at a relative position: the part at `v0` first.
    ///
    /// # Errors
    /// [`GeometryError::PositionOutOfRange`] unless `0 < position < 1`.
    ///
    /// # Examples
    /// ```
    /// use infoscene::geometry::{Rectangle, SplitAxis};
    /// use glam::DVec3;
    /// let square = Rectangle::try_new(DVec3::ZERO, DVec3::X, DVec3::Y)?;
    /// let [near, far] = square.split(SplitAxis::U, 0.25)?;
    /// assert_eq!((near.area(), far.area()), (0.25, 0.75));
    /// # Ok::<(), infoscene::geometry::GeometryError>(())
    /// ```
    pub fn split(&self, axis: SplitAxis, position: f64) -> Result<[Self; 2], GeometryError> {
        Ok([
            self.part(axis, 0.0, position)?,
            self.part(axis, position, 1.0)?,
        ])
    }
}

impl TryFrom<&Patch> for Rectangle {
    type Error = GeometryError;

    fn try_from(patch: &Patch) -> Result<Self, GeometryError> {
        let not = |reason: String| Err(GeometryError::NotARectangle { reason });
        let [v0, v1, v2, v3] = *patch.corners() else {
            return not(format!("it has {} corners", patch.corners().len()));
        };
        let (u, v) = (v1 - v0, v3 - v0);
        let largest = patch
            .corners()
            .iter()
            .map(|c| c.abs().max_element())
            .fold(0.0, f64::max);
        let allowed = tolerance::ALIGNMENT * largest;
        let opening = (v2 - v1 - v).length();
        if opening > allowed {
            return not(format!(
                "opposite edges differ by {opening:e}, {allowed:e} is accepted"
            ));
        }
        let lean = (u.dot(v) / u.length().max(v.length())).abs();
        if lean > allowed {
            return not(format!(
                "an edge leans by {lean:e}, {allowed:e} is accepted"
            ));
        }
        Ok(Self {
            origin: v0,
            edges: [u, v],
        })
    }
}

impl TryFrom<&Rectangle> for Patch {
    type Error = GeometryError;

    fn try_from(rectangle: &Rectangle) -> Result<Self, GeometryError> {
        Self::try_new(rectangle.corners().to_vec())
    }
}
