//! Real numbers of 320 bits (96 decimal digits), with operators.
//!
//! A thin wrapper of [`astro_float_num::BigFloat`]: the arithmetic keeps 320 bits
//! without correct rounding, so that a result is good to a few units of its
//! last bits, and the constants π and ln 2 are cached per thread.

use astro_float_num::{BigFloat, Consts, Radix, RoundingMode};
use std::cell::RefCell;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// Bits of every mantissa.
const BITS: usize = 320;
const ROUNDING: RoundingMode = RoundingMode::None;

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().unwrap());
}

/// Runs `f` with this thread's cache of constants.
fn with_constants<T>(f: impl FnOnce(&mut Consts) -> T) -> T {
    CONSTANTS.with(|constants| f(&mut constants.borrow_mut()))
}

/// A real number of 320 bits.
#[derive(Clone, Debug)]
pub struct Real(BigFloat);

impl Real {
    /// The number a decimal string states.
    pub fn decimal(text: &str) -> Self {
        let value =
            with_constants(|cc| BigFloat::parse(text.trim(), Radix::Dec, BITS, ROUNDING, cc));
        assert!(!value.is_nan(), "{text:?} is not a decimal number");
        Self(value)
    }

    /// An integer, exactly.
    pub fn int(n: i32) -> Self {
        Self(BigFloat::from_i32(n, BITS))
    }

    /// A double, exactly: used for first guesses only.
    pub fn double(x: f64) -> Self {
        Self(BigFloat::from_f64(x, BITS))
    }

    /// The quotient of two integers.
    pub fn ratio(p: i32, q: i32) -> Self {
        Self::int(p) / Self::int(q)
    }

    /// 2⁻ᵏ, exactly.
    pub fn two_to_minus(k: i32) -> Self {
        let mut value = BigFloat::from_i32(1, BITS);
        value.set_exponent(1 - k);
        Self(value)
    }

    /// π.
    pub fn pi() -> Self {
        Self(with_constants(|cc| cc.pi(BITS, ROUNDING)))
    }

    /// Natural logarithm.
    pub fn ln(&self) -> Self {
        Self(with_constants(|cc| self.0.ln(BITS, ROUNDING, cc)))
    }

    /// Logarithm to base 2, by the natural one.
    pub fn log2(&self) -> Self {
        self.ln() / Self(with_constants(|cc| cc.ln_2(BITS, ROUNDING)))
    }

    /// Arc tangent in (−π/2, π/2).
    pub fn atan(&self) -> Self {
        Self(with_constants(|cc| self.0.atan(BITS, ROUNDING, cc)))
    }

    /// Exponential.
    pub fn exp(&self) -> Self {
        Self(with_constants(|cc| self.0.exp(BITS, ROUNDING, cc)))
    }

    /// Square root.
    pub fn sqrt(&self) -> Self {
        Self(self.0.sqrt(BITS, ROUNDING))
    }

    /// Absolute value.
    pub fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    /// The `n`-th power, by repeated squaring.
    pub fn powi(&self, n: usize) -> Self {
        Self(self.0.powi(n, BITS, ROUNDING))
    }

    /// The square.
    pub fn squared(&self) -> Self {
        self * self
    }

    /// Half of the number.
    pub fn half(&self) -> Self {
        self * &Self::two_to_minus(1)
    }

    /// Whether the number is exactly zero.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Whether the number is above zero.
    pub fn is_above_zero(&self) -> bool {
        self.0.is_positive() && !self.0.is_zero()
    }

    /// The smaller of two numbers.
    pub fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
}

impl PartialEq for Real {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl PartialOrd for Real {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl fmt::Display for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = with_constants(|cc| self.0.format(Radix::Dec, RoundingMode::ToEven, cc));
        let text = text.map_err(|_| fmt::Error)?;
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "+0"));
        f.write_str(&mantissa[..mantissa.len().min(42)])?;
        write!(f, "e{exponent}")
    }
}

impl Neg for Real {
    type Output = Real;
    fn neg(self) -> Real {
        Real(self.0.neg())
    }
}

impl Neg for &Real {
    type Output = Real;
    fn neg(self) -> Real {
        Real(BigFloat::neg(&self.0))
    }
}

impl AddAssign for Real {
    fn add_assign(&mut self, other: Real) {
        self.0 = self.0.add(&other.0, BITS, ROUNDING);
    }
}

/// The four operators, for values and for references.
macro_rules! operator {
    ($operator:ident, $method:ident) => {
        impl $operator<&Real> for &Real {
            type Output = Real;
            fn $method(self, other: &Real) -> Real {
                Real(self.0.$method(&other.0, BITS, ROUNDING))
            }
        }
        impl $operator<Real> for Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                (&self).$method(&other)
            }
        }
        impl $operator<&Real> for Real {
            type Output = Real;
            fn $method(self, other: &Real) -> Real {
                (&self).$method(other)
            }
        }
        impl $operator<Real> for &Real {
            type Output = Real;
            fn $method(self, other: Real) -> Real {
                self.$method(&other)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

#[test]
fn the_arithmetic_keeps_eighty_digits() {
    let unit = Real::decimal("1e-80");
    let root = Real::int(2).sqrt();
    assert!((root.squared() - Real::int(2)).abs() < unit);
    assert!((Real::int(3).ln().exp() - Real::int(3)).abs() < unit);
    assert!((Real::int(1).atan() * Real::int(4) - Real::pi()).abs() < unit);
    assert!((Real::int(8).log2() - Real::int(3)).abs() < unit);
    assert!((Real::two_to_minus(3) - Real::decimal("0.125")).abs() < unit);
    assert_eq!(Real::decimal("-1.5").to_string(), "-1.5e+0");
}
