//! Entropies, mutual information, and the gain of a refinement, in bits.
//!
//! Equations (1)–(7) of the paper. Information is never a difference of two large
//! numbers here: mutual information and its gain are sums of non-negative terms.
//!
//! | question | call |
//! |---|---|
//! | information of a chain | [`mutual_information`], [`entropy_rate`], [`positional_entropy`] |
//! | of a scene, with an error | [`scene_information`] |
//! | of a scene under a brightness | [`brightness_information`] |
//! | of a scene, in the continuous limit | [`continuous_information`], [`pair_losses()`] |
//! | gain of a refinement | [`refinement_gain`] |
//! | estimates from random lines | [`LineSample`], [`PairCounts`], [`chord_information`] |
//! | their expected bias | [`expected_bias`], [`scene_information_and_bias`] |

mod brightness;
mod chain;
mod continuous;
mod gain;
mod pair_losses;
mod resolution;
mod sampled;
mod scene;

pub use brightness::brightness_information;
pub(crate) use chain::{divergence_error, pair_divergence};
pub use chain::{entropy_rate, mutual_information, positional_entropy};
pub use continuous::{ContinuousInformation, FacePair, continuous_information};
pub use gain::{divergence, refinement_gain, relative_entropy, subdivision_bound};
pub use pair_losses::{PairLoss, pair_losses};
pub use resolution::InformationResolution;
pub use sampled::chords::ChordInformation;
pub use sampled::expected_bias::{
    expected_bias, expected_bias_of_scene, expected_deviation, scene_information_and_bias,
};
pub use sampled::line_sample::{LineKind, LineSample, chord_information};
pub use sampled::pair_counts::PairCounts;
pub use scene::{OpenScene, SceneInformation, scene_information};
