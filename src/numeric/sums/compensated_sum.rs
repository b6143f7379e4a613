//! Sums whose rounding error does not grow with their length.

use super::expansion::two_sum;

/// A sum that can be added to: as if in twice the precision, rounded once at the end.
///
/// **Accuracy** relative to `Σ |x|`: ε/2 plus a term of order `n² ε²` (Neumaier 1974).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct CompensatedSum {
    sum: f64,
    correction: f64,
}

impl CompensatedSum {
    /// Adds a term.
    pub(crate) fn add(&mut self, term: f64) {
        let (sum, lost) = two_sum(self.sum, term);
        self.sum = sum;
        self.correction += lost;
    }

    /// Adds another sum.
    pub(crate) fn add_sum(&mut self, other: &Self) {
        self.add(other.sum);
        self.correction += other.correction;
    }

    /// The leading number and what it lost.
    pub(crate) const fn parts(&self) -> [f64; 2] {
        [self.sum, self.correction]
    }

    /// The sum with these [parts](Self::parts).
    pub(crate) const fn of_parts([sum, correction]: [f64; 2]) -> Self {
        Self { sum, correction }
    }

    /// The sum, rounded.
    #[must_use]
    pub(crate) fn total(&self) -> f64 {
        // an infinite sum has no correction
        if self.sum.is_finite() {
            self.sum + self.correction
        } else {
            self.sum
        }
    }
}

/// `Σ x`, as if summed in twice the precision and rounded once.
///
/// **Accuracy** relative to `Σ |x|`: ε/2 plus a term of order `n² ε²` (Neumaier 1974).
///
/// # Examples
/// ```
/// use infoscene::numeric::compensated_sum;
/// assert_eq!(compensated_sum([1.0, 1e100, 1.0, -1e100]), 2.0);
/// ```
#[must_use]
pub fn compensated_sum(terms: impl IntoIterator<Item = f64>) -> f64 {
    let mut sum = CompensatedSum::default();
    for term in terms {
        sum.add(term);
    }
    sum.total()
}
