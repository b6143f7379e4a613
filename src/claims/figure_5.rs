//! Fig. 5, read as sampled.
//!
//! No exact regular grid has the printed mutual information. A reading that explains all three printed values: 6 × 6 cells on every
//! face, and the plug-in estimate from N random lines with the areas known ([`PairCounts`](crate::information::PairCounts)),
//! which lies above the exact value by
//!
//! ```text
//!   E[Î] − I ≈ (K − 1)/(2N ln 2),      K = 19,440 pairs of cells that see each other
//! ```
//!
//! N is the one number that is fitted, to the printed value of the regular grid; the other two then follow, for the best grid without
//! another choice, for the third with lines that are guessed. One run has a standard deviation of which the rounding of the print is
//! a hundredth, so N is known to some 6 %.
//!
//! **Not covered**: a proof. The paper says neither cells, nor lines, nor how its values were computed.

use super::finding::Finding;
use super::{ClaimError, Inputs};
use crate::discretize::CubeGrid;
use crate::form_factor::DEFAULT_TOLERANCE;
use crate::information::{expected_bias, expected_deviation};
use crate::numeric::{Interval, Scalar, compensated_sum};
use crate::scene::{Congruence, Scene, ScenePairs};
use std::collections::BTreeMap;

/// A grid on the inside of a cube, of which lines at random tell.
#[derive(Debug, Clone)]
pub struct SampledGrid {
    scene: Scene,
    /// Probabilities of a pair of cells, and if they were independent; and how many have them.
    cells: Vec<([f64; 2], f64)>,
    mutual_information: f64,
}

/// The most lines that a fit looks at.
const MOST_SAMPLES: u64 = 1 << 50;

impl SampledGrid {
    /// The grid with these lines between 0 and 1 on all faces.
    ///
    /// # Errors
    /// [`ClaimError::Scene`] unless the lines increase.
    pub fn try_new(lines: &[f64]) -> Result<Self, ClaimError> {
        let scene = Scene::gridded_box([1.0; 3], lines)?;
        let pairs = ScenePairs::try_new(&scene, DEFAULT_TOLERANCE, Congruence::Shared)?;
        let (areas, exchange) = (pairs.areas(), pairs.exchange_areas()?);
        let total = compensated_sum(areas.iter().copied());
        // congruent cells have equal numbers
        let mut counts: BTreeMap<[u64; 2], f64> = BTreeMap::new();
        let mut values = exchange.values().iter();
        for j in 0..areas.len() {
            for (i, value) in (0..j).zip(&mut values) {
                let independent = areas[i] / total * (areas[j] / total);
                let both = [2.0 * value / total, 2.0 * independent].map(f64::to_bits);
                *counts.entry(both).or_default() += 1.0;
            }
        }
        let cells = counts.into_iter();
        let cells: Vec<([f64; 2], f64)> = cells
            .map(|(both, count)| (both.map(f64::from_bits), count))
            .filter(|([probability, _], _)| *probability > 0.0)
            .collect();
        let terms = cells
            .iter()
            .map(|([p, m], count)| count * p * (p / m).log2());
        Ok(Self {
            mutual_information: compensated_sum(terms),
            scene,
            cells,
        })
    }

    /// The regular grid.
    ///
    /// # Errors
    /// [`ClaimError::Scene`] for no cells.
    pub fn regular(cells: u32) -> Result<Self, ClaimError> {
        let line = |k: u32| f64::from(k) / f64::from(cells);
        Self::try_new(&(1..cells).map(line).collect::<Vec<_>>())
    }

    /// The scene.
    #[must_use]
    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The exact value, in bits.
    #[must_use]
    pub const fn mutual_information(&self) -> f64 {
        self.mutual_information
    }

    /// Pairs of cells that see each other.
    #[must_use]
    pub fn possible_pairs(&self) -> f64 {
        self.cells.iter().map(|(_, count)| count).sum()
    }

    /// The expected value of the plug-in estimate from so many lines, in bits.
    #[must_use]
    pub fn expected(&self, samples: u64) -> f64 {
        let cells = self.cells.iter().map(|([p, _], count)| (*p, *count));
        self.mutual_information + expected_bias(cells, samples)
    }

    /// The same if the weights are counted, too: every cell is an end of a binomial number of lines, whose bias is taken off.
    #[must_use]
    pub fn expected_with_counted_weights(&self, samples: u64) -> f64 {
        let total = self.scene.total_area();
        let areas = self
            .scene
            .patches()
            .iter()
            .map(|patch| patch.shape().area());
        self.expected(samples) - expected_bias(areas.map(|area| (2.0 * area / total, 1.0)), samples)
    }

    /// The standard deviation of one such estimate, in bits.
    #[must_use]
    pub fn deviation(&self, samples: u64) -> f64 {
        expected_deviation(&self.cells, samples)
    }

    /// The number of lines with which the estimate is this on average: the least with which it is no larger. `None` below the exact value,
    /// or for more than 10^15 lines.
    #[must_use]
    pub fn samples_for(&self, expected: f64) -> Option<u64> {
        let (mut low, mut high) = (0, 1);
        // the expected value falls with every line
        while self.expected(high) > expected {
            if high >= MOST_SAMPLES {
                return None;
            }
            (low, high) = (high, 2 * high);
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if self.expected(middle) > expected {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(high)
    }
}

/// What the fitted number of lines makes of a grid.
pub(super) fn reading(input: &Inputs, lines: &[f64]) -> Result<String, ClaimError> {
    let cells = input.count("cells")?;
    let printed = input.number("fitted_to")?;
    let regular = SampledGrid::regular(cells)?;
    let Some(samples) = regular.samples_for(printed) else {
        return Ok(format!("no number of lines gives a regular grid {printed}"));
    };
    let grid = SampledGrid::try_new(lines)?;
    #[allow(clippy::cast_precision_loss, reason = "exact up to 2^53 samples")]
    let thousands = samples as f64 / 1000.0;
    Ok(format!(
        "read as plug-in estimates from random lines, of which {thousands:.1} thousand give the regular grid {printed} on average (fitted), \
         this grid has {:.4} ± {:.4}: the best explanation found, not a proof",
        grid.expected(samples),
        grid.deviation(samples)
    ))
}

/// A grid with three lines to choose of five, mirrored.
pub(super) fn chosen_grid_information(input: &Inputs) -> Result<Finding, ClaimError> {
    let half = [input.interval("first")?, input.interval("second")?];
    let cells = input.count("cells")?;
    let grid = CubeGrid::mirrored(&half, cells, &half[0])?;
    let lines: Vec<f64> = grid.lines().iter().map(Interval::to_f64).collect();
    let note = format!(
        "neither cells nor lines are stated: lines at {lines:?} are a free choice; {}",
        reading(input, &lines)?
    );
    Ok(Finding::enclosed(grid.mutual_information()?).noting(note))
}
