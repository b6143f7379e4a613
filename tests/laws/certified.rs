//! Certified roots, maxima and stationary points against functions whose answer is known beforehand.

use infoscene::numeric::{
    Certificate, End, Function, Interval, NumericError, Objective, Scalar, VectorFunction,
    certified_maximum, certified_roots, certified_stationary_point,
};
use proptest::prelude::*;

/// Precision of the enclosures.
const BITS: u32 = 128;
/// Their width: a root of size one is found to a few units of 2⁻¹²⁸ = 3e-39, times condition.
const WIDTH: f64 = 1e-33;

/// Whole numbers p, q that stand for the root p/q.
type Fraction = (i16, i16);

/// `Π (q x − p)^k`, a polynomial with the roots p/q.
struct Polynomial(Vec<(Fraction, u32)>);

impl Polynomial {
    fn simple(roots: &[Fraction]) -> Self {
        Self(roots.iter().map(|root| (*root, 1)).collect())
    }
}

impl Function for Polynomial {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let factors = self.0.iter().flat_map(|((p, q), power)| {
            let factor = x.constant((*q).into()) * x - &x.constant((*p).into());
            std::iter::repeat_n(factor, *power as usize)
        });
        factors.reduce(|product, factor| product * &factor)
    }
}

/// Does the interval contain p/q? Exactly so if `q X` contains p, up to one more rounding outwards.
fn contains_fraction(interval: &Interval, (p, q): Fraction) -> bool {
    let multiple = interval.constant(q.into()) * interval;
    multiple.contains(&interval.constant(p.into()))
}

/// Fractions with denominators up to 12 inside (−1, 1), often with a power of two below.
fn fraction() -> impl Strategy<Value = Fraction> {
    let denominator = prop_oneof![2..12i16, prop_oneof![Just(2i16), Just(4), Just(8)]];
    denominator.prop_flat_map(|q| (-q + 1..q, Just(q)))
}

/// Fractions of different values, increasing.
fn fractions() -> impl Strategy<Value = Vec<Fraction>> {
    proptest::collection::vec(fraction(), 1..6).prop_map(|mut all| {
        let value = |(p, q): &Fraction| f64::from(*p) / f64::from(*q);
        all.sort_by(|a, b| value(a).total_cmp(&value(b)));
        all.dedup_by(|a, b| value(a) == value(b));
        all
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.div_ceil(8)))]

    /// Every root of a polynomial is found, none is invented, each lies in an enclosure of its own, and the sign
    /// of the slope alternates; on an interval whose halves and quarters are roots themselves.
    #[test]
    fn all_roots_of_a_polynomial_are_found(roots in fractions()) {
        let found = certified_roots(&Polynomial::simple(&roots), (-1.0, 1.0), BITS);
        prop_assert!(found.undecided.is_empty(), "{:?}", found.undecided);
        prop_assert_eq!(found.roots.len(), roots.len());
        for (k, (found, root)) in found.roots.iter().zip(&roots).enumerate() {
            prop_assert!(contains_fraction(&found.enclosure, *root), "{root:?}");
            prop_assert!(found.enclosure.width() <= WIDTH, "{:e}", found.enclosure.width());
            prop_assert_eq!(found.rises, (roots.len() - k) % 2 == 1);
        }
    }

    /// A multiple root is reported as undecided, never as absent nor as certain; simple ones beside it are found.
    #[test]
    fn multiple_roots_are_undecided(roots in fractions(), which in 0..5usize, power in 2..4u32) {
        let which = which % roots.len();
        let mut polynomial = Polynomial::simple(&roots);
        polynomial.0[which].1 = power;
        let found = certified_roots(&polynomial, (-1.0, 1.0), BITS);
        let (p, q) = roots[which];
        let multiple = f64::from(p) / f64::from(q);
        // p/q is rounded; the boxes are much wider than that
        let around = |(lower, upper): &(f64, f64)| lower.next_down() <= multiple && multiple <= upper.next_up();
        prop_assert!(found.undecided.iter().any(around), "{:?}", found.undecided);
        for (k, root) in roots.iter().enumerate() {
            let is_found = found.roots.iter().any(|found| contains_fraction(&found.enclosure, *root));
            prop_assert!(is_found == (k != which), "{root:?}: {found:?}");
        }
        prop_assert_eq!(found.roots.len(), roots.len() - 1);
    }
}

/// Roots a millionth from the ends are found; a root at an end itself is undecided or found, never absent.
#[test]
fn roots_next_to_the_ends_are_found() {
    struct NearEnds(f64);
    impl Function for NearEnds {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            let distance = x.constant(self.0);
            let one = x.constant(1.0);
            Some((x.clone() - &distance) * &(x.clone() - &(one - &distance)))
        }
    }
    for power in [-3, -20, -40, -60, -1000] {
        let distance = 2f64.powi(power);
        let found = certified_roots(&NearEnds(distance), (0.0, 1.0), BITS);
        // 1 − 2⁻⁶⁰ and 1 have one box of doubles in common
        let told_apart = if power > -53 { 2 } else { 1 };
        let undecided = 2 - told_apart;
        assert_eq!(found.roots.len(), told_apart, "{power}: {found:?}");
        assert_eq!(found.undecided.len(), undecided, "{power}: {found:?}");
        assert!(
            found.roots[0]
                .enclosure
                .contains(&Interval::precise(distance, BITS))
        );
    }
    let at_ends = certified_roots(&NearEnds(0.0), (0.0, 1.0), BITS);
    for end in [0.0, 1.0] {
        let is_reported = |(lower, upper): &(f64, f64)| (*lower..=*upper).contains(&end);
        assert!(at_ends.undecided.iter().any(is_reported), "{at_ends:?}");
    }
    assert!(at_ends.roots.is_empty());
}

/// No root is invented where a parabola passes the axis at a distance of 1e-6.
#[test]
fn near_misses_are_no_roots() {
    struct Parabola(f64);
    impl Function for Parabola {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            let third = x.constant(3.0) * x - &x.constant(1.0);
            Some(third.square() + &x.constant(self.0))
        }
    }
    let above = certified_roots(&Parabola(1e-6), (0.0, 1.0), BITS);
    assert!(
        above.roots.is_empty() && above.undecided.is_empty(),
        "{above:?}"
    );
    let below = certified_roots(&Parabola(-1e-6), (0.0, 1.0), BITS);
    assert!(
        below.roots.len() == 2 && below.undecided.is_empty(),
        "{below:?}"
    );
}

/// `eˣ = 2`, and the zeros of a wave: `T_n(x) = cos(n arccos x)` vanishes where `arccos x = (2k−1)π/(2n)`.
#[test]
fn roots_of_exponentials_and_waves_are_found() {
    struct Exponential;
    impl Function for Exponential {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(x.exp() - &x.constant(2.0))
        }
    }
    let found = certified_roots(&Exponential, (-1.0, 3.0), BITS);
    let [root] = found.roots.as_slice() else {
        panic!("{found:?}")
    };
    // OEIS A002162
    let ln_2 = Interval::parse("0.693147180559945309417232121458176568", BITS).unwrap();
    assert!((root.enclosure.clone() - &ln_2).abs().to_f64() < 1e-35 && root.rises);
    assert!(root.enclosure.width() <= WIDTH);

    struct Wave(u32);
    impl Function for Wave {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            let (mut before, mut wave) = (x.constant(1.0), x.clone());
            for _ in 1..self.0 {
                let next = x.constant(2.0) * x * &wave - &before;
                (before, wave) = (wave, next);
            }
            Some(wave)
        }
    }
    let n = 7;
    let found = certified_roots(&Wave(n), (-1.0, 1.0), BITS);
    assert!(found.undecided.is_empty() && found.roots.len() == n as usize);
    for (k, root) in found.roots.iter().rev().enumerate() {
        let x = &root.enclosure;
        let one = x.constant(1.0);
        let angle = (one - &x.square()).sqrt().atan2(x);
        let odd = x.constant(2.0 * f64::from(u32::try_from(k).unwrap()) + 1.0);
        let exact = x.pi() * &odd / &x.constant(2.0 * f64::from(n));
        assert!(angle.intersection(&exact).is_some(), "{k}");
        assert!(angle.width() < 1e-30);
    }
}

/// Where the function is not known, or the evaluations run out, the rest is undecided.
#[test]
fn what_is_not_known_is_undecided() {
    struct HalfKnown;
    impl Function for HalfKnown {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            (*x < x.constant(0.5)).then(|| x.clone() - &x.constant(0.25))
        }
    }
    let found = certified_roots(&HalfKnown, (0.0, 1.0), BITS);
    // the unknown half uses up the evaluations, before the known one is looked at
    let is_undecided = |x: f64| {
        found
            .undecided
            .iter()
            .any(|(lower, upper)| *lower <= x && x <= *upper)
    };
    assert!(
        is_undecided(0.75) && (is_undecided(0.25) || found.roots.len() == 1),
        "{found:?}"
    );
    struct Nothing;
    impl Function for Nothing {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(x.zero())
        }
    }
    let found = certified_roots(&Nothing, (0.0, 1.0), BITS);
    assert!(found.roots.is_empty() && !found.undecided.is_empty());
}

/// `a ln x + b ln(1 − x)`, largest at `a/(a + b)`.
struct Shares(f64, f64);

impl Objective for Shares {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let rest = x.constant(1.0) - x;
        Some(x.ln() * &x.constant(self.0) + &(rest.ln() * &x.constant(self.1)))
    }
    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let rest = x.constant(1.0) - x;
        Some(x.constant(self.0) / x - &(x.constant(self.1) / &rest))
    }
    fn slope_near<S: Scalar>(&self, end: End, distance: &S) -> Option<S> {
        let rest = distance.constant(1.0) - distance;
        match end {
            End::Lower => {
                Some(distance.constant(self.0) / distance - &(distance.constant(self.1) / &rest))
            }
            End::Upper => {
                Some(distance.constant(self.0) / &rest - &(distance.constant(self.1) / distance))
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.div_ceil(8)))]

    /// `a/(a+b)` for whole a and b, up to a thousandth from the ends.
    #[test]
    fn known_maxima_are_found(a in 1..1000u16, b in 1..1000u16) {
        let found = certified_maximum(&Shares(a.into(), b.into()), (0.0, 1.0), BITS).unwrap();
        let is_only_stationary_point = Some(true);
        prop_assert_eq!(&found.certificate, &Certificate::Unique { is_only_stationary_point });
        let a_and_b = found.position.constant(f64::from(a) + f64::from(b));
        prop_assert!((found.position.clone() * &a_and_b).contains(&a_and_b.constant(a.into())));
        prop_assert!(found.position.width() <= WIDTH && found.value.width() <= 1e-30);
        let value = Shares(a.into(), b.into()).value(&(a_and_b.constant(a.into()) / &a_and_b)).unwrap();
        prop_assert!(found.value.intersection(&value).is_some());
    }
}

/// `−(x−¼)²(x−¾)² + tilt·x`: two equal maxima, or nearly so.
struct TwoHills(f64);

impl TwoHills {
    fn sides<S: Scalar>(x: &S) -> [S; 2] {
        [0.25, 0.75].map(|hill| x.clone() - &x.constant(hill))
    }
}

impl Objective for TwoHills {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let [left, right] = Self::sides(x);
        Some(x.constant(self.0) * x - &(left * &right).square())
    }
    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let [left, right] = Self::sides(x);
        let sum = left.clone() + &right;
        Some(x.constant(self.0) - &(left * &right * &sum * &x.constant(2.0)))
    }
    fn slope_near<S: Scalar>(&self, end: End, distance: &S) -> Option<S> {
        match end {
            End::Lower => self.slope(distance),
            End::Upper => self.slope(&(distance.constant(1.0) - distance)),
        }
    }
}

/// Equal maxima are told as several; a tilt of 1e-60 is seen with 128 bits, as both hills are of height 0 to
/// the square of their positions' width; one of 1e-90 is not.
#[test]
fn equal_maxima_are_told_apart_or_not() {
    let several = Certificate::Several { maximisers: 2 };
    let one = Certificate::Unique {
        is_only_stationary_point: Some(false),
    };
    for (tilt, certificate) in [
        (0.0, &several),
        (1e-3, &one),
        (1e-60, &one),
        (-1e-60, &one),
        (1e-90, &several),
    ] {
        let found = certified_maximum(&TwoHills(tilt), (0.0, 1.0), BITS).unwrap();
        assert_eq!(&found.certificate, certificate, "{tilt:e}");
        let quarter = if tilt <= 0.0 { 0.25 } else { 0.75 };
        let off = (found.position.clone() - &found.position.constant(quarter)).abs();
        assert!(tilt == 1e-90 || off.to_f64() < 2e-2, "{tilt:e}: {off:?}");
        assert!(found.value.width() <= WIDTH);
        assert!(tilt != 0.0 || found.value.contains_zero());
    }
}

/// How the ends of [`Peak`] are covered.
#[derive(Clone, Copy, PartialEq)]
enum Ends {
    BySlope,
    ByBound,
    Not,
}

/// `x (1−x) + h w²/((x−c)² + w²)`: a hill with its top at ½, and a narrow peak aside.
struct Peak {
    height: f64,
    width: f64,
    at: f64,
    ends: Ends,
}

impl Objective for Peak {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let number = |value: f64| x.constant(value);
        let squared = number(self.width).square();
        let aside = (x.clone() - &number(self.at)).square();
        let peak = squared.clone() / &(aside + &squared) * &number(self.height);
        Some((number(1.0) - x) * x + &peak)
    }
    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let number = |value: f64| x.constant(value);
        let squared = number(self.width).square();
        let aside = x.clone() - &number(self.at);
        let below = (aside.square() + &squared).square();
        let peak = squared * &aside / &below * &number(-2.0 * self.height);
        Some(number(1.0) - x - x + &peak)
    }
    fn slope_near<S: Scalar>(&self, end: End, distance: &S) -> Option<S> {
        let position = match end {
            End::Lower => distance.clone(),
            End::Upper => distance.constant(1.0) - distance,
        };
        (self.ends == Ends::BySlope).then(|| self.slope(&position))?
    }
    fn bound_on(&self, domain: &Interval<f64>) -> Option<f64> {
        (self.ends == Ends::ByBound).then(|| self.value(domain).map(|value| *value.upper()))?
    }
}

/// A peak of width 1e-6 between the points of any scan, higher than the hill, is found; a lower one is passed over.
#[test]
fn a_narrow_peak_is_not_missed() {
    let (width, at) = (1e-6, 0.818_281_828_459);
    for ends in [Ends::BySlope, Ends::ByBound] {
        for (height, is_highest) in [(0.3, true), (0.05, false)] {
            let peak = Peak {
                height,
                width,
                at,
                ends,
            };
            let found = certified_maximum(&peak, (0.0, 1.0), BITS).unwrap();
            let is_only_stationary_point = (ends == Ends::BySlope).then_some(false);
            assert_eq!(
                found.certificate,
                Certificate::Unique {
                    is_only_stationary_point
                }
            );
            let top = if is_highest { at } else { 0.5 };
            assert!((found.position.to_f64() - top).abs() < 1e-6, "{found:?}");
            assert!(found.position.width() <= WIDTH);
            // x(1−x) is 0.1487 at the peak
            let value = if is_highest { 0.148_696 + height } else { 0.25 };
            assert!((found.value.to_f64() - value).abs() < 1e-5, "{found:?}");
        }
    }
}

/// What may be higher next to an end is not called a maximum: an end that nothing is known about, and two at which
/// the values grow.
#[test]
fn uncovered_ends_are_unknown() {
    let unknown = |found: &Certificate| matches!(found, Certificate::Unknown { reason } if reason.contains("ends"));
    let open = Peak {
        height: 0.0,
        width: 1.0,
        at: 0.5,
        ends: Ends::Not,
    };
    let found = certified_maximum(&open, (0.0, 1.0), BITS).unwrap();
    assert!(unknown(&found.certificate), "{found:?}");
    assert!(found.position.contains(&found.position.constant(0.5)));

    /// `x (x − ½)²·4 …`: a maximum inside, and a higher value at the upper end.
    struct HigherAtTheEnd(Ends);
    impl Objective for HigherAtTheEnd {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some((x.clone() - &x.constant(0.5)).square() * x)
        }
        fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
            let aside = x.clone() - &x.constant(0.5);
            Some(aside.square() + &(aside * x * &x.constant(2.0)))
        }
        fn slope_near<S: Scalar>(&self, end: End, distance: &S) -> Option<S> {
            let position = match end {
                End::Lower => distance.clone(),
                End::Upper => distance.constant(1.0) - distance,
            };
            (self.0 == Ends::BySlope).then(|| self.slope(&position))?
        }
        fn bound_on(&self, domain: &Interval<f64>) -> Option<f64> {
            (self.0 == Ends::ByBound).then(|| self.value(domain).map(|value| *value.upper()))?
        }
    }
    for ends in [Ends::BySlope, Ends::ByBound, Ends::Not] {
        let found = certified_maximum(&HigherAtTheEnd(ends), (0.0, 1.0), BITS).unwrap();
        assert!(unknown(&found.certificate), "{found:?}");
        // so near to the end that no scan sees it
        for at in [-1e-3, 1.001] {
            let (height, width) = (1.0, 1e-3);
            let peak = Peak {
                height,
                width,
                at,
                ends,
            };
            let found = certified_maximum(&peak, (0.0, 1.0), BITS).unwrap();
            assert!(unknown(&found.certificate), "{found:?}");
        }
    }
}

/// A maximum whose value is not known may be the highest.
#[test]
fn a_stationary_point_without_a_value_is_not_passed_over() {
    struct HalfKnown;
    impl Objective for HalfKnown {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            (*x < x.constant(0.5)).then(|| TwoHills(1e-3).value(x))?
        }
        fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
            TwoHills(1e-3).slope(x)
        }
        fn slope_near<S: Scalar>(&self, end: End, distance: &S) -> Option<S> {
            TwoHills(1e-3).slope_near(end, distance)
        }
    }
    let found = certified_maximum(&HalfKnown, (0.0, 1.0), BITS).unwrap();
    assert!(
        matches!(found.certificate, Certificate::Unknown { .. }),
        "{found:?}"
    );
}

/// No maximum, no interval: refused.
#[test]
fn what_has_no_maximum_is_refused() {
    struct Rising;
    impl Objective for Rising {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(x.clone())
        }
        fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(x.constant(1.0))
        }
    }
    let refusal = certified_maximum(&Rising, (0.0, 1.0), BITS).unwrap_err();
    assert!(matches!(refusal, NumericError::NoInteriorMaximum { .. }));
    for (lower, upper) in [
        (1.0, 1.0),
        (1.0, 0.0),
        (f64::NAN, 1.0),
        (0.0, f64::INFINITY),
    ] {
        let refusal = certified_maximum(&Shares(1.0, 1.0), (lower, upper), BITS).unwrap_err();
        assert!(matches!(refusal, NumericError::EmptyInterval { .. }));
    }
}

/// The gradient of `Σ_i −c_i (x_i − m_i)² − q (x_i − m_i)⁴ + k Σ_{i<j} (x_i − m_i)(x_j − m_j)`, with its root at m = thirds.
struct Hill {
    thirds: Vec<i16>,
    curvatures: Vec<f64>,
    quartic: f64,
    coupling: f64,
}

impl VectorFunction for Hill {
    fn values<S: Scalar>(&self, point: &[S]) -> Option<Vec<S>> {
        let aside: Vec<S> = point
            .iter()
            .zip(&self.thirds)
            .map(|(x, third)| x.clone() - &(x.constant((*third).into()) / &x.constant(3.0)))
            .collect();
        let slope = |i: usize| {
            let x = &aside[i];
            let start = -(x.constant(2.0 * self.curvatures[i]) * x)
                - &(x.square() * x * &x.constant(4.0 * self.quartic));
            let others = aside.iter().enumerate().filter(|(j, _)| *j != i);
            others.fold(start, |sum, (_, other)| {
                sum + &(other.clone() * &x.constant(self.coupling))
            })
        };
        Some((0..aside.len()).map(slope).collect())
    }
}

impl Hill {
    fn near(&self) -> Vec<f64> {
        self.thirds
            .iter()
            .map(|third| f64::from(*third) / 3.0)
            .collect()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.div_ceil(8)))]

    /// Concave quadratics and quartics in two and three variables, coupled less than their curvatures: the known
    /// maximum, also from a point 1e-13 aside.
    #[test]
    fn known_stationary_points_are_enclosed(
        thirds in proptest::collection::vec(-6..6i16, 2..4),
        curvatures in proptest::collection::vec(1.0..4.0f64, 3),
        quartic in prop_oneof![Just(0.0), 0.0..5.0f64],
        coupling in -0.9..0.9f64,
        aside in -1e-13..1e-13f64,
    ) {
        let hill = Hill { thirds, curvatures, quartic, coupling };
        let near: Vec<f64> = hill.near().iter().map(|x| x + aside).collect();
        let point = certified_stationary_point(&hill, &near, BITS).unwrap();
        prop_assert_eq!(point.len(), near.len());
        for (x, third) in point.iter().zip(&hill.thirds) {
            prop_assert!(contains_fraction(x, (*third, 3)));
            prop_assert!(x.width() <= WIDTH, "{:e}", x.width());
        }
    }
}

/// Saddles, minima, points too far off and points that are none are refused.
#[test]
fn only_maxima_nearby_are_certified() {
    let hill = |curvatures: [f64; 2], coupling| Hill {
        thirds: vec![1, 2],
        curvatures: curvatures.to_vec(),
        quartic: 1.0,
        coupling,
    };
    let is_refused = |hill: &Hill, near: &[f64]| {
        let result = certified_stationary_point(hill, near, BITS);
        matches!(result, Err(NumericError::NotIsolated { .. }))
    };
    let maximum = hill([1.0, 1.0], 0.5);
    let near = maximum.near();
    assert!(!is_refused(&maximum, &near));
    assert!(is_refused(&hill([1.0, -1.0], 0.5), &near), "a saddle");
    assert!(
        is_refused(&hill([1.0, 1.0], 3.0), &near),
        "a coupled saddle"
    );
    assert!(is_refused(&hill([-1.0, -1.0], 0.5), &near), "a minimum");
    assert!(is_refused(&hill([0.0, 0.0], 0.0), &near), "flat");
    for aside in [1e-11, 1e-6, 0.1, f64::NAN, f64::INFINITY] {
        assert!(is_refused(&maximum, &[near[0] + aside, near[1]]), "{aside}");
    }
    // the box of 1e-12 about a coordinate of 1e6 has no room between doubles
    let far = Hill {
        thirds: vec![3000, 3001],
        ..hill([1.0, 1.0], 0.5)
    };
    assert!(!is_refused(&far, &far.near()), "a thousand");
}

/// A known failure: a negative definite Hessian that Gershgorin's circles do not show to be so.
#[test]
fn strong_coupling_of_three_variables_is_refused() {
    // −2 on the diagonal and −1.5 beside it: eigenvalues −0.5, −0.5, −5, circles up to +1
    let hill = Hill {
        thirds: vec![0, 1, 2],
        curvatures: vec![1.0; 3],
        quartic: 0.0,
        coupling: -1.5,
    };
    let refusal = certified_stationary_point(&hill, &hill.near(), BITS).unwrap_err();
    assert!(matches!(refusal, NumericError::NotIsolated { .. }));
}
