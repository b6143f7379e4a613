//! The highest gains of one cut by a scan of gains, for many directions at once.
//!
//! Where a gain is smooth, its highest value needs no derivative and few evaluations: it is flat.
//!
//! **Not covered**: accurate positions ([`PatchSplit::best_cut`]).

use super::part_exchange;
use super::split::PatchSplit;
use crate::discretize::error::DiscretizeError;
use crate::discretize::measure::CutMeasure;
use crate::numeric::real;

/// Pieces at whose ends the gains are scanned, and halvings of a piece about the highest: (b) held
/// by `highest_gains_are_those_of_best_cuts`.
const PIECES: usize = 16;
const HALVINGS: usize = 4;

impl PatchSplit {
    /// The highest gain of one cut, by each of [`CutMeasure::ALL`].
    ///
    /// **Accuracy** within 1e-5 of itself if it is smooth there and no other maximum as high lies
    /// within an eighth of the patch: an estimate, held by
    /// `highest_gains_are_those_of_best_cuts`.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if an exchange area leaves `f64`'s range.
    pub fn highest_gains(&self) -> Result<[f64; 2], DiscretizeError> {
        let step = 1.0 / real(PIECES);
        let scanned = (1..PIECES).map(|k| self.gains(real(k) * step));
        let scanned = scanned.collect::<Result<Vec<_>, _>>()?;
        let mut highest = [0.0; 2];
        for (index, measure) in CutMeasure::ALL.into_iter().enumerate() {
            let at = |k: usize| match k.checked_sub(1) {
                Some(before) => scanned.get(before).map_or(0.0, |gains| gains[index]),
                None => 0.0,
            };
            let best = (1..PIECES).fold(1, |best, k| if at(k) > at(best) { k } else { best });
            let three = [at(best - 1), at(best), at(best + 1)];
            highest[index] = self.refined_gain(measure, real(best) * step, three)?;
        }
        Ok(highest)
    }

    /// The highest gain near a scanned one, from the gains at a step before it, at it and after it.
    fn refined_gain(
        &self,
        measure: CutMeasure,
        mut middle: f64,
        mut three: [f64; 3],
    ) -> Result<f64, DiscretizeError> {
        let gain = |at: f64| self.gain_by(measure, &[at]);
        let mut step = 1.0 / real(PIECES);
        for _ in 0..HALVINGS {
            step *= 0.5;
            let [left, right] = [gain(middle - step)?, gain(middle + step)?];
            let [before, own, after] = three;
            if left > own && left >= right {
                (middle, three) = (middle - step, [before, left, own]);
            } else if right > own {
                (middle, three) = (middle + step, [own, right, after]);
            } else {
                three = [left, own, right];
            }
        }
        // the top of the parabola through the three
        let [before, own, after] = three;
        let bend = before - 2.0 * own + after;
        let shift = 0.5 * step * (before - after) / bend;
        if shift.abs() < step {
            return Ok(gain(middle + shift)?.max(own));
        }
        Ok(own)
    }

    /// The gains of a cut by both measures.
    pub(crate) fn gains(&self, position: f64) -> Result<[f64; 2], DiscretizeError> {
        part_exchange::gains_by(CutMeasure::ALL, self.parts(), &[position])
    }
}
