//! Fig. 5, read as sampled.
//!
//! No exact regular grid has the printed mutual information. A reading that explains all three
//! printed values: 6 × 6 cells on every face, and the plug-in estimate from N random lines with the
//! areas known ([`PairCounts`](crate::information::PairCounts)), which lies above the exact value
//! by
//!
//! ```text
//!   E[Î] − I ≈ (K − 1)/(2N ln 2),      K = 19,440 pairs of cells that see each other
//! ```
//!
//! N is the one number that is fitted, to the printed value of the regular grid; the other two then
//! follow, for the best grid without another choice, for the third with lines that are guessed. One
//! run has a standard deviation of which the rounding of the print is a hundredth, so N is known to
//! some 6 %.
//!
//! **Not covered**: a proof. The paper says neither cells, nor lines, nor how its values were
//! computed.

use crate::claims::finding::Finding;
use crate::claims::{Case, ClaimError};
use crate::discretize::{BoxGrid, DiscretizeError, UNIT_CUBE};
use crate::numeric::{Interval, Scalar};

/// The most lines that a fit considers.
const MOST_SAMPLES: u64 = 1 << 50;

/// The number of lines with which the plug-in estimate of a grid is this on average: the least with
/// which it is no larger. `None` below the exact value, or for more than 10^15 lines.
///
/// # Errors
/// [`DiscretizeError::FormFactor`] if a pair is refused.
pub fn samples_for(grid: &BoxGrid, expected: f64) -> Result<Option<u64>, DiscretizeError> {
    let wanted = expected - grid.information()?.mutual_information.value;
    let (mut low, mut high) = (0, 1);
    // the bias falls with every line
    while grid.expected_bias(high)? > wanted {
        if high >= MOST_SAMPLES {
            return Ok(None);
        }
        (low, high) = (high, 2 * high);
    }
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if grid.expected_bias(middle)? > wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(Some(high))
}

/// The reading of a grid with the fitted number of lines, in words.
pub(crate) fn reading(case: &Case<'_>, lines: &[f64]) -> Result<String, ClaimError> {
    let printed = case.number("fitted_to")?;
    let regular = BoxGrid::regular(UNIT_CUBE, case.count("cells")?)?;
    let Some(samples) = samples_for(&regular, printed)? else {
        return Ok(format!("no number of lines gives a regular grid {printed}"));
    };
    let grid = BoxGrid::try_new(UNIT_CUBE, lines)?;
    #[allow(clippy::cast_precision_loss, reason = "exact up to 2^53 samples")]
    let thousands = samples as f64 / 1000.0;
    Ok(format!(
        "read as plug-in estimates from random lines, of which {thousands:.1} thousand give the \
         regular grid {printed} on average (fitted), this grid has {:.4} ± {:.4}: \
         the best explanation found, not a proof",
        grid.information()?.mutual_information.value + grid.expected_bias(samples)?,
        grid.expected_deviation(samples)?
    ))
}

/// A grid with three lines to choose of five, mirrored.
pub(crate) fn chosen_grid_information(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let half = [case.interval("first")?, case.interval("second")?];
    let cells = case.count("cells")?;
    let grid = BoxGrid::mirrored(UNIT_CUBE, &half, cells, &half[0])?;
    let lines: Vec<f64> = grid.lines().iter().map(Interval::to_f64).collect();
    let note = format!(
        "neither cells nor lines are stated: lines at {lines:?} are a free choice; {}",
        reading(case, &lines)?
    );
    Ok(Finding::enclosed(grid.mutual_information()?).noting(note))
}
