//! The visibility chain of a scene: `J_ij = A_i F_ij`, `w_i ∝ A_i`, `P_ij = F_ij`.

use super::{ChainError, ReversibleChain};
use crate::numeric::compensated_sum;
use crate::scene::Scene;

/// The visibility chain of a closed scene.
///
/// The weights are the row sums of the exchange areas, which for a closed scene are the areas
/// within the error bounds of the form factors.
///
/// # Errors
/// [`ChainError::OpenScene`] with the worst row if a row of form factors does not sum to one within
/// its error bounds; [`ChainError::Scene`] if a form factor is refused.
pub fn visibility_chain(scene: &Scene) -> Result<ReversibleChain, ChainError> {
    let exchange = scene.exchange_areas()?;
    let mut worst: Option<(f64, ChainError)> = None;
    for (row, patch) in scene.patches().iter().enumerate() {
        let area = patch.shape().area();
        let sum = compensated_sum(exchange.values().column(row).iter().copied()) / area;
        let bound = compensated_sum(exchange.error_bounds().column(row).iter().copied()) / area;
        let tolerance = bound + 4.0 * f64::EPSILON; // the area's and the quotient's rounding
        let excess = (sum - 1.0).abs() / tolerance;
        if excess > 1.0 && worst.as_ref().is_none_or(|(most, _)| excess > *most) {
            worst = Some((
                excess,
                ChainError::OpenScene {
                    row,
                    sum,
                    tolerance,
                },
            ));
        }
    }
    match worst {
        Some((_, open)) => Err(open),
        None => ReversibleChain::try_new(exchange.into_values()),
    }
}
