//! §3.4 and §3.5: the chains of radiosity and importance, on cubes whose patches reflect, emit and
//! matter unevenly.

use super::lit::{Carrier, Lit};
use crate::chain::{brightness_chain, continuous_chain};
use crate::claims::{Case, ClaimError, Finding};
use crate::form_factor::RectanglePair;
use crate::information::{entropy_rate, mutual_information, positional_entropy};
use crate::numeric::{Scalar, compensated_sum, larger, largest, tolerance};
use crate::transport::RadiositySystem;
use crate::transport::walks::{Steering, Walks};

pub(crate) fn light_rows_sum_to_one(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let off = (0..lit.patches()).map(|i| {
        let row = (0..lit.patches()).map(|j| lit.transition(i, j));
        (compensated_sum(row) - 1.0).abs()
    });
    Ok(Finding::residual(largest(off), tolerance::CLOSURE))
}

/// `Σ_j w_j P_ji = w_i`.
pub(crate) fn light_weights_are_stationary(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let off = (0..lit.patches()).map(|i| {
        let inflow = (0..lit.patches()).map(|j| lit.weight(j) * lit.transition(j, i));
        (compensated_sum(inflow) / lit.weight(i) - 1.0).abs()
    });
    Ok(Finding::residual(largest(off), tolerance::CLOSURE))
}

/// `Σ_i w_i` against `Σ_ij B_i A_i F_ij B_j`, what all pairs carry.
pub(crate) fn light_weights_sum_to_normalisation(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let brightness = lit.brightness();
    let all = 0..lit.patches();
    let carried = all.clone().flat_map(|i| {
        let (lit, brightness) = (&lit, &brightness);
        all.clone()
            .map(move |j| brightness[i] * lit.exchange.get(i, j).exchange.value * brightness[j])
    });
    let carried = compensated_sum(carried);
    let weights = compensated_sum(all.clone().map(|i| lit.weight(i)));
    Ok(Finding::residual(
        (weights / carried - 1.0).abs(),
        tolerance::CLOSURE,
    ))
}

/// `w_i P_ij` against `w_j P_ji`, each direction on its own: the weights as printed, the
/// probabilities as shares of what a patch receives, `A_i F_ij` from the frame of i. They agree
/// only where the weights are what the patches receive.
pub(crate) fn light_is_reciprocal(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let brightness = lit.brightness();
    let rectangles = (0..lit.patches())
        .map(|i| lit.scene.rectangle(i))
        .collect::<Result<Vec<_>, _>>()?;
    let carried = |i: usize, j: usize| -> Result<f64, ClaimError> {
        if i == j {
            return Ok(0.0);
        }
        let pair = RectanglePair::try_new(&rectangles[i], &rectangles[j])?;
        Ok(pair.exchange_area()?.value * brightness[j])
    };
    let flow = |i: usize| -> Result<Vec<f64>, ClaimError> {
        let row = (0..lit.patches()).map(|j| carried(i, j));
        let row = row.collect::<Result<Vec<_>, _>>()?;
        let received = compensated_sum(row.iter().copied());
        let weight = lit.weight(i);
        Ok(row.iter().map(|part| weight * part / received).collect())
    };
    let flows = (0..lit.patches())
        .map(flow)
        .collect::<Result<Vec<_>, _>>()?;
    let mut worst: f64 = 0.0;
    for (i, row) in flows.iter().enumerate() {
        for (there, back) in row.iter().zip(&flows).take(i) {
            if *there > 0.0 {
                worst = larger(worst, (back[i] / there - 1.0).abs());
            }
        }
    }
    Ok(Finding::residual(worst, tolerance::CLOSURE))
}

/// Every patch in four of its light: their joint entries add up to those of the whole patches.
pub(crate) fn divided_light_adds_up(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let flaw = case.number("part_flaw")?;
    let lit = Lit::new(case)?;
    let (fine, parents) = lit.scene.subdivided(1)?;
    let exchange = fine.exchange_areas()?;
    let whole = lit.brightness();
    let brightness: Vec<f64> = parents
        .iter()
        .enumerate()
        .map(|(part, parent)| whole[*parent] * if part == 0 { 1.0 + flaw } else { 1.0 })
        .collect();
    let n = lit.patches();
    let mut sums = vec![0.0; n * n];
    for (k, from) in parents.iter().enumerate() {
        for (l, to) in parents.iter().enumerate() {
            let value = exchange.get(k, l).exchange.value;
            sums[from * n + to] += brightness[k] * value * brightness[l];
        }
    }
    let mut worst: f64 = 0.0;
    for i in 0..n {
        for j in 0..n {
            let entry = whole[i] * lit.exchange.get(i, j).exchange.value * whole[j];
            if entry > 0.0 {
                worst = larger(worst, (sums[i * n + j] / entry - 1.0).abs());
            }
        }
    }
    Ok(Finding::residual(worst, tolerance::CLOSURE))
}

/// `E(x) = k (1 − R(x))`, or `V(x) = k (1/R(x) − 1)`, with a reflectance that varies inside the
/// patches: the largest difference of `P_ij`, by quadrature, from `F_ij`. The brightness is what
/// the integral equation makes of k, from which every point of a closed scene receives k.
pub(crate) fn even_light_is_visibility(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let (level, flaw) = (case.number("level")?, case.number("flaw")?);
    let brightness = |patch: usize, at: glam::DVec3| {
        let reflectance = lit.reflectance(patch) * (1.0 - 0.5 * at.x * at.y);
        let brighter = if patch == 0 { 1.0 + flaw } else { 1.0 };
        if lit.importance.is_some() {
            let direct = brighter * level * (1.0 / reflectance - 1.0);
            reflectance * (direct + level)
        } else {
            brighter * level * (1.0 - reflectance) + reflectance * level
        }
    };
    // an even brightness is exact in any division
    let chain = continuous_chain(&lit.scene, brightness, 1e-3)?.chain;
    let mut worst: f64 = 0.0;
    for i in 0..lit.patches() {
        for j in 0..lit.patches() {
            let off = chain.transition_probability(i, j) - lit.form_factor(i, j);
            worst = larger(worst, off.abs());
        }
    }
    Ok(Finding::residual(worst, tolerance::CLOSURE))
}

/// Two patches that see only each other, one of which emits: the row sum `R_1 F_12 B/(B_1 − E_1)`
/// with B_1 in the numerator as printed, or B_2.
pub(crate) fn printed_rows_of_light(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let reflectance = case.interval("reflectance")?;
    let one = reflectance.constant(1.0);
    // E_1 = 1, E_2 = 0: B_1 = 1/(1 − R²), B_2 = R B_1
    let first = one.clone() / &(one.clone() - &reflectance.square());
    let second = reflectance.clone() * &first;
    let numerator = if case.switch("own_radiosity")? {
        first.clone()
    } else {
        second
    };
    let row = reflectance * &numerator / &(first - &one);
    let off = row - &one;
    let narrow = off.constant(1e-30);
    let (is_one, is_not) = (off.abs() < narrow, off.abs() > narrow);
    Ok(Finding::decided(is_one, is_not, off).noting(
        "with the numerator B_i as printed, two patches that see each other have row sums 2 and \
         1/2; with B_j rows sum to one and reciprocity holds",
    ))
}

/// B, E and R constant on each patch: the integral form, by quadrature, against the discrete one.
pub(crate) fn continuous_light_extends_discrete(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let slope = case.number("slope")?;
    let brightness = lit.brightness();
    let varying = |patch: usize, at: glam::DVec3| brightness[patch] * (1.0 + slope * at.x);
    let continuous = continuous_chain(&lit.scene, varying, 1e-9)?.chain;
    let mut worst: f64 = 0.0;
    for i in 0..lit.patches() {
        for j in 0..lit.patches() {
            let off = continuous.transition_probability(i, j) - lit.transition(i, j);
            worst = larger(worst, off.abs());
        }
    }
    Ok(Finding::residual(worst, tolerance::CLOSURE))
}

/// The error that rounding may leave in walks: three roundings a step in the weight, one in the
/// sum.
fn walk_rounding(walks: &Walks) -> f64 {
    4.0 * f64::from(walks.longest + 6) * f64::EPSILON
}

/// The farthest that any gathering walk was from the radiosity, relative.
pub(crate) fn null_variance_gathering(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let room = RadiositySystem::of(&lit.exchange, &lit.materials)?;
    let exact = room.radiosity(&lit.sources)?.values;
    let (count, seed) = (case.count("walks")?, case.count("seed")?.into());
    let (mut worst, mut allowed): (f64, f64) = (0.0, 0.0);
    for from in (0..lit.patches()).step_by(7) {
        let towards = Steering::Towards(lit.solution.as_slice());
        let walks = room.gathering_walks(from, &lit.sources, towards, count, seed)?;
        let off = walks.farthest + (walks.mean - exact[from]).abs();
        worst = larger(worst, off / exact[from]);
        allowed = larger(allowed, 2.0 * walk_rounding(&walks));
    }
    Ok(Finding::residual(worst, allowed).sampled())
}

/// The farthest that any shooting walk was from the power `A_k B_k`, relative, for several V = δ_k.
pub(crate) fn null_variance_shooting(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lit = Lit::new(case)?;
    let room = RadiositySystem::of(&lit.exchange, &lit.materials)?;
    let exact = room.radiosity(&lit.sources)?.values;
    let (count, seed) = (case.count("walks")?, case.count("seed")?.into());
    let flaw = case.number("walk_flaw")?;
    let (mut worst, mut allowed): (f64, f64) = (0.0, 0.0);
    for target in (0..lit.patches()).step_by(29) {
        let direct: Vec<f64> = (0..lit.patches())
            .map(|patch| f64::from(u8::from(patch == target)))
            .collect();
        let mut importance = room.importance(&direct)?;
        for value in importance.reflected.values.iter_mut().step_by(2) {
            *value *= 1.0 + flaw;
        }
        let towards = Steering::Towards(&importance);
        let walks = room.shooting_walks(&lit.sources, &direct, towards, count, seed)?;
        let power = lit.exchange.areas()[target] * exact[target];
        worst = larger(worst, walks.farthest / power);
        allowed = larger(allowed, walk_rounding(&walks));
    }
    Ok(Finding::residual(worst, allowed).sampled())
}

/// `I = H_p − H_s` of the radiosity and of the importance chain.
pub(crate) fn light_has_the_same_measures(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let mut worst: f64 = 0.0;
    for carrier in [Carrier::Radiosity, Carrier::Importance] {
        let lit = Lit::of(carrier, case)?;
        let chain = brightness_chain(&lit.exchange, &lit.brightness())?;
        let rate = case.number("rate_factor")? * entropy_rate(&chain);
        let difference = positional_entropy(&chain) - rate;
        worst = larger(worst, (mutual_information(&chain) - difference).abs());
    }
    Ok(Finding::residual(worst, tolerance::IDENTITY))
}
