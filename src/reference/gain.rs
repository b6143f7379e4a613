//! The gain of a refinement enclosed, from the definition (8).
//!
//! ```text
//!   I′ − I = Σ J′ log2( J′_kl/(w′_k w′_l) ) − Σ J log2( J_ij/(w_i w_j) ),   total mass 1
//! ```
//!
//! The coarse entries are the parts' sums. A difference of two numbers of some bits each, it
//! resolves gains down to about `2^(8 − bits)`; it shares nothing with the sum of non-negative
//! terms it judges.

use crate::chain::Refinement;
use crate::numeric::{Interval, Scalar};

/// `I′ − I` in bits, for the refined joint entries as given.
///
/// **Returns** an enclosure; its width says what `bits` resolve: 1e-75 for 256.
#[must_use]
pub fn exact_gain(refinement: &Refinement, bits: u32) -> Interval {
    let parents = refinement.parents();
    let n = refinement.coarse().states();
    let number = |value: f64| Interval::precise(value, bits);
    let fine: Vec<Vec<Interval>> = refinement
        .refined()
        .joint()
        .row_iter()
        .map(|row| row.iter().map(|entry| number(*entry)).collect())
        .collect();
    let mut coarse = vec![vec![number(0.0); n]; n];
    for (k, row) in fine.iter().enumerate() {
        for (l, entry) in row.iter().enumerate() {
            let cell = &mut coarse[parents[k]][parents[l]];
            *cell = cell.clone() + entry;
        }
    }
    let zero = number(0.0);
    (nats(&fine, &zero) - &nats(&coarse, &zero)) / &number(2.0).ln()
}

/// Mutual information of a symmetric joint matrix, in nats.
fn nats(joint: &[Vec<Interval>], zero: &Interval) -> Interval {
    let weights: Vec<Interval> = joint
        .iter()
        .map(|row| row.iter().fold(zero.clone(), |sum, entry| sum + entry))
        .collect();
    let total = weights
        .iter()
        .fold(zero.clone(), |sum, weight| sum + weight);
    let mut sum = zero.clone();
    for (k, row) in joint.iter().enumerate() {
        for (l, entry) in row.iter().enumerate().take(k + 1) {
            if !entry.is_zero() {
                let ratio = entry.clone() * &total / &weights[k] / &weights[l];
                let both_ways = zero.constant(if k == l { 1.0 } else { 2.0 });
                sum = sum + &(ratio.ln() * entry * &both_ways);
            }
        }
    }
    sum / &total
}
