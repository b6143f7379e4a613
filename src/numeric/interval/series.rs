//! Power series of intervals: the terms left out are one more interval, an enclosure of the whole
//! tail, from which the Horner scheme starts.

use super::Interval;
use super::endpoint::{Direction, Endpoint};
use crate::numeric::Scalar;

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
        #[allow(clippy::cast_precision_loss, reason = "a few hundred terms")]
        let factor = count as f64 / largest;
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

#[cfg(test)]
mod tests {
    use super::super::constants::Constants;
    use super::*;

    /// Few terms show the tails, which all the terms hide below the last bit: each enclosure
    /// contains that by more terms, and is no wider than its tail, 1/(2k+3)·|s|ᵏ or 3/2·|r|ᵏ⁻¹/k!,
    /// and some units.
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
