//! Flat pieces of surface and how they lie to each other.
//!
//! A [`Patch`] is a planar simple polygon; a [`Rectangle`] is recognised from one, cut into
//! parts, and placed beside another by [`Placement`]; on one axis [`Span`]s lie to each other by
//! [`Offsets`]. What lies between two patches is their [`Shaft`]; [`side_of_plane`] is exact. Lengths are in any one unit.
//!
//! **Not here**: anything radiometric.

mod aligned_rectangle;
mod centroid;
mod convex_pieces;
mod cut_lines;
mod error;
mod offsets;
mod patch;
mod placement;
mod quarters;
mod rectangle;
mod shaft;
mod side;
mod span;
mod triangulation;
mod uniform_line;
mod vector;

pub use aligned_rectangle::AlignedRectangle;
pub use centroid::centroid;
pub use cut_lines::CutLines;
pub use error::GeometryError;
pub use offsets::Offsets;
pub use patch::Patch;
pub use placement::{Extent, Placement};
pub use quarters::quartered;
pub use rectangle::{Rectangle, SplitAxis};
pub use shaft::{Outline, Plane, Shaft};
pub use side::{Side, side_of_plane};
pub use span::Span;
pub use triangulation::triangulated;
pub(crate) use uniform_line::line_through_sphere;
pub use vector::Vector;
