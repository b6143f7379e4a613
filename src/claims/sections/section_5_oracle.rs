//! §5: the steps of the oracle as statements about one pair of patches.
//!
//! With W_i = A_i B_i (B_i − E_i)/R_i the generalised areas, Σw their sum and g = Σ_k |flux share −
//! weight share| of the parts,
//!
//! ```text
//!   step 1   potential ≤ ε₁  ⇒  gain ≤ 2 ε₁ log2 m / Σw                    (6)
//!   step 2   the bounds Σ_j 2 w_i P_ij log2 m are ordered as the W_i
//!   step 3   gain ≥ w_i P_ij g² / ln 2                                      Pinsker
//! ```
//!
//! **Not covered**: what the steps are worth in a refinement.

use super::lit::Lit;
use crate::chain::brightness_chain;
use crate::chain::random::seeded::RandomChains;
use crate::claims::{Case, ClaimError, Finding};
use crate::form_factor::RectanglePair;
use crate::information::{divergence, subdivision_bound};
use crate::numeric::{compensated_sum, larger, largest, smaller, tolerance};
use std::f64::consts::LN_2;

/// `Σ_j B_i B_j A_i F_ij` against `A_i B_i (B_i − E_i)/R_i`.
pub(crate) fn potentials_sum_to_generalised_area(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let off = (0..lit.patches()).map(|i| {
        let potentials = (0..lit.patches()).map(|j| lit.potential(i, j));
        (compensated_sum(potentials) / lit.weight(i) - 1.0).abs()
    });
    Ok(Finding::residual(largest(off), tolerance::CLOSURE))
}

/// `2 B_i B_j A_i F_ij log2 m` over Σw, the sum of the weights as printed, against the bound (6) of
/// the chain.
pub(crate) fn printed_maximum_is_proportional(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let chain = brightness_chain(&lit.exchange, &lit.brightness())?;
    let total = compensated_sum((0..lit.patches()).map(|i| lit.weight(i)));
    let parts = case.count("parts")?;
    let mut worst: f64 = 0.0;
    for i in 0..lit.patches() {
        for j in 0..lit.patches() {
            let printed = 2.0 * lit.potential(i, j) * f64::from(parts).log2();
            let bound = subdivision_bound(chain.joint()[(i, j)] / chain.total(), parts);
            if bound > 0.0 {
                worst = larger(worst, (printed / total / bound - 1.0).abs());
            }
        }
    }
    Ok(Finding::residual(worst, tolerance::CLOSURE))
}

/// The spread of the bound (6) over `B_i B_j A_i F_ij` from pair to pair, relative; with
/// `without_receiver` B_j is left out.
pub(crate) fn maximum_is_proportional_to_potential(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let chain = brightness_chain(&lit.exchange, &lit.brightness())?;
    let is_without = case.switch("without_receiver")?;
    let (mut least, mut most): (f64, f64) = (f64::INFINITY, 0.0);
    for i in 0..lit.patches() {
        for j in 0..lit.patches() {
            let receiver = if is_without { lit.solution[j] } else { 1.0 };
            let potential = lit.potential(i, j) / receiver;
            if potential > 0.0 {
                let ratio = subdivision_bound(chain.joint()[(i, j)], 2) / potential;
                (least, most) = (smaller(least, ratio), larger(most, ratio));
            }
        }
    }
    Ok(Finding::residual(most / least - 1.0, tolerance::CLOSURE))
}

/// Random regular divisions of every pair, and those that leave all the flux to one part: the
/// largest gain of a pair of potential ε₁ over `2 ε₁ log2 m/Σw`. With `lopsidedness` the first
/// part, which keeps the flux, takes that much less area.
pub(crate) fn discarded_pairs_gain_little(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let total = compensated_sum((0..lit.patches()).map(|i| lit.weight(i)));
    let lopsidedness = case.number("lopsidedness")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut largest_ratio: f64 = 0.0;
    for i in 0..lit.patches() {
        for j in 0..lit.patches() {
            let potential = lit.potential(i, j);
            if potential <= 0.0 {
                continue;
            }
            let count = random.count(2, 8);
            let mut weights = vec![1.0; count];
            weights[0] -= lopsidedness;
            let mut concentrated = vec![0.0; count];
            concentrated[0] = 1.0;
            let parts = u32::try_from(count).unwrap_or(u32::MAX);
            let allowed = 2.0 * potential * f64::from(parts).log2() / total;
            for shares in [random.numbers(count), concentrated] {
                let sum: f64 = shares.iter().sum();
                let fluxes: Vec<f64> = shares.iter().map(|x| potential * x / sum).collect();
                let gain = 2.0 * divergence(&fluxes, &weights) / total;
                largest_ratio = larger(largest_ratio, gain / allowed);
            }
        }
    }
    let holds = largest_ratio <= 1.0 + tolerance::GAIN;
    Ok(Finding::statement(holds, largest_ratio, tolerance::GAIN).sampled())
}

/// The share of pairs of patches whose bounds on the gain, summed over all others, are ordered as
/// their generalised areas.
pub(crate) fn larger_area_has_larger_bound(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let bound = |i: usize| {
        let bounds = (0..lit.patches()).map(|j| subdivision_bound(lit.potential(i, j), 4));
        compensated_sum(bounds)
    };
    let bounds: Vec<f64> = (0..lit.patches()).map(bound).collect();
    let (mut pairs, mut ordered) = (0_u32, 0_u32);
    for i in 0..lit.patches() {
        for j in 0..i {
            pairs += 1;
            let by_area = lit.weight(i).total_cmp(&lit.weight(j));
            ordered += u32::from(by_area == bounds[i].total_cmp(&bounds[j]));
        }
    }
    let share = f64::from(ordered) / f64::from(pairs);
    Ok(Finding::statement(ordered == pairs, share, 0.0).sampled())
}

/// The largest relative difference of the potentials of i and of j for one pair, `B_i B_j A_i F_ij`
/// and `B_j B_i A_j F_ji`, each from its own side: the one picked has the higher one if there is
/// any. The control makes the second larger by `area_factor`.
pub(crate) fn picked_patch_has_higher_potential(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let worst = largest_deviation(&lit, case, |[i, j], [there, back]| {
        let [own, other] =
            [there, back].map(|exchange| lit.solution[i] * lit.solution[j] * exchange);
        (other / own - 1.0).abs()
    })?;
    let holds = worst > tolerance::CLOSURE;
    let note = "of one pair the potential of either patch is the same, by reciprocity; summed over \
                all pairs it is the generalised area (s5-step-2)";
    Ok(Finding::statement(holds, worst, tolerance::CLOSURE).noting(note))
}

/// The potential `B_i B_j A_i F_ij` from the side of i against `B_i/R_i` times the quantity of the
/// power oracle from that of j, `B_j R_i A_j F_ji`.
pub(crate) fn potential_is_power_times_ratio(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let worst = largest_deviation(&lit, case, |[i, j], [there, back]| {
        let potential = lit.solution[i] * lit.solution[j] * there;
        let power = lit.solution[j] * lit.reflectance(i) * back;
        (lit.solution[i] / lit.reflectance(i) * power / potential - 1.0).abs()
    })?;
    let note = "the factor B_i/R_i differs from patch to patch, so that the two oracles order \
                pairs differently: it is an analogy and no more";
    Ok(Finding::residual(worst, tolerance::CLOSURE).noting(note))
}

/// The largest of a deviation over all pairs of a lit cube that see each other, given `A_i F_ij`
/// and `A_j F_ji`, each from its own side, the second times `area_factor`.
fn largest_deviation(
    lit: &Lit,
    case: &Case<'_>,
    deviation: impl Fn([usize; 2], [f64; 2]) -> f64,
) -> Result<f64, ClaimError> {
    let factor = case.number("area_factor")?;
    let mut worst: f64 = 0.0;
    for i in 0..lit.patches() {
        for j in 0..i {
            let (first, second) = (lit.scene.rectangle(i)?, lit.scene.rectangle(j)?);
            let there = RectanglePair::try_new(&first, &second)?.exchange_area()?;
            let back = RectanglePair::try_new(&second, &first)?.exchange_area()?;
            if there.value > 0.0 {
                let found = deviation([i, j], [there.value, factor * back.value]);
                worst = larger(worst, found);
            }
        }
    }
    Ok(worst)
}

/// Random and nearly even divisions into 2 to 8 parts: the smallest gain over `factor · wP g²/ln
/// 2`, which two halves that differ little reach.
pub(crate) fn gradient_guarantees_gain(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let factor = case.number("factor")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut smallest = f64::INFINITY;
    for draw in 0..case.count("draws")? {
        let (weights, mut fluxes) = match draw % 8 {
            0 => (vec![1.0, 1.0], vec![1.0 + 1e-3, 1.0 - 1e-3]),
            _ => {
                let count = random.count(2, 8);
                let weights: Vec<f64> = random.numbers(count).iter().map(|w| w + 1e-3).collect();
                (weights, random.numbers(count))
            }
        };
        let (weight, flux): (f64, f64) = (weights.iter().sum(), fluxes.iter().sum());
        fluxes.iter_mut().for_each(|part| *part /= flux);
        let apart = fluxes
            .iter()
            .zip(&weights)
            .map(|(f, w)| (f - w / weight).abs());
        let gradient = compensated_sum(apart);
        let gain = 2.0 * divergence(&fluxes, &weights);
        if gradient > 0.0 {
            smallest = smaller(smallest, gain / (factor * gradient * gradient / LN_2));
        }
    }
    let holds = smallest >= 1.0 - tolerance::GAIN;
    Ok(Finding::statement(holds, smallest, tolerance::GAIN).sampled())
}

/// Two halves with form factors F (1 ± g), g from 0 to 1, and random divisions into 2 to 8 parts
/// with `F (1 + g d_k)`, Σ w_k d_k = 0: the smallest step of the gain as g grows, relative to the
/// gain in the middle. With `flux_loss` the total falls as g grows.
pub(crate) fn gain_grows_with_gradient(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let loss = case.number("flux_loss")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut curve = Vec::new();
    let mut smallest = f64::INFINITY;
    for draw in 0..case.count("draws")? {
        let (weights, directions) = if draw == 0 {
            (vec![1.0, 1.0], vec![1.0, -1.0])
        } else {
            let count = random.count(2, 8);
            let weights: Vec<f64> = random.numbers(count).iter().map(|w| w + 1e-2).collect();
            let directions = random.numbers(count);
            (weights.clone(), centred(&weights, directions))
        };
        let gain = |g: f64| {
            let flux = 1.0 - loss * g;
            let parts = weights.iter().zip(&directions);
            let fluxes: Vec<f64> = parts.map(|(w, d)| flux * w * (1.0 + g * d)).collect();
            divergence(&fluxes, &weights)
        };
        let gains: Vec<[f64; 2]> = (0..=100)
            .map(|k| f64::from(k) / 100.0)
            .map(|g| [g, gain(g)])
            .collect();
        let steps = gains.windows(2).map(|pair| pair[1][1] - pair[0][1]);
        smallest = smaller(smallest, steps.fold(f64::INFINITY, smaller) / gain(0.5));
        if draw == 0 {
            curve = gains;
        }
    }
    let finding = Finding::statement(smallest > 0.0, smallest, tolerance::GAIN);
    Ok(finding.sampled().with_curve(curve))
}

/// Directions whose weighted mean is 0 and whose lowest is −1, so that no flux is negative; those
/// of equal numbers are turned.
fn centred(weights: &[f64], mut directions: Vec<f64>) -> Vec<f64> {
    directions[0] += 0.5;
    let weight: f64 = weights.iter().sum();
    let mean = weights
        .iter()
        .zip(&directions)
        .map(|(w, d)| w * d)
        .sum::<f64>()
        / weight;
    directions.iter_mut().for_each(|d| *d -= mean);
    let lowest = directions.iter().copied().fold(0.0, smaller);
    directions.iter_mut().for_each(|d| *d /= -lowest);
    directions
}
