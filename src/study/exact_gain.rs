//! The gain of a refinement with hundreds of bits, from the definition (8).
//!
//! ```text
//!   I′ − I = Σ J′ log2( J′_kl/(w′_k w′_l) ) − Σ J log2( J_ij/(w_i w_j) ),   total mass 1
//! ```
//!
//! The coarse entries are the parts' sums, with as many bits. A difference of two numbers of some bits each, it
//! resolves [`RESOLUTION`] with 256 bits; it shares nothing with the sum of non-negative terms it judges.

use crate::chain::Refinement;
use crate::numeric::{BigReal, Scalar};

/// What the difference resolves, in bits: 256 bits are 77 digits, of which the sums use up a few.
pub const RESOLUTION: f64 = 1e-70;

/// `I′ − I` in bits, for the refined joint entries as given.
///
/// **Accuracy** [`RESOLUTION`] absolute with 256 bits, if the entries span fewer than 77 decimal orders; smaller entries are
/// then felt only through their own terms, which is what they are worth.
#[must_use]
pub fn exact_gain<const BITS: usize>(refinement: &Refinement) -> BigReal<BITS> {
    let parents = refinement.parents();
    let n = refinement.coarse().states();
    let zero = BigReal::new(0.0);
    let joint = refinement.refined().joint();
    let fine: Vec<Vec<BigReal<BITS>>> = joint
        .row_iter()
        .map(|row| row.iter().map(|entry| BigReal::new(*entry)).collect())
        .collect();
    let mut coarse = vec![vec![zero; n]; n];
    for (k, row) in fine.iter().enumerate() {
        for (l, entry) in row.iter().enumerate() {
            let cell = &mut coarse[parents[k]][parents[l]];
            *cell = cell.clone() + entry;
        }
    }
    (nats(&fine) - &nats(&coarse)) / &BigReal::new(2.0).ln()
}

/// Mutual information of a symmetric joint matrix, in nats.
fn nats<const BITS: usize>(joint: &[Vec<BigReal<BITS>>]) -> BigReal<BITS> {
    let zero = || BigReal::new(0.0);
    let weights: Vec<BigReal<BITS>> = joint
        .iter()
        .map(|row| row.iter().fold(zero(), |sum, entry| sum + entry))
        .collect();
    let total = weights.iter().fold(zero(), |sum, weight| sum + weight);
    let mut sum = zero();
    for (k, row) in joint.iter().enumerate() {
        for (l, entry) in row.iter().enumerate().take(k + 1) {
            if !entry.is_zero() {
                let ratio = entry.clone() * &total / &weights[k] / &weights[l];
                let both_ways = if k == l { 1.0 } else { 2.0 };
                sum = sum + &(ratio.ln() * entry * &BigReal::new(both_ways));
            }
        }
    }
    sum / &total
}
