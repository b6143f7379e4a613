//! The information of a scene's radiosity or importance chain (§3.4, §3.5).
//!
//! **Errors** to first order: with `x_ij = log2( J_ij W/(w_i w_j) )`, W = ΣJ,
//!
//! ```text
//!   ΔI = Σ_ij ΔJ_ij (x_ij − I)/W,    |ΔJ_ij| ≤ β_i β_j δ_ij + J_ij (η_i + η_j)
//! ```
//!
//! δ the bounds of the exchange areas, η those of the brightnesses relative to themselves. The
//! error of the answer is an *estimate*.
//!
//! **Not covered**: what the resolution of coordinates can change, which is not known here.

use super::SceneInformation;
use super::chain::{divergence_error, pair_divergence, positional_entropy};
use super::resolution::InformationResolution;
use crate::chain::{ChainError, brightness_chain};
use crate::exchange::{Closure, ExchangeAreas};
use crate::numeric::{Bounded, compensated_sum, parallel_map, tolerance};
use crate::transport::RadiositySolution;
use std::f64::consts::LN_2;

/// The information of a scene's chain under a brightness; light that escapes has no state in it.
///
/// # Errors
/// As [`brightness_chain`].
///
/// # Examples
/// ```
/// use infoscene::information::{OpenScene, brightness_information, scene_information};
/// use infoscene::exchange::{Congruence, ScenePairs};
/// use infoscene::scene::{Material, Occlusion, Scene};
/// use infoscene::transport::RadiositySystem;
/// // with E = k (1 − R) everywhere the radiosity chain is the visibility chain (§3.4)
/// let cube = Scene::built_in("cube:2")?;
/// let pairs = ScenePairs::try_new(&cube, 1e-12, Congruence::Shared, Occlusion::Exact)?;
/// let exchange = pairs.exchange_areas()?;
/// let room = RadiositySystem::of(&exchange, &[Material::try_new(0.5, 0.0)?; 24])?;
/// let radiosity = brightness_information(&exchange, &room.radiosity(&[0.5; 24])?)?;
/// let visibility = scene_information(&pairs, OpenScene::Refuse)?;
/// let difference = radiosity.mutual_information.value - visibility.mutual_information.value;
/// assert!(difference.abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn brightness_information(
    exchange: &ExchangeAreas,
    brightness: &RadiositySolution,
) -> Result<SceneInformation, ChainError> {
    let chain = brightness_chain(exchange, &brightness.values)?;
    let n = chain.states();
    let (weights, total) = (chain.weights(), chain.total());
    let relative = relative_errors(brightness);
    let rows = parallel_map(n, &|j| {
        let column = chain.joint().column(j);
        let probability = weights[j] / total;
        if probability <= 0.0 {
            return [0.0; 3];
        }
        let lit = || (0..n).filter(|i| weights[*i] > 0.0);
        let terms = lit().map(|i| pair_divergence(column[i], weights[i], probability));
        let bounded = lit().map(|i| {
            let known = exchange.get(i, j).exchange;
            let share = if known.value > 0.0 {
                known.error / known.value
            } else {
                0.0
            };
            let bound = column[i] * (share + relative[i] + relative[j]);
            let moved = divergence_error(column[i], bound, weights[i] * probability);
            [bound, moved]
        });
        let bounds: Vec<[f64; 2]> = bounded.collect();
        [
            compensated_sum(terms),
            bounds.iter().map(|[bound, _]| bound).sum(),
            bounds.iter().map(|[_, moved]| moved).sum(),
        ]
    });
    let contributions: Vec<f64> = rows.iter().map(|row| row[0] / (total * LN_2)).collect();
    let mutual_information = compensated_sum(contributions.iter().copied());
    let [mass, moved] = [1, 2].map(|k| compensated_sum(rows.iter().map(|row| row[k])));
    let error = (moved / LN_2 + mass * (mutual_information + 1.0 / LN_2)) / total;
    let positional_entropy = positional_entropy(&chain);
    let rounding = tolerance::INFORMATION * (2.0 + mutual_information);
    Ok(SceneInformation {
        positional_entropy,
        entropy_rate: (positional_entropy - mutual_information).max(0.0),
        mutual_information: Bounded::estimate(mutual_information, error + rounding),
        resolution: exchange
            .resolution_errors()
            .is_none()
            .then(InformationResolution::default),
        contributions,
        outside_contribution: None,
        weights: (0..n).map(|i| chain.stationary_probability(i)).collect(),
        total_area: compensated_sum(exchange.areas().iter().copied()),
        closure: Closure::of_held(exchange),
        summary: exchange.summary().clone(),
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
