//! π, ln 2, 1/e and the tables that arguments are reduced by, computed once for each precision.

use super::Interval;
use super::endpoint::Endpoint;
use super::precise::Precise;
use super::series::{atan_series, atanh, between, exponential_tail};
use crate::numeric::Scalar;
use std::any::{Any, TypeId};
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::RangeInclusive;
use std::rc::Rc;

/// Significands are kept in words of this many bits.
pub(super) const WORD: u32 = 64;
/// The leading 32 bits of ln 2, so that its multiples by an exponent are doubles.
#[allow(clippy::approx_constant, reason = "cut on purpose")]
pub(super) const LN_2_HEAD: f64 = 2_977_044_471.0 / 4_294_967_296.0;
/// Entries per unit in the table of logarithms.
pub(super) const LN_STEPS: i32 = 64;
/// The table's first and last entry: for numbers from 3/4 to 3/2.
pub(super) const LN_ENTRIES: RangeInclusive<i32> = -16..=32;
/// Entries per unit in the table of arc tangents.
pub(super) const ATAN_STEPS: i32 = 32;

/// Constants at one precision.
pub(super) struct Constants<E> {
    pub(super) pi: Interval<E>,
    pub(super) ln_2: Interval<E>,
    /// The rest of ln 2, less [`LN_2_HEAD`].
    pub(super) ln_2_tail: Interval<E>,
    /// 1/e.
    pub(super) inverse_e: Interval<E>,
    /// Values of ln(1 + i/64), from i = −16.
    pub(super) ln: Vec<Interval<E>>,
    /// Values of atan(i/32).
    pub(super) atan: Vec<Interval<E>>,
    /// 1/1, 1/2, 1/3, …
    pub(super) reciprocals: Vec<Interval<E>>,
}

thread_local! {
    /// Constants for each type of end and precision.
    static CONSTANTS: RefCell<HashMap<(TypeId, u32), Rc<dyn Any>>> = RefCell::default();
}

impl<E: Endpoint> Constants<E> {
    /// The constants at the precision of `like`, computed once per thread.
    pub(super) fn of(like: &E) -> Rc<Self> {
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
