//! Elementary functions of intervals, from the four operations alone.
//!
//! Each function is evaluated at the ends (all are monotone by pieces) by an argument reduction and
//! a power series in interval arithmetic, with [`GUARD_BITS`] more bits, in whole words. What a
//! series leaves out is one more interval: the Horner scheme starts from an enclosure of the whole
//! tail.
//!
//! ```text
//!   ln m = ln c + 2 atanh z,   c = 1 + i/64,  z = (m − c)/(m + c),  |z| ≤ 1/192
//!   atanh z = z + z³ (1/3 + z²/5 + …)         tail from term k: [1, 2]/(2k+3) for z² ≤ 1/2
//!   atan t = atan c + atan r,  c = i/32,      r = (t − c)/(1 + t c),  |r| ≤ 2⁻⁶
//!   atan r = r − r³ (1/3 − r²/5 + …)          tail from term k: [0, 1]/(2k+3) for r² ≤ 1
//!   eˣ = 2ᵏ (e^r)^256,         r = (x − k ln 2)/256
//!   e^r = 1 + r/1 (1 + r/2 (…))               tail [1/2, 2] for |r| ≤ 1/2
//! ```

use super::Interval;
use super::arithmetic::Side;
use super::constants::{ATAN_STEPS, Constants, LN_2_HEAD, LN_ENTRIES, LN_STEPS, WORD};
use super::endpoint::{Direction, Endpoint};
use super::series::{atan_series, atanh, atanh_tail, exponential_tail};
use crate::numeric::Scalar;
use std::ops::RangeInclusive;

/// More bits than the result has, where the ends can hold them.
const GUARD_BITS: u32 = 32;
/// The number of times that the argument of an exponential is halved.
const HALVINGS: i32 = 8;

/// The nearest whole number among `entries`.
fn nearest(value: f64, entries: RangeInclusive<i32>) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "clamped to a small number")]
    let nearest = value.round() as i32;
    nearest.clamp(*entries.start(), *entries.end())
}

/// Functions of one end, as enclosures to within a few units in the last place; the guard bits come
/// from `Interval::with_guard`.
impl<E: Endpoint> Interval<E> {
    pub(super) fn guarded(end: &E) -> E {
        let bits = (end.bits() + GUARD_BITS).next_multiple_of(WORD);
        end.with_precision(bits, Direction::Down)
    }

    /// A function of one end, evaluated with guard bits.
    fn with_guard(at: impl Fn(&E) -> Self) -> impl Fn(&E) -> Self {
        move |end| at(&Self::guarded(end)).with_precision(end.bits())
    }

    /// `ln m` for m in [3/4, 3/2], given m − 1.
    fn ln_near_one(excess: &Self, constants: &Constants<E>) -> Self {
        let like = &excess.lower;
        let steps = f64::from(LN_STEPS);
        let middle = excess.midpoint().to_double(Direction::Down);
        let i = nearest(middle * steps, LN_ENTRIES);
        let offset = Self::point(like.constant(f64::from(i) / steps));
        let two = Self::point(like.constant(2.0));
        let difference = excess.clone() - &offset;
        let z = difference / &(excess.clone() + &(offset + &two));
        let near = atanh(&z, &constants.reciprocals);
        near.scaled(1) + &constants.ln[(i - LN_ENTRIES.start()).unsigned_abs() as usize]
    }

    fn ln_of(end: &E) -> Self {
        let zero = end.constant(0.0);
        if !end.is_finite() || *end <= zero {
            let bound = if *end > zero {
                f64::INFINITY
            } else {
                f64::NEG_INFINITY
            };
            return Self::point(end.constant(bound));
        }
        let constants = Constants::of(end);
        let mut power = end.exponent();
        let mut significand = end.scaled(-power, Direction::Down);
        if significand > end.constant(1.5) {
            power += 1;
            significand = end.scaled(-power, Direction::Down);
        }
        // m in [3/4, 3/2], so that m − 1 is exact
        let excess = Self::point(significand) - &Self::point(end.constant(1.0));
        let exponent = Self::point(end.constant(f64::from(power)));
        constants.ln_2.clone() * &exponent + &Self::ln_near_one(&excess, &constants)
    }

    fn ln_1p_of(end: &E) -> Self {
        if *end < end.constant(-0.25) || *end > end.constant(0.5) {
            let one_plus = Self::point(end.clone()) + &Self::point(end.constant(1.0));
            return one_plus.rising(Self::ln_of);
        }
        Self::ln_near_one(&Self::point(end.clone()), &Constants::of(end))
    }

    fn exp_of(end: &E) -> Self {
        let value = end.to_double(Direction::Down);
        if !(-1e9..=1e9).contains(&value) {
            // beyond any exponent
            let one = end.constant(1.0);
            return if value > 0.0 {
                Self {
                    lower: one.scaled(i32::MAX, Direction::Down),
                    upper: end.constant(f64::INFINITY),
                }
            } else {
                Self {
                    lower: end.constant(0.0),
                    upper: one.scaled(-i32::MAX, Direction::Up),
                }
            };
        }
        // every halving is a squaring later, which doubles the error: none where there are no guard
        // bits
        let halvings = if end.bits() > f64::MANTISSA_DIGITS {
            HALVINGS
        } else {
            0
        };
        let constants = Constants::of(end);
        let power = (value / std::f64::consts::LN_2).round();
        let multiple = |part: &Self| part.clone() * &Self::point(end.constant(power));
        let head = Self::point(end.constant(LN_2_HEAD));
        let reduced = Self::point(end.clone()) - &multiple(&head) - &multiple(&constants.ln_2_tail);
        let reduced = reduced.scaled(-halvings);
        let one = Self::point(end.constant(1.0));
        let start = exponential_tail(&reduced, &constants.reciprocals) * &reduced + &one;
        let exp = (0..halvings).fold(start, |power, _| power.square());
        #[expect(clippy::cast_possible_truncation, reason = "below 2e9")]
        exp.scaled(power as i32)
    }

    fn exp_m1_of(end: &E) -> Self {
        if *end < end.constant(-0.25) || *end > end.constant(0.25) {
            return Self::exp_of(end) - &Self::point(end.constant(1.0));
        }
        let r = Self::point(end.clone());
        exponential_tail(&r, &Constants::of(end).reciprocals) * &r
    }

    fn atan_of(end: &E) -> Self {
        let constants = Constants::of(end);
        let one = end.constant(1.0);
        let half_pi = || constants.pi.scaled(-1);
        if !end.is_finite() {
            if *end < one { -half_pi() } else { half_pi() }
        } else if *end > one {
            let complement = Self::point(one) / &Self::point(end.clone());
            half_pi() - &Self::atan_within(&complement, &constants)
        } else if *end < one.negated() {
            let complement = Self::point(one) / &Self::point(end.clone());
            -half_pi() - &Self::atan_within(&complement, &constants)
        } else {
            Self::atan_within(&Self::point(end.clone()), &constants)
        }
    }

    /// Encloses atan t for |t| ≤ 1.
    fn atan_within(t: &Self, constants: &Constants<E>) -> Self {
        let middle = t.midpoint().to_double(Direction::Down);
        if middle < 0.0 {
            return -Self::atan_within(&-t.clone(), constants);
        }
        let steps = f64::from(ATAN_STEPS);
        let i = nearest(middle * steps, 0..=ATAN_STEPS);
        let c = Self::point(t.lower.constant(f64::from(i) / steps));
        let one = Self::point(t.lower.constant(1.0));
        let r = (t.clone() - &c) / &(t.clone() * &c + &one);
        atan_series(&r, &constants.reciprocals) + &constants.atan[i.unsigned_abs() as usize]
    }

    /// φ of one number ≥ −1.
    fn divergence_kernel_of(end: &E) -> Self {
        let x = Self::point(end.clone());
        let one = Self::point(end.constant(1.0));
        if *end <= end.constant(-1.0) {
            return one;
        }
        if !end.is_finite() {
            return x;
        }
        if end.constant(-0.25) < *end && *end < end.constant(0.25) {
            // φ = 2 z² [1 + (1+z) z·tail]/(1 − z),  z = x/(2+x)
            let constants = Constants::of(end);
            let z = x.clone() / &(x + &Self::point(end.constant(2.0)));
            let tail = atanh_tail(&z, &constants.reciprocals) * &z * &(one.clone() + &z);
            (tail + &one) * &z.square().scaled(1) / &(one - &z)
        } else {
            Self::ln_1p_of(end) * &(x.clone() + &one) - &x
        }
    }

    /// `x ln |x|` of one number, 0 at 0.
    fn x_ln_x_of(end: &E) -> Self {
        if end.is_zero() || !end.is_finite() {
            return Self::point(end.clone());
        }
        let magnitude = if *end < end.constant(0.0) {
            end.negated()
        } else {
            end.clone()
        };
        Self::ln_of(&magnitude) * &Self::point(end.clone())
    }

    /// Times a power of two.
    fn scaled(&self, power: i32) -> Self {
        Self {
            lower: self.lower.scaled(power, Direction::Down),
            upper: self.upper.scaled(power, Direction::Up),
        }
    }
}

impl<E: Endpoint> Scalar for Interval<E> {
    const TRACKS_ROUNDING: bool = false;

    fn constant(&self, value: f64) -> Self {
        if value.is_nan() {
            return self.whole_line();
        }
        Self::point(self.lower.constant(value))
    }
    fn pi(&self) -> Self {
        let fine = Self::guarded(&self.lower);
        Constants::of(&fine).pi.with_precision(self.lower.bits())
    }
    /// The midpoint; NaN for an interval without bounds.
    fn to_f64(&self) -> f64 {
        if !self.is_bounded() {
            return f64::NAN;
        }
        self.midpoint().to_double(Direction::Down)
    }
    fn is_nonnegative(&self) -> bool {
        self.lower >= self.lower.constant(0.0)
    }
    fn sqrt(&self) -> Self {
        let zero = self.lower.constant(0.0);
        if self.upper < zero {
            return self.whole_line();
        }
        let lower = if self.lower <= zero {
            zero
        } else {
            self.lower.root(Direction::Down)
        };
        let upper = self.upper.root(Direction::Up);
        Self { lower, upper }
    }
    fn ln(&self) -> Self {
        if self.upper <= self.lower.constant(0.0) {
            return self.whole_line();
        }
        self.rising(Self::with_guard(Self::ln_of))
    }
    fn ln_1p(&self) -> Self {
        if self.upper <= self.lower.constant(-1.0) {
            return self.whole_line();
        }
        self.rising(Self::with_guard(Self::ln_1p_of))
    }
    fn exp(&self) -> Self {
        self.rising(Self::with_guard(Self::exp_of))
    }
    fn exp_m1(&self) -> Self {
        self.rising(Self::with_guard(Self::exp_m1_of))
    }
    /// The angle may jump where the half-line x ≤ 0, y = 0 is touched; then every angle is
    /// returned.
    fn atan2(&self, x: &Self) -> Self {
        let zero = self.lower.constant(0.0);
        let half_pi = || self.pi().scaled(-1);
        if x.lower > zero {
            (self.clone() / x).rising(Self::with_guard(Self::atan_of))
        } else if self.lower > zero {
            let angle = half_pi() - &(x.clone() / self).rising(Self::with_guard(Self::atan_of));
            if x.upper <= zero {
                return angle;
            }
            // the smallest angle lies right of the y axis, where the difference may cancel
            let slope = Self::point(self.lower.clone()) / &Self::point(x.upper.clone());
            let lower = slope.rising(Self::with_guard(Self::atan_of)).lower;
            Self { lower, ..angle }
        } else if self.upper < zero {
            -(-self.clone()).atan2(x)
        } else if x.lower >= zero {
            // from the origin to the right: y = 0 gives 0, y of either sign up to a right angle
            let up = if self.upper > zero {
                half_pi()
            } else {
                self.zero()
            };
            let down = if self.lower < zero {
                -half_pi()
            } else {
                self.zero()
            };
            down.hull(&up)
        } else {
            let pi = self.pi();
            (-pi.clone()).hull(&pi)
        }
    }
    fn divergence_kernel(&self) -> Self {
        if self.upper < self.lower.constant(-1.0) {
            return self.whole_line();
        }
        let hull = self.at_ends(Self::with_guard(Self::divergence_kernel_of));
        if self.contains_zero() {
            hull.hull(&self.zero())
        } else {
            hull
        }
    }
    fn x_ln_x(&self) -> Self {
        let hull = self.at_ends(Self::with_guard(Self::x_ln_x_of));
        // turning points at ±1/e, values ∓1/e
        let turn = Constants::of(&Self::guarded(&self.lower))
            .inverse_e
            .with_precision(self.lower.bits());
        let touches = |point: &Self| self.intersection(point).is_some();
        let mut image = hull;
        if touches(&turn) {
            image = image.hull(&-turn.clone());
        }
        if touches(&-turn.clone()) {
            image = image.hull(&turn);
        }
        image
    }
    fn abs(&self) -> Self {
        match self.side() {
            Side::Right => self.clone(),
            Side::Left => -self.clone(),
            Side::Both => Self {
                lower: self.lower.constant(0.0),
                upper: super::larger(&self.upper, &self.lower.negated()).clone(),
            },
        }
    }
    fn square(&self) -> Self {
        let size = self.abs();
        Self {
            lower: size.lower.times(&size.lower, Direction::Down),
            upper: size.upper.times(&size.upper, Direction::Up),
        }
    }
}
