//! The information of a scene's radiosity or importance chain (§3.4, §3.5), from its pairs as they
//! come.
//!
//! ```text
//!   w_i = B_i A_i H_i,   H_i = Σ_j F_ij B_j
//!   I = Σ_ij J_ij B_i B_j log2( J_ij B_i B_j W/(w_i w_j) )/W
//! ```
//!
//! W = Σw. The light in equilibrium brings the weights, so that one pass over the pairs is enough,
//! and the chain's matrix is never held.
//!
//! **Errors** to first order: with `x_ij = log2( J_ij B_i B_j W/(w_i w_j) )`,
//!
//! ```text
//!   ΔI = Σ_ij Δ(J_ij B_i B_j) (x_ij − I)/W
//!   |Δ(J_ij B_i B_j)| ≤ B_i B_j (δ_ij + J_ij (η_i + η_j))
//! ```
//!
//! δ the bounds of the exchange areas, η those of the brightnesses relative to themselves. The
//! error of the answer is an *estimate*.
//!
//! **Not covered**: what the resolution of coordinates can change, which is not known here.

use super::SceneInformation;
use super::chain::{Unit, divergence_error, pair_divergence};
use super::resolution::InformationResolution;
use crate::chain::{ChainError, in_unit};
use crate::exchange::{Closure, PairSource};
use crate::numeric::{Bounded, Scaled, compensated_sum, tolerance, x_log2_x};
use crate::transport::RadiositySolution;
use std::f64::consts::LN_2;

/// The information of a scene's chain under a brightness; light that escapes has no state in it.
///
/// **Arguments** `pairs`: those of the scene, or its stored matrix, or what a
/// [`SceneExchange`](crate::transport::SceneExchange) holds; `brightness`: their light in
/// equilibrium.
///
/// # Errors
/// As [`brightness_chain`](crate::chain::brightness_chain); [`ChainError::Exchange`] if two patches
/// are refused, or a store cannot be read.
///
/// # Examples
/// ```
/// use infoscene::information::{OpenScene, brightness_information, scene_information};
/// use infoscene::exchange::{Congruence, ScenePairs};
/// use infoscene::scene::{Occlusion, Scene};
/// use infoscene::transport::SceneExchange;
/// // with E = k (1 − R) everywhere the radiosity chain is the visibility chain (§3.4)
/// let cube = Scene::built_in("cube:2")?;
/// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Exact)?;
/// let exchange = SceneExchange::held(&pairs)?;
/// let light = exchange.system(vec![0.5; 24])?.radiosity(&[0.5; 24])?;
/// let radiosity = brightness_information(exchange.lower_pairs(), &light)?;
/// let visibility = scene_information(&pairs, OpenScene::Refuse)?;
/// let difference = radiosity.mutual_information.value - visibility.mutual_information.value;
/// assert!(difference.abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn brightness_information<'s>(
    pairs: impl Into<PairSource<'s>>,
    brightness: &RadiositySolution,
) -> Result<SceneInformation, ChainError> {
    let source = pairs.into();
    let pairs = source.pairs();
    let (lit, power) = in_unit(&brightness.values, pairs.rows())?;
    let total_area = compensated_sum(pairs.areas().iter().copied());
    let unit = Unit::of_total(total_area);
    let received = brightness.received.iter();
    let received = received.map(|received| Scaled::new(*received).times_power(power));
    let weights: Vec<f64> = lit
        .iter()
        .zip(received)
        .zip(pairs.areas())
        .map(|((lit, received), area)| lit * received * unit.times(*area))
        .collect();
    let total = compensated_sum(weights.iter().copied());
    if !(total.is_finite() && total > 0.0) {
        return Err(ChainError::NoMass { total });
    }
    let relative = relative_errors(brightness);
    let (sums, summary) = source.row_sums(|i, j, exchange| {
        let [value, bound] = [exchange.value, exchange.error];
        let [joint, moved] = [value, bound].map(|area| lit[i] * lit[j] * unit.times(area));
        let weight = weights[i] * (weights[j] / total);
        if weight <= 0.0 {
            return [value, bound, 0.0, 0.0, 0.0];
        }
        let moved = moved + joint * (relative[i] + relative[j]);
        let divergence = pair_divergence(joint, weights[i], weights[j] / total);
        let error = divergence_error(joint, moved, weight);
        [value, bound, divergence, moved, error]
    })?;
    // J = 0 where nothing is seen: φ(−1) = 1
    let unseen = pairs.unseen(&weights);
    let rows = sums.iter().zip(weights.iter().zip(unseen));
    let contributions: Vec<f64> = rows
        .map(|(sums, (weight, unseen))| (sums[2] + weight * (unseen / total)) / (total * LN_2))
        .collect();
    let mutual_information = compensated_sum(contributions.iter().copied());
    let [mass, moved] = [3, 4].map(|k| compensated_sum(sums.iter().map(|sums| sums[k])));
    let error = (moved / LN_2 + mass * (mutual_information + 1.0 / LN_2)) / total;
    let rounding = tolerance::INFORMATION * (2.0 + mutual_information);
    let weights: Vec<f64> = weights.iter().map(|weight| weight / total).collect();
    let positional_entropy = 0.0 - compensated_sum(weights.iter().map(|weight| x_log2_x(*weight)));
    Ok(SceneInformation {
        positional_entropy,
        entropy_rate: (positional_entropy - mutual_information).max(0.0),
        mutual_information: Bounded::estimate(mutual_information, error + rounding),
        resolution: (pairs.resolution() <= 0.0).then(InformationResolution::default),
        contributions,
        outside_contribution: None,
        weights,
        total_area,
        closure: Closure::of_sums(pairs, sums.iter().map(|sums| [sums[0], sums[1]])),
        summary,
    })
}

/// The relative error of each brightness: that of the solution and what form factors bring.
fn relative_errors(brightness: &RadiositySolution) -> Vec<f64> {
    let errors = brightness.form_factor_errors.as_ref();
    let values = brightness.values.iter().enumerate();
    let relative = values.map(|(i, value)| {
        let from_others = errors.map_or(0.0, |errors| errors[i]);
        if *value > 0.0 {
            brightness.relative_error + from_others / value
        } else {
            0.0
        }
    });
    relative.collect()
}
