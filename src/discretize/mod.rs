//! The discretizations that mutual information prefers.
//!
//! | question | answer |
//! |---|---|
//! | the best cut of a patch (§4.1, figs. 2, 3) | [`PatchSplit`]; enclosed: [`RectangleSplit`] |
//! | the cut of a partly dark patch (fig. 1, appendix B) | [`ContactShadow`] |
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

mod best_grid;
mod box_grid;
mod cell_classes;
mod cell_pair;
mod certified_grid;
mod contact_shadow;
mod cut_comparison;
mod cut_pair;
mod cut_search;
mod division;
mod error;
mod gradient_cut;
mod gradient_limit;
mod grid_axis;
mod grid_derivatives;
mod grid_sample;
mod part_exchange;
mod patch_split;
mod profile;
mod profile_cut;
mod rectangle_split;
mod stationarity;
mod straight_cut;

pub use best_grid::{BestGrid, Search};
pub use box_grid::{BoxGrid, GridInformation, LARGEST_ASPECT, MOST_CELLS, UNIT_CUBE};
pub use certified_grid::CertifiedGrid;
pub use contact_shadow::ContactShadow;
pub use cut_comparison::CutComparison;
pub use division::regular_positions;
pub use error::DiscretizeError;
pub use gradient_cut::{CertifiedCut, Cut, GradientCut};
pub use gradient_limit::{GradientLimit, LimitingCut};
pub use grid_axis::Spacing;
pub use patch_split::{PatchSplit, SplitOptimum};
pub use profile::Profile;
pub use profile_cut::{Irradiance, JudgedCut, ProfileCut};
pub use rectangle_split::RectangleSplit;
pub use straight_cut::{BestStraightCut, StraightCut};
