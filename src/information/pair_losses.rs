//! What each pair of patches contributes to the discrete and to the continuous mutual information, and what lies between.
//!
//! ```text
//!   I_ij = (J_ij/A_T) log2( J_ij A_T/(A_i A_j) ),     I^c_ij = (1/A_T) ∫∫ F log2(A_T F) dy dx ≥ I_ij
//! ```
//!
//! by Jensen's inequality. The loss `I^c_ij − I_ij` is the most that the pair can gain by subdividing both patches, however finely;
//! the losses of all pairs sum to `I^c − I`. So a row of losses says of a patch what eq. (6) only bounds for one subdivision.
//!
//! **Not covered**: rooms that are not convex inside.

use super::continuous::in_own_unit;
use crate::chain::ChainError;
use crate::form_factor::Logarithms;
use crate::geometry::Patch;
use crate::numeric::{Grade, compensated_sum, tolerance};
use crate::scene::{NamedPatch, Scene, SceneError};
use rayon::prelude::*;
use std::f64::consts::LN_2;

/// What a pair of patches contributes, in both directions together; in bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairLoss {
    /// Index of one patch.
    pub first: usize,
    /// Index of the other, larger.
    pub second: usize,
    /// The part of all transitions that go between the two.
    pub probability: f64,
    /// Its part of (3); may be negative.
    pub mutual_information: f64,
    /// Its part of (4); may be negative.
    pub continuous_mutual_information: f64,
    /// What (3) lacks of (4), ≥ 0 but for the error.
    pub loss: f64,
    /// Estimated absolute error of each of the three.
    pub error: f64,
}

impl PairLoss {
    /// What the error is.
    pub const ERROR_GRADE: Grade = Grade::Estimate;
}

/// The losses of all pairs of patches that see each other, in a closed room that is convex inside.
///
/// **Arguments** `done`: told as each pair is done, from any thread.
/// **Returns** the pairs in order of their indices, the same for any number of threads.
///
/// # Errors
/// [`ChainError::Scene`] if the room is not convex inside, a patch lies in another or is summed with others, or a pair is refused.
///
/// # Examples
/// ```
/// use infoscene::{information::pair_losses, scene::Scene};
/// let losses = pair_losses(&Scene::built_in("cube:1")?, || ())?;
/// // the contribution of two adjacent faces, there and back, from an independent evaluation to 26 digits
/// assert!((losses[1].continuous_mutual_information - 2.0 * 0.064_165_266_508_643_42).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pair_losses(scene: &Scene, done: impl Fn() + Sync) -> Result<Vec<PairLoss>, ChainError> {
    let (_, face_of) = scene.convex_room()?;
    let n = scene.patches().len();
    for index in 0..n {
        scene.whole_patch(index)?;
        if scene.group_of(index) != index {
            let what = "is summed with others";
            return Err(SceneError::NotAPatchOfItsOwn { index, what }.into());
        }
    }
    let shapes = scene.patches().iter().map(NamedPatch::shape);
    let shapes = in_own_unit(shapes).map_err(|(index, source)| scene.refused(index, source))?;
    let total = compensated_sum(shapes.iter().map(Patch::area));
    let first_with_all = |first: usize| {
        (first + 1..n)
            .into_par_iter()
            .map(move |second| [first, second])
    };
    let losses = (0..n)
        .into_par_iter()
        .flat_map(first_with_all)
        .map(|[first, second]| {
            let loss = if face_of[first] == face_of[second] {
                Ok(None)
            } else {
                of_pair(&shapes, [first, second], total)
            };
            done();
            loss
        });
    let losses: Vec<Option<PairLoss>> = losses.collect::<Result<_, _>>()?;
    Ok(losses.into_iter().flatten().collect())
}

fn of_pair(
    shapes: &[Patch],
    [first, second]: [usize; 2],
    total: f64,
) -> Result<Option<PairLoss>, SceneError> {
    let [one, other] = [&shapes[first], &shapes[second]];
    let refused = |source| SceneError::Pair {
        first,
        second,
        source,
    };
    let logarithms = Logarithms::of(one, other).map_err(refused)?;
    let exchange = logarithms.exchange.value;
    if exchange <= 0.0 {
        return Ok(None);
    }
    let ratio = (exchange / one.area() / other.area() * total).ln();
    let scale = 2.0 / (total * LN_2);
    let [discrete, continuous] =
        [exchange * ratio, logarithms.kernel(total)].map(|part| scale * part);
    let rounding = tolerance::INFORMATION * scale * exchange * (1.0 + ratio.abs());
    let from_exchange = scale * logarithms.exchange.error_bound * (1.0 + ratio.abs());
    Ok(Some(PairLoss {
        first,
        second,
        probability: 2.0 * exchange / total,
        mutual_information: discrete,
        continuous_mutual_information: continuous,
        loss: continuous - discrete,
        error: scale * logarithms.error_estimate + from_exchange + rounding,
    }))
}
