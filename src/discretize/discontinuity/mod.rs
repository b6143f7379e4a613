//! Lines of discontinuity of a patch, and the cuts beside them (fig. 1, appendix B).
//!
//! A receiver sees a source past blockers. What a point x of it sees changes its form where x
//! crosses a plane through a vertex and an edge, one of a blocker and one of the source or of
//! another blocker, that are seen in one; where x crosses the plane of a blocker that hides
//! something, or of the source; and where a blocker stands on the receiver.
//!
//! | question | answer |
//! |---|---|
//! | the lines of a receiver, the views beside them, what makes them | [`OccludedPair::lines`] |
//! | the cut along a line, and the best cuts | [`PatchSplit`](crate::discretize::PatchSplit) |
//! | a penumbra in closed form | [`HalfPlaneShadow`] |
//! | the two measures of a cut | [`CutMeasure`](crate::discretize::CutMeasure) |
//!
//! | step | file |
//! |---|---|
//! | lines of sight through a vertex and an edge, where nothing hides them | `sights` |
//! | blockers seen edge-on, and standing on the receiver | `traces` |
//! | points at which blockers leave no way past | `contact` |
//! | a plane with coordinates, ranges of its line, its makers | `section`, `ranges`, `candidate` |
//! | all together, with what is seen beside | `lines` |
//!
//! **Not covered**: curves. Two blockers and more have conics, too, on which three edges are seen
//! concurrent ([`OccludedPair::may_have_curves`]). Along a line of two parallel edges the places
//! count from which an end of one is seen in line with the other; where all ends are hidden and
//! only inner points are seen, the line is left out. Time grows with the cube of the number of
//! blockers.
//!
//! Reference: Lischinski, Tampieri and Greenberg, "Discontinuity meshing for accurate radiosity",
//! *IEEE Computer Graphics and Applications* 12 (1992), 25–39.

mod candidate;
mod contact;
pub(crate) mod half_plane;
pub(crate) mod lines;
pub(crate) mod pair;
mod ranges;
mod section;
mod sights;
mod traces;

pub use candidate::{Feature, Generator};
pub use half_plane::HalfPlaneShadow;
pub use lines::{DiscontinuityLine, LineKind, View};
pub use pair::OccludedPair;
