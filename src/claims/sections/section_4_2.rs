//! §4.2: the cut across a radiosity gradient.

use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{GradientCut, StraightCut};
use crate::numeric::{Interval, Scalar, integral, larger, largest, tolerance};

fn cut(case: &Case<'_>) -> Result<GradientCut, ClaimError> {
    let irradiance = case.number("irradiance_exponent")?;
    Ok(GradientCut::try_new(case.number("exponent")?, irradiance)?)
}

/// The emission that the printed expression needs, for n from `least_exponent` to
/// `largest_exponent`.
///
/// ```text
///   gain per flux = D(G ‖ W),  G = l^(n+1),  W the share of ∫ B H up to l      eq. (5), §3.4
///   E = B − RH ≥ 0             so R H ≤ B lⁿ, and W ≤ c l^(2n+1)
///   printed                    W = l^(n+2), so H ∝ l; the other W of the same gain lies above G
///   E ∝ lⁿ − ρ l,  ρ = RH/(B l) > 0;  with l = s ρ^(1/(n−1)):  E ∝ ρ^(n/(n−1)) (sⁿ − s)
/// ```
///
/// The least of `sⁿ − s` is at `s = n^(−1/(n−1))`: the number is the same for every ρ. It is below
/// 0 for n ≥ 2; for n = 1 the exponents n + 2 and 2n + 1 agree, and no emission is needed.
pub(crate) fn objective_follows(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let (least, largest) = (
        case.count("least_exponent")?,
        case.count("largest_exponent")?,
    );
    if least == 0 || least > largest {
        return Err(ClaimError::Input {
            name: "least_exponent",
            reason: format!("is {least}: from 1 to largest_exponent, {largest}, is needed"),
        });
    }
    let one = Interval::precise(1.0, case.bits());
    let emission = |n: u32| {
        if n == 1 {
            return one.zero();
        }
        let n = one.constant(f64::from(n));
        let s = (-(n.ln() / &(n.clone() - &one))).exp();
        s * &(one.clone() / &n - &one)
    };
    let rest = least + 1..=largest;
    let highest = rest.fold(emission(least), |highest, n| {
        highest.larger_of(&emission(n))
    });
    let exponents_agree = (least..=largest).all(|n| n + 2 == 2 * n + 1);
    let needs_negative_emission = highest < one.zero();
    let note = "the weight printed, with exponent n + 2, needs an irradiance that grows as l for \
                every n; what is left of the radiosity lⁿ for emission is then negative near the \
                dark edge for every n ≥ 2, however little is reflected; without emission the \
                exponent is 2n + 1, which agrees for n = 1 only";
    Ok(Finding::decided(exponents_agree, needs_negative_emission, highest).noting(note))
}

/// A position to four decimals at most.
fn rounded(position: &Interval) -> f64 {
    (1e4 * position.to_f64()).round() / 1e4
}

/// Two divisions of one patch: at the cut of highest mutual information, and `offset` beyond that
/// of least mean square error. The first has more information; the number is its error relative to
/// the other's.
pub(crate) fn highest_information_is_most_precise(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let patch = cut(case)?;
    let highest = patch.certified_mutual_information_cut(case.bits())?;
    let square = patch.certified_mean_square_cut(case.bits())?;
    let other = -(square.position.clone() + &case.interval("offset")?).ln();
    let least = patch.mean_square_error_at(&other);
    let ratio = patch.mean_square_error_at(&-highest.position.ln()) / &least;
    let has_less = patch.gain_at(&other) < highest.value;
    let note = format!(
        "two cuts of one patch, B growing as l to the power {}: at {} the information is highest, \
         at {} the error is least; what remains of the statement, that of two meshes the one with \
         more information mostly has less error, needs meshes",
        case.number("exponent")?,
        rounded(&highest.position),
        rounded(&square.position)
    );
    let fails = has_less && ratio > ratio.constant(1.0);
    Ok(Finding::refuted_if(fails, ratio).noting(note))
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
        "gain {:.6} bit; {:.4} for irradiance growing as the radiosity, which is what constant \
         reflectance without emission gives",
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
