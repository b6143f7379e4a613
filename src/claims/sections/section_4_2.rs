//! §4.2: the cut across a radiosity gradient.

use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{GradientCut, StraightCut};
use crate::information::divergence;
use crate::numeric::{Interval, Scalar, integral, larger, largest, tolerance, x_log2_ratio};

fn cut(case: &Case<'_>) -> Result<GradientCut, ClaimError> {
    let irradiance = case.number("irradiance_exponent")?;
    Ok(GradientCut::try_new(case.number("exponent")?, irradiance)?)
}

/// The printed expression against eq. (5), its fluxes ∫B and weights ∫B H by quadrature of the
/// profile itself, H the irradiance; no emission and constant reflectance make H ∝ B.
pub(crate) fn objective_follows(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let (n, m) = (
        case.number("exponent")?,
        case.number("irradiance_exponent")?,
    );
    let share = |power: f64, l: f64| -> Result<[f64; 2], ClaimError> {
        let profile = |x: f64| x.powf(power);
        let near = integral(profile, (0.0, l), 1e-14)?.value;
        Ok([near, integral(profile, (l, 1.0), 1e-14)?.value].map(|part| part * (power + 1.0)))
    };
    let mut deviations = Vec::new();
    for tenth in 1..10 {
        let l = f64::from(tenth) / 10.0;
        let gain = divergence(&share(n, l)?, &share(n + m, l)?);
        let (flux, weight) = (l.powf(n + 1.0), l.powf(n + 2.0));
        let printed = x_log2_ratio(flux, weight) + x_log2_ratio(1.0 - flux, 1.0 - weight);
        deviations.push((gain - printed).abs());
    }
    let note = "the weight printed, with exponent n + 2, needs an irradiance that grows as l for \
                every n; constant reflectance without emission gives 2n + 1, which agrees for \
                n = 1 only";
    Ok(Finding::residual(largest(deviations), tolerance::IDENTITY).noting(note))
}

/// The best line of all at each whole degree from the one across the gradient to the one along it,
/// against the best at `reference_angle`, for n = 1, 2, … up to `largest_exponent`; the curve is
/// that of n = 1, in bits.
pub(crate) fn best_cut_is_perpendicular(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let m = case.number("irradiance_exponent")?;
    let reference = case.number("reference_angle")?;
    let mut largest_ratio: f64 = 0.0;
    let mut curve = Vec::new();
    for n in 1..=case.count("largest_exponent")? {
        let patch = GradientCut::try_new(n.into(), m)?;
        let at_reference = StraightCut::best(reference, &patch)?.gain;
        for degrees in 0..=90 {
            let best = StraightCut::best(degrees.into(), &patch)?.gain;
            if degrees > 0 {
                largest_ratio = larger(largest_ratio, best / at_reference);
            }
            if n == 1 {
                curve.push([degrees.into(), best]);
            }
        }
    }
    let holds = largest_ratio < 1.0;
    let finding = Finding::statement(holds, largest_ratio, tolerance::IDENTITY).sampled();
    Ok(finding.with_curve(curve))
}

pub(crate) fn information_cut(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let found = cut(case)?.certified_mutual_information_cut(case.bits())?;
    let n = case.number("exponent")?;
    let derived = GradientCut::try_new(n, n)?.certified_mutual_information_cut(case.bits())?;
    let note = format!(
        "gain {:.6} bit; {:.4} for irradiance growing as the radiosity",
        found.value.to_f64(),
        derived.position.to_f64()
    );
    Ok(Finding::enclosed(found.position).noting(note))
}

/// Checks that the L2 error at each cut, by quadrature, is lower than a thousandth to either side,
/// and that the printed polynomial `2n lⁿ − lⁿ⁻¹ − … − 1` (its n raised by `degree_shift`)
/// vanishes.
pub(crate) fn polynomial_follows(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let shift = case.count("degree_shift")?;
    let mut values = Vec::new();
    let mut is_least = true;
    for n in 1..=4 {
        let power = f64::from(n);
        let l = GradientCut::try_new(power, 1.0)?
            .mean_square_cut()?
            .position;
        let error = |l: f64| -> Result<f64, ClaimError> {
            let mut sum = 0.0;
            for (from, to) in [(0.0, l), (l, 1.0)] {
                let mean = integral(|x| x.powf(power), (from, to), 1e-14)?.value / (to - from);
                sum += integral(|x| (x.powf(power) - mean).powi(2), (from, to), 1e-14)?.value;
            }
            Ok(sum)
        };
        is_least &= error(l)? < error(l - 1e-3)?.min(error(l + 1e-3)?);
        let degree = n + shift;
        let lower: f64 = (0..degree).map(|k| l.powf(f64::from(k))).sum();
        values.push((2.0 * f64::from(degree) * l.powf(f64::from(degree)) - lower).abs());
    }
    let mut finding = Finding::residual(largest(values), tolerance::GAIN);
    finding.holds = finding.holds.map(|vanishes| vanishes && is_least);
    Ok(finding)
}

pub(crate) fn mean_square_cut(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let cut = GradientCut::try_new(case.number("exponent")?, 1.0)?;
    let found = cut.certified_mean_square_cut(case.bits())?;
    let note = format!("mean square error {:.6}", found.value.to_f64());
    Ok(Finding::enclosed(found.position).noting(note))
}

pub(crate) fn cuts_are_near(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let distance = |n: f64, m: f64| -> Result<Interval, ClaimError> {
        let cut = GradientCut::try_new(n, m)?;
        let square = cut.certified_mean_square_cut(case.bits())?.position;
        Ok((square - &cut.certified_mutual_information_cut(case.bits())?.position).abs())
    };
    let m = case.number("irradiance_exponent")?;
    let near = case.interval("near")?;
    let (mut printed, mut derived) = (near.zero(), near.zero());
    for n in [1.0, 2.0, 3.0, 4.0] {
        printed = printed.larger_of(&distance(n, m)?);
        derived = derived.larger_of(&distance(n, n)?);
    }
    let note = format!(
        "very near: within {} of the patch; {:.4} for irradiance growing as the radiosity",
        near.to_f64(),
        derived.to_f64()
    );
    Ok(Finding::decided(printed < near, printed > near, printed).noting(note))
}
