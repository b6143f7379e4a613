//! Power series of intervals: the terms left out are one more interval, an enclosure of the whole
//! tail, from which the Horner scheme starts.

use super::Interval;
use super::endpoint::{Direction, Endpoint};
use crate::numeric::{Scalar, real};

/// The number of terms with which a series in z², |z| < 2^(exponent + 1), reaches the last bit.
pub(super) fn terms<E: Endpoint>(z: &Interval<E>, available: usize) -> usize {
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

/// `1/3 + s/5 + s²/7 + …` for |s| ≤ 1/2, of which `terms` terms are summed; `tail` times 1/(2k+3)
/// encloses what follows term k.
pub(super) fn odd_series<E: Endpoint>(
    s: &Interval<E>,
    terms: usize,
    tail: &Interval<E>,
    reciprocals: &[Interval<E>],
) -> Interval<E> {
    let odd = |k: usize| &reciprocals[2 * k + 2];
    let start = tail.clone() * odd(terms);
    (0..terms).rev().fold(start, |sum, k| sum * s + odd(k))
}

pub(super) fn between<E: Endpoint>(like: &E, lower: f64, upper: f64) -> Interval<E> {
    Interval {
        lower: like.constant(lower),
        upper: like.constant(upper),
    }
}

/// `(atanh z − z)/z³`, |z| ≤ 1/3.
pub(super) fn atanh_tail<E: Endpoint>(z: &Interval<E>, reciprocals: &[Interval<E>]) -> Interval<E> {
    let tail = between(&z.lower, 1.0, 2.0);
    odd_series(&z.square(), terms(z, reciprocals.len()), &tail, reciprocals)
}

/// Encloses atanh z for |z| ≤ 1/3.
pub(super) fn atanh<E: Endpoint>(z: &Interval<E>, reciprocals: &[Interval<E>]) -> Interval<E> {
    z.square() * &atanh_tail(z, reciprocals) * z + z
}

/// Encloses atan r for |r| ≤ 1/4.
pub(super) fn atan_series<E: Endpoint>(
    r: &Interval<E>,
    reciprocals: &[Interval<E>],
) -> Interval<E> {
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
pub(super) fn exponential_tail<E: Endpoint>(
    r: &Interval<E>,
    reciprocals: &[Interval<E>],
) -> Interval<E> {
    // |r|^(count−1)/count! must fall below the last bit
    let largest = super::larger(&r.upper, &r.lower.negated()).to_double(Direction::Up);
    let needed = f64::from(r.lower.bits() + 4);
    let mut gained = 0.0;
    let mut count = 1;
    while gained < needed && count < reciprocals.len() {
        count += 1;
        let factor = real(count) / largest;
        gained += factor.log2();
    }
    exponential_series(r, count, reciprocals)
}

/// The exponential by `count` terms, the last of which encloses all that follow.
pub(super) fn exponential_series<E: Endpoint>(
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
