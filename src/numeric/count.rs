//! Counts as doubles.

/// A whole number that counts something: patches, points, samples.
pub(crate) trait Count {
    /// The count as a double.
    fn to_real(self) -> f64;
}

impl Count for usize {
    #[inline]
    #[expect(
        clippy::cast_precision_loss,
        reason = "exact up to 2⁵³, and no memory holds more things"
    )]
    fn to_real(self) -> f64 {
        self as f64
    }
}

impl Count for u64 {
    #[inline]
    #[expect(
        clippy::cast_precision_loss,
        reason = "exact up to 2⁵³, and no run draws more samples; beyond it the nearest double"
    )]
    fn to_real(self) -> f64 {
        self as f64
    }
}

/// The count as a double, the one conversion in which a count could lose digits.
#[inline]
pub(crate) fn real(count: impl Count) -> f64 {
    count.to_real()
}
