//! The gain in mutual information when a state is refined: equations (5) to (7).
//!
//! ```text
//!   ΔI = (1/Σw) [ 2 Σ_{j≠i} D(J_1j … J_mj ‖ w_1 … w_m) + D(J_kl ‖ w_k w_l) ]
//!   D(J ‖ w) = J Σ_k p_k log2(p_k/a_k) = J Σ_k a_k φ(x_k)/ln 2,
//!   p_k = J_k/J,  a_k = w_k/w,  x_k = p_k/a_k − 1,  φ(x) = (1+x) ln(1+x) − x ≥ 0
//! ```
//!
//! Each term is ≥ 0, so ΔI ≥ 0 in floating point too, and it is never the difference of two mutual
//! informations. Where p and a nearly agree, `x_k = (J_k w − J w_k)/(J w_k)` is taken from
//! exact products and sums, so the gain keeps its relative precision however small it is.

use crate::chain::{ReversibleChain, StateRefinement};
use crate::numeric::{Expansion, compensated_sum, divergence_kernel};
use std::f64::consts::LN_2;

/// `D(J ‖ w)`: what a pair gains in one direction when its flux `ΣJ_k` is told apart by sub-states.
///
/// Half of eq. (5), before division by Σw: for fluxes `J_k = w_k P_kj` it is
/// `Σ_k J_k log2 P_kj − J log2 P_ij`.
///
/// **Arguments** as many fluxes as weights, all finite and ≥ 0; where a weight is 0 so is the flux.
/// **Returns** bits times the unit of flux, ≥ 0; 0 exactly if the fluxes are proportional to the
/// weights.
/// **Accuracy** a few ε relative to the given numbers, taken as exact, as long as they are 0 or
/// ≥ 1e-290 of the largest.
///
/// # Examples
/// ```
/// use infoscene::information::divergence;
/// assert_eq!(divergence(&[1.0, 1.0], &[1.0, 1.0]), 0.0);
/// assert_eq!(divergence(&[1.0, 0.0], &[1.0, 1.0]), 1.0); // all the flux to one of two halves
/// ```
#[must_use]
pub fn divergence(fluxes: &[f64], weights: &[f64]) -> f64 {
    let fluxes: Vec<Scaled> = fluxes.iter().map(|flux| Scaled::new(*flux)).collect();
    let weights: Vec<Scaled> = weights.iter().map(|weight| Scaled::new(*weight)).collect();
    let (flux, flux_unit) = common_scale(&fluxes);
    let (weight, weight_unit) = common_scale(&weights);
    let (flux_sum, weight_sum) = (flux.iter().sum::<f64>(), weight.iter().sum::<f64>());
    if flux_sum <= 0.0 || weight_sum <= 0.0 {
        return 0.0;
    }
    let terms = (0..flux.len())
        .filter(|k| weights[*k].significand > 0.0)
        .map(|k| {
            // this sub-state's own scale, so that a tiny one keeps its digits
            let exponent = weights[k]
                .exponent
                .max(fluxes[k].exponent - flux_unit + weight_unit);
            let own_weight = weights[k].times_power(-exponent);
            let own_flux = fluxes[k].times_power(weight_unit - flux_unit - exponent);
            let share = weight[k] / weight_sum;
            let independent = flux_sum * own_weight;
            let quick = own_flux * weight_sum / independent - 1.0;
            let x = if quick >= FAR_ABOVE {
                return far_above(flux[k] / flux_sum, share);
            } else if quick.abs() >= NEARLY_PROPORTIONAL {
                quick
            } else {
                let cross = &Expansion::from(own_flux) * &Expansion::sum(weight.iter().copied());
                let other = &Expansion::from(own_weight) * &Expansion::sum(flux.iter().copied());
                (cross - &other).to_f64() / independent
            };
            share * divergence_kernel(x)
        });
    let sum = compensated_sum(terms) * flux_sum / LN_2;
    Scaled::new(sum).times_power(flux_unit)
}

/// Below this |x| the quotient's own rounding would be seen in φ: exact products take over.
const NEARLY_PROPORTIONAL: f64 = 0.125;

/// From this x on `a φ(x) = p (ln(p/a) − 1) + a` is used, which cannot overflow.
const FAR_ABOVE: f64 = 4.0;

fn far_above(p: f64, a: f64) -> f64 {
    p * ((p / a).ln() - 1.0) + a
}

/// `D(J_kl ‖ w_k w_l)`: what a state gains with itself.
///
/// The self-term of the theorem's proof, eq. (11): `Σ_kl J_kl log2(J_kl/(w_k w_l)) − J log2(J/w²)`.
///
/// **Arguments** a square matrix in rows, and as many weights as it has rows; all finite and ≥ 0.
/// **Returns** bits times the unit of flux, ≥ 0.
/// **Accuracy** as [`divergence`].
#[must_use]
pub fn self_divergence(joint: &[Vec<f64>], weights: &[f64]) -> f64 {
    let m = weights.len();
    let scaled: Vec<Scaled> = weights.iter().map(|weight| Scaled::new(*weight)).collect();
    let (weight, _) = common_scale(&scaled);
    let entries: Vec<Scaled> = joint
        .iter()
        .flatten()
        .map(|entry| Scaled::new(*entry))
        .collect();
    let (flux, flux_unit) = common_scale(&entries);
    let (flux_sum, weight_sum) = (flux.iter().sum::<f64>(), weight.iter().sum::<f64>());
    if flux_sum <= 0.0 || weight_sum <= 0.0 {
        return 0.0;
    }
    let terms = (0..m * m)
        .filter(|kl| weight[kl / m] > 0.0 && weight[kl % m] > 0.0)
        .map(|kl| {
            let (a, b) = (weight[kl / m], weight[kl % m]);
            let share = (a / weight_sum) * (b / weight_sum);
            let quick = (flux[kl] / flux_sum) / share - 1.0;
            let x = if quick >= FAR_ABOVE {
                return far_above(flux[kl] / flux_sum, share);
            } else if quick.abs() >= NEARLY_PROPORTIONAL {
                quick
            } else {
                let total = Expansion::sum(weight.iter().copied());
                let joint = &Expansion::from(flux[kl]) * &(&total * &total);
                let product = &Expansion::from(a) * &Expansion::from(b);
                let independent = &product * &Expansion::sum(flux.iter().copied());
                (joint - &independent).to_f64() / independent.to_f64()
            };
            share * divergence_kernel(x)
        });
    Scaled::new(compensated_sum(terms) * flux_sum / LN_2).times_power(flux_unit)
}

/// The gain `ΔI = I′ − I` of a refinement, eqs. (5), (7) and the self-term of (11).
///
/// **Returns** bits, ≥ 0 by construction (Theorem 1).
#[must_use]
pub fn refinement_gain(chain: &ReversibleChain, refinement: &StateRefinement) -> f64 {
    let outward = refinement.outward();
    let pairs = compensated_sum(
        (0..chain.states())
            .filter(|j| *j != refinement.state())
            .map(|j| {
                let fluxes: Vec<f64> = outward.column(j).iter().copied().collect();
                divergence(&fluxes, refinement.weights())
            }),
    );
    let within: Vec<Vec<f64>> = refinement
        .within()
        .row_iter()
        .map(|row| row.iter().copied().collect())
        .collect();
    (2.0 * pairs + self_divergence(&within, refinement.weights())) / chain.total()
}

/// The largest gain that a regular division into `parts` can bring to a pair, eq. (6).
///
/// **Arguments** `joint`: `w_i P_ij`, in units of Σw.
/// **Returns** `2 w_i P_ij log2 m`, in bits. It is attained when all flux leaves from one part,
/// which needs `m P_ij ≤ 1`.
#[must_use]
pub fn subdivision_bound(joint: f64, parts: u32) -> f64 {
    2.0 * joint * f64::from(parts).log2()
}

/// A double as `significand · 2^exponent`, significand 0 or in [1, 2).
#[derive(Debug, Clone, Copy)]
struct Scaled {
    significand: f64,
    exponent: i32,
}

impl Scaled {
    fn new(value: f64) -> Self {
        const EXPONENT_MASK: u64 = 0x7ff << 52;
        if value <= 0.0 || !value.is_finite() {
            return Self {
                significand: value,
                exponent: 0,
            };
        }
        let (normal, shift) = if value < f64::MIN_POSITIVE {
            (value * 2f64.powi(64), -64)
        } else {
            (value, 0)
        };
        let bits = normal.to_bits();
        #[allow(clippy::cast_possible_truncation, reason = "eleven bits fit")]
        let exponent = ((bits & EXPONENT_MASK) >> 52) as i32 - 1023;
        let significand = f64::from_bits((bits & !EXPONENT_MASK) | (1023 << 52));
        Self {
            significand,
            exponent: exponent + shift,
        }
    }

    /// `value · 2^power`, correctly rounded into `f64`'s range.
    fn times_power(self, power: i32) -> f64 {
        let power = (self.exponent + power).clamp(-2200, 2200);
        // in two steps only where one power would leave the range
        if (-1022..=1023).contains(&power) {
            self.significand * 2f64.powi(power)
        } else {
            self.significand * 2f64.powi(power / 2) * 2f64.powi(power - power / 2)
        }
    }
}

/// The numbers divided by the power of two of the largest, and that power.
fn common_scale(numbers: &[Scaled]) -> (Vec<f64>, i32) {
    let positive = numbers.iter().filter(|number| number.significand > 0.0);
    let unit = positive.map(|number| number.exponent).max().unwrap_or(0);
    (
        numbers
            .iter()
            .map(|number| number.times_power(-unit))
            .collect(),
        unit,
    )
}
