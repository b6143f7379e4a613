//! A number with its derivative: what a formula over [`Scalar`] becomes when its slope is wanted
//! too.
//!
//! ```text
//!   (x, x′) ∘ f = (f(x), f′(x) x′)
//! ```
//!
//! Over intervals the slope is an enclosure of the derivative at every point of the interval.
//!
//! **Not covered**: several variables at once; the slope of `|x|` where the sign is open.
//!
//! Reference: Griewank and Walther, *Evaluating Derivatives*, 2008, ch. 3.

use super::Scalar;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its derivative by one variable.
#[derive(Debug, Clone, Copy)]
pub struct Dual<S> {
    /// The value.
    pub value: S,
    /// The derivative.
    pub slope: S,
}

impl<S: Scalar> Dual<S> {
    /// The variable itself: slope 1.
    #[must_use]
    pub fn variable(value: S) -> Self {
        let slope = value.constant(1.0);
        Self { value, slope }
    }

    /// A number that does not vary: slope 0.
    #[must_use]
    pub fn constant_like(value: &S) -> Self {
        Self {
            value: value.clone(),
            slope: value.zero(),
        }
    }

    /// A function's value and its derivative there, by the chain rule; a slope that is exactly 0
    /// stays so.
    fn through(&self, value: S, derivative: impl FnOnce() -> S) -> Self {
        let slope = if self.slope.is_zero() {
            self.slope.clone()
        } else {
            derivative() * &self.slope
        };
        Self { value, slope }
    }
}

/// Compares values alone.
impl<S: Scalar> PartialEq for Dual<S> {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

/// Orders by value alone.
impl<S: Scalar> PartialOrd for Dual<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl<S: Scalar> Add<&Self> for Dual<S> {
    type Output = Self;
    fn add(self, other: &Self) -> Self {
        Self {
            value: self.value + &other.value,
            slope: self.slope + &other.slope,
        }
    }
}

impl<S: Scalar> Sub<&Self> for Dual<S> {
    type Output = Self;
    fn sub(self, other: &Self) -> Self {
        Self {
            value: self.value - &other.value,
            slope: self.slope - &other.slope,
        }
    }
}

impl<S: Scalar> Mul<&Self> for Dual<S> {
    type Output = Self;
    fn mul(self, other: &Self) -> Self {
        Self {
            slope: self.slope * &other.value + &(other.slope.clone() * &self.value),
            value: self.value * &other.value,
        }
    }
}

impl<S: Scalar> Div<&Self> for Dual<S> {
    type Output = Self;
    fn div(self, other: &Self) -> Self {
        let value = self.value / &other.value;
        let slope = (self.slope - &(other.slope.clone() * &value)) / &other.value;
        Self { value, slope }
    }
}

macro_rules! by_value {
    ($trait:ident, $method:ident) => {
        impl<S: Scalar> $trait for Dual<S> {
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

impl<S: Scalar> Scalar for Dual<S> {
    const TRACKS_ROUNDING: bool = false;

    fn constant(&self, value: f64) -> Self {
        Self {
            value: self.value.constant(value),
            slope: self.value.zero(),
        }
    }
    fn pi(&self) -> Self {
        Self {
            value: self.value.pi(),
            slope: self.value.zero(),
        }
    }
    fn to_f64(&self) -> f64 {
        self.value.to_f64()
    }
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.is_zero()
    }
    fn is_nonnegative(&self) -> bool {
        self.value.is_nonnegative()
    }
    fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        self.through(root.clone(), || root.constant(0.5) / &root)
    }
    fn ln(&self) -> Self {
        self.through(self.value.ln(), || self.value.constant(1.0) / &self.value)
    }
    fn ln_1p(&self) -> Self {
        let one = self.value.constant(1.0);
        self.through(self.value.ln_1p(), || one.clone() / &(one + &self.value))
    }
    fn exp(&self) -> Self {
        let exp = self.value.exp();
        self.through(exp.clone(), || exp)
    }
    fn exp_m1(&self) -> Self {
        self.through(self.value.exp_m1(), || self.value.exp())
    }
    fn atan2(&self, x: &Self) -> Self {
        let value = self.value.atan2(&x.value);
        if self.slope.is_zero() && x.slope.is_zero() {
            return Self {
                slope: value.zero(),
                value,
            };
        }
        let zero = value.zero();
        let is_aside = matches!(
            self.value.partial_cmp(&zero),
            Some(Ordering::Less | Ordering::Greater)
        );
        if !is_aside && !x.value.is_nonnegative() {
            // the angle may jump across the half-line x < 0, y = 0, and a jump has no bounded slope
            let slope = value.constant(1.0) / &zero;
            return Self { value, slope };
        }
        let turn = self.slope.clone() * &x.value - &(x.slope.clone() * &self.value);
        let slope = turn / &(self.value.square() + &x.value.square());
        Self { value, slope }
    }
    fn divergence_kernel(&self) -> Self {
        self.through(self.value.divergence_kernel(), || self.value.ln_1p())
    }
    fn x_ln_x(&self) -> Self {
        self.through(self.value.x_ln_x(), || {
            self.value.abs().ln() + &self.value.constant(1.0)
        })
    }
    fn abs(&self) -> Self {
        let zero = self.value.zero();
        self.through(self.value.abs(), || {
            let sign = |sign: f64| self.value.constant(sign);
            if self.value > zero {
                sign(1.0)
            } else if self.value < zero {
                sign(-1.0)
            } else {
                sign(1.0) / &zero
            }
        })
    }
    fn square(&self) -> Self {
        let twice = || self.value.clone() + &self.value;
        self.through(self.value.square(), twice)
    }
}
