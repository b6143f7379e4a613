//! Visibility: surfaces that may stand between two patches, and the first surface that a line
//! meets.
//!
//! [`Occlusion`](crate::scene::Occlusion) is the policy for scenes in which something stands
//! between two patches: pairs are evaluated past what does, unless that is refused or left out.
//! Overlapping patches are refused always.
//!
//! Open `occlusion` for the policy, `blockers` for the surfaces in the way of a pair, `screens` for
//! what these hide in few polygons and `screening` for the few of them that a pair takes, `hiding`
//! for pairs of which convex bodies (`bodies`) leave nothing, `surfaces` for the planes and trees
//! of boxes that these need, `lines` for random lines through any scene, and `grid_lines` for the
//! faster ones inside a gridded box.
//!
//! **Not covered**: the share of a pair that is hidden
//! ([`Polygon::exchange_area_past`](crate::form_factor::Polygon::exchange_area_past)).

pub(crate) mod blockers;
mod bodies;
mod boxes;
pub(crate) mod grid_lines;
mod hiding;
pub(crate) mod lines;
pub(crate) mod obstacle;
pub(crate) mod occlusion;
pub(crate) mod screening;
pub(crate) mod screens;
pub(crate) mod surfaces;
