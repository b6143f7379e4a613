//! The gain in mutual information when states are refined: equations (5) to (7).
//!
//! ```text
//!   ΔI = (1/ΣJ) Σ_ij D( J′_kl, k ∈ i, l ∈ j ‖ w_k w_l )
//!   D(J ‖ a b) = J Σ_kl p_kl log2( p_kl/(a_k b_l) ) = J Σ_kl a_k b_l φ(x_kl)/ln 2,
//!   p_kl = J_kl/J,  a, b: shares of the weights,  x = p/(a b) − 1,  φ(x) = (1+x) ln(1+x) − x ≥ 0
//! ```
//!
//! over the pairs of states of which one at least is divided; the pair of a divided state with
//! itself is the self-term of the theorem's proof, eq. (11). Each term is ≥ 0, so ΔI ≥ 0 in
//! floating point too, and it is never the difference of two mutual informations. Where p and ab
//! nearly agree, `x = (J_kl A B − J a_k b_l)/(J a_k b_l)` is taken from exact sums and products, so
//! the gain keeps its relative precision however small it is.
//!
//! **Not covered**: relative precision where an entry is below 1e-290 of the largest; an absolute
//! error of [`tolerance::TINY_GAIN`](crate::numeric::tolerance::TINY_GAIN) bits remains.

use super::chain::LOGARITHMIC_FROM;
use crate::chain::Refinement;
use crate::numeric::functions::elementary::{ln, ln_1p, log2};
use crate::numeric::{Expansion, Scalar, Scaled, common_scale, compensated_sum, divergence_kernel};
use std::cell::OnceCell;
use std::f64::consts::LN_2;

/// The divergence `D(J ‖ w)`: the gain of a pair in one direction when its flux `ΣJ_k` is divided
/// among sub-states.
///
/// Half of eq. (5), before division by Σw: for fluxes `J_k = w_k P_kj` it is
/// `Σ_k J_k log2 P_kj − J log2 P_ij`.
///
/// **Arguments** as many fluxes as weights (the shorter list counts), all finite and ≥ 0; where a
/// weight is 0 so is the flux.
/// **Returns** bits times the unit of flux, ≥ 0; 0 exactly if the fluxes are proportional to the
/// weights.
/// **Accuracy** within [`GAIN`](crate::numeric::tolerance::GAIN) of the value for the given
/// numbers, taken as exact, as long as they are 0 or ≥ 1e-290 of the largest: measured against 256
/// bits by `divergence_is_non_negative_and_accurate`.
///
/// # Examples
/// ```
/// use infoscene::information::divergence;
/// assert_eq!(divergence(&[1.0, 1.0], &[1.0, 1.0]), 0.0);
/// assert_eq!(divergence(&[1.0, 0.0], &[1.0, 1.0]), 1.0); // all the flux to one of two halves
/// ```
#[must_use]
pub fn divergence(fluxes: &[f64], weights: &[f64]) -> f64 {
    let exact = |k: usize| Expansion::from(weights[k]);
    let count = fluxes.len().min(weights.len());
    let rows = PartWeights::new(&weights[..count], &exact);
    let (value, unit) = block_divergence(&|k, _| fluxes[k], &rows, &PartWeights::whole());
    Scaled::new(value).times_power(unit)
}

/// The divergence `D(J ‖ w)` in any number type, over intervals an enclosure.
///
/// [`divergence`] takes doubles as exact, and keeps its digits where known fluxes are nearly
/// proportional; this function is for fluxes that were themselves computed.
///
/// **Arguments** `flux` and `weight`: the sums over the parts; `parts`: flux and weight of each,
/// weights > 0.
/// **Returns** bits times the unit of flux.
#[must_use]
pub fn relative_entropy<S: Scalar>(flux: &S, weight: &S, parts: &[[S; 2]]) -> S {
    let nats = parts.iter().fold(flux.zero(), |sum, [part, share]| {
        // x = (J_k/J)/(w_k/w) − 1
        let x = part.clone() * weight / &(share.clone() * flux) - &flux.constant(1.0);
        sum + &(x.divergence_kernel() * share)
    });
    nats * flux / &(weight.constant(2.0).ln() * weight)
}

/// The gain `ΔI = I′ − I` of a refinement, eqs. (5), (7) and (11).
///
/// **Returns** bits, ≥ 0 by construction (Theorem 1); 0 exactly if every division is proportional.
/// **Accuracy** within [`GAIN`](crate::numeric::tolerance::GAIN) of the value for the refined joint
/// entries, taken as exact, wherever the smallest positive one is ≥ 1e-290 of their sum.
#[must_use]
pub fn refinement_gain(refinement: &Refinement) -> f64 {
    let refined = refinement.refined();
    let joint = refined.joint();
    let sums: Vec<OnceCell<Expansion>> = vec![OnceCell::new(); refined.states()];
    let exact_weight = |k: usize| {
        sums[k]
            .get_or_init(|| Expansion::sum(joint.column(k).iter().copied()))
            .clone()
    };
    let parts = refinement.parts();
    let exact: Vec<_> = parts
        .iter()
        .map(|parts| |k: usize| exact_weight(parts[k]))
        .collect();
    let sides: Vec<PartWeights<'_>> = parts
        .iter()
        .zip(&exact)
        .map(|(parts, exact)| match parts.as_slice() {
            [_] => PartWeights::whole(),
            parts => {
                let weights: Vec<f64> = parts.iter().map(|k| refined.weights()[*k]).collect();
                PartWeights::new(&weights, exact)
            }
        })
        .collect();
    // relative to the total, so that a small gain of small entries does not underflow on the way
    let total = Scaled::new(refined.total());
    let mut terms = Vec::new();
    for i in 0..parts.len() {
        for j in 0..=i {
            if parts[i].len() > 1 || parts[j].len() > 1 {
                let entry = |k: usize, l: usize| joint[(parts[i][k], parts[j][l])];
                let both_ways = if i == j { 1.0 } else { 2.0 };
                let (value, unit) = block_divergence(&entry, &sides[i], &sides[j]);
                terms.push(both_ways * Scaled::new(value).times_power(unit - total.exponent));
            }
        }
    }
    compensated_sum(terms) / total.significand
}

/// The weights of the parts of one state of a pair.
struct PartWeights<'w> {
    scaled: Vec<Scaled>,
    /// The weights in units of a power of two near the largest.
    values: Vec<f64>,
    unit: i32,
    sum: f64,
    exact: &'w dyn Fn(usize) -> Expansion,
    /// Each weight in its own power of two, once it is needed.
    exact_own: Vec<OnceCell<Expansion>>,
    exact_sum: OnceCell<Expansion>,
}

impl<'w> PartWeights<'w> {
    fn new(weights: &[f64], exact: &'w dyn Fn(usize) -> Expansion) -> Self {
        let scaled: Vec<Scaled> = weights.iter().map(|weight| Scaled::new(*weight)).collect();
        let (values, unit) = common_scale(&scaled);
        let sum = compensated_sum(values.iter().copied());
        Self {
            scaled,
            values,
            unit,
            sum,
            exact,
            exact_own: vec![OnceCell::new(); weights.len()],
            exact_sum: OnceCell::new(),
        }
    }

    /// The side of a state that is not divided.
    fn whole() -> Self {
        Self::new(&[1.0], &|_| Expansion::from(1.0))
    }

    fn share(&self, k: usize) -> f64 {
        self.values[k] / self.sum
    }

    /// The power of two of weight `k`, relative to the unit.
    fn power(&self, k: usize) -> i32 {
        self.scaled[k].exponent - self.unit
    }

    /// Weight `k` in its own power of two.
    fn exact(&self, k: usize) -> &Expansion {
        self.exact_own[k].get_or_init(|| (self.exact)(k).times_power(-self.scaled[k].exponent))
    }

    /// All weights in units.
    fn exact_sum(&self) -> &Expansion {
        self.exact_sum.get_or_init(|| {
            (0..self.values.len())
                .map(|k| (self.exact)(k).times_power(-self.unit))
                .fold(Expansion::sum([]), |sum, weight| sum + &weight)
        })
    }
}

/// The |x| below which exact products are used: (a) there the rounding of the quotient, some ε, is
/// more than 8 ε of x, and twice that of φ.
const NEARLY_PROPORTIONAL: f64 = 0.125;

/// `J Σ_kl a_k b_l φ(x_kl)/ln 2` for the parts of two states, as a number and a power of two.
fn block_divergence(
    joint: &dyn Fn(usize, usize) -> f64,
    rows: &PartWeights<'_>,
    columns: &PartWeights<'_>,
) -> (f64, i32) {
    let (m, n) = (rows.values.len(), columns.values.len());
    let entries: Vec<Scaled> = (0..m * n)
        .map(|kl| Scaled::new(joint(kl / n, kl % n)))
        .collect();
    let (fluxes, unit) = common_scale(&entries);
    let flux = compensated_sum(fluxes.iter().copied());
    if flux <= 0.0 {
        return (0.0, 0);
    }
    let exact_flux = OnceCell::new();
    let flux_of_rows = vec![OnceCell::new(); m];
    let positive = |kl: &usize| rows.values[kl / n] > 0.0 && columns.values[kl % n] > 0.0;
    let terms = (0..m * n).filter(positive).map(|kl| {
        let (k, l) = (kl / n, kl % n);
        let (a, b) = (rows.share(k), columns.share(l));
        // in the parts' own powers of two, so that tiny ones keep their digits
        let own_flux = entries[kl].times_power(-unit - rows.power(k) - columns.power(l));
        let [own_row, own_column] = [rows.scaled[k].significand, columns.scaled[l].significand];
        let independent = flux * own_row * own_column;
        let quick = own_flux * rows.sum * columns.sum / independent - 1.0;
        let x = if quick >= LOGARITHMIC_FROM {
            let p = fluxes[kl] / flux;
            let log_ratio = if quick.is_finite() {
                ln_1p(quick)
            } else {
                let sums = ln(rows.sum * columns.sum / flux);
                let exponents = rows.unit + columns.unit - unit;
                entries[kl].ln() - rows.scaled[k].ln() - columns.scaled[l].ln()
                    + sums
                    + f64::from(exponents) * LN_2
            };
            // p is 0 where the flux is too small to change that of the block
            return p * (log_ratio - 1.0) + a * b;
        } else if quick.abs() >= NEARLY_PROPORTIONAL {
            quick
        } else {
            let flux = exact_flux.get_or_init(|| Expansion::sum(fluxes.iter().copied()));
            let cross = &(&Expansion::from(own_flux) * rows.exact_sum()) * columns.exact_sum();
            let row = flux_of_rows[k].get_or_init(|| flux * rows.exact(k));
            let other = row * columns.exact(l);
            (cross - &other).to_f64() / independent
        };
        a * b * divergence_kernel(x)
    });
    (compensated_sum(terms) * flux / LN_2, unit)
}

/// The largest gain that a regular division into `parts` can bring to a pair, eq. (6).
///
/// **Arguments** `joint`: `w_i P_ij`, in units of Σw; `parts` ≥ 1.
/// **Returns** `2 w_i P_ij log2 m`, in bits. It is attained when all flux leaves from one part,
/// which needs `m P_ij ≤ 1`.
#[must_use]
pub fn subdivision_bound(joint: f64, parts: u32) -> f64 {
    2.0 * joint * log2(f64::from(parts))
}
