//! §3.1 to §3.3: Theorem 1, the increase of a pair, and visibility.

use super::enclosed::exchange_row;
use super::section_2::cube;
use crate::chain::random::seeded::RandomChains;
use crate::chain::{ReversibleChain, visibility_chain};
use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{PatchSplit, regular_positions};
use crate::form_factor::RectanglePair;
use crate::geometry::{Rectangle, SplitAxis};
use crate::information::{divergence, mutual_information, subdivision_bound};
use crate::numeric::{
    Interval, Scalar, compensated_sum, larger, largest, real, smaller, tolerance, x_log2_ratio,
    x_log2_x,
};
use crate::scene::Scene;

/// The smallest `I′ − I`, each from its own chain by eq. (3). `dilution` mixes the refined joint
/// matrix with the independent one, which keeps its weights and breaks hypothesis (b).
pub(crate) fn theorem_1(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let dilution = case.number("dilution")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut smallest = f64::INFINITY;
    for _ in 0..case.count("chains")? {
        let refinement = random.refinement(8)?;
        let (chain, refined) = (refinement.coarse(), refinement.refined());
        let weights = refined.weights();
        let independent = |i: usize, j: usize| weights[i] * weights[j] / refined.total();
        let n = refined.states();
        let joint = nalgebra::DMatrix::from_fn(n, n, |i, j| {
            let (i, j) = (i.min(j), i.max(j)); // the same rounding on both sides
            (1.0 - dilution) * refined.joint()[(i, j)] + dilution * independent(i, j)
        });
        let diluted = ReversibleChain::try_new(joint)?;
        smallest = smaller(
            smallest,
            mutual_information(&diluted) - mutual_information(chain),
        );
    }
    let holds = smallest >= -tolerance::IDENTITY;
    Ok(Finding::statement(holds, smallest, tolerance::IDENTITY).sampled())
}

/// Patch 0 of a cube cut at `position`: `I′ − I` of the two chains against eq. (5), first line,
/// with the parts of a cut at `formula_position`.
pub(crate) fn pair_increases_add_up(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = cube(case)?;
    let chain_of = |name| -> Result<_, ClaimError> {
        Ok(visibility_chain(&scene.with_patch_split(
            0,
            SplitAxis::U,
            case.number(name)?,
        )?)?)
    };
    let (chain, refined) = (visibility_chain(&scene)?, chain_of("position")?);
    let formula = chain_of("formula_position")?;
    let (near, far) = (0, formula.states() - 1);
    let term = |chain: &ReversibleChain, i: usize, j: usize| {
        let joint = chain.joint()[(i, j)] / chain.total();
        let ratio = chain.transition_probability(i, j) / chain.stationary_probability(j);
        if joint > 0.0 {
            joint * ratio.log2()
        } else {
            0.0
        }
    };
    let increases = (1..chain.states())
        .map(|j| term(&formula, near, j) + term(&formula, far, j) - term(&chain, 0, j));
    let increase = mutual_information(&refined) - mutual_information(&chain);
    let deviation = (increase - 2.0 * compensated_sum(increases)).abs();
    Ok(Finding::residual(deviation, tolerance::IDENTITY))
}

/// Computes both lines of eq. (5) for every pair of a random refinement, the first sub-state's flux
/// times `cover`.
pub(crate) fn destination_weight_drops_out(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let cover = case.number("cover")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut worst: f64 = 0.0;
    for _ in 0..case.count("chains")? {
        let refinement = random.refinement(8)?;
        let (chain, refined) = (refinement.coarse(), refinement.refined());
        let parts = &refinement.parts()[0]; // state 0 is the divided one
        for j in 1..chain.states() {
            let line = |destination: f64| {
                let part = |k: &usize| {
                    let cover = if *k == 0 { cover } else { 1.0 };
                    let flux = cover * refined.joint()[(*k, j)];
                    x_log2_ratio(flux, refined.weights()[*k] * destination)
                };
                let whole = x_log2_ratio(chain.joint()[(0, j)], chain.weights()[0] * destination);
                compensated_sum(parts.iter().map(part)) - whole
            };
            let difference = line(chain.weights()[j]) - line(1.0);
            worst = larger(worst, 2.0 * difference.abs() / chain.total());
        }
    }
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

/// `(w/m) Σ P_k log P_k − w P log P`, w = 1, against the gain of fluxes `w_k P_k`; with
/// `lopsidedness` the first part takes that much more weight.
pub(crate) fn regular_form(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lopsidedness = case.number("lopsidedness")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut worst: f64 = 0.0;
    for _ in 0..case.count("chains")? {
        let m = random.count(2, 8);
        let transitions = random.numbers(m);
        let mut weights = vec![1.0; m];
        weights[0] += lopsidedness;
        let total: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= total);
        let fluxes: Vec<f64> = transitions
            .iter()
            .zip(&weights)
            .map(|(p, w)| p * w)
            .collect();
        let whole: f64 = fluxes.iter().sum();
        let parts = compensated_sum(transitions.iter().map(|p| x_log2_x(*p))) / real(m);
        let regular = parts - x_log2_x(whole);
        worst = larger(worst, (regular - divergence(&fluxes, &weights)).abs());
    }
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

/// Random fluxes of m equal parts; with `lopsidedness` the first part takes that much less weight.
pub(crate) fn subdivision_bound_holds(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let lopsidedness = case.number("lopsidedness")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut largest_ratio: f64 = 0.0;
    for _ in 0..case.count("draws")? {
        let count = random.count(2, 5);
        let fluxes = random.numbers(count);
        let mut weights = vec![1.0; fluxes.len()];
        weights[0] -= lopsidedness;
        let joint = compensated_sum(fluxes.iter().copied());
        let parts = u32::try_from(fluxes.len()).unwrap_or(u32::MAX);
        let ratio = 2.0 * divergence(&fluxes, &weights) / subdivision_bound(joint, parts);
        largest_ratio = larger(largest_ratio, ratio);
    }
    let holds = largest_ratio <= 1.0 + tolerance::GAIN;
    Ok(Finding::statement(holds, largest_ratio, tolerance::GAIN).sampled())
}

/// One of m parts keeps all the flux but `leak` of it; then its own P is `m P_ij`, at most 1.
pub(crate) fn subdivision_bound_is_attained(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let leak = case.number("leak")?;
    let deviations = (2..=16u32).map(|parts| {
        let probability = 0.9 / f64::from(parts); // m P_ij = 0.9
        let joint = probability; // w_i = 1
        let others = leak * joint / f64::from(parts - 1);
        let mut fluxes = vec![others; parts as usize];
        fluxes[0] = (1.0 - leak) * joint;
        let weights = vec![1.0 / f64::from(parts); parts as usize];
        let gain = 2.0 * divergence(&fluxes, &weights) / subdivision_bound(joint, parts);
        let own = fluxes[0] / weights[0] / (f64::from(parts) * probability);
        larger((gain - 1.0).abs(), (own - 1.0).abs())
    });
    let note = "a sub-state cannot keep more than its own weight, so the bound is out of reach \
                where m P_ij > 1";
    Ok(Finding::residual(largest(deviations), tolerance::GAIN).noting(note))
}

pub(crate) fn bounds_sum_to_weight(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let chain = visibility_chain(&cube(case)?)?;
    bounds_sum_to(&chain, case, |i| chain.stationary_probability(i))
}

pub(crate) fn bounds_sum_to_area(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = cube(case)?;
    let chain = visibility_chain(&scene)?;
    bounds_sum_to(&chain, case, |i| {
        scene.patches()[i].shape().area() / scene.total_area()
    })
}

/// `Σ_j 2 w_i P_ij log2 m` against `2 w_i log2 m`, the weights from elsewhere.
fn bounds_sum_to(
    chain: &ReversibleChain,
    case: &Case<'_>,
    weight: impl Fn(usize) -> f64,
) -> Result<Finding, ClaimError> {
    let (parts, formula_parts) = (case.count("parts")?, case.count("formula_parts")?);
    let deviations = (0..chain.states()).map(|i| {
        let row = chain.joint().column(i);
        let bounds = row
            .iter()
            .map(|joint| subdivision_bound(joint / chain.total(), parts));
        let total = 2.0 * weight(i) * f64::from(formula_parts).log2();
        (compensated_sum(bounds) / total - 1.0).abs()
    });
    Ok(Finding::residual(largest(deviations), tolerance::CLOSURE))
}

/// The most that a face of a box of cells can gain by a regular division into `parts`, over
/// `2 w_i log2 m`, from the form factors of the first patch.
///
/// ```text
///   gain of a pair ≤ 2 w P_ij min( log2 m, −log2 P_ij ),   as a part's own P ≤ 1
/// ```
pub(crate) fn printed_total_is_a_maximum(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = cube(case)?;
    let like = Interval::precise(1.0, case.bits());
    let parts = like.constant(f64::from(case.count("parts")?)).ln();
    let area = like.constant(scene.rectangle(0)?.area());
    let mut reached = like.zero();
    for [exchange, _] in exchange_row(&scene, 0, &like)? {
        if exchange.is_zero() {
            continue;
        }
        let probability = exchange / &area;
        let own = -probability.ln();
        let most = if own < parts { own } else { parts.clone() };
        reached = reached + &(probability * &most);
    }
    let ratio = reached / &parts;
    let note = format!(
        "as an upper bound it holds; where some m P_ij > 1, as for {} parts, it is out of reach",
        case.count("parts")?
    );
    Ok(Finding::refuted_if(ratio < like, ratio).noting(note))
}

pub(crate) fn largest_weight_has_largest_potential(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let power = case.number("power")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let count = case.count("chains")?;
    let mut agreeing = 0;
    for _ in 0..count {
        let refinement = random.refinement(8)?;
        let chain = refinement.coarse();
        let potential = |i: usize| {
            compensated_sum(
                chain
                    .joint()
                    .column(i)
                    .iter()
                    .map(|joint| subdivision_bound(*joint, 2)),
            )
        };
        let heaviest = argmax(chain.states(), |i| chain.weights()[i].powf(power));
        agreeing += u32::from(heaviest == argmax(chain.states(), potential));
    }
    let share = f64::from(agreeing) / f64::from(count);
    Ok(Finding::statement(agreeing == count, share, 0.0).sampled())
}

fn argmax(count: usize, value: impl Fn(usize) -> f64) -> usize {
    (0..count).fold(0, |best, i| if value(i) > value(best) { i } else { best })
}

/// (a) `A_k F_kj = A_j F_jk`, each from its own side; (b) `Σ_k A_k F_kj = A_i F_ij`, with a `gap`
/// left between the parts.
pub(crate) fn split_patches_fulfil_the_hypotheses(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = cube(case)?;
    let (position, gap) = (case.number("position")?, case.number("gap")?);
    let first = scene.rectangle(0)?;
    let mut worst: f64 = 0.0;
    for j in 1..scene.patches().len() {
        let other = scene.rectangle(j)?;
        let exchange = |a: &Rectangle, b: &Rectangle| -> Result<f64, ClaimError> {
            Ok(RectanglePair::try_new(a, b)?.exchange_area()?.value)
        };
        let whole = exchange(&first, &other)?;
        if whole <= 0.0 {
            continue;
        }
        for axis in SplitAxis::ALL {
            let parts = [
                first.part(axis, 0.0, position)?,
                first.part(axis, position + gap, 1.0)?,
            ];
            let mut sum = 0.0;
            for part in &parts {
                let (there, back) = (exchange(part, &other)?, exchange(&other, part)?);
                worst = larger(worst, (there - back).abs() / whole);
                sum += there;
            }
            worst = larger(worst, (sum / whole - 1.0).abs());
        }
    }
    Ok(Finding::residual(worst, tolerance::CLOSURE))
}

/// Regular divisions of the squares of figs. 2 and 3 into up to `parts`, against the bound for
/// `formula_parts/parts` times as many.
pub(crate) fn visibility_bound_holds(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let parts = case.count("parts")?;
    let formula = case.number("formula_parts")?.log2() / f64::from(parts).log2();
    let mut largest_ratio: f64 = 0.0;
    for name in ["two-squares", "three-squares"] {
        let scene = Scene::built_in(name)?;
        let against: Vec<usize> = (1..scene.patches().len()).collect();
        for axis in SplitAxis::ALL {
            let split = PatchSplit::try_new(&scene, 0, &against, axis)?;
            for m in 2..=parts {
                let bound = formula * split.maximum_gain(m)?;
                largest_ratio = larger(largest_ratio, split.gain(&regular_positions(m))? / bound);
            }
        }
    }
    Ok(Finding::statement(
        largest_ratio <= 1.0,
        largest_ratio,
        tolerance::GAIN,
    ))
}
