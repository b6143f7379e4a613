//! Flat pieces of surface and their positions relative to each other.
//!
//! A [`Patch`] is a planar simple polygon; a [`Rectangle`] is recognised from one, cut into
//! parts, and placed beside another by [`Placement`]; on one axis [`Offsets`] hold the distances
//! between the ends of two [`Span`]s. The solid between two patches is their [`Shaft`]. Lengths are
//! in any one unit.
//!
//! **Not here**: anything radiometric.

mod error;
mod local_line;
mod patch;
mod polygon;
mod rectangle;
mod shaft;
mod uniform_line;
mod vector;

pub use error::GeometryError;
pub(crate) use local_line::{Facet, LocalLine, Slope};
pub use patch::Patch;
pub use polygon::centroid::centroid;
pub(crate) use polygon::clip::{ClippedCorner, clip, clipped};
pub(crate) use polygon::containment::{NotContained, check_contained, distance_from_plane};
pub use polygon::convexity::convex_hull;
pub(crate) use polygon::convexity::is_convex;
pub use polygon::cut_lines::CutLines;
pub(crate) use polygon::ears::EarClipper;
pub use polygon::quarters::quartered;
pub use polygon::triangulation::triangulated;
pub use rectangle::aligned::{AlignedRectangle, FlatBox};
pub use rectangle::offsets::Offsets;
pub use rectangle::placement::{Extent, Placement};
pub use rectangle::span::Span;
pub use rectangle::{Rectangle, SplitAxis};
pub use shaft::{Outline, Plane, Shaft};
pub(crate) use uniform_line::line_through_sphere;
pub use vector::Vector;
