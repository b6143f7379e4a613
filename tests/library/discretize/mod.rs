//! Best cuts and best grids.

mod agreement;
mod cuts;
mod discontinuities;
mod enclosures;
mod gradient_cuts;
mod gradient_limits;
mod grid;
mod half_planes;
mod occluded_cuts;
mod polygon_cuts;
mod polygon_splits;
mod profile_cuts;
mod rectangle_splits;
mod straight_cuts;
