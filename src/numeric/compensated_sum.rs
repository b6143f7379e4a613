//! Sums whose rounding error does not grow with their length.

use super::expansion::two_sum;

/// `Σ x`, as if summed in twice the precision and rounded once.
///
/// **Accuracy** relative to `Σ |x|`: ε/2 plus a term of order `n² ε²` (Neumaier 1974).
#[must_use]
pub fn compensated_sum(terms: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, correction) = terms
        .into_iter()
        .fold((0.0, 0.0), |(sum, correction), term| {
            let (sum, lost) = two_sum(sum, term);
            (sum, correction + lost)
        });
    // an infinite sum has no correction
    if sum.is_finite() {
        sum + correction
    } else {
        sum
    }
}
