//! §2: the visibility chain and its measures.

use crate::chain::random::seeded::RandomChains;
use crate::chain::visibility_chain;
use crate::claims::{Case, ClaimError, Finding};
use crate::form_factor::RectanglePair;
use crate::information::{entropy_rate, mutual_information, positional_entropy};
use crate::numeric::{compensated_sum, larger, largest, tolerance, x_log2_x};
use crate::scene::Scene;
use nalgebra::{DMatrix, DVector};

pub(crate) fn cube(case: &Case<'_>) -> Result<Scene, ClaimError> {
    Ok(Scene::built_in(&format!("cube:{}", case.count("cells")?))?)
}

/// X⁰ in state 0, then `Xᵏ⁺¹ = Xᵏ P`.
pub(crate) fn walk_converges(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let chain = visibility_chain(&cube(case)?)?;
    let n = chain.states();
    let transitions = DMatrix::from_fn(n, n, |i, j| chain.transition_probability(i, j));
    let mut probabilities = DVector::zeros(n);
    probabilities[0] = 1.0;
    for _ in 0..case.count("steps")? {
        probabilities = transitions.tr_mul(&probabilities);
    }
    let left = (0..n).map(|i| (probabilities[i] - chain.stationary_probability(i)).abs());
    Ok(Finding::residual(largest(left), tolerance::CLOSURE))
}

/// `Σ_j w_j F_ji = w_i` with `w_i = A_i/A_T`, i.e. `Σ_j A_j F_ji = A_i`.
pub(crate) fn areas_are_stationary(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = cube(case)?;
    let factor = case.number("area_factor")?;
    let exchange = scene.exchange_areas()?.into_values();
    let deviations = scene.patches().iter().enumerate().map(|(i, patch)| {
        let inflow = compensated_sum(exchange.column(i).iter().copied());
        (inflow / (factor * patch.shape().area()) - 1.0).abs()
    });
    Ok(Finding::residual(largest(deviations), tolerance::CLOSURE))
}

/// `A_i F_ij` from the frame of i against `A_j F_ji` from the frame of j.
pub(crate) fn form_factors_are_reciprocal(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let scene = cube(case)?;
    let factor = case.number("area_factor")?;
    let mut worst: f64 = 0.0;
    for i in 0..scene.patches().len() {
        for j in 0..i {
            let (first, second) = (scene.rectangle(i)?, scene.rectangle(j)?);
            let there = RectanglePair::try_new(&first, &second)?
                .exchange_area()?
                .value;
            let back = factor
                * RectanglePair::try_new(&second, &first)?
                    .exchange_area()?
                    .value;
            if there > 0.0 {
                worst = larger(worst, (back / there - 1.0).abs());
            }
        }
    }
    Ok(Finding::residual(worst, tolerance::CLOSURE))
}

pub(crate) fn information_is_a_difference(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let chain = visibility_chain(&cube(case)?)?;
    let difference =
        positional_entropy(&chain) - case.number("rate_factor")? * entropy_rate(&chain);
    let deviation = (mutual_information(&chain) - difference).abs();
    Ok(Finding::residual(deviation, tolerance::IDENTITY))
}

/// `H(w) − Σ_i w_i H(next | i)` against `H(w) − Σ_j w_j H(previous | j)`; with `skew` the flow from
/// i to j < i is made larger than the flow back, so that reciprocity fails.
pub(crate) fn information_is_mutual(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let skew = case.number("skew")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut worst: f64 = 0.0;
    for _ in 0..case.count("chains")? {
        let refinement = random.refinement(8)?;
        let chain = refinement.coarse();
        let n = chain.states();
        let flow =
            |i: usize, j: usize| chain.joint()[(i, j)] * if j < i { 1.0 + skew } else { 1.0 };
        let weight: Vec<f64> = (0..n).map(|i| (0..n).map(|j| flow(i, j)).sum()).collect();
        let total: f64 = weight.iter().sum();
        // entropy of a row of numbers that should sum to w
        let conditional = |row: Vec<f64>, w: f64| -> f64 {
            if w > 0.0 {
                row.iter().map(|x| -w * x_log2_x(x / w)).sum()
            } else {
                0.0
            }
        };
        let next: f64 = (0..n)
            .map(|i| conditional((0..n).map(|j| flow(i, j)).collect(), weight[i]))
            .sum();
        let previous: f64 = (0..n)
            .map(|j| conditional((0..n).map(|i| flow(i, j)).collect(), weight[j]))
            .sum();
        worst = larger(worst, (next - previous).abs() / total);
    }
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}
