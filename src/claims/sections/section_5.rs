//! §5: the potential gain, the real gain, and the logarithm.

use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::PatchSplit;
use crate::form_factor::RectanglePair;
use crate::geometry::{Rectangle, SplitAxis};
use crate::information::{divergence, relative_entropy};
use crate::numeric::{Interval, Scalar, smaller, tolerance, x_log2_ratio};
use crate::scene::Scene;

/// Exchange areas of all ordered pairs of patches, and the product of their areas.
fn exchanges(scene: &Scene, like: &Interval) -> Result<Vec<Vec<[Interval; 2]>>, ClaimError> {
    let rectangles = (0..scene.patches().len())
        .map(|index| scene.rectangle(index))
        .collect::<Result<Vec<_>, _>>()?;
    let pair = |a: &Rectangle, b: &Rectangle| {
        let exchange = if a == b {
            like.zero()
        } else {
            RectanglePair::try_new(a, b)?
                .lifted(like)
                .exchange_value()?
        };
        let areas = like.constant(a.area()) * &like.constant(b.area());
        Ok([exchange, areas])
    };
    let row = |a| rectangles.iter().map(|b| pair(a, b)).collect();
    rectangles.iter().map(row).collect()
}

/// Mutual information of a closed scene, eq. (3).
fn enclosed_information(scene: &Scene, like: &Interval) -> Result<Interval, ClaimError> {
    let total = like.constant(scene.total_area());
    let pairs = exchanges(scene, like)?.concat();
    Ok(relative_entropy(&total, &total.square(), &pairs) / &total)
}

/// Compares the printed gain with the true one for B = 1, where the radiosity chain is the
/// visibility chain: the true gain is `I′ − I` of the unit cube with one face cut, and Σw = A_T.
pub(crate) fn printed_gain_is_not_normalised(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let position = case.number("position")?;
    let like = case.interval("position")?;
    let scene = Scene::built_in("cube:1")?;
    let split = scene.with_patch_split(0, SplitAxis::U, position)?;
    let gain = enclosed_information(&split, &like)? - &enclosed_information(&scene, &like)?;
    let (whole, parts) = (exchanges(&scene, &like)?, exchanges(&split, &like)?);
    let area = |index: usize| Ok::<_, ClaimError>(like.constant(split.rectangle(index)?.area()));
    let far = split.patches().len() - 1;
    let areas = [area(0)?, area(far)?];
    // 2 B_i B_j ( Σ_k A_k F_kj log F_kj − A_i F_ij log F_ij ), summed over j; A_i = 1
    let term = |exchange: &Interval, area: &Interval| (exchange.clone() / area).x_ln_x() * area;
    let mut nats = like.zero();
    for j in 1..scene.patches().len() {
        nats = nats + &term(&parts[0][j][0], &areas[0]) + &term(&parts[far][j][0], &areas[1])
            - &whole[0][j][0].x_ln_x();
    }
    let printed = nats * &like.constant(2.0) / &like.constant(2.0).ln();
    ratio_to_truth(printed / &gain, scene.total_area(), case)
}

/// `2 B_i B_j A_i F_ij log2 m` against eq. (6) of the chain, for two adjacent faces and m = 2.
pub(crate) fn printed_maximum_is_not_normalised(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let like = Interval::precise(1.0, case.bits());
    let scene = Scene::built_in("cube:1")?;
    let exchange = exchanges(&scene, &like)?[0][2][0].clone();
    let printed = exchange.clone() * &like.constant(2.0);
    // w_i P_ij of the chain, whose weights sum to one
    let truth = exchange / &like.constant(scene.total_area()) * &like.constant(2.0);
    ratio_to_truth(printed / &truth, scene.total_area(), case)
}

fn ratio_to_truth(ratio: Interval, total: f64, case: &Case<'_>) -> Result<Finding, ClaimError> {
    let ratio = if case.switch("normalised")? {
        ratio.clone() / &ratio.constant(total)
    } else {
        ratio
    };
    let one = ratio.constant(1.0);
    let note = format!(
        "the printed expression lacks the factor 1/Σw: with Σw = {total:.0} it is {:.3} times the \
         truth; as 'proportional to' it is right",
        ratio.to_f64()
    );
    let fails = ratio.intersection(&one).is_none();
    // an equality cannot be enclosed, only refuted; the control comes to within its enclosure and
    // is left open
    Ok(Finding::refuted_if(fails, ratio).noting(note))
}

/// Three equal strips of two facing squares, at `distance` and at half of it: the gain is below the
/// share `far` of the potential, and the farther the squares are the less of it is left. Near to
/// each other it is the other way round, as the form factors of touching squares are equal, too.
pub(crate) fn potential_is_far_from_real_gain(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let far = case.interval("far")?;
    let three = far.constant(3.0);
    let thirds = [1.0, 2.0].map(|k| far.constant(k) / &three);
    let share = |distance: f64| -> Result<Interval, ClaimError> {
        let scene = Scene::facing_squares(distance)?;
        let split = PatchSplit::try_new(&scene, 0, &[1], SplitAxis::U)?;
        let split = split.rectangles()?.lifted(&far);
        Ok(split.gain(&thirds)? / &split.maximum_gain(3)?)
    };
    let distance = case.number("distance")?;
    let (near, share) = (share(0.5 * distance)?, share(distance)?);
    let note = format!("{:.1e} of it at half the distance", near.to_f64());
    let (holds, fails) = (share < far && share < near, share > far || share > near);
    Ok(Finding::decided(holds, fails, share).noting(note))
}

/// Two halves with form factors F (1 ± g), g from 0 to 1; with `flux_loss` the total falls as g
/// grows.
pub(crate) fn gain_grows_with_gradient(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let loss = case.number("flux_loss")?;
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

/// Fluxes 1 + d and 1 − d of equal parts, as doubles: the error of the expression as printed, and
/// of the sum of non-negative terms.
pub(crate) fn printed_gain_is_unstable(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let d = case.number("difference")?;
    let like = case.interval("difference")?;
    let fluxes = [1.0 + d, 1.0 - d];
    let exact = fluxes.map(|flux| like.constant(flux));
    let total = exact[0].clone() + &exact[1];
    let parts = exact.map(|flux| [flux, like.constant(1.0)]);
    let exact = relative_entropy(&total, &like.constant(2.0), &parts);
    let error = |value: f64| ((like.constant(value) - &exact) / &exact).abs();
    let printed = error(x_log2_ratio(fluxes[0], 1.0) + x_log2_ratio(fluxes[1], 1.0));
    let stable = error(divergence(&fluxes, &[1.0, 1.0]));
    // a relative error of rounding noise is worth its order of magnitude only
    let digits = |error: &Interval| (-error.to_f64().max(f64::EPSILON).log10()).floor().max(0.0);
    let note = format!(
        "not a property of the gain: the sum of non-negative terms keeps {} digits there",
        digits(&stable)
    );
    let three_digits = like.constant(1e-3);
    let (holds, fails) = (printed > three_digits, printed < three_digits);
    Ok(Finding::decided(holds, fails, like.constant(digits(&printed))).noting(note))
}
