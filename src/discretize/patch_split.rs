//! The cut of a patch that gains the most mutual information, eq. (7).
//!
//! ```text
//!   ΔI(t) = (2/A_T) Σ_j [ Σ_k A_k F_kj log2 F_kj − A F_j log2 F_j ]
//! ```
//!
//! over the patches j named, parts k between the cuts `t`. No outside state enters: a scene
//! need not be closed.
//!
//! **Not covered**: cuts that are not parallel to an edge; occlusion.

use super::{DiscretizeError, stationarity};
use crate::form_factor::RectanglePair;
use crate::geometry::SplitAxis;
use crate::information::{divergence, subdivision_bound};
use crate::numeric::{NumericError, compensated_sum, maximum, maximum_of_many, x_log2_ratio};
use crate::scene::Scene;
use std::cell::RefCell;
use std::f64::consts::LN_2;

/// A patch of a scene, to be cut across one of its axes.
#[derive(Debug, Clone, PartialEq)]
pub struct PatchSplit {
    pairs: Vec<RectanglePair>,
    axis: SplitAxis,
    area: f64,
    total_area: f64,
}

/// The best cuts, with what they gain.
#[derive(Debug, Clone, PartialEq)]
pub struct SplitOptimum {
    /// Relative positions of the cuts, increasing, in `(0, 1)`.
    pub positions: Vec<f64>,
    /// `ΔI` there, in bits.
    pub gain: f64,
    /// The largest |∂ΔI/∂t| that is left, in bits.
    pub residual: f64,
}

/// Equally spaced points at which the derivative is scanned for maxima.
const SCANNED_INTERVALS: u32 = 64;

impl PatchSplit {
    /// Patch `patch` of `scene`, cut across `axis`, judged by what it exchanges with the
    /// patches `against`.
    ///
    /// # Errors
    /// [`DiscretizeError::Scene`] if a patch does not exist or is not a rectangle;
    /// [`DiscretizeError::FormFactor`] if a pair is not aligned;
    /// [`DiscretizeError::AgainstItself`]; [`DiscretizeError::NamedTwice`];
    /// [`DiscretizeError::NothingToGain`].
    pub fn try_new(
        scene: &Scene,
        patch: usize,
        against: &[usize],
        axis: SplitAxis,
    ) -> Result<Self, DiscretizeError> {
        let rectangle = scene.rectangle(patch)?;
        let mut pairs = Vec::new();
        let mut exchanged = 0.0;
        for other in against {
            if *other == patch {
                return Err(DiscretizeError::AgainstItself { patch });
            }
            if against.iter().filter(|index| *index == other).count() > 1 {
                return Err(DiscretizeError::NamedTwice { patch: *other });
            }
            let pair = RectanglePair::try_new(&rectangle, &scene.rectangle(*other)?)?;
            let exchange = pair.exchange_area()?.value;
            if exchange > 0.0 {
                exchanged += exchange;
                pairs.push(pair);
            }
        }
        if exchanged <= 0.0 {
            return Err(DiscretizeError::NothingToGain { patch });
        }
        Ok(Self {
            pairs,
            axis,
            area: rectangle.area(),
            total_area: scene.total_area(),
        })
    }

    /// The gain of cuts at increasing relative positions, in bits.
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] unless `0 < t_1 < … < 1`.
    pub fn gain(&self, positions: &[f64]) -> Result<f64, DiscretizeError> {
        let parts = parts(positions);
        let weights: Vec<f64> = parts.iter().map(|(from, to)| to - from).collect();
        let mut gains = Vec::with_capacity(self.pairs.len());
        for pair in &self.pairs {
            let fluxes = parts
                .iter()
                .map(|(from, to)| exchange(pair, self.axis, *from, *to))
                .collect::<Result<Vec<f64>, _>>()?;
            gains.push(divergence(&fluxes, &weights));
        }
        Ok(2.0 * compensated_sum(gains) / self.total_area)
    }

    /// The derivative of the gain as cut `k` moves, in bits per relative position.
    ///
    /// # Errors
    /// As [`gain`](Self::gain).
    pub fn gain_derivative(&self, positions: &[f64], k: usize) -> Result<f64, DiscretizeError> {
        let parts = parts(positions);
        let (Some(before), Some(after)) = (parts.get(k).copied(), parts.get(k + 1).copied()) else {
            let (parameter, condition) = ("the index of a cut", "that of one of the positions");
            #[allow(clippy::cast_precision_loss, reason = "only shown")]
            let value = k as f64;
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value,
                condition,
            });
        };
        let mut derivatives = Vec::with_capacity(self.pairs.len());
        for pair in &self.pairs {
            let ratio = |(from, to): (f64, f64)| {
                exchange(pair, self.axis, from, to).map(|flux| flux / (self.area * (to - from)))
            };
            let rate = pair.strip_exchange(self.axis, before.1)?;
            derivatives.push(stationarity(rate, self.area, ratio(before)?, ratio(after)?));
        }
        Ok(2.0 * compensated_sum(derivatives) / (self.total_area * LN_2))
    }

    /// The largest gain that a regular division into `parts` could bring at all, eqs. (6), (7).
    ///
    /// # Errors
    /// [`DiscretizeError::FormFactor`] if an exchange area leaves `f64`'s range.
    pub fn maximum_gain(&self, parts: u32) -> Result<f64, DiscretizeError> {
        let exchanged = self
            .pairs
            .iter()
            .map(|pair| pair.exchange_area().map(|exchange| exchange.value))
            .collect::<Result<Vec<f64>, _>>()?;
        Ok(subdivision_bound(
            compensated_sum(exchanged) / self.total_area,
            parts,
        ))
    }

    /// The cuts into `parts` parts that gain the most.
    ///
    /// Two parts: the highest of the maxima that a scan of the derivative shows, each
    /// refined as its root (of equal ones, the nearest to `v0`). More: the best
    /// cuts on a fine lattice, all of them compared by dynamic programming, refined as the root of the
    /// gradient.
    ///
    /// # Errors
    /// [`DiscretizeError::OutOfRange`] below two parts; [`DiscretizeError::Numeric`] if no
    /// interior maximum is found.
    pub fn best(&self, parts: u32) -> Result<SplitOptimum, DiscretizeError> {
        if parts < 2 {
            let (parameter, condition) = ("the number of parts", "at least 2");
            return Err(DiscretizeError::OutOfRange {
                parameter,
                value: parts.into(),
                condition,
            });
        }
        let positions = if parts == 2 {
            let found = self.searching(|gain, derivative| {
                maximum(
                    |t| gain(&[t]),
                    |t| derivative(&[t], 0),
                    (0.0, 1.0),
                    SCANNED_INTERVALS,
                )
            })?;
            vec![found.position]
        } else {
            let start = self.best_on_lattice(parts as usize)?;
            self.searching(|_, derivative| {
                let gradient = |positions: &[f64]| {
                    (0..positions.len())
                        .map(|k| derivative(positions, k))
                        .collect()
                };
                maximum_of_many(gradient, start)
            })?
        };
        let mut residual: f64 = 0.0;
        for k in 0..positions.len() {
            residual = residual.max(self.gain_derivative(&positions, k)?.abs());
        }
        Ok(SplitOptimum {
            gain: self.gain(&positions)?,
            residual,
            positions,
        })
    }

    /// The best cuts whose positions are multiples of a step of an eighth part or less: the gain is a sum over
    /// the parts, so the best last part extends the best cuts before it.
    fn best_on_lattice(&self, parts: usize) -> Result<Vec<f64>, DiscretizeError> {
        let count = (8 * parts).max(64);
        #[allow(clippy::cast_precision_loss, reason = "a few hundred points")]
        let at = |k: usize| k as f64 / count as f64;
        // value[from][to]: Σ_j G log2(G/W) of one part
        let mut value = vec![vec![0.0; count + 1]; count];
        for (from, row) in value.iter_mut().enumerate() {
            for (to, value) in row.iter_mut().enumerate().skip(from + 1) {
                for pair in &self.pairs {
                    let flux = exchange(pair, self.axis, at(from), at(to))?;
                    *value += x_log2_ratio(flux, at(to) - at(from));
                }
            }
        }
        // best[m][to]: the most that m + 1 parts of [0, to] bring, and where the last one starts
        let mut best: Vec<Vec<(f64, usize)>> = vec![value[0].iter().map(|v| (*v, 0)).collect()];
        for m in 1..parts {
            let before = &best[m - 1];
            let extended = (0..=count).map(|to| {
                (m..to).fold((f64::NEG_INFINITY, 0), |most, from| {
                    let sum = before[from].0 + value[from][to];
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
            positions.push(at(to));
        }
        positions.reverse();
        Ok(positions)
    }

    /// Runs an optimiser that knows only numbers; where it fails, the first refusal inside is the reason.
    fn searching<T>(
        &self,
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
            &|positions| number(self.gain(positions)),
            &|positions, k| number(self.gain_derivative(positions, k)),
        );
        // a refusal matters only if the optimiser could not do without that point
        found.map_err(|error| refusal.into_inner().unwrap_or(error.into()))
    }
}

/// `1/m, 2/m, …`: the regular division into `parts`.
#[must_use]
pub fn regular_positions(parts: u32) -> Vec<f64> {
    (1..parts)
        .map(|k| f64::from(k) / f64::from(parts))
        .collect()
}

fn parts(positions: &[f64]) -> Vec<(f64, f64)> {
    let from = std::iter::once(0.0).chain(positions.iter().copied());
    let to = positions.iter().copied().chain(std::iter::once(1.0));
    from.zip(to).collect()
}

fn exchange(
    pair: &RectanglePair,
    axis: SplitAxis,
    from: f64,
    to: f64,
) -> Result<f64, DiscretizeError> {
    Ok(pair.part(axis, from, to)?.exchange_area()?.value)
}
