//! Certified maxima against functions whose maximum is known beforehand.

use infoscene::discretize::PatchSplit;
use infoscene::geometry::SplitAxis;
use infoscene::numeric::{
    Certificate, Dual, EndPoint, Interval, Maximand, NumericError, Scalar, certified_maximum,
};
use infoscene::scene::Scene;
use proptest::prelude::*;

/// Precision of the enclosures.
const BITS: u32 = 128;
/// Their width: a root of size one is found to a few units of 2⁻¹²⁸ = 3e-39, times condition.
const WIDTH: f64 = 1e-33;

/// `a ln x + b ln(1 − x)`, largest at `a/(a + b)`.
struct Shares(f64, f64);

impl Maximand for Shares {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let rest = x.constant(1.0) - x;
        Some(x.ln() * &x.constant(self.0) + &(rest.ln() * &x.constant(self.1)))
    }
    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let rest = x.constant(1.0) - x;
        Some(x.constant(self.0) / x - &(x.constant(self.1) / &rest))
    }
    fn slope_near<S: Scalar>(&self, end: EndPoint, distance: &S) -> Option<S> {
        let rest = distance.constant(1.0) - distance;
        match end {
            EndPoint::Lower => {
                Some(distance.constant(self.0) / distance - &(distance.constant(self.1) / &rest))
            }
            EndPoint::Upper => {
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
        prop_assert_eq!(
            &found.certificate,
            &Certificate::Unique {
                is_only_stationary_point
            }
        );
        let a_and_b = found.position.constant(f64::from(a) + f64::from(b));
        prop_assert!((found.position.clone() * &a_and_b).contains(&a_and_b.constant(a.into())));
        prop_assert!(found.position.width() <= WIDTH && found.value.width() <= 1e-30);
        let value = Shares(a.into(), b.into())
            .value(&(a_and_b.constant(a.into()) / &a_and_b))
            .unwrap();
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

impl Maximand for TwoHills {
    fn value<S: Scalar>(&self, x: &S) -> Option<S> {
        let [left, right] = Self::sides(x);
        Some(x.constant(self.0) * x - &(left * &right).square())
    }
    fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
        let [left, right] = Self::sides(x);
        let sum = left.clone() + &right;
        Some(x.constant(self.0) - &(left * &right * &sum * &x.constant(2.0)))
    }
    fn slope_near<S: Scalar>(&self, end: EndPoint, distance: &S) -> Option<S> {
        match end {
            EndPoint::Lower => self.slope(distance),
            EndPoint::Upper => self.slope(&(distance.constant(1.0) - distance)),
        }
    }
}

/// Equal maxima are told as several; a tilt of 1e-60 is seen with 128 bits, as both hills are of
/// height 0 to the square of their positions' width; one of 1e-90 is not.
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

/// The treatment of the ends of [`Peak`].
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

impl Maximand for Peak {
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
    fn slope_near<S: Scalar>(&self, end: EndPoint, distance: &S) -> Option<S> {
        let position = match end {
            EndPoint::Lower => distance.clone(),
            EndPoint::Upper => distance.constant(1.0) - distance,
        };
        (self.ends == Ends::BySlope).then(|| self.slope(&position))?
    }
    fn bound_on(&self, domain: &Interval<f64>) -> Option<f64> {
        (self.ends == Ends::ByBound).then(|| self.value(domain).map(|value| *value.upper()))?
    }
}

/// A peak of width 1e-6 between the points of any scan, higher than the hill, is found; a lower one
/// is passed over.
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

/// A point that may be lower than one next to an end is not called a maximum: an end that nothing
/// is known about, and two at which the values grow.
#[test]
fn uncovered_ends_are_unknown() {
    let unknown = |found: &Certificate| match found {
        Certificate::Unknown { reason } => reason.contains("ends"),
        _ => false,
    };
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
    impl Maximand for HigherAtTheEnd {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some((x.clone() - &x.constant(0.5)).square() * x)
        }
        fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
            let aside = x.clone() - &x.constant(0.5);
            Some(aside.square() + &(aside * x * &x.constant(2.0)))
        }
        fn slope_near<S: Scalar>(&self, end: EndPoint, distance: &S) -> Option<S> {
            let position = match end {
                EndPoint::Lower => distance.clone(),
                EndPoint::Upper => distance.constant(1.0) - distance,
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
    impl Maximand for HalfKnown {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            (*x < x.constant(0.5)).then(|| TwoHills(1e-3).value(x))?
        }
        fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
            TwoHills(1e-3).slope(x)
        }
        fn slope_near<S: Scalar>(&self, end: EndPoint, distance: &S) -> Option<S> {
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
    impl Maximand for Rising {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(x.clone())
        }
        fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(x.constant(1.0))
        }
    }
    let refusal = certified_maximum(&Rising, (0.0, 1.0), BITS).unwrap_err();
    assert!(matches!(refusal, NumericError::NoInteriorMaximum { .. }));

    /// `−(x − ½)⁴`: its slope has a triple root.
    struct Flat;
    impl Maximand for Flat {
        fn value<S: Scalar>(&self, x: &S) -> Option<S> {
            Some(-(x.clone() - &x.constant(0.5)).square().square())
        }
        fn slope<S: Scalar>(&self, x: &S) -> Option<S> {
            let aside = x.clone() - &x.constant(0.5);
            Some(aside.square() * &aside * &x.constant(-4.0))
        }
    }
    let refusal = certified_maximum(&Flat, (0.0, 1.0), BITS).unwrap_err();
    assert!(matches!(refusal, NumericError::NotIsolated { .. }));
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

/// The slope that a split gives on a box holds at every point of the box: value and derivative,
/// to the ends.
#[test]
fn slopes_on_boxes_contain_the_slopes_in_them() {
    let scenes = [
        (Scene::floor_and_wall(1.0), 1),
        (Scene::floor_and_wall(100.0), 1),
        (Scene::facing_squares(0.5), 1),
        (Scene::built_in("three-squares"), 2),
    ];
    for (scene, neighbours) in scenes {
        let against: Vec<usize> = (1..=neighbours).collect();
        for axis in SplitAxis::ALL {
            let split = PatchSplit::try_new(scene.as_ref().unwrap(), 0, &against, axis).unwrap();
            let split = split.rectangles().unwrap();
            for (lower, width) in [
                (0.03, 1e-3),
                (0.1, 0.05),
                (0.37, 0.1),
                (0.4, 1e-6),
                (0.93, 0.02),
                (0.2, 0.4),
                (0.5, 0.45),
                (0.05, 0.9),
            ] {
                let domain = Interval::try_new(lower, lower + width).unwrap();
                let Some(Dual { value, slope }) = split.slope_on_box(&domain) else {
                    continue;
                };
                for share in [0.0, 0.1, 0.5, 0.77, 1.0] {
                    let at = (lower + share * width).min(lower + width);
                    let exact = split
                        .slope(&Dual::variable(Interval::precise(at, 128)))
                        .unwrap();
                    for (wide, point) in [(&value, &exact.value), (&slope, &exact.slope)] {
                        let wide = Interval::from_doubles(wide, 128);
                        assert!(point.width() < 1e-25, "{axis:?} {lower} {width}");
                        assert!(
                            wide.contains(point),
                            "{axis:?} {lower} {width}: {wide:?} {point:?}"
                        );
                    }
                }
            }
        }
    }
}
