//! Certified roots against functions whose roots are known beforehand.

use infoscene::numeric::{Interval, IntervalFunction, Scalar, certified_roots};
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

impl IntervalFunction for Polynomial {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let factors = self.0.iter().flat_map(|((p, q), power)| {
            let factor = x.constant((*q).into()) * x - &x.constant((*p).into());
            std::iter::repeat_n(factor, *power as usize)
        });
        factors.reduce(|product, factor| product * &factor)
    }
}

/// Whether the interval contains p/q: exactly so if `q X` contains p, up to one more rounding
/// outwards.
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

    /// Every root of a polynomial is found, none is invented, each lies in an enclosure of its own,
    /// and the sign of the slope alternates; on an interval whose halves and quarters are roots
    /// themselves.
    #[test]
    fn all_roots_of_a_polynomial_are_found(roots in fractions()) {
        let found = certified_roots(&Polynomial::simple(&roots), (-1.0, 1.0), BITS);
        prop_assert!(found.undecided.is_empty(), "{:?}", found.undecided);
        prop_assert_eq!(found.roots.len(), roots.len());
        for (k, (found, root)) in found.roots.iter().zip(&roots).enumerate() {
            prop_assert!(contains_fraction(&found.enclosure, *root), "{root:?}");
            prop_assert!(
                found.enclosure.width() <= WIDTH,
                "{:e}",
                found.enclosure.width()
            );
            prop_assert_eq!(found.rises, (roots.len() - k) % 2 == 1);
        }
    }

    /// A multiple root is reported as undecided, never as absent nor as certain; simple ones beside
    /// it are found.
    #[test]
    fn multiple_roots_are_undecided(roots in fractions(), which in 0..5usize, power in 2..4u32) {
        let which = which % roots.len();
        let mut polynomial = Polynomial::simple(&roots);
        polynomial.0[which].1 = power;
        let found = certified_roots(&polynomial, (-1.0, 1.0), BITS);
        let (p, q) = roots[which];
        let multiple = f64::from(p) / f64::from(q);
        // p/q is rounded; the boxes are much wider than that
        let around = |(lower, upper): &(f64, f64)| {
            lower.next_down() <= multiple && multiple <= upper.next_up()
        };
        prop_assert!(found.undecided.iter().any(around), "{:?}", found.undecided);
        for (k, root) in roots.iter().enumerate() {
            let is_found = found
                .roots
                .iter()
                .any(|found| contains_fraction(&found.enclosure, *root));
            prop_assert!(is_found == (k != which), "{root:?}: {found:?}");
        }
        prop_assert_eq!(found.roots.len(), roots.len() - 1);
    }
}

/// Roots a millionth from the ends are found; a root at an end itself is undecided or found, never
/// absent.
#[test]
fn roots_next_to_the_ends_are_found() {
    struct NearEnds(f64);
    impl IntervalFunction for NearEnds {
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
    impl IntervalFunction for Parabola {
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

/// `eˣ = 2`, and the zeros of a wave: `T_n(x) = cos(n arccos x)` vanishes where `arccos x =
/// (2k−1)π/(2n)`.
#[test]
fn roots_of_exponentials_and_waves_are_found() {
    struct Exponential;
    impl IntervalFunction for Exponential {
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
    impl IntervalFunction for Wave {
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

/// A function that is not known somewhere, or evaluations that run out, leave the rest undecided.
#[test]
fn what_is_not_known_is_undecided() {
    struct HalfKnown;
    impl IntervalFunction for HalfKnown {
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
    impl IntervalFunction for Nothing {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(x.zero())
        }
    }
    let found = certified_roots(&Nothing, (0.0, 1.0), BITS);
    assert!(found.roots.is_empty() && !found.undecided.is_empty());
}

/// `y + atan2(y, −1)/100` jumps across 0 and has no root, though its slope is near 1 on either
/// side.
#[test]
fn a_jump_of_the_angle_is_no_root() {
    struct Jump;
    impl IntervalFunction for Jump {
        fn value<S: Scalar>(&self, y: &S) -> Option<S> {
            let angle = y.atan2(&y.constant(-1.0));
            Some(angle * &y.constant(0.01) + y)
        }
    }
    let found = certified_roots(&Jump, (-0.25, 0.25), 128);
    assert!(found.roots.is_empty(), "{found:?}");
    assert!(!found.undecided.is_empty());
}
