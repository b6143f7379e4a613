//! The routes to a form factor, by name.

/// How a pair's exchange area was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Route {
    /// Both lie in one plane: nothing is exchanged.
    Coplanar,
    /// One lies behind the other's plane, or its front faces away: nothing is exchanged.
    BackFacing,
    /// Closed form of two parallel rectangles with edges along common axes.
    ParallelRectangles,
    /// Closed form of two perpendicular rectangles with edges along common axes.
    PerpendicularRectangles,
    /// Contour integral over both boundaries: closed forms for coplanar edges, Gauss rules for skew ones.
    Contour,
    /// Gauss rule over one polygon, the other one seen from each point in closed form.
    PointToPolygon,
    /// Gauss rules over both polygons.
    Kernel,
    /// The contour integral in double-double arithmetic.
    DoubleDouble,
}

impl Route {
    /// The name that tables and JSON use.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coplanar => "coplanar",
            Self::BackFacing => "back-facing",
            Self::ParallelRectangles => "parallel-rectangles",
            Self::PerpendicularRectangles => "perpendicular-rectangles",
            Self::Contour => "contour",
            Self::PointToPolygon => "point-to-polygon",
            Self::Kernel => "kernel",
            Self::DoubleDouble => "double-double",
        }
    }
}
