//! The discretizations that mutual information prefers.
//!
//! | question | answer |
//! |---|---|
//! | the best cut of a patch (§4.1, figs. 2, 3) | [`PatchSplit`]; enclosed: [`RectangleSplit`] |
//! | the cut of a partly dark patch (fig. 1, appendix B) | [`ContactShadow`] |
//! | the same with a penumbra, in closed form | [`HalfPlaneShadow`] |
//! | lines of discontinuity of a patch | [`OccludedPair::lines`] |
//! | the best tensor grid on the inside of a box (figs. 4 and 5) | [`BestGrid`], [`BoxGrid`] |
//! | the cut across a radiosity gradient (§4.2), against the mean square | [`GradientCut`] |
//! | its limit as the gradient grows | [`GradientLimit`] |
//! | the same in any direction | [`StraightCut`] |
//! | the same for radiosities that are no powers | [`ProfileCut`] |
//!
//! An optimum is the root of a derivative that is written in closed form. For a cut at t with flux
//! G(t) and weight W(t), and the ratios a, b of flux to weight on its two sides,
//!
//! ```text
//!   d/dt Σ_k G_k ln(G_k/W_k) = G′ ln(a/b) − W′ (a − b)
//! ```
//!
//! so that the best cut is where `G′/W′` is the logarithmic mean of a and b.

mod contact_shadow;
mod discontinuity;
mod division;
mod error;
mod gradient;
mod grid;
mod measure;
mod patch;
mod stationarity;

pub use contact_shadow::ContactShadow;
pub use discontinuity::{
    DiscontinuityLine, Feature, Generator, HalfPlaneShadow, LineKind, OccludedPair, View,
};
pub use division::regular_positions;
pub use error::DiscretizeError;
pub use gradient::comparison::CutComparison;
pub use gradient::cut::{CertifiedCut, Cut, GradientCut};
pub use gradient::limit::{GradientLimit, LimitingCut};
pub use gradient::profile::Profile;
pub use gradient::profile_cut::{Irradiance, JudgedCut, ProfileCut};
pub use gradient::straight::{BestStraightCut, StraightCut};
pub use grid::axis::Spacing;
pub use grid::best::{BestGrid, Search};
pub use grid::certified::{CertifiedGrid, ThreeCells};
pub use grid::{BoxGrid, GridInformation, LARGEST_ASPECT, MOST_CELLS, UNIT_CUBE};
pub use measure::CutMeasure;
pub use patch::rectangles::RectangleSplit;
pub use patch::split::{PatchSplit, SplitOptimum};
