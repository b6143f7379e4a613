//! Numbers of 106 bits: the unevaluated sum of two doubles.
//!
//! ```text
//!   x = high + low,   |low| ≤ ½ ulp(high)
//!   ln x   = k ln 2 + ln c + 2 Σ z^(2i+1)/(2i+1)     x = 2^k m,  c = m rounded to 1/32,
//!                                                    z = (m − c)/(m + c)
//!   atan t = atan c + Σ (−1)^i u^(2i+1)/(2i+1)       c = t rounded to 1/32,  u = (t − c)/(1 + t c)
//! ```
//!
//! Sums and products are within 4 ε², quotients and roots within 16 ε², functions within 64 ε²
//! (held by `double_doubles_keep_their_bound`), as long as nothing leaves the range of `f64`.
//!
//! Everything is inlined, so that code made for a processor with fused multiply-add has it inside.
//!
//! **Not covered**: infinities, and magnitudes below 1e-290, whose low halves are lost.
//!
//! Reference: Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks
//! of double-word arithmetic", *ACM Trans. Math. Softw.* 44 (2017), 15.

use super::{Interval, Scalar};
use crate::numeric::sums::expansion::two_sum;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::LazyLock;

/// A number as the sum of two doubles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

/// `ε²`: what the relative errors of this arithmetic are multiples of.
pub const SQUARED_EPSILON: f64 = f64::EPSILON * f64::EPSILON;

impl DoubleDouble {
    /// The sum of two doubles, exactly but for its rounding to 106 bits.
    #[must_use]
    #[inline(always)]
    pub fn sum(a: f64, b: f64) -> Self {
        let (high, low) = two_sum(a, b);
        Self { high, low }
    }

    /// `a − b`, exactly but for its rounding to 106 bits.
    #[must_use]
    #[inline(always)]
    pub fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// The leading double.
    #[must_use]
    pub const fn high(self) -> f64 {
        self.high
    }

    /// The rest beside the leading double.
    #[must_use]
    pub const fn low(self) -> f64 {
        self.low
    }

    /// The sum of two doubles, the first not smaller than the second.
    #[inline(always)]
    fn fast_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self {
            high,
            low: b - (high - a),
        }
    }

    #[inline(always)]
    fn times(self, factor: f64) -> Self {
        let high = self.high * factor;
        let low = self.high.mul_add(factor, -high);
        Self::fast_sum(high, self.low.mul_add(factor, low))
    }

    /// Times a power of two.
    #[inline(always)]
    fn scaled(self, power: f64) -> Self {
        Self {
            high: self.high * power,
            low: self.low * power,
        }
    }

    /// `Σ_{i ≥ 0} sign^i z^(2i+1)/(2i+1)` for |z| ≤ 1/60.
    #[inline(always)]
    fn odd_series(self, sign: f64) -> Self {
        // z²⁰ is below ε² there; the first terms need no low half
        let square = (self * self).scaled(sign);
        let rough = square.high * (1.0 / 17.0 + square.high * (1.0 / 19.0 + square.high / 21.0));
        let mut sum = Self::fast_sum(ODD_RECIPROCALS[0].high, ODD_RECIPROCALS[0].low + rough);
        for reciprocal in &ODD_RECIPROCALS[1..] {
            sum = sum * square + *reciprocal;
        }
        sum * self
    }

    fn of_enclosure(value: &Interval) -> Self {
        let high = value.to_f64();
        let low = (value.clone() - &value.constant(high)).to_f64();
        Self { high, low }
    }
}

/// 1/15, 1/13, … 1, to 106 bits: the low halves are (1 − k high)/k, exact in the numerator.
const ODD_RECIPROCALS: [DoubleDouble; 8] = {
    let mut reciprocals = [DoubleDouble {
        high: 1.0,
        low: 0.0,
    }; 8];
    let mut i = 0;
    while i < 7 {
        let k = 15.0 - 2.0 * i as f64;
        let high = 1.0 / k;
        // high = top + rest with few bits each, so that k times them is exact
        let split = 134_217_729.0 * high;
        let top = split - (split - high);
        let rest = high - top;
        reciprocals[i] = DoubleDouble {
            high,
            low: ((1.0 - k * top) - k * rest) / k,
        };
        i += 1;
    }
    reciprocals
};

/// `ln(c)` for `c = 22/32 … 46/32`.
static LOGARITHMS: LazyLock<Vec<DoubleDouble>> = LazyLock::new(|| {
    let c = |step: u32| Interval::precise(f64::from(step) / 32.0, 192);
    (22..=46)
        .map(|step| DoubleDouble::of_enclosure(&c(step).ln()))
        .collect()
});

/// `atan(c)` for `c = 0 … 32/32`.
static ANGLES: LazyLock<Vec<DoubleDouble>> = LazyLock::new(|| {
    let one = Interval::precise(1.0, 192);
    let c = |step: u32| one.constant(f64::from(step) / 32.0);
    (0..=32)
        .map(|step| DoubleDouble::of_enclosure(&c(step).atan2(&one)))
        .collect()
});

static PI: LazyLock<DoubleDouble> =
    LazyLock::new(|| DoubleDouble::of_enclosure(&Interval::precise(1.0, 192).pi()));

static LN_2: LazyLock<DoubleDouble> =
    LazyLock::new(|| DoubleDouble::of_enclosure(&Interval::precise(2.0, 192).ln()));

impl From<f64> for DoubleDouble {
    #[inline(always)]
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl PartialOrd for DoubleDouble {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.high.partial_cmp(&other.high) {
            Some(Ordering::Equal) => self.low.partial_cmp(&other.low),
            decided => decided,
        }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let sum = Self::fast_sum(high.high, high.low + low.high);
        Self::fast_sum(sum.high, low.low + sum.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let high = self.high * other.high;
        let low = self.high.mul_add(other.high, -high);
        let cross = self.high.mul_add(other.low, self.low * other.high);
        Self::fast_sum(high, low + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self - other.times(first);
        let second = rest.high / other.high;
        let third = (rest - other.times(second)).high / other.high;
        Self::fast_sum(first, second) + Self::from(third)
    }
}

macro_rules! by_reference {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator<&Self> for DoubleDouble {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: &Self) -> Self {
                $operator::$method(self, *other)
            }
        }
    )*};
}
by_reference!(Add add, Sub sub, Mul mul, Div div);

impl Scalar for DoubleDouble {
    #[inline(always)]
    fn constant(&self, value: f64) -> Self {
        value.into()
    }
    #[inline(always)]
    fn pi(&self) -> Self {
        *PI
    }
    #[inline(always)]
    fn to_f64(&self) -> f64 {
        self.high
    }
    #[inline(always)]
    fn sqrt(&self) -> Self {
        let root = self.high.sqrt();
        if root <= 0.0 {
            return Self::from(root);
        }
        let rest = *self - Self::from(root) * Self::from(root);
        Self::fast_sum(root, rest.high / (2.0 * root))
    }
    #[inline(always)]
    fn ln(&self) -> Self {
        if !(self.high > 0.0 && self.high < f64::INFINITY) {
            return Self::from(self.high.ln());
        }
        // exact powers of two, so that the leading half of m lies in [√½, √2)
        let exponent = (self.high * std::f64::consts::SQRT_2).log2().floor();
        let m = self
            .scaled((-exponent / 2.0).floor().exp2())
            .scaled((-exponent / 2.0).ceil().exp2());
        let step = (m.high * 32.0).round().clamp(22.0, 46.0);
        let c = Self::from(step / 32.0);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "22 to 46"
        )]
        let log_c = LOGARITHMS[step as usize - 22];
        let series = ((m - c) / (m + c)).odd_series(1.0).scaled(2.0);
        LN_2.times(exponent) + (log_c + series)
    }
    #[inline(always)]
    fn ln_1p(&self) -> Self {
        if self.high.abs() < 1.0 / 32.0 {
            // 2 atanh(x/(2 + x))
            (*self / (*self + Self::from(2.0)))
                .odd_series(1.0)
                .scaled(2.0)
        } else {
            (*self + Self::from(1.0)).ln()
        }
    }
    #[inline(always)]
    fn exp(&self) -> Self {
        self.exp_m1() + Self::from(1.0)
    }
    #[inline(always)]
    fn exp_m1(&self) -> Self {
        // halved until small, then (1 + y)² − 1 = y (2 + y) as often
        let halvings = (self.high.abs() * 64.0).log2().ceil().max(0.0);
        let x = self.scaled((-halvings).exp2());
        let mut sum = Self::from(1.0);
        for k in (2..=15).rev() {
            sum = sum * x / Self::from(f64::from(k)) + Self::from(1.0);
        }
        let mut y = sum * x;
        let mut left = halvings;
        while left > 0.0 {
            y = y * (y + Self::from(2.0));
            left -= 1.0;
        }
        y
    }
    #[inline(always)]
    fn atan2(&self, x: &Self) -> Self {
        let (up, across) = (self.abs(), x.abs());
        let steep = up > across;
        let (short, long) = if steep { (across, up) } else { (up, across) };
        let t = if long.high > 0.0 { short / long } else { short };
        let step = (t.high * 32.0).round().clamp(0.0, 32.0);
        let c = Self::from(step / 32.0);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "0 to 32"
        )]
        let angle_c = ANGLES[step as usize];
        let octant = angle_c + ((t - c) / (Self::from(1.0) + t * c)).odd_series(-1.0);
        let quadrant = if steep {
            PI.scaled(0.5) - octant
        } else {
            octant
        };
        let half = if x.high < 0.0 {
            *PI - quadrant
        } else {
            quadrant
        };
        if self.high < 0.0 { -half } else { half }
    }
    #[inline(always)]
    fn divergence_kernel(&self) -> Self {
        let x = *self;
        if x <= Self::from(-1.0) {
            return Self::from(1.0);
        }
        if x.high.abs() > 1.0 / 16.0 {
            return (x + Self::from(1.0)) * x.ln_1p() - x;
        }
        // Σ_{k ≥ 2} (−x)^k / (k (k − 1))
        let mut sum = Self::from(0.0);
        for k in (2..=28).rev() {
            let k = f64::from(k);
            sum = Self::from(1.0) / Self::from(k * (k - 1.0)) - sum * x;
        }
        sum * x * x
    }
    #[inline(always)]
    fn x_ln_x(&self) -> Self {
        if self.is_zero() {
            *self
        } else {
            *self * self.abs().ln()
        }
    }
}
