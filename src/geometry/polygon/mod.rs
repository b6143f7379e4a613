//! Planar polygons: tests on outlines, and ways to cut them.
//!
//! `convexity` and `containment` test outlines, `centroid` measures one. `clip` cuts at a plane or
//! line, `cut_lines` into strips along parallel lines, `quarters` into parts of the same kind.
//! `triangulation` and `convex_pieces` divide concave polygons, both by way of `ears`; `outline`
//! and `weakly_simple` mend and divide outlines that are no polygons yet.

pub(crate) mod centroid;
pub(crate) mod clip;
pub(crate) mod containment;
pub(crate) mod convex_pieces;
pub(crate) mod convexity;
pub(crate) mod cut_lines;
pub(crate) mod ears;
pub(crate) mod outline;
pub(crate) mod quarters;
pub(crate) mod triangulation;
pub(crate) mod weakly_simple;
