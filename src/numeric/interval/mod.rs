//! Intervals that contain every value of their expression, which makes a result an *enclosure*.
//!
//! An operation on intervals returns an interval that contains the results for all numbers in its
//! operands, with ends rounded outwards. A formula written over [`Scalar`](super::Scalar) becomes
//! an enclosure of its exact value by being evaluated here.
//!
//! ```text
//!   Interval<f64>       53 bits, fast: for searching
//!   Interval<Precise>   any number of bits, on astro-float: for tightening
//! ```
//!
//! Where an operation is not defined on a part of an operand (division by an interval that contains
//! 0, the logarithm or root of one that reaches below 0) that part counts for nothing or the result
//! is the whole line; no operation fails. Comparisons are certain: `a < b` holds if every number in
//! a is smaller than every number in b, and two intervals are equal only if both are the same
//! single number. A branch of a formula taken on a comparison must therefore be right, if less
//! accurate, on the other side too.
//!
//! **Not covered**: decorations of IEEE 1788; complex numbers.
//!
//! Reference: Moore, Kearfott and Cloud, *Introduction to Interval Analysis*, 2009.

pub(crate) mod arithmetic;
pub(crate) mod constants;
pub(crate) mod decimal;
pub(crate) mod elementary;
pub(crate) mod endpoint;
pub(crate) mod precise;
pub(crate) mod series;

pub use decimal::DecimalBounds;
pub use endpoint::{Direction, Endpoint};
pub use precise::Precise;

use std::cmp::Ordering;

/// The numbers from `lower` to `upper`, both included; an infinite end is not a number of it.
#[derive(Debug, Clone, Copy)]
pub struct Interval<E = Precise> {
    lower: E,
    upper: E,
}

impl<E: Endpoint> Interval<E> {
    /// The interval between two ends; `None` unless `lower ≤ upper`.
    #[must_use]
    pub fn try_new(lower: E, upper: E) -> Option<Self> {
        (lower <= upper).then_some(Self { lower, upper })
    }

    /// The single number `value`.
    #[must_use]
    pub fn point(value: E) -> Self {
        Self {
            lower: value.clone(),
            upper: value,
        }
    }

    /// All real numbers, at the precision of `self`.
    #[must_use]
    pub fn whole_line(&self) -> Self {
        Self {
            lower: self.lower.constant(f64::NEG_INFINITY),
            upper: self.lower.constant(f64::INFINITY),
        }
    }

    /// Lower end.
    #[must_use]
    pub const fn lower(&self) -> &E {
        &self.lower
    }

    /// Upper end.
    #[must_use]
    pub const fn upper(&self) -> &E {
        &self.upper
    }

    /// The length, rounded up.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.upper
            .plus(&self.lower.negated(), Direction::Up)
            .to_double(Direction::Up)
    }

    /// A number of the interval about halfway between the ends; NaN of an interval without bounds.
    #[must_use]
    pub fn midpoint(&self) -> E {
        let half = self.lower.constant(0.5);
        let halves = [&self.lower, &self.upper].map(|end| end.times(&half, Direction::Down));
        let middle = halves[0].plus(&halves[1], Direction::Down);
        // halves of the smallest doubles are rounded by themselves
        larger(smaller(&middle, &self.upper), &self.lower).clone()
    }

    /// Tells whether both ends are finite.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.lower.is_finite() && self.upper.is_finite()
    }

    /// Tells whether the interval is a single number.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.lower == self.upper
    }

    /// Tells whether 0 is in the interval.
    #[must_use]
    pub fn contains_zero(&self) -> bool {
        self.lower.sign().is_le() && self.upper.sign().is_ge()
    }

    /// Tells whether the interval contains all of `other`.
    #[must_use]
    pub fn contains(&self, other: &Self) -> bool {
        self.lower <= other.lower && other.upper <= self.upper
    }

    /// Tells whether the interval contains all of `other` in its inside.
    #[must_use]
    pub fn contains_inside(&self, other: &Self) -> bool {
        self.lower < other.lower && other.upper < self.upper
    }

    /// The numbers in both; `None` if there are none.
    #[must_use]
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let lower = larger(&self.lower, &other.lower);
        let upper = smaller(&self.upper, &other.upper);
        Self::try_new(lower.clone(), upper.clone())
    }

    /// The smallest interval that contains both.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        Self {
            lower: smaller(&self.lower, &other.lower).clone(),
            upper: larger(&self.upper, &other.upper).clone(),
        }
    }

    /// An interval that contains the larger of a number here and a number there.
    #[must_use]
    pub fn larger_of(&self, other: &Self) -> Self {
        Self {
            lower: larger(&self.lower, &other.lower).clone(),
            upper: larger(&self.upper, &other.upper).clone(),
        }
    }

    /// The two halves; `None` where no number lies between the ends.
    #[must_use]
    pub fn halves(&self) -> Option<[Self; 2]> {
        let middle = self.midpoint();
        (self.lower < middle && middle < self.upper).then(|| {
            [
                Self {
                    lower: self.lower.clone(),
                    upper: middle.clone(),
                },
                Self {
                    lower: middle.clone(),
                    upper: self.upper.clone(),
                },
            ]
        })
    }

    /// An enclosure of the interval with ends of `bits` bits, rounded outwards.
    #[must_use]
    pub fn with_precision(&self, bits: u32) -> Self {
        Self {
            lower: self.lower.with_precision(bits, Direction::Down),
            upper: self.upper.with_precision(bits, Direction::Up),
        }
    }

    /// The ends as doubles, rounded outwards.
    #[must_use]
    pub fn to_doubles(&self) -> (f64, f64) {
        (
            self.lower.to_double(Direction::Down),
            self.upper.to_double(Direction::Up),
        )
    }

    /// `xⁿ`.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        use super::Scalar;
        // squares and the base's own products: 13 = 1101₂ is ((x²·x)²)²·x
        let bits = u32::BITS - exponent.leading_zeros();
        let of_end = |end: &E| {
            let base = Self::point(end.clone());
            (0..bits).rev().fold(self.constant(1.0), |power, bit| {
                let square = power.square();
                if exponent >> bit & 1 == 1 {
                    square * &base
                } else {
                    square
                }
            })
        };
        if exponent.is_multiple_of(2) {
            self.abs().rising(of_end)
        } else {
            self.rising(of_end)
        }
    }

    /// The hull of the images of the ends.
    fn at_ends(&self, at: impl Fn(&E) -> Self) -> Self {
        let lower = at(&self.lower);
        if self.is_point() {
            return lower;
        }
        lower.hull(&at(&self.upper))
    }

    /// The image under a function that rises on the whole interval, given as an enclosure at each
    /// end.
    fn rising(&self, at: impl Fn(&E) -> Self) -> Self {
        let lower = at(&self.lower);
        if self.is_point() {
            return lower;
        }
        Self {
            lower: lower.lower,
            upper: at(&self.upper).upper,
        }
    }
}

impl Interval {
    /// The double `value`, exactly, as the start of calculations with `bits` bits.
    #[must_use]
    pub fn precise(value: f64, bits: u32) -> Self {
        if value.is_nan() {
            return Self::point(Precise::new(0.0, bits)).whole_line();
        }
        Self::point(Precise::new(value, bits))
    }

    /// The interval between two doubles, with `bits` bits.
    #[must_use]
    pub fn from_doubles(interval: &Interval<f64>, bits: u32) -> Self {
        Self {
            lower: Precise::new(interval.lower, bits),
            upper: Precise::new(interval.upper, bits),
        }
    }
}

fn smaller<'e, E: PartialOrd>(a: &'e E, b: &'e E) -> &'e E {
    if b < a { b } else { a }
}

fn larger<'e, E: PartialOrd>(a: &'e E, b: &'e E) -> &'e E {
    if b > a { b } else { a }
}

impl<E: Endpoint> PartialEq for Interval<E> {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl<E: Endpoint> PartialOrd for Interval<E> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self.upper < other.lower {
            Some(Ordering::Less)
        } else if self.lower > other.upper {
            Some(Ordering::Greater)
        } else if self.is_point() && other.is_point() {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}
