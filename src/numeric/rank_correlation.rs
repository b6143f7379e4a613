//! Spearman's rank correlation.
//!
//! ```text
//!   ρ = Σ (r_k − r̄)(s_k − r̄)/√(Σ (r_k − r̄)² Σ (s_k − r̄)²)       r, s: ranks, r̄ their mean
//! ```
//!
//! Values that are tied share the mean of their ranks.
//!
//! Reference: Spearman, *The proof and measurement of association between two things*, American
//! Journal of Psychology 15, 1904.

use super::real;

/// Spearman's rank correlation of pairs of values, in `[−1, 1]` up to rounding; none if one side is
/// tied throughout.
///
/// **Arguments** `tied`: the difference of neighbours in order up to which they count as equal.
///
/// # Examples
/// ```
/// use infoscene::numeric::rank_correlation;
/// let falling = [[1.0, 9.0], [2.0, 4.0], [3.0, 1.0]];
/// assert_eq!(rank_correlation(&falling, 0.0), Some(-1.0));
/// ```
#[must_use]
pub fn rank_correlation(pairs: &[[f64; 2]], tied: f64) -> Option<f64> {
    let ranks = [0, 1].map(|side| {
        let values: Vec<f64> = pairs.iter().map(|pair| pair[side]).collect();
        ranks(&values, tied)
    });
    let middle = (real(pairs.len()) - 1.0) / 2.0;
    let product = |a: &[f64], b: &[f64]| -> f64 {
        let off = a.iter().zip(b);
        off.map(|(a, b)| (a - middle) * (b - middle)).sum()
    };
    let [one, other] = [&ranks[0], &ranks[1]];
    let scale = (product(one, one) * product(other, other)).sqrt();
    (scale > 0.0).then(|| product(one, other) / scale)
}

/// The ranks of values from 0, tied ones sharing the mean of theirs.
fn ranks(values: &[f64], tied: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut first = 0;
    for run in order.chunk_by(|a, b| values[*b] - values[*a] <= tied) {
        let mean = real(first) + (real(run.len()) - 1.0) / 2.0;
        for index in run {
            ranks[*index] = mean;
        }
        first += run.len();
    }
    ranks
}
