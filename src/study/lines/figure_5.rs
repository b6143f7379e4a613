//! Fig. 5 read as plug-in estimates from 200,000 random lines, a round number: three printed
//! values, nothing fitted.
//!
//! [`BoxGrid`] gives the expected values; each grid is also sampled, all with the same lines, so
//! that the differences between grids are known better than the values. Lines start from points of
//! the faces; in a cube the chords of global lines are the same.

use crate::claims::{ClaimError, Printed, registry};
use crate::discretize::{BestGrid, BoxGrid, DiscretizeError, UNIT_CUBE};
use crate::information::expected_bias;
use crate::numeric::{compensated_sum, real};
use crate::scene::GridLines;
use crate::study::StudyError;

/// One grid.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Figure5Row {
    /// The grid in words.
    pub case: &'static str,
    /// The lines of the grid, in units of the edge.
    pub lines: Vec<f64>,
    /// The printed value, in bits.
    pub printed: Option<f64>,
    /// The exact value, in bits.
    pub mutual_information: f64,
    /// Lines N at which the plug-in estimate has the printed value on average, and for half a unit
    /// of its last decimal more and less; none where the printed value is below the exact one.
    pub samples_for_printed: Option<[u64; 3]>,
    /// The N taken: 200,000.
    pub samples: u64,
    /// The expected value of the plug-in estimate from N lines with known weights, in bits.
    pub expected: f64,
    /// The expected value with counted weights.
    pub expected_with_counted_weights: f64,
    /// The standard deviation of one estimate, by formula.
    pub deviation: f64,
    /// Runs, all of N lines.
    pub runs: u64,
    /// The mean over the runs, in bits.
    pub sampled: f64,
    /// The standard deviation of one run.
    pub sampled_deviation: f64,
    /// The mean over the runs of what the grid has over the regular one with the same lines.
    pub difference: f64,
    /// The standard deviation of this in one run.
    pub difference_deviation: f64,
    /// The difference as printed.
    pub printed_difference: Option<f64>,
}

/// Cells a side.
const CELLS: u32 = 6;

/// Lines of one estimate: a round number near those at which the printed values are expected.
pub(crate) const SAMPLES: u64 = 200_000;

/// Runs, all with the same number of lines: enough for a tenth of the deviation of one.
const RUNS: u64 = 160;

/// The regular grid, the best one, one with lines at a quarter, and one a little off the best.
///
/// **Arguments** `quick`: two runs in place of 160.
///
/// # Errors
/// [`StudyError`] if a grid is refused; none is known to be.
pub fn figure_5(quick: bool) -> Result<Vec<Figure5Row>, StudyError> {
    let regular = BoxGrid::regular(UNIT_CUBE, CELLS)?;
    let of_regular = printed("fig5-regular")?;
    let runs = if quick { 2 } else { RUNS };
    let of_lines = |lines: &[f64]| BoxGrid::try_new(UNIT_CUBE, lines);
    let best = BestGrid::find(UNIT_CUBE, CELLS)?.grid;
    let grids = [
        ("regular", regular, Some(of_regular.clone())),
        ("best", best, Some(printed("fig5-optimal")?)),
        (
            "lines at a quarter",
            of_lines(&[0.25, 0.375, 0.5, 0.625, 0.75])?,
            Some(printed("fig5-bad")?),
        ),
        (
            "first line at a tenth",
            of_lines(&[0.1, 0.3, 0.5, 0.7, 0.9])?,
            None,
        ),
    ];
    let sample = Sample {
        samples: SAMPLES,
        runs,
    };
    let mut reference: Option<Vec<f64>> = None;
    let mut rows = Vec::new();
    for (case, grid, printed) in grids {
        let estimates = sample.estimates(&grid)?;
        let reference = reference.get_or_insert_with(|| estimates.clone());
        let mut row = sample.row(case, &grid, &estimates, reference)?;
        if let Some(printed) = printed {
            row.samples_for_printed = samples_for_printed(&grid, &printed)?;
            row.printed = Some(printed.value);
            row.printed_difference = Some(printed.value - of_regular.value);
        }
        rows.push(row);
    }
    Ok(rows)
}

/// The size of the samples, the same for all grids.
struct Sample {
    samples: u64,
    runs: u64,
}

impl Sample {
    /// The plug-in estimates of a grid, one for each run; lines of one seed are the same for all
    /// grids.
    fn estimates(&self, grid: &BoxGrid) -> Result<Vec<f64>, StudyError> {
        let lines = u32::try_from(self.samples).unwrap_or(u32::MAX);
        let estimate = |seed| Ok(grid.sample(lines, seed)?.counts.plug_in());
        (1..=self.runs).map(estimate).collect()
    }

    /// The row of a grid, without a printed value.
    fn row(
        &self,
        case: &'static str,
        grid: &BoxGrid,
        estimates: &[f64],
        reference: &[f64],
    ) -> Result<Figure5Row, StudyError> {
        let differences: Vec<f64> = estimates
            .iter()
            .zip(reference)
            .map(|(one, other)| one - other)
            .collect();
        let [sampled, sampled_deviation] = mean_and_deviation(estimates);
        let [difference, difference_deviation] = mean_and_deviation(&differences);
        let mutual_information = grid.information()?.mutual_information.value;
        let expected = mutual_information + grid.expected_bias(self.samples)?;
        let of_weights = bias_of_weights(grid, self.samples)?;
        Ok(Figure5Row {
            case,
            lines: grid.lines().to_vec(),
            printed: None,
            mutual_information,
            samples_for_printed: None,
            samples: self.samples,
            expected,
            expected_with_counted_weights: expected - of_weights,
            deviation: grid.expected_deviation(self.samples)?,
            runs: self.runs,
            sampled,
            sampled_deviation,
            difference,
            difference_deviation,
            printed_difference: None,
        })
    }
}

/// Lines at which a grid's estimate is the printed value on average, and its ends.
fn samples_for_printed(grid: &BoxGrid, printed: &Printed) -> Result<Option<[u64; 3]>, StudyError> {
    let (low, high) = printed.interval();
    let of = |value: f64| samples_for(grid, value);
    let [at, from, to] = [of(printed.value)?, of(high)?, of(low)?];
    Ok(at.zip(from.zip(to)).map(|(at, (from, to))| [at, from, to]))
}

/// The number that a claim is about.
fn printed(id: &str) -> Result<Printed, ClaimError> {
    let claim = registry()?.into_iter().find(|claim| claim.id == id);
    let unknown = || ClaimError::UnknownClaim {
        id: id.to_owned(),
        nearest: None,
    };
    claim.and_then(|claim| claim.printed).ok_or_else(unknown)
}

/// The part of the bias that counted weights take off: each cell is an end of a binomial number of
/// lines.
fn bias_of_weights(grid: &BoxGrid, samples: u64) -> Result<f64, StudyError> {
    let areas = GridLines::try_new(UNIT_CUBE, grid.lines())?.areas();
    let total = compensated_sum(areas.iter().copied());
    let ends = areas.iter().map(|area| (2.0 * area / total, 1.0));
    Ok(expected_bias(ends, samples))
}

fn mean_and_deviation(values: &[f64]) -> [f64; 2] {
    let count = real(values.len());
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    [mean, (squares / (count - 1.0)).sqrt()]
}

/// The most lines that a fit considers.
const MOST_SAMPLES: u64 = 1 << 50;

/// The number of lines with which the plug-in estimate of a grid is this on average: the least with
/// which it is no larger. `None` below the exact value, or for more than 10^15 lines.
///
/// # Errors
/// [`DiscretizeError::FormFactor`] if a pair is refused.
fn samples_for(grid: &BoxGrid, expected: f64) -> Result<Option<u64>, DiscretizeError> {
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
