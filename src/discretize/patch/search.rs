//! The search for the best cuts of a patch.
//!
//! The derivative of the gain is continuous except at kinks, where a cut runs in the plane of
//! another patch or along an edge of its own. So the search goes piece by piece between them, and a
//! kink is a candidate itself: if the part before a plane is dark, the derivative falls there from
//! above 0 to −∞.
//!
//! **Not covered**: a proof that no maximum hides between two scanned points.

use super::split::{PatchSplit, SplitOptimum};
use crate::discretize::error::DiscretizeError;
use crate::discretize::measure::CutMeasure;
use crate::numeric::{NumericError, is_higher, maximum, maximum_of_many, real, x_log2_ratio};
use std::cell::RefCell;

/// Pieces of the whole at whose ends the derivative is scanned for maxima: (b) maxima less than a
/// piece apart may be missed; `best_cuts_agree_with_certified_ones` finds none that are.
const SCANNED_INTERVALS: f64 = 64.0;

/// The least number of pieces between two kinks, as [`SCANNED_INTERVALS`] where kinks are close.
const FEWEST_INTERVALS: f64 = 16.0;

/// The distance from a kink at which the derivatives on its two sides are taken: (a) positions are
/// known to some ε, so that this is beside the kink for certain, and a gain is flat over it.
const BESIDE: f64 = 1e-9;

/// A derivative beside a kink that points away from it by more than this, in bits, is no rounding:
/// (a) a gain of ε relative over the step [`BESIDE`] is an error of the derivative of 1e-7.
const UPHILL: f64 = 1e-6;

/// Steps of the lattice from which several cuts start, for each part and in all: (b)
/// `more_parts_gain_more` and `many_parts_come_to_rest` reach their cuts from it.
const LATTICE_STEPS_PER_PART: usize = 8;
const FEWEST_LATTICE_STEPS: usize = 64;

/// The share of the way to the next cut that a cut leaves a kink by: a start, which the refinement
/// then moves.
const LEAVING_STEP: f64 = 1e-3;

impl PatchSplit {
    /// The cuts into `parts` parts that gain the most.
    ///
    /// Two parts: the highest of the maxima that a scan of the derivative shows between kinks, each
    /// refined as its root, and of the kinks (of equal ones, the nearest to `v0`). More: the best
    /// cuts on a fine lattice that holds the kinks, all of them compared by dynamic programming;
    /// those between kinks are refined as the root of the gradient.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] below two parts; [`DiscretizeError::Numeric`] if no
    /// interior maximum is found.
    pub fn best(&self, parts: u32) -> Result<SplitOptimum, DiscretizeError> {
        let positions = match parts {
            0 | 1 => {
                let (parameter, condition) = ("the number of parts", "at least 2");
                return Err(DiscretizeError::OutOfRange {
                    parameter,
                    value: parts.into(),
                    condition,
                });
            }
            2 => vec![self.best_cut(CutMeasure::Information)?],
            _ => self.refined(self.best_on_lattice(parts as usize)?)?,
        };
        let mut residual: f64 = 0.0;
        for k in 0..positions.len() {
            residual = residual.max(self.uphill(&positions, k)?.abs());
        }
        Ok(SplitOptimum {
            gain: self.gain(&positions)?,
            residual,
            positions,
        })
    }

    /// The cut that gains the most by a measure, found as [`best`](Self::best) finds it.
    ///
    /// # Errors
    /// [`DiscretizeError::Numeric`] if no interior maximum is found.
    pub fn best_cut(&self, measure: CutMeasure) -> Result<f64, DiscretizeError> {
        let mut best: Option<(f64, f64)> = None;
        let mut consider = |position: f64, gain: f64| {
            // the first of equal maxima
            if best.is_none_or(|(_, most)| is_higher(gain, most)) {
                best = Some((position, gain));
            }
        };
        let mut lower = 0.0;
        for upper in self.kinks.iter().copied().chain([1.0]) {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "16 to 64"
            )]
            let intervals = (SCANNED_INTERVALS * (upper - lower))
                .ceil()
                .max(FEWEST_INTERVALS) as u32;
            let found = self.searching(measure, |gain, derivative| {
                let derivative = |t| derivative(&[t], 0);
                match maximum(|t| gain(&[t]), derivative, (lower, upper), intervals) {
                    Err(NumericError::NoInteriorMaximum { .. }) => Ok(None),
                    found => found.map(Some),
                }
            })?;
            if let Some(found) = found {
                consider(found.position, found.value);
            }
            if upper < 1.0 {
                let gain = self.gain_by(measure, &[upper])?;
                if gain > 0.0 {
                    consider(upper, gain);
                }
            }
            lower = upper;
        }
        let (lower, upper) = (0.0, 1.0);
        let none = NumericError::NoInteriorMaximum { lower, upper };
        best.map_or(Err(none.into()), |(position, _)| Ok(position))
    }

    /// The best cuts on a lattice whose step is an eighth part or less, and the kinks: the gain is
    /// a sum over the parts, so the best last part extends the best cuts before it.
    fn best_on_lattice(&self, parts: usize) -> Result<Vec<f64>, DiscretizeError> {
        debug_assert!(parts >= 2, "{parts} parts");
        let at = self.lattice(parts);
        let count = at.len() - 1;
        let value = self.values_between(&at)?;
        // best[m][to]: the most that m + 1 parts before `to` bring, and where the last one starts
        let first = (0..=count).map(|to| if to == 0 { (0.0, 0) } else { (value(0, to), 0) });
        let mut best: Vec<Vec<(f64, usize)>> = vec![first.collect()];
        for m in 1..parts {
            let shorter = &best[m - 1];
            let extended = (0..=count).map(|to| {
                (m..to).fold((f64::NEG_INFINITY, 0), |most, from| {
                    let sum = shorter[from].0 + value(from, to);
                    if sum > most.0 { (sum, from) } else { most }
                })
            });
            let extended = extended.collect();
            best.push(extended);
        }
        let mut positions = Vec::with_capacity(parts - 1);
        let mut to = count;
        for m in (1..parts).rev() {
            to = best[m][to].1;
            positions.push(at[to]);
        }
        positions.reverse();
        Ok(positions)
    }

    /// The points of the lattice for so many parts, increasing from 0 to 1: regular steps, with the
    /// kinks in place of the steps next to them.
    fn lattice(&self, parts: usize) -> Vec<f64> {
        let steps = (LATTICE_STEPS_PER_PART * parts).max(FEWEST_LATTICE_STEPS);
        let regular = (1..steps).map(|k| real(k) / real(steps));
        let far = |t: &f64| self.kinks.iter().all(|kink| (t - kink).abs() > BESIDE);
        let mut at: Vec<f64> = regular.filter(far).collect();
        at.extend(self.kinks.iter().copied().chain([0.0, 1.0]));
        at.sort_by(f64::total_cmp);
        at
    }

    /// The term `Σ_j β_j G_j log2(G_j/s)` of the part between two points of a lattice.
    fn values_between(
        &self,
        at: &[f64],
    ) -> Result<impl Fn(usize, usize) -> f64 + use<>, DiscretizeError> {
        let count = at.len() - 1;
        // fluxes before each point, by additivity: a rounding of some ε hurts no start
        let split = self.parts();
        let brightness = split.weights().brightness.clone();
        let mut before = vec![vec![0.0; brightness.len()]; count + 1];
        let mut shares = vec![0.0; count + 1];
        for k in 0..count {
            let strip = [at[k], at[k + 1]];
            let (earlier, later) = before.split_at_mut(k + 1);
            for (j, (sum, next)) in earlier[k].iter().zip(&mut later[0]).enumerate() {
                *next = sum + split.flux(j, &strip)?;
            }
            shares[k + 1] = shares[k] + split.share(&strip);
        }
        Ok(move |from: usize, to: usize| -> f64 {
            let fluxes = before[from].iter().zip(&before[to]);
            fluxes
                .zip(&brightness)
                .map(|((from_flux, to_flux), brightness)| {
                    brightness * x_log2_ratio(to_flux - from_flux, shares[to] - shares[from])
                })
                .sum()
        })
    }

    /// Cuts near a maximum, refined.
    ///
    /// Cuts at kinks stay there unless the gain rises beside them; the best places of cuts between
    /// two of them do not depend on the cuts beyond. A cut that does not converge runs into the
    /// kink next to it.
    fn refined(&self, mut positions: Vec<f64>) -> Result<Vec<f64>, DiscretizeError> {
        let mut pinned: Vec<bool> = positions.iter().map(|t| self.is_kink(*t)).collect();
        for _ in 0..=2 * positions.len() {
            let mut is_settled = true;
            let mut start = 0_usize;
            for end in 0..=positions.len() {
                if pinned.get(end) == Some(&false) {
                    continue;
                }
                let lower = start.checked_sub(1).map_or(0.0, |k| positions[k]);
                let upper = positions.get(end).copied().unwrap_or(1.0);
                if start < end {
                    match self.between(&positions, start..end, [lower, upper]) {
                        Ok(refined) => positions[start..end].copy_from_slice(&refined),
                        Err(error) => {
                            let nearest = self.nearest_kink(&positions, start..end, [lower, upper]);
                            let (k, kink) = nearest.ok_or(error)?;
                            positions[k] = kink;
                            pinned[k] = true;
                            is_settled = false;
                        }
                    }
                }
                start = end + 1;
            }
            for k in 0..positions.len() {
                if !pinned[k] || !is_settled {
                    continue;
                }
                let uphill = self.uphill(&positions, k)?;
                if uphill.abs() > UPHILL {
                    let next = if uphill > 0.0 {
                        positions.get(k + 1).copied().unwrap_or(1.0)
                    } else {
                        k.checked_sub(1).map_or(0.0, |k| positions[k])
                    };
                    positions[k] += LEAVING_STEP * (next - positions[k]);
                    pinned[k] = false;
                    is_settled = false;
                }
            }
            if is_settled {
                break;
            }
        }
        Ok(positions)
    }

    /// The cuts `range`, refined between two neighbours that stay.
    fn between(
        &self,
        positions: &[f64],
        range: std::ops::Range<usize>,
        [lower, upper]: [f64; 2],
    ) -> Result<Vec<f64>, DiscretizeError> {
        let width = upper - lower;
        let scaled = positions[range.clone()].iter();
        let scaled = scaled.map(|t| (t - lower) / width).collect();
        let found = self.searching(CutMeasure::Information, |_, derivative| {
            let gradient = |shares: &[f64]| {
                let mut moved = positions.to_vec();
                for (position, share) in moved[range.clone()].iter_mut().zip(shares) {
                    *position = lower + width * share;
                }
                range
                    .clone()
                    .map(|k| width * derivative(&moved, k))
                    .collect()
            };
            maximum_of_many(gradient, scaled)
        })?;
        Ok(found
            .into_iter()
            .map(|share| lower + width * share)
            .collect())
    }

    /// The cut of `range` and the kink between its neighbours that are nearest to each other.
    fn nearest_kink(
        &self,
        positions: &[f64],
        range: std::ops::Range<usize>,
        [lower, upper]: [f64; 2],
    ) -> Option<(usize, f64)> {
        let pairs = range.flat_map(|k| {
            let left = k.checked_sub(1).map_or(0.0, |k| positions[k]).max(lower);
            let right = positions.get(k + 1).copied().unwrap_or(1.0).min(upper);
            let kinks = self.kinks.iter().copied();
            let between = kinks.filter(move |kink| *kink > left && *kink < right);
            between.map(move |kink| (k, kink))
        });
        pairs.min_by(|a, b| {
            let distance = |(k, kink): &(usize, f64)| (positions[*k] - kink).abs();
            distance(a).total_cmp(&distance(b))
        })
    }

    fn is_kink(&self, position: f64) -> bool {
        self.kinks.iter().any(|kink| (kink - position).abs() <= 0.0)
    }

    /// The remaining derivative at cut `k`; at a kink that of the side which rises, 0 if both fall.
    fn uphill(&self, positions: &[f64], k: usize) -> Result<f64, DiscretizeError> {
        if !self.is_kink(positions[k]) {
            return self.gain_derivative(positions, k);
        }
        let beside = |shift: f64| {
            let mut moved = positions.to_vec();
            moved[k] += shift;
            self.gain_derivative(&moved, k)
        };
        let (left, right) = (beside(-BESIDE)?, beside(BESIDE)?);
        Ok(if right > 0.0 { right } else { left.min(0.0) })
    }

    /// Runs an optimiser that knows only numbers; where it fails, the first refusal inside is the
    /// reason.
    fn searching<T>(
        &self,
        measure: CutMeasure,
        search: impl FnOnce(
            &dyn Fn(&[f64]) -> f64,
            &dyn Fn(&[f64], usize) -> f64,
        ) -> Result<T, NumericError>,
    ) -> Result<T, DiscretizeError> {
        let refusal = RefCell::new(None);
        let number = |result: Result<f64, DiscretizeError>| {
            result.unwrap_or_else(|error| {
                refusal.borrow_mut().get_or_insert(error);
                f64::NAN
            })
        };
        let found = search(
            &|positions| number(self.gain_by(measure, positions)),
            &|positions, k| number(self.gain_derivative_by(measure, positions, k)),
        );
        // a refusal matters only if the optimiser could not do without that point
        found.map_err(|error| refusal.into_inner().unwrap_or(error.into()))
    }
}
