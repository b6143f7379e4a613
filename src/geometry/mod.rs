//! Flat pieces of surface and how they lie to each other.
//!
//! A [`Patch`] is a planar simple polygon; a [`Rectangle`] is recognised from one, cut into
//! parts, and placed beside another by [`Placement`]; on one axis [`Span`]s lie to each other by
//! [`Offsets`]. What lies between two patches is their [`Shaft`]. Lengths are in any one unit.
//!
//! **Not here**: anything radiometric.

mod aligned_rectangle;
mod centroid;
mod clip;
mod containment;
mod convex_pieces;
mod convexity;
mod cut_lines;
mod ears;
mod error;
mod local_line;
mod offsets;
mod patch;
mod placement;
mod quarters;
mod rectangle;
mod shaft;
mod span;
mod triangulation;
mod uniform_line;
mod vector;

pub use aligned_rectangle::{AlignedRectangle, FlatBox};
pub use centroid::centroid;
pub(crate) use clip::{ClippedCorner, clip, clipped};
pub(crate) use containment::{NotContained, check_contained, distance_from_plane};
pub use convexity::convex_hull;
pub(crate) use convexity::is_convex;
pub use cut_lines::CutLines;
pub(crate) use ears::EarClipper;
pub use error::GeometryError;
pub(crate) use local_line::{Facet, LocalLine, Slope};
pub use offsets::Offsets;
pub use patch::Patch;
pub use placement::{Extent, Placement};
pub use quarters::quartered;
pub use rectangle::{Rectangle, SplitAxis};
pub use shaft::{Outline, Plane, Shaft};
pub use span::Span;
pub use triangulation::triangulated;
pub(crate) use uniform_line::line_through_sphere;
pub use vector::Vector;
