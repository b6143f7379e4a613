//! Positional entropy, entropy rate and mutual information of a scene's visibility chain, from its pairs as they come.
//!
//! The matrix is never held. With the areas as weights the sums over rows need one pass, because the total N of an open
//! chain can be put in afterwards:
//!
//! ```text
//!   q_ij = A_i A_j / A_T:   Σ_j J_ij ln(J_ij N/(A_i A_j)) = Σ_j q_ij φ(J_ij/q_ij − 1) + (r_i − A_i) + r_i ln(N/A_T)
//! ```
//!
//! where `r_i = Σ_j J_ij`. For a closed scene the last two vanish and what is left is a sum of terms ≥ 0; pairs left out by
//! the plan give `Σ q_ij`, plane by plane.
//!
//! **Errors** `f(J) = J log2(J/q) − (J − q)/ln 2` is convex with slope `log2(J/q)`. If J is known to ± e < J,
//!
//! ```text
//!   |Δf| ≤ e (|log2(J/q)| + e/((J − e) ln 2)),
//! ```
//!
//! summed over all pairs: a *bound* for a closed scene, whose exact weights are the areas. For an open scene the errors also
//! move the escaping parts and N; their first-order effect is added, and the result is an *estimate*.
//!
//! **Not covered**: what is below 1e-308 of the total.

use super::measures::{Unit, pair_divergence};
use crate::chain::ChainError;
use crate::numeric::{Grade, compensated_sum, tolerance, x_log2_x};
use crate::scene::{Account, Closure, ScenePairs};
use std::f64::consts::LN_2;

/// What becomes of power that meets no patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Surroundings {
    /// There must be none: an open scene is refused.
    None,
    /// It goes to the state `outside`.
    Outside,
}

/// The information of a scene's chain, in bits.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneInformation {
    /// Positional entropy, eq. (1).
    pub positional_entropy: f64,
    /// Entropy rate, eq. (2): `H_p − I`.
    pub entropy_rate: f64,
    /// Mutual information, eq. (3).
    pub mutual_information: f64,
    /// The error of the mutual information.
    pub error: f64,
    /// The grade of the error: a bound for a closed scene, an estimate for an open one.
    pub error_grade: Grade,
    /// The terms of eq. (3) by patch, or by the row that several are summed into, `w_i Σ_j P_ij log2(P_ij/w_j)`.
    pub contributions: Vec<f64>,
    /// The same of the state `outside`, if there is one.
    pub outside_contribution: Option<f64>,
    /// Stationary probabilities of the patches: areas, or generalised areas, over their sum.
    pub weights: Vec<f64>,
    /// Sum of the areas.
    pub total_area: f64,
    /// The sums of the rows of form factors.
    pub closure: Closure,
    /// The plan, and whether the tolerance was reached.
    pub account: Account,
}

/// Sums of one row, in units of [`Unit`] and nats.
const VALUE: usize = 0;
const BOUND: usize = 1;
const DIVERGENCE: usize = 2;
const DIVERGENCE_ERROR: usize = 3;

/// The information of a scene's visibility chain, each pair taken once and none held.
///
/// # Errors
/// [`ChainError::Scene`] for an open scene without [`Surroundings::Outside`], for rows above one, and if two patches are
/// refused.
///
/// # Examples
/// ```
/// use infoscene::information::{Surroundings, scene_information};
/// use infoscene::scene::{Congruence, Scene, ScenePairs};
/// let pairs = ScenePairs::try_new(&Scene::built_in("cube:1")?, 1e-12, Congruence::Shared)?;
/// let cube = scene_information(&pairs, Surroundings::None)?;
/// // one patch per face, from a 50-digit evaluation
/// assert!((cube.mutual_information - 0.263_034_544_099_120_5).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn scene_information(
    pairs: &ScenePairs,
    surroundings: Surroundings,
) -> Result<SceneInformation, ChainError> {
    let total_area = compensated_sum(pairs.areas().iter().copied());
    let unit = Unit::of_total(total_area);
    let areas: Vec<f64> = pairs.areas().iter().map(|area| unit.times(*area)).collect();
    let area = unit.times(total_area);
    let (sums, account) = pairs.row_sums(|i, j, exchange| {
        let (value, bound) = (unit.times(exchange.value), unit.times(exchange.error_bound));
        let probability = areas[j] / area;
        let divergence = pair_divergence(value, areas[i], probability);
        let error = divergence_error(value, bound, areas[i] * probability);
        [value, bound, divergence, error]
    })?;
    let area_bounds = pairs.area_bounds().iter();
    let area_bounds: Vec<f64> = area_bounds.map(|bound| unit.times(*bound)).collect();
    let closure = Closure::new(
        &areas,
        &area_bounds,
        sums.iter().map(|sum| [sum[VALUE], sum[BOUND]]),
    );
    match surroundings {
        Surroundings::None => closure.require_closed()?,
        Surroundings::Outside => closure.require_at_most_one()?,
    }
    let is_closed = closure.is_closed();
    let escaping: Vec<f64> = if is_closed {
        vec![0.0; areas.len()]
    } else {
        (0..areas.len())
            .map(|i| areas[i] * closure.escaping(i))
            .collect()
    };
    let outside = Outside::new(area, escaping);
    let unseen = pairs.unseen(&areas);
    let rows = areas.iter().zip(&sums).zip(unseen).enumerate();
    let contributions = rows.map(|(i, ((weight, sum), unseen))| {
        let dark = weight * (unseen / area); // φ(−1) = 1
        let closed = sum[DIVERGENCE] + dark;
        let nats = if is_closed {
            closed
        } else {
            let inside = (sum[VALUE] - weight) + sum[VALUE] * (outside.total / area).ln();
            closed + inside + outside.term(i, *weight)
        };
        nats / (outside.total * LN_2)
    });
    let contributions: Vec<f64> = contributions.collect();
    let outside_contribution = (!is_closed).then(|| {
        let terms = areas.iter().enumerate().map(|(i, w)| outside.term(i, *w));
        compensated_sum(terms) / (outside.total * LN_2)
    });
    let all = contributions.iter().copied().chain(outside_contribution);
    let mutual_information = compensated_sum(all);
    let weights = areas.iter().copied().chain([outside.weight]);
    let positional_entropy =
        0.0 - compensated_sum(weights.map(|weight| x_log2_x(weight / outside.total)));
    let from_pairs = compensated_sum(sums.iter().map(|sum| sum[DIVERGENCE_ERROR])) / LN_2;
    let from_escaping = if is_closed {
        0.0
    } else {
        outside.error(
            area,
            &areas,
            sums.iter().map(|sum| sum[BOUND]),
            mutual_information,
        )
    };
    // Σ |q − J| ≤ 2 A_i in row and column i; where an area is one patch's, its 4 ε are in the rounding
    let from_areas = areas.iter().zip(&area_bounds).map(|(area, bound)| {
        let more = bound - 4.0 * f64::EPSILON * area;
        4.0 * more / LN_2
    });
    let from_areas = compensated_sum(from_areas);
    let rounding = tolerance::INFORMATION * (2.0 + mutual_information);
    Ok(SceneInformation {
        positional_entropy,
        // a difference below rounding may come out on the other side of 0
        entropy_rate: (positional_entropy - mutual_information).max(0.0),
        mutual_information,
        error: (from_pairs + from_areas + from_escaping) / outside.total + rounding,
        error_grade: if is_closed {
            Grade::Bound
        } else {
            Grade::Estimate
        },
        contributions,
        outside_contribution,
        weights: areas.iter().map(|area| area / outside.total).collect(),
        total_area,
        closure,
        account,
    })
}

/// The state that takes what escapes.
struct Outside {
    escaping: Vec<f64>,
    weight: f64,
    total: f64,
}

impl Outside {
    fn new(area: f64, escaping: Vec<f64>) -> Self {
        let weight = compensated_sum(escaping.iter().copied());
        Self {
            escaping,
            weight,
            total: area + weight,
        }
    }

    /// `J ln(J N/(A_i w_out))` for what escapes from i, in nats.
    fn term(&self, i: usize, area: f64) -> f64 {
        let escaping = self.escaping[i];
        if escaping > 0.0 {
            escaping * (escaping / area / (self.weight / self.total)).ln()
        } else {
            0.0
        }
    }

    /// To first order, in bits times the total: what the rows' bounds do to the escaping parts and to N.
    fn error(&self, area: f64, areas: &[f64], bounds: impl Iterator<Item = f64>, bits: f64) -> f64 {
        let growth = (self.total / area).log2();
        let rows = areas.iter().zip(&self.escaping).zip(bounds);
        compensated_sum(rows.map(|((weight, escaping), bound)| {
            if bound <= 0.0 {
                return 0.0;
            }
            let ratio = escaping.max(bound) / weight / (self.weight / self.total);
            // there and back, and the share of N
            bound * (growth + 2.0 * (ratio.log2().abs() + 1.0 / LN_2) + bits)
        }))
    }
}

/// What an error of the exchange area may change `J ln(J/q) − J + q` by, in nats.
pub(crate) fn divergence_error(value: f64, bound: f64, product: f64) -> f64 {
    if bound <= 0.0 {
        return 0.0;
    }
    let slope = |value: f64| (value / product).ln().abs();
    if bound < value {
        return bound * (slope(value) + bound / (value - bound));
    }
    // down to 0, up to value + bound, or to the lowest point between
    let up = bound * slope(value + bound);
    let down = if value > 0.0 {
        (value * slope(value) + value).max(bound * slope(value))
    } else {
        bound
    };
    up.max(down)
}
