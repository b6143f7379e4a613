//! Sums, products and quotients of intervals.
//!
//! Each end of a result is one operation on ends, chosen by signs; a product takes four only where
//! both factors have both signs.

use super::Interval;
use super::endpoint::{Direction, Endpoint};
use std::ops::{Add, Div, Mul, Neg, Sub};

impl<E: Endpoint> Neg for Interval<E> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            lower: self.upper.negated(),
            upper: self.lower.negated(),
        }
    }
}

impl<E: Endpoint> Add<&Self> for Interval<E> {
    type Output = Self;
    fn add(self, other: &Self) -> Self {
        Self {
            lower: self.lower.plus(&other.lower, Direction::Down),
            upper: self.upper.plus(&other.upper, Direction::Up),
        }
    }
}

impl<E: Endpoint> Sub<&Self> for Interval<E> {
    type Output = Self;
    fn sub(self, other: &Self) -> Self {
        Self {
            lower: self.lower.plus(&other.upper.negated(), Direction::Down),
            upper: self.upper.plus(&other.lower.negated(), Direction::Up),
        }
    }
}

/// `x · y` where an infinite end stands for arbitrarily large numbers: times 0 it is 0.
fn product<E: Endpoint>(x: &E, y: &E, direction: Direction) -> E {
    if x.is_zero() || y.is_zero() {
        x.constant(0.0)
    } else {
        x.times(y, direction)
    }
}

/// `x / y` where an infinite y leaves 0.
fn quotient<E: Endpoint>(x: &E, y: &E, direction: Direction) -> E {
    if x.is_zero() || !y.is_finite() {
        x.constant(0.0)
    } else {
        x.over(y, direction)
    }
}

/// The side of 0 on which an interval lies.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// An interval of numbers ≥ 0.
    Right,
    /// An interval of numbers ≤ 0.
    Left,
    /// An interval with numbers of both signs.
    Both,
}

impl<E: Endpoint> Interval<E> {
    pub(super) fn side(&self) -> Side {
        if self.lower.sign().is_ge() {
            Side::Right
        } else if self.upper.sign().is_le() {
            Side::Left
        } else {
            Side::Both
        }
    }
}

impl<E: Endpoint> Mul<&Self> for Interval<E> {
    type Output = Self;
    fn mul(self, other: &Self) -> Self {
        use Direction::{Down, Up};
        let (a, b) = (&self, other);
        let ends = |lower: [&E; 2], upper: [&E; 2]| Self {
            lower: product(lower[0], lower[1], Down),
            upper: product(upper[0], upper[1], Up),
        };
        match (a.side(), b.side()) {
            (Side::Right, Side::Right) => ends([&a.lower, &b.lower], [&a.upper, &b.upper]),
            (Side::Right, Side::Left) => ends([&a.upper, &b.lower], [&a.lower, &b.upper]),
            (Side::Right, Side::Both) => ends([&a.upper, &b.lower], [&a.upper, &b.upper]),
            (Side::Left, Side::Right) => ends([&a.lower, &b.upper], [&a.upper, &b.lower]),
            (Side::Left, Side::Left) => ends([&a.upper, &b.upper], [&a.lower, &b.lower]),
            (Side::Left, Side::Both) => ends([&a.lower, &b.upper], [&a.lower, &b.lower]),
            (Side::Both, Side::Right) => ends([&a.lower, &b.upper], [&a.upper, &b.upper]),
            (Side::Both, Side::Left) => ends([&a.upper, &b.lower], [&a.lower, &b.lower]),
            (Side::Both, Side::Both) => ends([&a.lower, &b.upper], [&a.upper, &b.upper])
                .hull(&ends([&a.upper, &b.lower], [&a.lower, &b.lower])),
        }
    }
}

impl<E: Endpoint> Div<&Self> for Interval<E> {
    type Output = Self;
    fn div(self, other: &Self) -> Self {
        use Direction::{Down, Up};
        let (a, b) = match other.side() {
            Side::Both => return self.whole_line(),
            Side::Left => (-self, -other.clone()),
            Side::Right => (self, other.clone()),
        };
        if b.upper.is_zero() {
            return a.whole_line();
        }
        // b > 0, or from 0 upwards: then quotients have no bound away from 0
        let infinity = |sign: f64| a.lower.constant(sign * f64::INFINITY);
        let lower = match () {
            () if a.lower.sign().is_ge() => quotient(&a.lower, &b.upper, Down),
            () if b.lower.is_zero() => infinity(-1.0),
            () => quotient(&a.lower, &b.lower, Down),
        };
        let upper = match () {
            () if a.upper.sign().is_le() => quotient(&a.upper, &b.upper, Up),
            () if b.lower.is_zero() => infinity(1.0),
            () => quotient(&a.upper, &b.lower, Up),
        };
        Self { lower, upper }
    }
}

macro_rules! by_value {
    ($trait:ident, $method:ident) => {
        impl<E: Endpoint> $trait for Interval<E> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                $trait::$method(self, &other)
            }
        }
    };
}
by_value!(Add, add);
by_value!(Sub, sub);
by_value!(Mul, mul);
by_value!(Div, div);
