//! Where to cut: the discretization that mutual information prefers.
//!
//! [`PatchSplit`] is the best cut of a patch (§4.1, figs. 2 and 3), [`ContactShadow`] the cut of a
//! partly dark one (fig. 1, appendix B), [`BoxGrid`] a tensor grid on the inside of a box
//! (figs. 4 and 5), [`GradientCut`] the cut across a radiosity gradient, by mutual information and
//! by mean square (§4.2): [`GradientLimit`] is where it goes as the gradient grows, [`StraightCut`] leaves the direction
//! open, [`ProfileCut`] is the same for radiosities that are no powers.
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
mod error;
mod gradient_cut;
mod gradient_limit;
mod grid_axis;
mod grid_derivatives;
mod grid_sample;
mod patch_split;
mod profile;
mod profile_cut;
mod straight_cut;

use crate::numeric::Scalar;

pub use best_grid::{BestGrid, Search};
pub use box_grid::{BoxGrid, GridInformation, LARGEST_ASPECT, MOST_CELLS, UNIT_CUBE};
pub use certified_grid::CertifiedGrid;
pub use contact_shadow::ContactShadow;
pub use cut_comparison::CutComparison;
pub use error::DiscretizeError;
pub use gradient_cut::{CertifiedCut, Cut, GradientCut};
pub use gradient_limit::{GradientLimit, LimitingCut};
pub use grid_axis::Spacing;
pub use patch_split::{PatchSplit, SplitOptimum, regular_positions};
pub use profile::Profile;
pub use profile_cut::{Irradiance, JudgedCut, ProfileCut};
pub use straight_cut::{BestStraightCut, StraightCut};

/// `G′ ln(a/b) − W′ (a − b)`, the derivative of the gain in nats as a cut moves.
///
/// With `G′ = 0` the logarithm does not count, even where a or b is 0.
fn stationarity<S: Scalar>(flux_rate: &S, weight_rate: &S, before: &S, after: &S) -> S {
    let difference = before.clone() - after;
    let logarithm = if flux_rate.is_zero() {
        flux_rate.clone()
    } else if difference.abs() < after.clone() * &after.constant(0.5) {
        (difference.clone() / after).ln_1p()
    } else {
        (before.clone() / after).ln()
    };
    logarithm * flux_rate - &(difference * weight_rate)
}
