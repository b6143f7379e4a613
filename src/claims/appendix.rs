//! Appendices A (proof of Theorem 1) and B (discontinuity meshing).

use super::registry::Computation;
use super::section_2::largest;
use super::{ClaimError, Finding, Inputs};
use crate::chain::random::RandomChains;
use crate::chain::{ReversibleChain, StateRefinement};
use crate::discretize::ContactShadow;
use crate::information::mutual_information;
use crate::numeric::{compensated_sum, tolerance, x_log2_ratio};

pub(super) const COMPUTATIONS: &[(&str, Computation)] = &[
    ("unlisted_premises_follow", unlisted_premises_follow),
    ("equation_9", equation_9),
    ("equation_10", equation_10),
    ("equation_11", equation_11),
    ("log_sum_inequality", log_sum_inequality),
    ("equation_13", equation_13),
    ("inequality_14", inequality_14),
    (
        "limit_of_the_discontinuity_line",
        limit_of_the_discontinuity_line,
    ),
];

/// The largest of a deviation over random chains and refinements.
fn over_random_refinements(
    input: &Inputs,
    deviation: impl Fn(&ReversibleChain, &StateRefinement) -> Result<f64, ClaimError>,
) -> Result<f64, ClaimError> {
    let mut random = RandomChains::new(input.count("seed")?.into());
    let mut deviations = Vec::new();
    for _ in 0..input.count("chains")? {
        let chain = random.chain(8)?;
        let refinement = random.refinement(&chain, 4)?;
        deviations.push(deviation(&chain, &refinement)?);
    }
    Ok(largest(deviations))
}

/// `w_i P_ij log2( P_ij / w_j )` of states that sum to one.
fn term(chain: &ReversibleChain, i: usize, j: usize) -> f64 {
    let independent = chain.weights()[i] * chain.weights()[j] / chain.total();
    x_log2_ratio(chain.joint()[(i, j)], independent) / chain.total()
}

/// `w_i = Σ_k w_ik`, the sub-states' outward fluxes reduced by `loss`.
fn unlisted_premises_follow(input: &Inputs) -> Result<Finding, ClaimError> {
    let kept = 1.0 - input.number("loss")?;
    let worst = over_random_refinements(input, |chain, refinement| {
        let outward = compensated_sum(refinement.outward().iter().copied());
        let within = compensated_sum(refinement.within().iter().copied());
        let state = refinement.state();
        let weight = chain.weights()[state];
        let own = (within - chain.joint()[(state, state)]).abs();
        Ok(((kept * outward + within - weight).abs().max(own)) / chain.total())
    })?;
    let note = "used in (9) without being listed; both follow from (a) and (b)";
    Ok(Finding::residual(worst, tolerance::IDENTITY)
        .sampled()
        .noting(note))
}

/// The states of a refined chain that came from the divided one.
fn is_sub_state(chain: &ReversibleChain, refinement: &StateRefinement, index: usize) -> bool {
    index == refinement.state() || index >= chain.states()
}

/// Four blocks: neither, the second, the first, or both of two states new.
fn equation_9(input: &Inputs) -> Result<Finding, ClaimError> {
    let omit = input.switch("omit_self_block")?;
    let worst = over_random_refinements(input, |chain, refinement| {
        let refined = refinement.refined(chain)?;
        let n = refined.states();
        let block = |first_new: bool, second_new: bool| {
            let is_new = |index| is_sub_state(chain, refinement, index);
            let indices = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
            compensated_sum(
                indices
                    .filter(|(i, j)| is_new(*i) == first_new && is_new(*j) == second_new)
                    .map(|(i, j)| term(&refined, i, j)),
            )
        };
        let own = if omit { 0.0 } else { block(true, true) };
        let sum = block(false, false) + block(false, true) + block(true, false) + own;
        Ok((sum - mutual_information(&refined)).abs())
    })?;
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

fn equation_10(input: &Inputs) -> Result<Finding, ClaimError> {
    let factor = input.number("diagonal_factor")?;
    let worst = over_random_refinements(input, |chain, _| {
        let n = chain.states();
        let above = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let upper = compensated_sum(above.map(|(i, j)| term(chain, i, j)));
        let diagonal = compensated_sum((0..n).map(|i| term(chain, i, i)));
        Ok((2.0 * upper + factor * diagonal - mutual_information(chain)).abs())
    })?;
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

fn equation_11(input: &Inputs) -> Result<Finding, ClaimError> {
    let omit = input.switch("omit_self_term")?;
    let worst = over_random_refinements(input, |chain, refinement| {
        let refined = refinement.refined(chain)?;
        let state = refinement.state();
        let new: Vec<usize> = (0..refined.states())
            .filter(|i| is_sub_state(chain, refinement, *i))
            .collect();
        let pairs = (0..chain.states()).filter(|j| *j != state).map(|j| {
            let parts = compensated_sum(new.iter().map(|k| term(&refined, j, *k)));
            parts - term(chain, j, state)
        });
        let own = new
            .iter()
            .flat_map(|k| new.iter().map(|l| term(&refined, *k, *l)));
        let own = compensated_sum(own) - term(chain, state, state);
        let increase = 2.0 * compensated_sum(pairs) + if omit { 0.0 } else { own };
        Ok((mutual_information(&refined) - mutual_information(chain) - increase).abs())
    })?;
    Ok(Finding::residual(worst, tolerance::IDENTITY).sampled())
}

/// `Σ a log(a/b) − (Σa) log(Σa/Σb)` for the first two columns of random chains; `negative` turns the
/// sign of one pair a, b while both sums stay positive.
fn log_sum_inequality(input: &Inputs) -> Result<Finding, ClaimError> {
    let negative = input.switch("negative")?;
    let mut random = RandomChains::new(input.count("seed")?.into());
    let mut smallest = f64::INFINITY;
    for _ in 0..input.count("draws")? {
        let chain = random.chain(6)?;
        let mut a: Vec<f64> = chain.joint().column(0).iter().copied().collect();
        // b > 0 wherever a > 0
        let mut b: Vec<f64> = chain.joint().column(1).iter().map(|b| b + 1e-3).collect();
        if negative {
            a[0] = -0.5 * a[1..].iter().sum::<f64>();
            b[0] = -0.1 * b[1..].iter().sum::<f64>();
        }
        let parts = a
            .iter()
            .zip(&b)
            .map(|(a, b)| x_log2_ratio(a.abs(), b.abs()) * a.signum());
        let (sum_a, sum_b) = (a.iter().sum::<f64>(), b.iter().sum::<f64>());
        smallest = smallest.min(compensated_sum(parts) - x_log2_ratio(sum_a, sum_b));
    }
    let holds = smallest >= -tolerance::IDENTITY;
    Ok(Finding::statement(holds, smallest, tolerance::IDENTITY).sampled())
}

/// Eq. (13), last line, times 1/A_T with A_T = 2: `2/A_T · J [ log2(F_j,ic/(A_ic + A_id)) − log2(F_ij/A_j) ]`
/// with A_j = 1, for cuts at and beyond the line.
fn equation_13(input: &Inputs) -> Result<Finding, ClaimError> {
    let line = input.number("line")?;
    let shadow = ContactShadow::try_new(line)?;
    let lit = ContactShadow::try_new(input.number("formula_line")?)?.exchange_area()?;
    let mut deviations = Vec::new();
    let mut previous = f64::INFINITY;
    let mut falls = true;
    for k in 0..10 {
        let cut = line + (1.0 - line) * f64::from(k) / 10.0;
        let formula = x_log2_ratio(lit, cut) - x_log2_ratio(lit, 1.0);
        falls &= formula < previous;
        previous = formula;
        deviations.push((shadow.gain(cut)? - formula).abs());
    }
    let mut finding = Finding::residual(largest(deviations), tolerance::IDENTITY);
    finding.holds = finding.holds.map(|agrees| agrees && falls);
    Ok(finding)
}

/// The right side of (14) takes the logarithm with A_id alone, the left one with A_id + A_ic; the dark
/// area enters times `dark_factor`.
fn inequality_14(input: &Inputs) -> Result<Finding, ClaimError> {
    let line = input.number("line")?;
    let dark = input.number("dark_factor")? * (1.0 - line);
    let whole = ContactShadow::try_new(line)?.exchange_area()?;
    let mut smallest = f64::INFINITY;
    for k in 1..10 {
        let cut = line * f64::from(k) / 10.0;
        let beyond = whole - ContactShadow::try_new(cut)?.exchange_area()?;
        let left = x_log2_ratio(beyond, line - cut + dark);
        smallest = smallest.min(x_log2_ratio(beyond, line - cut) - left);
    }
    Ok(Finding::statement(
        smallest >= 0.0,
        smallest,
        tolerance::IDENTITY,
    ))
}

fn limit_of_the_discontinuity_line(input: &Inputs) -> Result<Finding, ClaimError> {
    let limit = ContactShadow::limit_of_the_discontinuity_line()?;
    let shadow = ContactShadow::try_new(limit)?;
    let other = shadow.best_lit_cut()?.unwrap_or(limit);
    let note = format!(
        "there a cut at {other:.4} gains as much; with the shadow line nearer to the far edge it gains \
         more, so the discontinuity is not always the best cut of a contact shadow"
    );
    // the two gains cross at an angle: their relative error over the difference of slopes
    let error = 100.0 * tolerance::GAIN;
    Ok(Finding::statement(limit < input.number("safe")?, limit, error).noting(note))
}
