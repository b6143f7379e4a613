//! §5: the potential gain, the real gain, and the logarithm.

use super::extremes::smaller;
use super::finding::Computation;
use super::{ClaimError, Finding, Inputs};
use crate::chain::visibility_chain;
use crate::discretize::{PatchSplit, regular_positions};
use crate::geometry::SplitAxis;
use crate::information::{divergence, mutual_information, subdivision_bound};
use crate::numeric::{HighPrecision, Scalar, compensated_sum, tolerance, x_log2_ratio};
use crate::scene::Scene;

pub(super) const COMPUTATIONS: &[(&str, Computation)] = &[
    (
        "printed_gain_is_not_normalised",
        printed_gain_is_not_normalised,
    ),
    (
        "printed_maximum_is_not_normalised",
        printed_maximum_is_not_normalised,
    ),
    (
        "potential_is_far_from_real_gain",
        potential_is_far_from_real_gain,
    ),
    ("gain_grows_with_gradient", gain_grows_with_gradient),
    ("printed_gain_is_unstable", printed_gain_is_unstable),
];

/// With B = 1 the radiosity chain is the visibility chain, so the true gain is `I′ − I` of the unit cube
/// with one face cut, and Σw = A_T.
fn printed_gain_is_not_normalised(input: &Inputs) -> Result<Finding, ClaimError> {
    let scene = Scene::built_in("cube:1")?;
    let split = scene.with_patch_split(0, SplitAxis::U, 0.3)?;
    let gain = mutual_information(&visibility_chain(&split)?)
        - mutual_information(&visibility_chain(&scene)?);
    let (whole, parts) = (scene.exchange_areas()?, split.exchange_areas()?);
    let far = split.patches().len() - 1;
    let areas = [0, far].map(|k| split.patches()[k].shape().area());
    // 2 B_i B_j ( Σ_k A_k F_kj log F_kj − A_i F_ij log F_ij ), summed over j; A_i = 1
    let printed = compensated_sum((1..scene.patches().len()).flat_map(|j| {
        let part = |k: usize, area: f64| x_log2_ratio(parts.values()[(k, j)], area);
        [
            part(0, areas[0]),
            part(far, areas[1]),
            -x_log2_ratio(whole.values()[(0, j)], 1.0),
        ]
    }));
    ratio_to_truth(2.0 * printed / gain, scene.total_area(), input)
}

/// `2 B_i B_j A_i F_ij log2 m` against eq. (6) of the chain, for two adjacent faces and m = 2.
fn printed_maximum_is_not_normalised(input: &Inputs) -> Result<Finding, ClaimError> {
    let scene = Scene::built_in("cube:1")?;
    let chain = visibility_chain(&scene)?;
    let printed = subdivision_bound(scene.exchange_areas()?.values()[(0, 2)], 2);
    let truth = subdivision_bound(chain.joint()[(0, 2)] / chain.total(), 2);
    ratio_to_truth(printed / truth, scene.total_area(), input)
}

fn ratio_to_truth(ratio: f64, total: f64, input: &Inputs) -> Result<Finding, ClaimError> {
    let ratio = if input.switch("normalised")? {
        ratio / total
    } else {
        ratio
    };
    let holds = (ratio - 1.0).abs() <= tolerance::CLOSURE;
    let note = format!(
        "the printed expression lacks the factor 1/Σw: with Σw = {total:.0} it is {ratio:.3} times the \
         truth; as 'proportional to' it is right"
    );
    Ok(Finding::statement(holds, ratio, tolerance::CLOSURE).noting(note))
}

/// Three equal strips of two facing squares, `far` being the share below which the potential counts as far.
fn potential_is_far_from_real_gain(input: &Inputs) -> Result<Finding, ClaimError> {
    let scene = Scene::facing_squares(input.number("distance")?)?;
    let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U)?;
    let share = split.gain(&regular_positions(3))? / split.maximum_gain(3)?;
    Ok(Finding::statement(
        share < input.number("far")?,
        share,
        tolerance::GAIN,
    ))
}

/// Two halves with form factors F (1 ± g), g from 0 to 1; with `flux_loss` the total falls as g grows.
fn gain_grows_with_gradient(input: &Inputs) -> Result<Finding, ClaimError> {
    let loss = input.number("flux_loss")?;
    let gain = |g: f64| {
        let flux = 1.0 - loss * g;
        divergence(&[flux * (1.0 + g), flux * (1.0 - g)], &[1.0, 1.0])
    };
    let curve: Vec<[f64; 2]> = (0..=100)
        .map(|k| f64::from(k) / 100.0)
        .map(|g| [g, gain(g)])
        .collect();
    let steps = curve
        .windows(2)
        .map(|pair| (pair[1][1] - pair[0][1]) / gain(0.5));
    let smallest = steps.fold(f64::INFINITY, smaller);
    let finding = Finding::statement(smallest > 0.0, smallest, tolerance::GAIN);
    Ok(finding.sampled().with_curve(curve))
}

/// Fluxes 1 + d and 1 − d of equal parts, as doubles: the expression as printed and the sum of non-negative
/// terms against 256 bits.
fn printed_gain_is_unstable(input: &Inputs) -> Result<Finding, ClaimError> {
    let d = input.number("difference")?;
    let fluxes = [1.0 + d, 1.0 - d];
    let number = HighPrecision::new;
    let total = number(fluxes[0]) + &number(fluxes[1]);
    let exact = fluxes.iter().fold(number(0.0), |sum, flux| {
        let share = number(*flux) * &number(2.0) / &total;
        sum + &(share.ln() * &number(*flux))
    }) / &number(2.0).ln();
    let error = |value: f64| ((number(value) - &exact) / &exact).abs().to_f64();
    let printed = error(x_log2_ratio(fluxes[0], 1.0) + x_log2_ratio(fluxes[1], 1.0));
    let stable = error(divergence(&fluxes, &[1.0, 1.0]));
    // a relative error of rounding noise is worth its order of magnitude only
    let digits = |error: f64| (-error.max(f64::EPSILON).log10()).floor().max(0.0);
    let note = format!(
        "not a property of the gain: the sum of non-negative terms keeps {} digits there",
        digits(stable)
    );
    Ok(Finding::statement(digits(printed) < 3.0, digits(printed), 0.0).noting(note))
}
