//! The routes to a form factor, by name.

/// Declares the routes with their names, so that neither the list nor a name can be forgotten.
macro_rules! routes {
    ($($(#[doc = $doc:literal])+ $route:ident = $name:literal,)+) => {
        /// The way in which a pair's exchange area was found.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Route {
            $($(#[doc = $doc])+ $route,)+
        }

        impl Route {
            /// All routes; each stands at the place of its discriminant.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$route),+];

            /// The name that tables and JSON use.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$route => $name,)+
                }
            }
        }
    };
}

routes! {
    /// The polygons lie in one plane: nothing is exchanged.
    Coplanar = "coplanar",
    /// One lies behind the other's plane, or its front faces away: nothing is exchanged.
    BackFacing = "back-facing",
    /// Closed form of two parallel rectangles with edges along common axes.
    ParallelRectangles = "parallel-rectangles",
    /// Closed form of two perpendicular rectangles with edges along common axes.
    PerpendicularRectangles = "perpendicular-rectangles",
    /// Contour integral over both boundaries: closed forms for coplanar edges, Gauss rules for skew
    /// ones.
    Contour = "contour",
    /// Gauss rule over one polygon, the other one seen from each point in closed form.
    PointToPolygon = "point-to-polygon",
    /// Gauss rules over both polygons.
    Kernel = "kernel",
    /// The contour integral in double-double arithmetic.
    DoubleDouble = "double-double",
    /// Contours of what is seen past other polygons, along their edges and the polygons' own.
    Occluded = "occluded",
    /// Other polygons hide all: nothing is exchanged.
    Hidden = "hidden",
}
