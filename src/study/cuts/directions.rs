//! Gains of straight cuts in any direction across a square whose radiosity grows along one axis
//! (§4.2).

use crate::discretize::{BestStraightCut, DiscretizeError, GradientCut, StraightCut};
use std::time::Instant;

/// The best cut at one angle.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionRow {
    /// The patch.
    pub patch: GradientCut,
    /// The best of the parallel cuts at this angle.
    pub best: BestStraightCut,
    /// The gain of that cut as a share of the gain of the best cut across the gradient.
    pub share: f64,
    /// Time of the search, in seconds.
    pub seconds: f64,
}

/// Exponents of radiosity and irradiance: as printed, and under the section's hypotheses.
const EXPONENTS: [[f64; 2]; 5] = [[1.0, 1.0], [2.0, 1.0], [4.0, 1.0], [2.0, 2.0], [4.0, 4.0]];

/// Every five degrees from across the gradient to along it, for five patches.
///
/// # Errors
/// [`DiscretizeError::Numeric`] if a cut is not found.
pub fn directions() -> Result<Vec<DirectionRow>, DiscretizeError> {
    let mut rows = Vec::new();
    for [exponent, irradiance_exponent] in EXPONENTS {
        let patch = GradientCut::try_new(exponent, irradiance_exponent)?;
        let across = patch.mutual_information_cut()?.value;
        for step in 0..=18 {
            let start = Instant::now();
            let best = StraightCut::best(5.0 * f64::from(step), &patch)?;
            let seconds = start.elapsed().as_secs_f64();
            let share = best.gain / across;
            rows.push(DirectionRow {
                patch,
                best,
                share,
                seconds,
            });
        }
    }
    Ok(rows)
}
