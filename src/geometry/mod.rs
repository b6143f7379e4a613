//! Flat pieces of surface and their positions relative to each other.
//!
//! A [`Patch`] is a planar simple polygon; a [`Rectangle`] is recognised from one, cut into
//! parts, and placed beside another; its sides along one axis are [`Span`]s. The solid between two
//! patches is their [`Shaft`]. Lengths are in any one unit.
//!
//! **Not here**: anything radiometric.

mod error;
mod local_line;
mod part;
mod patch;
mod plane;
mod points;
mod polygon;
mod rectangle;
mod shaft;
mod uniform_line;
mod vector;

pub use error::GeometryError;
pub(crate) use local_line::{Facet, LocalLine, Slope};
pub(crate) use part::check_part;
pub use patch::Patch;
pub use plane::Plane;
pub(crate) use points::{bounds, mean};
pub use polygon::centroid::centroid;
pub(crate) use polygon::clip::{ClippedCorner, clip, clipped};
pub(crate) use polygon::containment::{
    NotContained, check_contained, distance_from_patch, distance_from_plane, is_inside,
};
pub(crate) use polygon::convex_pieces::convex_pieces;
pub(crate) use polygon::convexity::is_convex;
// hidden here and below: what a test judges by itself, not an interface
#[doc(hidden)]
pub use polygon::cut_lines::CutLines;
pub(crate) use polygon::outline::{CleanOutline, is_on_one_line};
pub use polygon::quarters::quartered;
pub(crate) use polygon::triangulation::{triangles_of, triangulated};
pub(crate) use polygon::weakly_simple::{FlatOutline, united};
#[doc(hidden)]
pub use rectangle::aligned::{AlignedRectangle, FlatBox};
pub(crate) use rectangle::offsets::Offsets;
pub(crate) use rectangle::placement::{Extent, Placement};
pub use rectangle::span::Span;
pub use rectangle::{Rectangle, SplitAxis};
#[doc(hidden)]
pub(crate) use shaft::are_apart;
pub use shaft::{Outline, Shaft};
pub(crate) use uniform_line::line_through_sphere;
pub(crate) use vector::Vector;
