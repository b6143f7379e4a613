//! The slope of a dual number is the derivative, over doubles and enclosed over intervals, once and
//! twice over.

use crate::support::intervals::{self, Judge, OPERATIONS, misses, power_of_two};
use infoscene::numeric::{Dual, Interval, Scalar};
use proptest::prelude::*;

/// An operation of [`Scalar`] on the line `(x + t, y + c t)`.
#[derive(Debug, Clone, Copy)]
enum Operation {
    OfIntervals(intervals::Operation),
    Negate,
    Constants,
}

/// All of them but for powers, which are products.
fn operations() -> Vec<Operation> {
    let is_power = |one: &intervals::Operation| matches!(one, intervals::Operation::Power(_));
    let shared = OPERATIONS.into_iter().filter(|one| !is_power(one));
    let shared = shared.map(Operation::OfIntervals);
    shared
        .chain([Operation::Negate, Operation::Constants])
        .collect()
}

impl Operation {
    fn of<S: Scalar>(self, x: &S, y: &S) -> S {
        match self {
            Self::OfIntervals(operation) => operation.of(x, y),
            Self::Negate => -x.clone(),
            Self::Constants => (x.pi() + &x.constant(2.0)) * x + &x.zero(),
        }
    }

    /// A number of its domain, well away from where a derivative has no bounds.
    fn within_domain(self, x: f64) -> f64 {
        use intervals::Operation::{DivergenceKernel, Ln, Ln1p, Sqrt};
        match self {
            Self::OfIntervals(Sqrt | Ln) => x.abs(),
            Self::OfIntervals(Ln1p | DivergenceKernel) => x.max(-0.9),
            _ => x,
        }
    }
}

/// Step of the differences: their error is its square, 2⁻²⁰⁰, times a derivative; rounding is
/// 2⁻²⁴⁸.
const STEP: i32 = -100;

/// The first and second derivative by central differences at 448 bits.
fn derivatives(operation: Operation, x: f64, y: f64, rate: f64) -> [Judge; 2] {
    let number = Judge::new;
    let step = power_of_two(STEP);
    let at = |sign: f64| {
        let t = step.clone() * number(sign);
        operation.of(&(number(x) + &t), &(number(y) + &(t * &number(rate))))
    };
    let [before, here, after] = [-1.0, 0.0, 1.0].map(at);
    let twice = step.clone() * number(2.0);
    [
        (after.clone() - &before) / twice,
        (after + &before - &(here * number(2.0))) / step.square(),
    ]
}

/// Whether the interval, widened by the error of the differences, contains the number.
fn is_enclosed(interval: &Interval<f64>, number: &Judge) -> bool {
    // third and fourth derivatives of arguments from 0.1 to 10 are below 2^60
    let slack = power_of_two(-130);
    let (below, above) = (number.clone() - &slack, number.clone() + &slack);
    let (lower, upper) = (Judge::new(*interval.lower()), Judge::new(*interval.upper()));
    lower <= above && below <= upper
}

/// Sizes from 0.1 to 10 of either sign, often a power of two or one.
fn number() -> impl Strategy<Value = f64> {
    let size = prop_oneof![
        0.1..10.0f64,
        prop_oneof![Just(0.25), Just(0.5), Just(1.0), Just(2.0)],
        (-40..-5i32).prop_map(|power| 1.0 + 2f64.powi(power)),
    ];
    (size, any::<bool>()).prop_map(|(size, is_negative)| if is_negative { -size } else { size })
}

/// An operation, a place of its domain, and the rate at which y grows there while x grows at rate
/// 1.
fn place() -> impl Strategy<Value = (Operation, f64, f64, f64)> {
    let operation = prop::sample::select(operations());
    (operation, number(), number(), -2.0..2.0f64)
        .prop_map(|(operation, x, y, rate)| (operation, operation.within_domain(x), y, rate))
}

/// The operation on enclosed dual numbers.
fn enclosed((operation, x, y, rate): (Operation, f64, f64, f64)) -> Dual<Interval<f64>> {
    let [x, y, rate] = [x, y, rate].map(Interval::point);
    operation.of(
        &Dual::variable(x),
        &Dual {
            value: y,
            slope: rate,
        },
    )
}

proptest! {
    /// `(f(x), f′(x) x′)` over intervals: the slope contains the derivative, and its width is some
    /// hundred ε of it and of the terms that may cancel.
    #[test]
    fn slopes_enclose_the_derivative(place in place()) {
        let (operation, x, y, rate) = place;
        let [first, _] = derivatives(operation, x, y, rate);
        let dual = enclosed(place);
        prop_assert!(
            is_enclosed(&dual.slope, &first),
            "{:?} {:e}",
            dual.slope,
            first.to_f64()
        );
        // the largest term of a derivative of these operations is below 2e6 where |x|, |y| ≥ 0.1
        prop_assert!(dual.slope.width() <= 64.0 * f64::EPSILON * (first.to_f64().abs() + 300.0));
    }

    /// The value of a dual number is the value without a slope, to the last bit.
    #[test]
    fn values_do_not_depend_on_slopes(place in place()) {
        let (operation, x, y, _) = place;
        let value = operation.of(&Interval::point(x), &Interval::point(y));
        let dual = enclosed(place).value;
        prop_assert!(dual.lower() == value.lower() && dual.upper() == value.upper());
    }

    /// Slopes in doubles lie beside the enclosed ones, at most their width away.
    #[test]
    fn slopes_in_doubles_lie_at_the_enclosure(place in place()) {
        let (operation, x, y, rate) = place;
        let fast = operation.of(
            &Dual::variable(x),
            &Dual {
                value: y,
                slope: rate,
            },
        );
        let slope = enclosed(place).slope;
        let (lower, upper) = (slope.lower() - slope.width(), slope.upper() + slope.width());
        prop_assert!(
            (lower..=upper).contains(&fast.slope),
            "{:e} beside {slope:?}",
            fast.slope
        );
    }

    /// Dual numbers of dual numbers: `f′` twice and `f″`, enclosed as narrowly.
    #[test]
    fn slopes_of_slopes_enclose_the_second_derivative((operation, x, y, rate) in place()) {
        let [first, second] = derivatives(operation, x, y, rate);
        let [x, y, rate] = [x, y, rate].map(Interval::point);
        let fixed = Dual::constant_like(&rate);
        let moving = Dual {
            value: Dual {
                value: y,
                slope: rate,
            },
            slope: fixed,
        };
        let nested = operation.of(&Dual::variable(Dual::variable(x)), &moving);
        for slope in [&nested.value.slope, &nested.slope.value] {
            prop_assert!(is_enclosed(slope, &first), "{slope:?} {:e}", first.to_f64());
        }
        let slope = &nested.slope.slope;
        prop_assert!(
            is_enclosed(slope, &second),
            "{slope:?} {:e}",
            second.to_f64()
        );
        prop_assert!(slope.width() <= 64.0 * f64::EPSILON * (second.to_f64().abs() + 30000.0));
    }

    /// Over a box, the slope contains the derivative at every point of it.
    #[test]
    fn slopes_on_a_box_contain_all_derivatives(
        operation in prop::sample::select(operations()),
        x in number(),
        y in number(),
        rate in -2.0..2.0f64,
        width in prop_oneof![1e-9..1e-3f64, 0.0..1.0f64],
        share in 0.0..1.0f64,
    ) {
        let x = operation.within_domain(x);
        let domain = Interval::try_new(x, x + width).unwrap();
        let inside = (x + share * width).min(x + width);
        prop_assume!(inside.abs() > 0.05);
        let on_box = operation.of(
            &Dual::variable(domain),
            &Dual {
                value: Interval::point(y),
                slope: Interval::point(rate),
            },
        );
        // at the point (inside, y) of the box, moved along (1, rate)
        let [first, _] = derivatives(operation, inside, y, rate);
        prop_assert!(
            is_enclosed(&on_box.slope, &first),
            "{operation:?} on {domain:?}: {:?} {:e}",
            on_box.slope,
            first.to_f64()
        );
        let [value] = [operation.of(&Judge::new(inside), &Judge::new(y))];
        prop_assert!(!misses(&on_box.value, &value));
    }
}

/// A slope that is infinite or open at a corner is not lost.
#[test]
fn slopes_at_corners_are_open() {
    let at = |lower, upper| Dual::variable(Interval::try_new(lower, upper).unwrap());
    let open = at(-1.0, 1.0).abs().slope;
    assert!(open.contains(&Interval::try_new(-1.0, 1.0).unwrap()));
    assert!(!at(0.0, 1.0).sqrt().slope.is_bounded());
    assert!(!at(0.0, 1.0).x_ln_x().slope.is_bounded());
    assert!(!at(0.0, 1.0).ln().slope.is_bounded());
    // what does not vary has slope 0 even there
    let fixed = Dual::constant_like(&Interval::point(0.0));
    assert!(fixed.sqrt().slope.is_zero() && fixed.abs().slope.is_zero());
}
