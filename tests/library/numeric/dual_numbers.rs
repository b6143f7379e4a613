//! The slope of a dual number is the derivative, over doubles and enclosed over intervals, once and twice over.

use crate::support::intervals::{Judge, misses, power_of_two};
use infoscene::numeric::{Dual, Interval, Scalar};
use proptest::prelude::*;

/// Every operation of [`Scalar`] on the line `(x + t, y + c t)`.
#[derive(Debug, Clone, Copy)]
enum Operation {
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Sqrt,
    Ln,
    Ln1p,
    Exp,
    ExpM1,
    Atan2,
    DivergenceKernel,
    XLnX,
    Abs,
    Square,
    Constants,
}

const OPERATIONS: [Operation; 16] = {
    use Operation::{
        Abs, Add, Atan2, Constants, DivergenceKernel, Divide, Exp, ExpM1, Ln, Ln1p, Multiply,
        Negate, Sqrt, Square, Subtract, XLnX,
    };
    [
        Negate,
        Add,
        Subtract,
        Multiply,
        Divide,
        Sqrt,
        Ln,
        Ln1p,
        Exp,
        ExpM1,
        Atan2,
        DivergenceKernel,
        XLnX,
        Abs,
        Square,
        Constants,
    ]
};

impl Operation {
    fn of<S: Scalar>(self, x: &S, y: &S) -> S {
        match self {
            Self::Negate => -x.clone(),
            Self::Add => x.clone() + y,
            Self::Subtract => x.clone() - y,
            Self::Multiply => x.clone() * y,
            Self::Divide => x.clone() / y,
            Self::Sqrt => x.sqrt(),
            Self::Ln => x.ln(),
            Self::Ln1p => x.ln_1p(),
            Self::Exp => x.exp(),
            Self::ExpM1 => x.exp_m1(),
            Self::Atan2 => x.atan2(y),
            Self::DivergenceKernel => x.divergence_kernel(),
            Self::XLnX => x.x_ln_x(),
            Self::Abs => x.abs(),
            Self::Square => x.square(),
            Self::Constants => (x.pi() + &x.constant(2.0)) * x + &x.zero(),
        }
    }

    /// A number of its domain, well away from where a derivative has no bounds.
    fn within_domain(self, x: f64) -> f64 {
        match self {
            Self::Sqrt | Self::Ln => x.abs(),
            Self::Ln1p | Self::DivergenceKernel => x.max(-0.9),
            _ => x,
        }
    }
}

/// Step of the differences: their error is its square, 2⁻²⁰⁰, times a derivative; rounding is 2⁻²⁴⁸.
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

/// Does the interval, widened by what the differences are off, contain the number?
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

proptest! {
    /// `(f(x), f′(x) x′)` and, nested, `f″`: the doubles lie beside the interval at most its own width away, the
    /// interval contains the derivative, and its width is some hundred ε of it and of the terms that may cancel.
    #[test]
    fn slopes_are_derivatives(
        operation in prop::sample::select(OPERATIONS.to_vec()), x in number(), y in number(), rate in -2.0..2.0f64,
    ) {
        let x = operation.within_domain(x);
        let [first, second] = derivatives(operation, x, y, rate);
        let wide = Interval::point;
        let dual = operation.of(&Dual::variable(wide(x)), &Dual { value: wide(y), slope: wide(rate) });
        prop_assert!(is_enclosed(&dual.slope, &first), "{operation:?}: {:?} {:e}", dual.slope, first.to_f64());
        // the largest term of a derivative of these operations is below 2e6 where |x|, |y| ≥ 0.1
        prop_assert!(dual.slope.width() <= 64.0 * f64::EPSILON * (first.to_f64().abs() + 300.0));
        let value = operation.of(&wide(x), &wide(y));
        prop_assert!(dual.value.lower() == value.lower() && dual.value.upper() == value.upper());

        let fast = operation.of(&Dual::variable(x), &Dual { value: y, slope: rate });
        let room = dual.slope.width();
        prop_assert!(
            (*dual.slope.lower() - room..=*dual.slope.upper() + room).contains(&fast.slope),
            "{operation:?}: {:e} beside {:?}", fast.slope, dual.slope
        );

        let nested_x = Dual::variable(Dual::variable(wide(x)));
        let fixed = Dual::constant_like(&wide(rate));
        let nested_y = Dual { value: Dual { value: wide(y), slope: wide(rate) }, slope: fixed };
        let nested = operation.of(&nested_x, &nested_y);
        prop_assert!(is_enclosed(&nested.value.slope, &first) && is_enclosed(&nested.slope.value, &first));
        prop_assert!(is_enclosed(&nested.slope.slope, &second), "{operation:?}: {:?} {:e}", nested.slope.slope, second.to_f64());
        prop_assert!(nested.slope.slope.width() <= 64.0 * f64::EPSILON * (second.to_f64().abs() + 30000.0));
    }

    /// Over a box, the slope contains the derivative at every point of it.
    #[test]
    fn slopes_on_a_box_contain_all_derivatives(
        operation in prop::sample::select(OPERATIONS.to_vec()), x in number(), y in number(),
        rate in -2.0..2.0f64, width in prop_oneof![1e-9..1e-3f64, 0.0..1.0f64], share in 0.0..1.0f64,
    ) {
        let x = operation.within_domain(x);
        let domain = Interval::try_new(x, x + width).unwrap();
        let inside = (x + share * width).min(x + width);
        prop_assume!(inside.abs() > 0.05);
        let on_box = operation.of(&Dual::variable(domain), &Dual { value: Interval::point(y), slope: Interval::point(rate) });
        // at the point (inside, y) of the box, moved along (1, rate)
        let [first, _] = derivatives(operation, inside, y, rate);
        prop_assert!(is_enclosed(&on_box.slope, &first), "{operation:?} on {domain:?}: {:?} {:e}", on_box.slope, first.to_f64());
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
