//! Bounds on what the resolution of a scene's coordinates can change of its information.
//!
//! ```text
//!   f(J, q) = J ln(J/q) − J + q,      I = Σ_ij f(J_ij, q_ij)/(A_T ln 2),      q_ij = A_i A_j/A_T
//! ```
//!
//! Exchange areas change by `ρ_ij` at most and areas by `a_i`
//! ([`ScenePairs::resolution_error`]). So every f changes by what it does between `J ± ρ`, for all
//! pairs but those of surfaces that are taken to lie in one plane, which exchange nothing if they
//! do; then q changes by `q t` with
//!
//! ```text
//!   |t_ij| ≤ (η_i + η_j + η) (1 + max η)/(1 − η),      η_i = a_i/A_i,  η = Σ a_i/A_T
//!   |Δf| ≤ |q − J| |t| + J t²/(2 (1 − |t|)),           Σ_j |q_ij − J_ij| ≤ 2 A_i
//!   Σ_ij |Δf| ≤ 6 Σ a_i · (1 + max η)²/(1 − η) · (1 + T/(1 − T)),      T = max t
//! ```
//!
//! as the rows of the exact J sum to the exact areas: a bound for a closed scene. For an open one
//! the effect on what escapes is added to first order, as for errors of the computation.
//!
//! No bound is larger than the range of what it bounds, from 0 to log2 of the number of states.

use super::chain::divergence_error;
use crate::exchange::ScenePairs;
use crate::numeric::functions::elementary::{ln, log2};
use crate::numeric::{compensated_sum, parallel_map, real};
use std::f64::consts::LN_2;

/// Bounds on the changes of a scene's information, in bits; 0 if coordinates are exact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct InformationResolution {
    /// A bound on the change of the positional entropy.
    pub positional_entropy: f64,
    /// A bound on the change of the mutual information; that of the entropy rate is within the sum
    /// of both.
    pub mutual_information: f64,
}

/// Bounds on what the resolution can change of a scene's sums, in units of its area.
pub(super) struct Changes {
    /// Bounds on the changes of the areas, by row.
    pub areas: Vec<f64>,
    /// A bound on the change of what a row exchanges with those that it sees.
    pub rows: Vec<f64>,
    /// The sum of the changes of f over all pairs, there and back.
    pub divergence: f64,
}

impl Changes {
    /// The changes of the sums over the pairs that see each other, by row, completed.
    ///
    /// **Arguments** `unit`: brings areas into the unit of the sums; `weights`: the areas in it.
    pub(super) fn of(
        pairs: &ScenePairs<'_>,
        unit: impl Fn(f64) -> f64 + Sync,
        weights: &[f64],
        sums: &[[f64; 2]],
    ) -> Self {
        let total = compensated_sum(weights.iter().copied());
        let of_areas = pairs.area_resolution_errors().into_iter();
        let unseen = parallel_map(weights.len(), &|i| {
            let hidden = (0..i).filter(|j| pairs.is_behind(i, *j));
            let changes = hidden.map(|j| {
                let change = unit(pairs.resolution_error(i, j));
                divergence_error(0.0, change, weights[i] * (weights[j] / total))
            });
            2.0 * changes.sum::<f64>()
        });
        let seen = compensated_sum(sums.iter().map(|[_, divergence]| *divergence));
        Self {
            areas: of_areas.map(unit).collect(),
            rows: sums.iter().map(|[exchange, _]| *exchange).collect(),
            divergence: seen + compensated_sum(unseen),
        }
    }

    /// Bounds on what a row's sum of exchange areas may be off its area, by row.
    pub(super) fn of_rows(&self) -> impl Iterator<Item = f64> + '_ {
        let rows = self.rows.iter().zip(&self.areas);
        rows.map(|(exchange, area)| exchange + area)
    }

    /// The bounds on the entropies.
    ///
    /// **Arguments** `weights`: the areas; `more`: what else changes of the sum of f, in bits;
    /// `bits`: the mutual information.
    pub(super) fn bounds(&self, weights: &[f64], more: f64, bits: f64) -> InformationResolution {
        let total = compensated_sum(weights.iter().copied());
        let moved = compensated_sum(self.areas.iter().copied());
        let all = moved / total;
        let shares: Vec<f64> = self.areas.iter().zip(weights).map(|(a, w)| a / w).collect();
        let most = shares.iter().copied().fold(0.0, f64::max);
        let range = log2(real(weights.len() + 1));
        let within_range = |bound: f64| {
            // also a comparison that NaN fails
            if bound < range { bound } else { range }
        };
        if all >= 1.0 || all.is_nan() {
            return InformationResolution {
                positional_entropy: range,
                mutual_information: range,
            };
        }
        let slope = (1.0 + most) / (1.0 - all);
        let largest = (2.0 * most + all) * slope;
        let curved = if largest < 1.0 {
            1.0 + largest / (1.0 - largest)
        } else {
            f64::INFINITY
        };
        let from_areas = 6.0 * moved * slope * (1.0 + most) * curved;
        let divergence = (self.divergence + from_areas) / LN_2 + more + bits * moved;
        let entropy = weights.iter().zip(&shares).map(|(weight, share)| {
            let (weight, change) = (weight / total, (share + all) / (1.0 - all));
            weight * change * (ln(weight).abs() + 1.0 + change) / LN_2
        });
        InformationResolution {
            positional_entropy: within_range(entropy.sum()),
            mutual_information: within_range(divergence / (total - moved)),
        }
    }
}
