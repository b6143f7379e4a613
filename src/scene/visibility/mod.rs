//! Visibility: surfaces that may stand between two patches, and the first surface that a line
//! meets.
//!
//! Form factors are computed as if nothing were in the way. A scene in which something may stand
//! between two patches is therefore refused, with the pair and the obstacle named, unless
//! unoccluded values are asked for: [`Occlusion`](crate::scene::Occlusion) is that policy, and
//! every constructor that evaluates pairs takes it or refuses. Overlapping patches are refused
//! always. What *is* computed with occlusion are estimates from random lines
//! ([`LineSample`](crate::information::LineSample)), in concave and furnished rooms, too.
//!
//! Open `occlusion` for the policy, `blockers` for the search behind it, `surfaces` for the planes
//! and trees of boxes that it needs, `lines` for random lines through any scene, and `grid_lines`
//! for the faster ones inside a gridded box.
//!
//! **Not covered**: the share of a pair that is hidden.

pub(crate) mod blockers;
pub(crate) mod grid_lines;
pub(crate) mod lines;
pub(crate) mod obstacle;
pub(crate) mod occlusion;
pub(crate) mod surfaces;
