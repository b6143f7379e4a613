//! Positional entropy (1), entropy rate (2) and mutual information (3) of a chain, in bits.
//!
//! ```text
//!   H_p = −Σ w_i log2 w_i            H_s = −Σ_ij w_i P_ij log2 P_ij
//!   I   = H_p − H_s = Σ_ij J_ij log2( J_ij / (w_i w_j) ) = Σ_ij w_i w_j φ(x_ij) / ln 2,
//!   x_ij = J_ij/(w_i w_j) − 1        (total mass 1)
//! ```

use crate::chain::ReversibleChain;
use crate::numeric::functions::elementary::ln;
use crate::numeric::{Scaled, compensated_sum, divergence_kernel, x_log2_ratio, x_log2_x};
use std::f64::consts::LN_2;

/// The x from which on `a φ(x) = p (ln(p/a) − 1) + a` is used, whose factors cannot overflow: (a)
/// for x ≥ e − 1 both terms are ≥ 0, and nothing cancels.
pub(super) const LOGARITHMIC_FROM: f64 = 4.0;

/// Positional entropy `H_p` of the stationary distribution, eq. (1).
///
/// **Returns** bits, from 0 (one state) to log2 n (equal weights).
#[must_use]
pub fn positional_entropy(chain: &ReversibleChain) -> f64 {
    0.0 - compensated_sum((0..chain.states()).map(|i| x_log2_x(chain.stationary_probability(i))))
}

/// Entropy rate `H_s`: the uncertainty about the next state, given this one, eq. (2).
///
/// **Returns** bits, from 0 to `H_p`.
#[must_use]
pub fn entropy_rate(chain: &ReversibleChain) -> f64 {
    let unit = Unit::of(chain);
    let sum = (0..chain.states()).map(|j| {
        let weight = unit.times(chain.weights()[j]);
        let column = chain.joint().column(j);
        compensated_sum(
            column
                .iter()
                .map(|joint| x_log2_ratio(unit.times(*joint), weight)),
        )
    });
    0.0 - compensated_sum(sum) / unit.times(chain.total())
}

/// Mutual information `I = H_p − H_s` between two successive states, eq. (3).
///
/// **Returns** bits, ≥ 0 by construction, at most `H_p`.
/// **Accuracy** each term is non-negative and computed to a few ε of itself plus 2 ε of `w_i w_j`;
/// terms below 1e-308 of the total may be lost.
///
/// # Examples
/// ```
/// use infoscene::chain::visibility_chain;
/// use infoscene::information::mutual_information;
/// use infoscene::scene::Scene;
/// let cube = visibility_chain(&Scene::built_in("cube:1")?)?;
/// // One patch per face, from a 50-digit evaluation.
/// assert!((mutual_information(&cube) - 0.263_034_544_099_120_5).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn mutual_information(chain: &ReversibleChain) -> f64 {
    let unit = Unit::of(chain);
    let total = unit.times(chain.total());
    let weights: Vec<f64> = chain
        .weights()
        .iter()
        .map(|weight| unit.times(*weight))
        .collect();
    let sum = (0..chain.states()).filter(|j| weights[*j] > 0.0).map(|j| {
        let column = chain.joint().column(j);
        let probability = weights[j] / total;
        // the upper triangle twice, the diagonal once
        let above = (0..j).filter(|i| weights[*i] > 0.0);
        let term = |i: usize| pair_divergence(unit.times(column[i]), weights[i], probability);
        2.0 * compensated_sum(above.map(term)) + term(j)
    });
    compensated_sum(sum) / (total * LN_2)
}

/// One term of eq. (3), `w_i p_j φ(x)` with `x = J_ij/(w_i p_j) − 1`, in nats and in the scale of J
/// and w.
///
/// **Arguments** the joint entry, the weight of one state > 0, the probability of the other > 0.
pub(crate) fn pair_divergence(joint: f64, weight: f64, probability: f64) -> f64 {
    debug_assert!(weight > 0.0 && probability > 0.0, "{weight}, {probability}");
    let transition = joint / weight;
    let x = transition / probability - 1.0;
    if x < LOGARITHMIC_FROM {
        weight * probability * divergence_kernel(x)
    } else {
        // w_i w_j φ(x) without the product and the quotient, which may leave the range
        joint * (ln(transition) - ln(probability) - 1.0) + weight * probability
    }
}

/// A bound on the change of `J ln(J/q) − J + q` by an error of the exchange area J, in nats.
pub(crate) fn divergence_error(value: f64, bound: f64, product: f64) -> f64 {
    if bound <= 0.0 {
        return 0.0;
    }
    let slope = |value: f64| ln(value / product).abs();
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

/// A power of two that brings the chain's total near 1, as two factors that `f64` can hold.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unit([f64; 2]);

impl Unit {
    fn of(chain: &ReversibleChain) -> Self {
        Self::of_total(chain.total())
    }

    /// The unit of a chain with this total.
    pub(super) fn of_total(total: f64) -> Self {
        let power = -Scaled::new(total).exponent;
        Self([power / 2, power - power / 2].map(|power| 2f64.powi(power)))
    }

    /// The value in this unit; exact, but for values below 1e-308 of the total.
    pub(super) fn times(self, value: f64) -> f64 {
        value * self.0[0] * self.0[1]
    }
}
