//! Ends of intervals that round to nearest where they must round outwards: the negative control of
//! every enclosure.

use super::intervals::{Judge, Judged};
use infoscene::numeric::interval::{Direction, Endpoint};

/// No fault.
pub const NONE: u8 = 0;
/// Sums are rounded to nearest.
pub const ADD: u8 = 1;
/// Products are.
pub const MULTIPLY: u8 = 2;
/// Quotients are.
pub const DIVIDE: u8 = 4;
/// Roots are.
pub const ROOT: u8 = 8;
/// All are.
pub const ALL: u8 = ADD | MULTIPLY | DIVIDE | ROOT;

/// A double with some faults: a type for each choice, as constants are kept by type.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Misrounded<const FAULTS: u8>(pub f64);

impl<const FAULTS: u8> Misrounded<FAULTS> {
    const fn either(fault: u8, nearest: f64, outward: f64) -> Self {
        Self(if FAULTS & fault == 0 {
            outward
        } else {
            nearest
        })
    }
}

impl<const FAULTS: u8> Endpoint for Misrounded<FAULTS> {
    fn constant(&self, value: f64) -> Self {
        Self(value)
    }
    fn with_precision(&self, _bits: u32, _direction: Direction) -> Self {
        *self
    }
    fn bits(&self) -> u32 {
        self.0.bits()
    }
    fn negated(&self) -> Self {
        Self(-self.0)
    }
    fn plus(&self, other: &Self, direction: Direction) -> Self {
        Self::either(ADD, self.0 + other.0, self.0.plus(&other.0, direction))
    }
    fn times(&self, other: &Self, direction: Direction) -> Self {
        Self::either(
            MULTIPLY,
            self.0 * other.0,
            self.0.times(&other.0, direction),
        )
    }
    fn over(&self, other: &Self, direction: Direction) -> Self {
        Self::either(DIVIDE, self.0 / other.0, self.0.over(&other.0, direction))
    }
    fn root(&self, direction: Direction) -> Self {
        Self::either(ROOT, self.0.sqrt(), self.0.root(direction))
    }
    fn scaled(&self, power: i32, direction: Direction) -> Self {
        Self(self.0.scaled(power, direction))
    }
    fn exponent(&self) -> i32 {
        self.0.exponent()
    }
    fn to_double(&self, _direction: Direction) -> f64 {
        self.0
    }
    fn is_finite(&self) -> bool {
        self.0.is_finite()
    }
}

impl<const FAULTS: u8> Judged for Misrounded<FAULTS> {
    fn exact(&self) -> Judge {
        self.0.exact()
    }
    fn unit(&self) -> Judge {
        self.0.unit()
    }
}
