//! Appendices A (proof of Theorem 1) and B (discontinuity meshing).

use crate::chain::random::seeded::RandomChains;
use crate::chain::{Refinement, ReversibleChain};
use crate::claims::{Case, ClaimError, Finding};
use crate::discretize::{ContactShadow, DiscretizeError};
use crate::information::mutual_information;
use crate::numeric::{
    Certificate, NumericError, Scalar, compensated_sum, largest, smaller, tolerance, x_log2_ratio,
};

/// The largest of a deviation over random chains and refinements.
fn over_random_refinements(
    case: &Case<'_>,
    deviation: impl Fn(&Refinement) -> f64,
) -> Result<f64, ClaimError> {
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut deviations = Vec::new();
    for _ in 0..case.count("chains")? {
        deviations.push(deviation(&random.refinement(8)?));
    }
    Ok(largest(deviations))
}

/// `w_i P_ij log2( P_ij / w_j )` of states that sum to one.
fn term(chain: &ReversibleChain, i: usize, j: usize) -> f64 {
    let independent = chain.weights()[i] * chain.weights()[j] / chain.total();
    x_log2_ratio(chain.joint()[(i, j)], independent) / chain.total()
}

/// `w_i = Σ_k w_ik` and `J_ii = Σ_kl J_{ik,il}`, the parts reduced by `loss`.
pub(crate) fn unlisted_premises_follow(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let kept = 1.0 - case.number("loss")?;
    let worst = over_random_refinements(case, |refinement| {
        let (chain, refined) = (refinement.coarse(), refinement.refined());
        let parts = &refinement.parts()[0];
        let weight = compensated_sum(parts.iter().map(|k| refined.weights()[*k]));
        let own = parts
            .iter()
            .flat_map(|k| parts.iter().map(|l| refined.joint()[(*k, *l)]));
        let own = kept * compensated_sum(own) - chain.joint()[(0, 0)];
        (kept * weight - chain.weights()[0]).abs().max(own.abs()) / chain.total()
    })?;
    let note = "used in (9) without being listed; both follow from (a) and (b)";
    Ok(Finding::residual(worst, tolerance::IDENTITY)
        .sampled()
        .noting(note))
}

/// Four blocks: neither, the second, the first, or both of two states new.
pub(crate) fn equation_9(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let omit = case.switch("omit_self_block")?;
    let worst = over_random_refinements(case, |refinement| {
        let refined = refinement.refined();
        let n = refined.states();
        let block = |first_new: bool, second_new: bool| {
            let is_new = |part: usize| refinement.parents()[part] == 0;
            let indices = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
            compensated_sum(
                indices
                    .filter(|(i, j)| is_new(*i) == first_new && is_new(*j) == second_new)
                    .map(|(i, j)| term(refined, i, j)),
            )
        };
        let own = if omit { 0.0 } else { block(true, true) };
        let sum = block(false, false) + block(false, true) + block(true, false) + own;
        (sum - mutual_information(refined)).abs()
    })?;
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

pub(crate) fn equation_10(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let factor = case.number("diagonal_factor")?;
    let worst = over_random_refinements(case, |refinement| {
        let chain = refinement.coarse();
        let n = chain.states();
        let above = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let upper = compensated_sum(above.map(|(i, j)| term(chain, i, j)));
        let diagonal = compensated_sum((0..n).map(|i| term(chain, i, i)));
        (2.0 * upper + factor * diagonal - mutual_information(chain)).abs()
    })?;
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

pub(crate) fn equation_11(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let omit = case.switch("omit_self_term")?;
    let worst = over_random_refinements(case, |refinement| {
        let (chain, refined) = (refinement.coarse(), refinement.refined());
        let new = &refinement.parts()[0];
        let pairs = (1..chain.states()).map(|j| {
            let parts = compensated_sum(new.iter().map(|k| term(refined, j, *k)));
            parts - term(chain, j, 0)
        });
        let own = new
            .iter()
            .flat_map(|k| new.iter().map(|l| term(refined, *k, *l)));
        let own = compensated_sum(own) - term(chain, 0, 0);
        let increase = 2.0 * compensated_sum(pairs) + if omit { 0.0 } else { own };
        (mutual_information(refined) - mutual_information(chain) - increase).abs()
    })?;
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

/// `Σ a log(a/b) − (Σa) log(Σa/Σb)` for random numbers; `negative` turns the
/// sign of one pair a, b while both sums stay positive.
pub(crate) fn log_sum_inequality(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let negative = case.switch("negative")?;
    let mut random = RandomChains::new(case.count("seed")?.into());
    let mut smallest = f64::INFINITY;
    for _ in 0..case.count("draws")? {
        let count = random.count(2, 6);
        let mut a = random.numbers(count);
        // b > 0 wherever a > 0
        let mut b: Vec<f64> = random.numbers(count).iter().map(|b| b + 1e-3).collect();
        if negative {
            a[0] = -0.5 * a[1..].iter().sum::<f64>();
            b[0] = -0.1 * b[1..].iter().sum::<f64>();
        }
        let parts = a
            .iter()
            .zip(&b)
            .map(|(a, b)| x_log2_ratio(a.abs(), b.abs()) * a.signum());
        let (sum_a, sum_b) = (a.iter().sum::<f64>(), b.iter().sum::<f64>());
        smallest = smaller(
            smallest,
            compensated_sum(parts) - x_log2_ratio(sum_a, sum_b),
        );
    }
    let holds = smallest >= -tolerance::IDENTITY;
    Ok(Finding::statement(holds, smallest, tolerance::IDENTITY).sampled())
}

/// Eq. (13), last line, times 1/A_T with A_T = 2:
/// `2/A_T · J [ log2(F_j,ic/(A_ic + A_id)) − log2(F_ij/A_j) ]` with A_j = 1, for cuts at and beyond
/// the line.
pub(crate) fn equation_13(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let line = case.number("line")?;
    let shadow = ContactShadow::try_new(line)?;
    let lit = ContactShadow::try_new(case.number("formula_line")?)?.exchange_area()?;
    let mut deviations = Vec::new();
    let mut previous = f64::INFINITY;
    let mut falls = true;
    for k in 0..10 {
        let cut = line + (1.0 - line) * f64::from(k) / 10.0;
        let formula = x_log2_ratio(lit, cut) - x_log2_ratio(lit, 1.0);
        falls &= formula < previous;
        previous = formula;
        deviations.push((shadow.gain(&cut)? - formula).abs());
    }
    let mut finding = Finding::residual(largest(deviations), tolerance::IDENTITY);
    finding.holds = finding.holds.map(|agrees| agrees && falls);
    Ok(finding)
}

/// Eq. (14) for cuts short of the line: its middle line must be the gain itself, its right side,
/// with `A_id + dark A_ic` for the area in the second logarithm, at least that.
pub(crate) fn inequality_14(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let line = case.number("line")?;
    let shadow = ContactShadow::try_new(line)?;
    let whole = shadow.exchange_area()?;
    let dark = case.number("dark_on_the_right")? * (1.0 - line);
    let mut smallest = f64::INFINITY;
    let mut agrees = true;
    for k in 1..10 {
        let cut = line * f64::from(k) / 10.0;
        let lit = ContactShadow::try_new(cut)?.exchange_area()?;
        let beyond = whole - lit;
        let increase = |area_beyond: f64| {
            x_log2_ratio(lit, cut) + x_log2_ratio(beyond, area_beyond) - x_log2_ratio(whole, 1.0)
        };
        let gain = shadow.gain(&cut)?;
        agrees &= (increase(1.0 - cut) - gain).abs() <= tolerance::IDENTITY;
        smallest = smaller(smallest, increase(line - cut + dark) - gain);
    }
    let holds = agrees && smallest > tolerance::IDENTITY;
    Ok(Finding::statement(holds, smallest, tolerance::IDENTITY))
}

/// The right side of (14) against the gain of the cut along the line, both for flux proportional to
/// lit area, the form factor beyond the cut being `ratio` times the one before it.
pub(crate) fn mesh_gain_is_the_bound(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let (line, ratio) = (case.number("line")?, case.number("form_factor_ratio")?);
    let shadow = ContactShadow::try_new(line)?;
    let along_the_line = shadow.uniform_gain(line);
    let deviations = (1..10).map(|k| {
        let cut = line * f64::from(k) / 10.0;
        let (lit, beyond) = (cut, ratio * (line - cut));
        let right = x_log2_ratio(lit, cut) + x_log2_ratio(beyond, line - cut)
            - x_log2_ratio(lit + beyond, 1.0);
        (right - along_the_line).abs()
    });
    Ok(Finding::residual(largest(deviations), tolerance::IDENTITY))
}

/// Compares the best cut through the lit part, enclosed, with the cut along the shadow's line, at
/// `line`. Where the gain has no highest point short of the line, the line is the best cut.
pub(crate) fn a_lit_cut_can_beat_the_line(case: &Case<'_>) -> Result<Finding, ClaimError> {
    let shadow = ContactShadow::try_new(case.number("line")?)?;
    let line = case.interval("line")?;
    let one = line.constant(1.0);
    let limit = ContactShadow::limit_of_the_discontinuity_line()?;
    let limited = format!(
        "the discontinuity is the best cut of a contact shadow only up to a line at {limit:.6} of \
         the way from the common edge to the far one"
    );
    let best = match shadow.certified_lit_cut(case.bits()) {
        Err(DiscretizeError::Numeric(NumericError::NoInteriorMaximum { .. })) => {
            return Ok(Finding::decided(false, true, one).noting(limited));
        }
        // next to the line the gain is too flat to tell
        Err(DiscretizeError::Numeric(NumericError::NotIsolated { .. })) => {
            return Ok(Finding::decided(false, false, one).noting(limited));
        }
        best => best?,
    };
    let ratio = best.value / &shadow.gain(&line)?;
    let is_best = matches!(best.certificate, Certificate::Unique { .. });
    let note = format!(
        "there the best cut is at {:.4}; {limited}",
        best.position.to_f64()
    );
    let (holds, fails) = (ratio > one && is_best, ratio < one && is_best);
    Ok(Finding::decided(holds, fails, ratio).noting(note))
}
