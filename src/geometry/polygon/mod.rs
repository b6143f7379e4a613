//! Planar polygons: clipping, triangles, convex pieces, quarters and cuts.

pub(crate) mod centroid;
pub(crate) mod clip;
pub(crate) mod containment;
pub(crate) mod convex_pieces;
pub(crate) mod convexity;
pub(crate) mod cut_lines;
pub(crate) mod ears;
pub(crate) mod quarters;
pub(crate) mod triangulation;
