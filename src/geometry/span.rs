//! An interval of positive length on a coordinate axis.

use super::GeometryError;
use crate::numeric::Scalar;

/// From `lower` to `upper`, `lower < upper`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span<S = f64> {
    lower: S,
    upper: S,
}

impl<S: Scalar> Span<S> {
    /// The span between two points in increasing order.
    ///
    /// # Errors
    /// [`GeometryError::EmptySpan`] unless both are finite and `lower < upper`.
    pub fn try_new(lower: S, upper: S) -> Result<Self, GeometryError> {
        let finite = lower.to_f64().is_finite() && upper.to_f64().is_finite();
        if finite && lower < upper {
            Ok(Self { lower, upper })
        } else {
            Err(GeometryError::EmptySpan { lower: lower.to_f64(), upper: upper.to_f64() })
        }
    }

    /// Lower end.
    #[must_use]
    pub const fn lower(&self) -> &S {
        &self.lower
    }

    /// Upper end.
    #[must_use]
    pub const fn upper(&self) -> &S {
        &self.upper
    }

    /// `upper − lower`, > 0.
    #[must_use]
    pub fn length(&self) -> S {
        self.upper.clone() - &self.lower
    }

    /// The part at and above `floor`; `None` if nothing of positive length is left.
    #[must_use]
    pub fn above(&self, floor: &S) -> Option<Self> {
        let lower = if self.lower < *floor { floor.clone() } else { self.lower.clone() };
        (lower < self.upper).then(|| Self { lower, upper: self.upper.clone() })
    }

    /// The same span seen from `origin` in the opposite direction: `origin − upper … origin − lower`.
    #[must_use]
    pub fn mirrored(&self, origin: &S) -> Self {
        Self { lower: origin.clone() - &self.upper, upper: origin.clone() - &self.lower }
    }

    /// The part between two relative positions in `[0, 1]`.
    ///
    /// # Errors
    /// [`GeometryError::EmptySpan`] if they coincide or are out of order.
    pub fn part(&self, from: &S, to: &S) -> Result<Self, GeometryError> {
        let length = self.length();
        let at = |t: &S| {
            if *t == t.constant(1.0) {
                self.upper.clone()
            } else {
                length.clone() * t + &self.lower
            }
        };
        Self::try_new(at(from), at(to))
    }
}
