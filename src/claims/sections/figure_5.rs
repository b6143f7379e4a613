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
//! Nothing is fitted: for N = 200,000, a round number, all three printed values lie one standard
//! deviation of a run below the expected ones, as they would if all three grids were given the same
//! lines. Which N gives a printed value on average is told by the study of figure 5; one run has a
//! standard deviation of which the rounding of the print is a hundredth, so that it says N to some
//! 6 %.
//!
//! **Not covered**: a proof. The paper says neither cells, nor lines, nor how its values were
//! computed.

use crate::claims::finding::Finding;
use crate::claims::{Case, ClaimError};
use crate::discretize::{BoxGrid, UNIT_CUBE};
use crate::numeric::{Interval, Scalar};

/// The reading of a grid with the number of lines that the claim's data name, in words.
pub(crate) fn reading(case: &Case<'_>, lines: &[f64]) -> Result<String, ClaimError> {
    let samples = u64::from(case.count("lines")?);
    let printed = case.number("as_printed")?;
    let grid = BoxGrid::try_new(UNIT_CUBE, lines)?;
    let expected = grid.information()?.mutual_information.value + grid.expected_bias(samples)?;
    let deviation = grid.expected_deviation(samples)?;
    Ok(format!(
        "read as a plug-in estimate from {samples} random lines, a round number and no fit, this \
         grid has {expected:.4} ± {deviation:.4}, and the printed value lies {:.1} standard \
         deviations below: an explanation, not a proof",
        (expected - printed) / deviation
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
