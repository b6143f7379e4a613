//! The contribution of each pair of patches to the discrete and to the continuous mutual
//! information, and the loss between the two.
//!
//! ```text
//!   I_ij = (J_ij/A_T) log2( J_ij A_T/(A_i A_j) )
//!   I^c_ij = (1/A_T) ∫∫ F log2(A_T F) dy dx ≥ I_ij
//! ```
//!
//! by Jensen's inequality. The loss `I^c_ij − I_ij` is the most that the pair can gain by
//! subdividing both patches, however finely; the losses of all pairs sum to `I^c − I`. So a row of
//! losses holds the value for a patch that eq. (6) only bounds for one subdivision.
//!
//! **Not covered**: rooms that are not convex inside.

use super::continuous::in_own_unit;
use crate::chain::ChainError;
use crate::exchange::{ExchangeError, Progress};
use crate::form_factor::LogMeans;
use crate::geometry::Patch;
use crate::numeric::functions::elementary::ln;
use crate::numeric::{Grade, compensated_sum, tolerance, try_parallel_map};
use crate::scene::{NamedPatch, Occlusion, Scene, SceneError};
use std::f64::consts::LN_2;

/// The contributions of a pair of patches, in both directions together; in bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairLoss {
    /// Index of one patch.
    pub first: usize,
    /// Index of the other, larger.
    pub second: usize,
    /// The probability of a transition between the two.
    pub probability: f64,
    /// The part of the pair in (3); may be negative.
    pub mutual_information: f64,
    /// The part of the pair in (4); may be negative.
    pub continuous_mutual_information: f64,
    /// The part in (4) less that in (3), ≥ 0 but for the error.
    pub loss: f64,
    /// The estimated absolute error of each of the three.
    pub error: f64,
}

impl PairLoss {
    /// The grade of the error.
    pub const GRADE: Grade = Grade::Estimate;
}

/// The losses of all pairs of patches that see each other, in a closed room that is convex inside.
///
/// **Arguments** `progress`: told as each pair is done.
/// **Returns** the pairs in order of their indices, the same for any number of threads.
///
/// # Errors
/// [`ChainError::Scene`] if the room is not convex inside, an obstruction stands in it, patches
/// overlap, or a patch lies in another or is summed with others; [`ChainError::Exchange`] if a pair
/// is refused.
///
/// # Examples
/// ```
/// use infoscene::information::pair_losses;
/// use infoscene::exchange::Unheard;
/// use infoscene::scene::Scene;
/// let losses = pair_losses(&Scene::built_in("cube:1")?, &Unheard)?;
/// // the contribution of two adjacent faces, from an independent evaluation to 26 digits
/// let there_and_back = 2.0 * 0.064_165_266_508_643_42;
/// assert!((losses[1].continuous_mutual_information - there_and_back).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pair_losses(scene: &Scene, progress: &dyn Progress) -> Result<Vec<PairLoss>, ChainError> {
    let (_, face_of) = scene.convex_room()?;
    Occlusion::Refuse.check(scene)?;
    let n = scene.patches().len();
    for index in 0..n {
        scene.whole_patch(index)?;
    }
    if let Some(index) = scene.first_summed() {
        let what = "is summed with others";
        return Err(SceneError::NotAPatchOfItsOwn { index, what }.into());
    }
    let given = scene.patches().iter().map(NamedPatch::shape);
    let shapes = in_own_unit(given).map_err(|(index, source)| scene.refused(index, source))?;
    let total = compensated_sum(shapes.iter().map(Patch::area));
    let pairs: Vec<[usize; 2]> = (0..n)
        .flat_map(|first| (first + 1..n).map(move |second| [first, second]))
        .collect();
    let losses = try_parallel_map(pairs.len(), &|pair| {
        let [first, second] = pairs[pair];
        let loss = if face_of[first] == face_of[second] {
            Ok(None)
        } else {
            of_pair(&shapes, [first, second], total)
        };
        progress.advance(1);
        loss
    })?;
    Ok(losses.into_iter().flatten().collect())
}

/// The loss of a pair of patches with this total area; `None` if they exchange nothing.
fn of_pair(
    shapes: &[Patch],
    [first, second]: [usize; 2],
    total: f64,
) -> Result<Option<PairLoss>, ExchangeError> {
    let [one, other] = [&shapes[first], &shapes[second]];
    let refused = |source| ExchangeError::Pair {
        first,
        second,
        source,
    };
    let logarithms = LogMeans::of(one, other).map_err(refused)?;
    let exchange = logarithms.exchange.value;
    if exchange <= 0.0 {
        return Ok(None);
    }
    let ratio = ln(exchange / one.area() / other.area() * total);
    let scale = 2.0 / (total * LN_2);
    let kernel = logarithms.kernel(total);
    let [discrete, continuous] = [exchange * ratio, kernel.value].map(|part| scale * part);
    let rounding = tolerance::INFORMATION * scale * exchange * (1.0 + ratio.abs());
    let from_exchange = scale * logarithms.exchange.error * (1.0 + ratio.abs());
    Ok(Some(PairLoss {
        first,
        second,
        probability: 2.0 * exchange / total,
        mutual_information: discrete,
        continuous_mutual_information: continuous,
        loss: continuous - discrete,
        error: scale * kernel.error + from_exchange + rounding,
    }))
}
