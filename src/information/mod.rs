//! Entropies, mutual information, and what a refinement gains, in bits.
//!
//! Equations (1)–(7) of the paper. Information is never a difference of two large
//! numbers here: mutual information and its gain are sums of non-negative terms.
//! [`PairCounts`] estimates it from counted pairs, which [`LineSample`] draws from a scene; [`expected_bias`] says how far such
//! estimates lie above.

mod brightness;
mod chords;
mod continuous;
mod expected_bias;
mod gain;
mod line_sample;
mod measures;
mod pair_counts;
mod pair_losses;
mod scene;

pub use brightness::brightness_information;
pub use chords::{ChordInformation, chord_information};
pub use continuous::{ContinuousInformation, FacePair, continuous_information};
pub use expected_bias::{expected_bias, expected_bias_of_scene, expected_deviation};
pub use gain::{divergence, refinement_gain, relative_entropy, subdivision_bound};
pub use line_sample::{LineKind, LineSample};
pub(crate) use measures::pair_divergence;
pub use measures::{entropy_rate, mutual_information, positional_entropy};
pub use pair_counts::PairCounts;
pub use pair_losses::{PairLoss, pair_losses};
pub(crate) use scene::divergence_error;
pub use scene::{SceneInformation, Surroundings, scene_information};

/// From this x on `a φ(x) = p (ln(p/a) − 1) + a` is used, whose factors cannot overflow.
const FAR_ABOVE: f64 = 4.0;
