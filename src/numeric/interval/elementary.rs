//! Elementary functions of intervals, from the four operations alone.
//!
//! Each function is evaluated at the ends (all are monotone by pieces) by an argument reduction and a
//! power series in interval arithmetic, with [`GUARD_BITS`] more bits, in whole words. What a series leaves out is one more interval:
//! the Horner scheme starts from an enclosure of the whole tail.
//!
//! ```text
//!   ln m = ln c + 2 atanh z,   c = 1 + i/64,  z = (m − c)/(m + c),  |z| ≤ 1/192
//!   atanh z = z + z³ (1/3 + z²/5 + …)         tail from term k: [1, 2]/(2k+3) for z² ≤ 1/2
//!   atan t = atan c + atan r,  c = i/32,      r = (t − c)/(1 + t c),  |r| ≤ 2⁻⁶
//!   atan r = r − r³ (1/3 − r²/5 + …)          tail from term k: [0, 1]/(2k+3) for r² ≤ 1
//!   eˣ = 2ᵏ (e^r)^256,  r = (x − k ln 2)/256; e^r = 1 + r/1 (1 + r/2 (…)),  tail [1/2, 2] for |r| ≤ 1/2
//! ```

use super::super::Scalar;
use super::{Direction, Endpoint, Interval, Precise};
use std::any::{Any, TypeId};
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::RangeInclusive;
use std::rc::Rc;

/// More bits than the result has, where the ends can hold them.
const GUARD_BITS: u32 = 32;
/// Significands are kept in words of this many bits.
const WORD: u32 = 64;

/// How often the argument of an exponential is halved.
const HALVINGS: i32 = 8;
/// ln 2 to 32 bits, so that its multiples by an exponent are doubles.
#[allow(clippy::approx_constant, reason = "cut on purpose")]
const LN_2_HEAD: f64 = 2_977_044_471.0 / 4_294_967_296.0;
/// Entries per unit in the table of logarithms.
const LN_STEPS: i32 = 64;
/// Its first and last entry: for numbers from 3/4 to 3/2.
const LN_ENTRIES: RangeInclusive<i32> = -16..=32;
/// Entries per unit in the table of arc tangents.
const ATAN_STEPS: i32 = 32;

/// Constants at one precision.
struct Constants<E> {
    pi: Interval<E>,
    ln_2: Interval<E>,
    /// ln 2 − [`LN_2_HEAD`].
    ln_2_tail: Interval<E>,
    /// 1/e.
    inverse_e: Interval<E>,
    /// ln(1 + i/64), from i = −16.
    ln: Vec<Interval<E>>,
    /// atan(i/32).
    atan: Vec<Interval<E>>,
    /// 1/1, 1/2, 1/3, …
    reciprocals: Vec<Interval<E>>,
}

thread_local! {
    /// Constants for each type of end and precision.
    static CONSTANTS: RefCell<HashMap<(TypeId, u32), Rc<dyn Any>>> = RefCell::default();
}

impl<E: Endpoint> Constants<E> {
    /// The constants at the precision of `like`, computed once per thread.
    fn of(like: &E) -> Rc<Self> {
        let key = (TypeId::of::<E>(), like.bits());
        let cached = CONSTANTS.with_borrow(|cache| cache.get(&key).cloned());
        if let Some(constants) = cached.and_then(|any| any.downcast::<Self>().ok()) {
            return constants;
        }
        let constants = Rc::new(if like.bits() > f64::MANTISSA_DIGITS {
            Self::at(like)
        } else {
            Self::short(like)
        });
        CONSTANTS.with_borrow_mut(|cache| cache.insert(key, constants.clone()));
        constants
    }

    fn at(like: &E) -> Self {
        let fine = Interval::guarded(like);
        let whole = |value: i32| Interval::point(fine.constant(f64::from(value)));
        let ratio = |p: i32, q: i32| whole(p) / &whole(q);
        let fine_reciprocals: Vec<_> = (1..)
            .take(fine.bits() as usize + 8)
            .map(|k| ratio(1, k))
            .collect();
        let rounded = |value: &Interval<E>| value.with_precision(like.bits());
        // atanh(1/3) = ln(2)/2, and ln(1 + i/64) = 2 atanh(i/(128 + i))
        let ln = |i: i32| atanh(&ratio(i, 2 * LN_STEPS + i), &fine_reciprocals) * &whole(2);
        let pi = atan_series(&ratio(1, 5), &fine_reciprocals) * &whole(16)
            - &(atan_series(&ratio(1, 239), &fine_reciprocals) * &whole(4));
        // atan c = 4 atan of c halved twice as an angle
        let atan = |i: i32| {
            let halved = |t: Interval<E>| {
                let secant = (t.square() + &whole(1)).sqrt();
                t / &(secant + &whole(1))
            };
            atan_series(&halved(halved(ratio(i, ATAN_STEPS))), &fine_reciprocals) * &whole(4)
        };
        let ln_2 = ln(LN_STEPS);
        let ln_2_tail = ln_2.clone() - &Interval::point(fine.constant(LN_2_HEAD));
        // the series wants |r| ≤ 1/2: 1/e = (e^(−1/2))²
        let half = -Interval::point(fine.constant(0.5));
        let inverse_root = exponential_tail(&half, &fine_reciprocals) * &half + &whole(1);
        Self {
            pi: rounded(&pi),
            ln_2: rounded(&ln_2),
            ln_2_tail: rounded(&ln_2_tail),
            inverse_e: rounded(&inverse_root.square()),
            ln: LN_ENTRIES.map(|i| rounded(&ln(i))).collect(),
            atan: (0..=ATAN_STEPS).map(|i| rounded(&atan(i))).collect(),
            reciprocals: fine_reciprocals.iter().map(rounded).collect(),
        }
    }

    /// The constants for ends without guard bits, cut from longer ones.
    fn short(like: &E) -> Self {
        let long = Constants::<Precise>::of(&Precise::new(0.0, 2 * WORD));
        let cut = |value: &Interval| {
            let (lower, upper) = value.to_doubles();
            between(like, lower, upper)
        };
        Self {
            pi: cut(&long.pi),
            ln_2: cut(&long.ln_2),
            ln_2_tail: cut(&long.ln_2_tail),
            inverse_e: cut(&long.inverse_e),
            ln: long.ln.iter().map(cut).collect(),
            atan: long.atan.iter().map(cut).collect(),
            reciprocals: long.reciprocals.iter().map(cut).collect(),
        }
    }
}

/// How many terms of a series in z², |z| < 2^(exponent + 1), reach the last bit.
fn terms<E: Endpoint>(z: &Interval<E>, available: usize) -> usize {
    let largest = if z.upper.negated() < z.lower {
        &z.upper
    } else {
        &z.lower
    };
    if largest.is_zero() {
        return 0;
    }
    let bits_per_term = 2 * largest.exponent().saturating_add(1).unsigned_abs().max(1);
    let count = (z.lower.bits() + 4).div_ceil(bits_per_term) as usize;
    // 1/(2k+3) is the last reciprocal needed
    count.min((available - 3) / 2)
}

/// `1/3 + s/5 + s²/7 + …` for |s| ≤ 1/2, of which `terms` terms are summed; `tail` times 1/(2k+3) encloses what
/// follows term k.
fn odd_series<E: Endpoint>(
    s: &Interval<E>,
    terms: usize,
    tail: &Interval<E>,
    reciprocals: &[Interval<E>],
) -> Interval<E> {
    let odd = |k: usize| &reciprocals[2 * k + 2];
    let start = tail.clone() * odd(terms);
    (0..terms).rev().fold(start, |sum, k| sum * s + odd(k))
}

fn between<E: Endpoint>(like: &E, lower: f64, upper: f64) -> Interval<E> {
    Interval {
        lower: like.constant(lower),
        upper: like.constant(upper),
    }
}

/// `(atanh z − z)/z³`, |z| ≤ 1/3.
fn atanh_tail<E: Endpoint>(z: &Interval<E>, reciprocals: &[Interval<E>]) -> Interval<E> {
    let tail = between(&z.lower, 1.0, 2.0);
    odd_series(&z.square(), terms(z, reciprocals.len()), &tail, reciprocals)
}

/// atanh z, |z| ≤ 1/3.
fn atanh<E: Endpoint>(z: &Interval<E>, reciprocals: &[Interval<E>]) -> Interval<E> {
    z.square() * &atanh_tail(z, reciprocals) * z + z
}

/// atan r, |r| ≤ 1/4.
fn atan_series<E: Endpoint>(r: &Interval<E>, reciprocals: &[Interval<E>]) -> Interval<E> {
    let tail = between(&r.lower, 0.0, 1.0);
    let square = r.square();
    let sum = odd_series(
        &-square.clone(),
        terms(r, reciprocals.len()),
        &tail,
        reciprocals,
    );
    r.clone() - &(square * &sum * r)
}

/// `(eʳ − 1)/r`, |r| ≤ 1/2: 1 + r/2 (1 + r/3 (…)).
fn exponential_tail<E: Endpoint>(r: &Interval<E>, reciprocals: &[Interval<E>]) -> Interval<E> {
    // |r|^(count−1)/count! must fall below the last bit
    let largest = super::larger(&r.upper, &r.lower.negated()).to_double(Direction::Up);
    let needed = f64::from(r.lower.bits() + 4);
    let mut gained = 0.0;
    let mut count = 1;
    while gained < needed && count < reciprocals.len() {
        count += 1;
        #[allow(clippy::cast_precision_loss, reason = "a few hundred terms")]
        let factor = count as f64 / largest;
        gained += factor.log2();
    }
    exponential_series(r, count, reciprocals)
}

/// The same by `count` terms, the last of which encloses all that follow.
fn exponential_series<E: Endpoint>(
    r: &Interval<E>,
    count: usize,
    reciprocals: &[Interval<E>],
) -> Interval<E> {
    let one = Interval::point(r.lower.constant(1.0));
    let start = between(&r.lower, 0.5, 2.0);
    (2..=count)
        .rev()
        .fold(start, |sum, k| sum * r * &reciprocals[k - 1] + &one)
}

/// The nearest whole number among `entries`.
fn nearest(value: f64, entries: RangeInclusive<i32>) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "clamped to a small number")]
    let nearest = value.round() as i32;
    nearest.clamp(*entries.start(), *entries.end())
}

/// Functions of one end, as enclosures to within a few units in the last place; the guard bits come from
/// [`Interval::with_guard`].
impl<E: Endpoint> Interval<E> {
    fn guarded(end: &E) -> E {
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
        // every halving is a squaring later, which doubles the error: none where there are no guard bits
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
        #[allow(clippy::cast_possible_truncation, reason = "below 2e9")]
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

    /// atan t, |t| ≤ 1.
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
    /// Where the half-line x ≤ 0, y = 0 is touched the angle may jump, and every angle is returned.
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
            super::Side::Right => self.clone(),
            super::Side::Left => -self.clone(),
            super::Side::Both => Self {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// With few terms the tails show, which all the terms hide below the last bit: each enclosure contains that by
    /// more terms, and is no wider than its tail, 1/(2k+3)·|s|ᵏ or 3/2·|r|ᵏ⁻¹/k!, and some units.
    #[test]
    fn few_terms_of_a_series_enclose_many() {
        let reciprocals = &Constants::of(&0.0).reciprocals;
        for s in [-1.0, -0.3, -1e-3, 0.0, 1e-3, 0.1, 0.5] {
            let tail = if s < 0.0 {
                between(&s, 0.0, 1.0)
            } else {
                between(&s, 1.0, 2.0)
            };
            let series = |terms| odd_series(&Interval::point(s), terms, &tail, reciprocals);
            for terms in 0..8 {
                let width = s.abs().powi(terms) / f64::from(2 * terms + 3);
                let few = series(terms.unsigned_abs() as usize);
                assert!(few.contains(&series(28)) || s.abs() < 0.01, "{s} {terms}");
                assert!(few.intersection(&series(28)).is_some(), "{s} {terms}");
                assert!(few.width() <= width + 8.0 * f64::EPSILON, "{s} {terms}");
            }
        }
        for r in [-0.5, -0.1, 0.1, 0.5] {
            let series = |count| exponential_series(&Interval::point(r), count, reciprocals);
            let mut width: f64 = 1.5;
            for count in 1..8 {
                assert!(series(count).contains(&series(30)), "{r} {count}");
                assert!(
                    series(count).width() <= width + 8.0 * f64::EPSILON,
                    "{r} {count}"
                );
                #[allow(clippy::cast_precision_loss, reason = "below 8")]
                let next = (count + 1) as f64;
                width *= r.abs() / next;
            }
        }
    }
}
