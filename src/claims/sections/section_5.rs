//! §5: the gain as printed, the potential against the real gain, and the logarithm.

use super::enclosed::{enclosed_information, exchanges};
use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::PatchSplit;
use crate::geometry::SplitAxis;
use crate::information::relative_entropy;
use crate::numeric::{Interval, Scalar, largest, tolerance};
use crate::scene::Scene;

/// The printed gain of §5, `2 B_i B_j ( Σ_k A_k F_kj log F_kj − A_i F_ij log F_ij )` summed over j,
/// over the true one for B = 1, where the radiosity chain is the visibility chain: the true gain is
/// `I′ − I` of the unit cube with one face cut.
fn printed_over_true_gain(position: f64, like: &Interval) -> Result<[Interval; 2], ClaimError> {
    let scene = Scene::built_in("cube:1")?;
    let split = scene.with_patch_split(0, SplitAxis::U, position)?;
    let gain = enclosed_information(&split, like)? - &enclosed_information(&scene, like)?;
    let (whole, parts) = (exchanges(&scene, like)?, exchanges(&split, like)?);
    let area = |index: usize| Ok::<_, ClaimError>(like.constant(split.rectangle(index)?.area()));
    let far = split.patches().len() - 1;
    let areas = [area(0)?, area(far)?];
    let term = |exchange: &Interval, area: &Interval| (exchange.clone() / area).x_ln_x() * area;
    let mut nats = like.zero();
    for j in 1..scene.patches().len() {
        nats = nats + &term(&parts[0][j][0], &areas[0]) + &term(&parts[far][j][0], &areas[1])
            - &whole[0][j][0].x_ln_x(); // A_i = 1
    }
    let printed = nats * &like.constant(2.0) / &like.constant(2.0).ln();
    Ok([printed / &gain, like.constant(scene.total_area())])
}

/// The expressions of §3.4, §3.5 and §5 as they stand against weights that sum to one, for B = 1 on
/// the unit cube.
pub(crate) fn printed_weights_are_not_normalised(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let like = case.interval("position")?;
    let [ratio, total] = printed_over_true_gain(case.number("position")?, &like)?;
    let ratio = if case.switch("normalised")? {
        ratio / &total
    } else {
        ratio
    };
    let note = format!(
        "weights and gains are printed without the factor 1/Σw: with Σw = {:.0} they are {:.3} \
         times those of a chain whose probabilities sum to one; §3.4 gives Σw beside its \
         integrals, §3.5 says \"without normalising\", §5 says neither",
        total.to_f64(),
        ratio.to_f64()
    );
    let fails = ratio.intersection(&ratio.constant(1.0)).is_none();
    Ok(Finding::refuted_if(fails, ratio).noting(note))
}

/// The printed gain over the true one against Σw, for cuts from one side to the other;
/// `total_factor` times Σw is taken.
pub(crate) fn printed_gain_is_proportional(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let like = case.interval("total_factor")?;
    let mut deviations = Vec::new();
    for position in [0.125, 0.5] {
        let [ratio, total] = printed_over_true_gain(position, &like)?;
        let off = ratio / &(total * &like) - &like.constant(1.0);
        deviations.push(off.abs().to_f64());
    }
    Ok(Finding::residual(largest(deviations), tolerance::CLOSURE))
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

/// Two halves with fluxes 1 + d and 1 − d as doubles, and their gain in nats by two forms, each
/// with the logarithms that it takes.
struct Halves {
    /// The error of the expression as printed, relative.
    printed: Interval,
    /// The error of the sum of non-negative terms.
    stable: Interval,
    /// The logarithms of the printed form, and of the other.
    logarithms: [u32; 2],
}

impl Halves {
    /// Computes both forms, counting logarithms, and encloses their errors.
    fn new(case: &Case<'_>) -> Result<Self, ClaimError> {
        let d = case.number("difference")?;
        let like = case.interval("difference")?;
        let fluxes = [1.0 + d, 1.0 - d];
        let lifted = fluxes.map(|flux| like.constant(flux));
        let total = lifted[0].clone() + &lifted[1];
        let parts = lifted.map(|flux| [flux, like.constant(1.0)]);
        // bits, turned into nats
        let exact =
            relative_entropy(&total, &like.constant(2.0), &parts) * &like.constant(2.0).ln();
        let error = |value: f64| ((like.constant(value) - &exact) / &exact).abs();
        // Σ G_k ln(G_k/W_k) − G ln(G/W), W_k = 1, W = 2
        let mut printed = [0, 0];
        let whole: f64 = fluxes.iter().sum();
        let mut sum = -whole * counted(&mut printed[0], || (0.5 * whole).ln());
        for flux in fluxes {
            sum += flux * counted(&mut printed[0], || flux.ln());
        }
        // Σ q_k φ(x_k), q_k the independent flux, G_k = q_k (1 + x_k), φ(x) = (1 + x) ln1p(x) − x
        let independent = 0.5 * whole;
        let terms = fluxes.map(|flux| {
            let x = (flux - independent) / independent;
            independent * counted(&mut printed[1], || crate::numeric::divergence_kernel(x))
        });
        Ok(Self {
            printed: error(sum),
            stable: error(terms[0] + terms[1]),
            logarithms: printed,
        })
    }

    /// The correct digits under a relative error: of rounding noise its order of magnitude only.
    fn digits(error: &Interval) -> f64 {
        let error = error.to_f64().max(f64::EPSILON);
        (-error.log10()).floor().max(0.0)
    }
}

fn counted<T>(count: &mut u32, logarithm: impl FnOnce() -> T) -> T {
    *count += 1;
    logarithm()
}

/// The digits that are left of the printed expression.
pub(crate) fn printed_gain_is_unstable(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let halves = Halves::new(case)?;
    let digits = Halves::digits(&halves.printed);
    let note = format!(
        "not a property of the gain: the sum of non-negative terms keeps {} digits there",
        Halves::digits(&halves.stable)
    );
    let three_digits = halves.printed.constant(1e-3);
    let (holds, fails) = (halves.printed > three_digits, halves.printed < three_digits);
    let digits = three_digits.constant(digits);
    Ok(Finding::decided(holds, fails, digits).noting(note))
}

/// The logarithms of a form that keeps its digits over those of the printed one; with
/// `as_it_stands`, no other form is known, so that digits must be bought by longer numbers.
pub(crate) fn exact_gain_costs_more(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let halves = Halves::new(case)?;
    let error = if case.switch("as_it_stands")? {
        &halves.printed
    } else {
        &halves.stable
    };
    let [printed, stable] = halves.logarithms.map(f64::from);
    let ratio = error.constant(stable) / &error.constant(printed);
    let twelve_digits = error.constant(1e-12);
    let is_stable = *error < twelve_digits && stable <= printed;
    let note = format!(
        "a sum of non-negative terms, one logarithm for each part, keeps {} digits in ordinary \
         doubles where the printed form, with one logarithm more, keeps {}: the instability costs \
         nothing; what the exact gain does cost is the form factors of the parts",
        Halves::digits(&halves.stable),
        Halves::digits(&halves.printed)
    );
    let costs_more = *error > twelve_digits;
    Ok(Finding::decided(costs_more, is_stable, ratio).noting(note))
}
