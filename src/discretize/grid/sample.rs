//! A grid on a box sampled by random lines, and the expected bias and deviation of that.
//!
//! The bias and the deviation of the plug-in estimate are sums over pairs of cells; congruent pairs
//! are taken once. A line finds its cells by bisection.
//!
//! **Not covered**: other ways to draw lines than from points of the faces; in a convex room global
//! lines have the same chords.

use super::BoxGrid;
use crate::discretize::error::DiscretizeError;
use crate::information::{LineSample, expected_bias, expected_deviation};
use crate::numeric::{compensated_sum, try_parallel_map};
use crate::scene::GridLines;

/// Error of an exchange area relative to itself plus that of independent cells: (a) a bias is known
/// to 1e-11 of itself, and no better from exact probabilities.
const PROBABILITY_ERROR: f64 = 1e-11;

impl BoxGrid {
    /// The expected bias of the plug-in estimate from so many lines, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a pair is refused.
    ///
    /// # Examples
    /// ```
    /// use infoscene::discretize::{BoxGrid, UNIT_CUBE};
    /// // 15 pairs of faces: (15 − 1)/(2 N ln 2) but for terms in 1/N²
    /// let bias = BoxGrid::regular(UNIT_CUBE, 1)?.expected_bias(10_000)?;
    /// assert!((bias - 14.0 / (2.0 * 1e4 * 2f64.ln())).abs() < 3e-7);
    /// # Ok::<(), infoscene::discretize::DiscretizeError>(())
    /// ```
    pub fn expected_bias(&self, samples: u64) -> Result<f64, DiscretizeError> {
        let parts = self.probabilities(|cells| {
            let cells = cells
                .iter()
                .map(|([probability, _], count)| (*probability, *count));
            expected_bias(cells, samples)
        })?;
        Ok(compensated_sum(parts))
    }

    /// The standard deviation of the plug-in estimate from so many lines, in bits, to second order
    /// in 1/N.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if a pair is refused.
    pub fn expected_deviation(&self, samples: u64) -> Result<f64, DiscretizeError> {
        let cells = self.probabilities(<[_]>::to_vec)?;
        Ok(expected_deviation(cells.into_iter().flatten(), samples))
    }

    /// Samples the grid by local lines; for one seed and box the same lines for all grids.
    ///
    /// **Arguments** `lines`: at least 2; fewer count as 2.
    ///
    /// # Errors
    /// As [`LineSample::draw_in_grid`].
    pub fn sample(&self, lines: u32, seed: u64) -> Result<LineSample, DiscretizeError> {
        let grid = GridLines::try_new(self.edges(), self.lines())?;
        Ok(LineSample::draw_in_grid(&grid, lines, seed)?)
    }

    /// Applies a function to the classes of each row: the probability of a pair of cells, that of
    /// independent cells, and the number of such pairs.
    fn probabilities<T: Send + Sync>(
        &self,
        of_row: impl Fn(&[([f64; 2], f64)]) -> T + Sync,
    ) -> Result<Vec<T>, DiscretizeError> {
        let classes = self.classes()?;
        let (total, _) = self.faces();
        let rows = classes.rows();
        try_parallel_map(rows.len(), &|row| {
            let cells = classes.row(&rows[row]).map(|pair| {
                let product = pair.areas() / total;
                let exchange = pair.exchange_area(product, PROBABILITY_ERROR)?;
                // a chord has no direction: both ordered pairs are one cell
                let both = [exchange.value, product].map(|ordered| 2.0 * ordered / total);
                Ok((both, 0.5 * pair.count))
            });
            let cells: Vec<_> = cells.collect::<Result<_, DiscretizeError>>()?;
            Ok(of_row(&cells))
        })
    }
}
