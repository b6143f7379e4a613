//! The positions of two spans of one axis relative to each other.

use crate::geometry::Span;
use crate::numeric::Scalar;

/// The differences of two spans' ends, kept apart from the ends themselves.
///
/// Over intervals `x − x` is not 0 unless it is known to be the same x: where two spans share an
/// end, or all of their length, only this says so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Offsets<S = f64> {
    differences: [[S; 2]; 2],
    lengths: [S; 2],
}

impl<S: Scalar> Offsets<S> {
    /// Offsets made of the differences themselves: `differences[i][k]` is end i of the first span
    /// less end k of the second, lower ends first; `lengths` are theirs.
    #[must_use]
    pub const fn new(differences: [[S; 2]; 2], lengths: [S; 2]) -> Self {
        Self {
            differences,
            lengths,
        }
    }

    /// The offsets of two spans on one axis.
    #[inline(always)]
    #[must_use]
    pub fn between(first: &Span<S>, second: &Span<S>) -> Self {
        let difference = |a: &S, b: &S| a.clone() - b;
        let row = |end| {
            [
                difference(end, second.lower()),
                difference(end, second.upper()),
            ]
        };
        Self {
            differences: [row(first.lower()), row(first.upper())],
            lengths: [first.length().clone(), second.length().clone()],
        }
    }

    /// The difference of end `i` of the first and end `k` of the second; 0 is the lower one.
    #[must_use]
    pub const fn difference(&self, i: usize, k: usize) -> &S {
        &self.differences[i][k]
    }

    /// The length of the first.
    #[must_use]
    pub const fn first_length(&self) -> &S {
        &self.lengths[0]
    }

    /// The length of the second.
    #[must_use]
    pub const fn second_length(&self) -> &S {
        &self.lengths[1]
    }

    /// Exchanges first and second, unless they are to stay.
    #[inline(always)]
    #[must_use]
    pub fn swapped_unless(&self, stays: bool) -> Self {
        let [[a, b], [c, d]] = &self.differences;
        let [first, second] = &self.lengths;
        let of = |here: &S, there: &S| if stays { here.clone() } else { there.clone() };
        let difference = |here: &S, there: &S| {
            if stays { here.clone() } else { -there.clone() }
        };
        Self {
            differences: [
                [difference(a, a), difference(b, c)],
                [difference(c, b), difference(d, d)],
            ],
            lengths: [of(first, second), of(second, first)],
        }
    }
}
