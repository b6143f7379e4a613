//! Hypotheses of Theorem 1 that are broken on purpose.

use crate::chain::Refinement;
use crate::numeric::x_log2_ratio;

/// A hypothesis broken on purpose, to see that a counterexample is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sabotage {
    /// Hypothesis (a): what leaves a sub-state ignores where it came from.
    Reciprocity,
    /// Hypothesis (b): the sub-states are mixed with independent ones and no longer add up.
    Covering,
    /// No hypothesis: the gain itself is off by 1e-9 of it.
    Gain,
}

/// `w_k P_kl` of the refined chain with one hypothesis broken, rows summing to w.
pub(super) fn broken_flow(
    refinement: &Refinement,
    sabotage: Option<Sabotage>,
) -> Option<Vec<Vec<f64>>> {
    let sabotage = sabotage.filter(|sabotage| *sabotage != Sabotage::Gain)?;
    let refined = refinement.refined();
    let parts = refinement.parts();
    let divided = |k: usize| parts[refinement.parents()[k]].len() > 1;
    let w = |k: usize| refined.stationary_probability(k);
    let transition = |k: usize, l: usize| match sabotage {
        Sabotage::Reciprocity if divided(k) => w(l),
        Sabotage::Covering if divided(k) || divided(l) => {
            0.5 * (refined.transition_probability(k, l) + w(l))
        }
        _ => refined.transition_probability(k, l),
    };
    let n = refined.states();
    Some(
        (0..n)
            .map(|k| (0..n).map(|l| w(k) * transition(k, l)).collect())
            .collect(),
    )
}

/// Eq. (8) of a flow `w_k P_kl` that need not be reciprocal, w its row sums, in bits.
pub(super) fn plain_information(flow: &[Vec<f64>]) -> f64 {
    let w: Vec<f64> = flow.iter().map(|row| row.iter().sum()).collect();
    let terms = flow.iter().zip(&w).flat_map(|(row, from)| {
        row.iter()
            .zip(&w)
            .filter(|(_, to)| **to > 0.0)
            .map(move |(flow, to)| {
                if *from > 0.0 {
                    from * x_log2_ratio(flow / from, *to)
                } else {
                    0.0
                }
            })
    });
    terms.sum()
}
