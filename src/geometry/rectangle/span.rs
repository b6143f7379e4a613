//! An interval of positive length on a coordinate axis.

use crate::geometry::GeometryError;
use crate::numeric::Scalar;

/// The interval from `lower` to `upper`, `lower < upper`, with its length kept apart.
///
/// Far from the origin `upper − lower` would lose digits of a short length that is known exactly.
/// The ends are then rounded, and a length below ε of the ends is lost in them: closed forms take
/// the ends as given, and bounds that are for lengths as given add the difference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span<S = f64> {
    lower: S,
    upper: S,
    length: S,
}

impl Span {
    /// Lifts the span to numbers of the type and precision of `like`: lower end and length exactly
    /// as given.
    #[must_use]
    pub fn lifted<S: Scalar>(&self, like: &S) -> Span<S> {
        let [lower, length] = [self.lower, self.length].map(|end| like.constant(end));
        Span {
            upper: lower.clone() + &length,
            lower,
            length,
        }
    }
}

impl<S: Scalar> Span<S> {
    /// The span between two points in increasing order.
    ///
    /// # Errors
    /// [`GeometryError::EmptySpan`] unless both are finite and `lower < upper`.
    #[inline(always)]
    pub fn try_new(lower: S, upper: S) -> Result<Self, GeometryError> {
        let length = upper.clone() - &lower;
        Self::checked(lower, upper, length)
    }

    /// The span that starts at `lower` and has this length.
    ///
    /// # Errors
    /// [`GeometryError::EmptySpan`] unless both are finite and `length > 0`.
    #[inline(always)]
    pub fn with_length(lower: S, length: S) -> Result<Self, GeometryError> {
        let upper = lower.clone() + &length;
        Self::checked(lower, upper, length)
    }

    #[inline(always)]
    fn checked(lower: S, upper: S, length: S) -> Result<Self, GeometryError> {
        let finite = lower.to_f64().is_finite() && upper.to_f64().is_finite();
        if finite && length > length.zero() && lower < upper {
            Ok(Self {
                lower,
                upper,
                length,
            })
        } else {
            Err(GeometryError::EmptySpan {
                lower: lower.to_f64(),
                upper: upper.to_f64(),
            })
        }
    }

    /// One of two, number by number: for a choice that vector code makes without a branch.
    #[inline(always)]
    #[must_use]
    pub fn either(is_first: bool, first: &Self, second: &Self) -> Self {
        let of = |a: &S, b: &S| if is_first { a.clone() } else { b.clone() };
        Self {
            lower: of(&first.lower, &second.lower),
            upper: of(&first.upper, &second.upper),
            length: of(&first.length, &second.length),
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

    /// Length, > 0.
    #[must_use]
    pub const fn length(&self) -> &S {
        &self.length
    }

    /// The part at and above `floor`; `None` if nothing of positive length is left. Over intervals
    /// the comparison must be certain: a span that may or may not reach above `floor` counts as
    /// nothing.
    #[must_use]
    #[inline(always)]
    pub fn above(&self, floor: &S) -> Option<Self> {
        if self.lower < *floor {
            Self::try_new(floor.clone(), self.upper.clone()).ok()
        } else {
            Some(self.clone())
        }
    }

    /// The span moved by `shift`.
    #[must_use]
    #[inline(always)]
    pub fn shifted(&self, shift: &S) -> Self {
        let (lower, upper) = (self.lower.clone() + shift, self.upper.clone() + shift);
        Self {
            lower,
            upper,
            length: self.length.clone(),
        }
    }

    /// The span seen from `origin` in the opposite direction:
    /// `origin − upper … origin − lower`.
    #[must_use]
    #[inline(always)]
    pub fn mirrored(&self, origin: &S) -> Self {
        let (lower, upper) = (origin.clone() - &self.upper, origin.clone() - &self.lower);
        Self {
            lower,
            upper,
            length: self.length.clone(),
        }
    }

    /// The part between two relative positions in `[0, 1]`.
    ///
    /// # Errors
    /// [`GeometryError::EmptySpan`] if they coincide or are out of order.
    pub fn part(&self, from: &S, to: &S) -> Result<Self, GeometryError> {
        let at = |t: &S| {
            // 1 itself, not a variable that is there just now
            if (t.clone() - &t.constant(1.0)).is_zero() {
                self.upper.clone()
            } else {
                self.length.clone() * t + &self.lower
            }
        };
        Self::checked(at(from), at(to), (to.clone() - from) * &self.length)
    }
}
