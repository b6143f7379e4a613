//! Intervals to draw, operations on them, and what they are judged by: the same operation on
//! numbers of 448 bits, by the functions of `astro-float`, of which the intervals use none.

use super::high_precision::BigReal;
use infoscene::numeric::interval::{Direction, Endpoint};
use infoscene::numeric::{Interval, Precise, Scalar};
use proptest::prelude::*;
use std::cmp::Ordering;

/// Nearly 200 bits more than any end under test: the judge's own roundings are far below every
/// slack.
pub type Judge = BigReal<448>;

/// The relative error that the judge may have: its functions are off by a few units of 2^-448, sums
/// of them where they cancel (φ near its series) by 2^-430.
fn slack() -> Judge {
    Judge::new(2f64.powi(-420))
}

/// 2^power, exactly.
pub fn power_of_two(power: i32) -> Judge {
    if power.abs() < 1000 {
        return Judge::new(2f64.powi(power));
    }
    let base = Judge::new(if power < 0 { 0.5 } else { 2.0 });
    let bits = (0..32)
        .rev()
        .map(|bit| power.unsigned_abs() >> bit & 1 == 1);
    bits.fold(Judge::new(1.0), |product, is_set| {
        let square = product.square();
        if is_set { square * &base } else { square }
    })
}

/// An end whose value the judge can read.
pub trait Judged: Endpoint {
    /// Whether functions can be evaluated with more bits than their result has.
    const HAS_GUARD_BITS: bool = false;
    /// The exact value.
    fn exact(&self) -> Judge;
    /// The weight of the last bit of a number of this size.
    fn unit(&self) -> Judge;
}

impl Judged for f64 {
    fn exact(&self) -> Judge {
        Judge::new(*self)
    }
    fn unit(&self) -> Judge {
        Judge::new(self.abs().next_up() - self.abs())
    }
}

impl Judged for Precise {
    const HAS_GUARD_BITS: bool = true;

    /// Taken apart into doubles.
    fn exact(&self) -> Judge {
        if !Endpoint::is_finite(self) {
            return Judge::new(self.to_double(Direction::Down));
        }
        let mut rest = self.clone();
        let mut sum = Judge::new(0.0);
        while !Endpoint::is_zero(&rest) {
            let power = rest.exponent();
            let piece = rest
                .scaled(-power, Direction::Down)
                .to_double(Direction::Down);
            sum = sum + Judge::new(piece) * power_of_two(power);
            let taken = rest.constant(-piece).scaled(power, Direction::Down);
            rest = rest.plus(&taken, Direction::Down);
        }
        sum
    }
    fn unit(&self) -> Judge {
        if Endpoint::is_zero(self) {
            // the smallest number there is
            return power_of_two(-(1 << 28) - 1);
        }
        power_of_two(self.exponent() + 1 - i32::try_from(self.bits()).unwrap())
    }
}

/// The reach of an interval from its base.
#[derive(Debug, Clone, Copy)]
pub enum Shape {
    Point,
    OneUnit,
    /// An interval to base · (1 + 2^-power).
    Narrow(i32),
    /// An interval to base times a factor.
    Wide(f64),
    /// An interval to the other side of 0.
    Astride(f64),
    /// An interval from or to 0.
    Touching,
}

/// An interval in the making, for any type of end.
#[derive(Debug, Clone, Copy)]
pub struct Draw {
    pub base: f64,
    /// Bits beyond the 53 of the base, where the ends can hold them: less 2^-tail · base.
    pub tail: i32,
    pub shape: Shape,
    /// The choice of one of its numbers: below 1/3 the lower end, above 2/3 the upper end.
    pub place: f64,
}

impl Draw {
    /// The interval with ends like `like`.
    pub fn interval<E: Endpoint>(&self, like: &E) -> Interval<E> {
        let up = Direction::Up;
        let base = like.constant(self.base);
        let base = base.plus(&base.scaled(-self.tail, up).negated(), up);
        let factor = |value: f64| base.times(&base.constant(value), up);
        let other = match self.shape {
            Shape::Point => base.clone(),
            Shape::OneUnit => base.plus(&base.constant(f64::from_bits(1)), up),
            Shape::Narrow(power) => base.plus(&base.scaled(-power, up), up),
            Shape::Wide(value) => factor(value),
            Shape::Astride(value) => factor(-value),
            Shape::Touching => base.constant(0.0),
        };
        let (lower, upper) = if other < base {
            (other, base)
        } else {
            (base, other)
        };
        Interval::try_new(lower, upper).unwrap()
    }

    /// The number drawn from it.
    pub fn number<E: Endpoint>(&self, interval: &Interval<E>) -> E {
        let (lower, upper) = (interval.lower(), interval.upper());
        if lower.is_finite() && (self.place < 1.0 / 3.0 || !upper.is_finite()) {
            lower.clone()
        } else if upper.is_finite() && (self.place > 2.0 / 3.0 || !lower.is_finite()) {
            upper.clone()
        } else {
            interval.midpoint()
        }
    }
}

/// Sizes of numbers, most of them at hard spots: table entries and where forms change, tiny, huge,
/// near ±1.
fn base() -> impl Strategy<Value = f64> {
    let near = |center: f64| (3..60i32).prop_map(move |power| center + 2f64.powi(-power));
    let size = prop_oneof![
        3 => 0.1..10.0f64,
        2 => (-120..240i32).prop_map(|i| f64::from(i) / 64.0 + 1.0 / 128.0),
        2 => prop::sample::select(vec![
            0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0,
            0.25f64.next_down(), 0.25f64.next_up(), 1.5f64.next_up(),
            (-1f64).exp(), (-1f64).exp().next_up(),
            f64::MIN_POSITIVE, f64::MAX, f64::from_bits(1), f64::from_bits(3),
        ]),
        2 => near(1.0),
        2 => near(1.0).prop_map(|x| 2.0 - x),
        1 => (-307.0..-3.0f64).prop_map(|exponent| 10f64.powf(exponent)),
        1 => (1u64..1 << 52).prop_map(f64::from_bits),
        1 => (1u64..1 << 52, 0..52u32)
            .prop_map(|(bits, shift)| f64::from_bits(u64::max(bits >> shift, 1))),
        1 => (1.0..308.0f64).prop_map(|exponent| 10f64.powf(exponent)),
        2 => (0.0..3.0f64).prop_map(|exponent| 10f64.powf(exponent)),
    ];
    (size, any::<bool>()).prop_map(|(size, is_negative)| if is_negative { -size } else { size })
}

/// An interval of any size and shape.
pub fn draw() -> impl Strategy<Value = Draw> {
    let shape = prop_oneof![
        3 => Just(Shape::Point),
        2 => Just(Shape::OneUnit),
        2 => (5..55i32).prop_map(Shape::Narrow),
        2 => (1.0..4.0f64).prop_map(Shape::Wide),
        1 => (1.0..1e6f64).prop_map(Shape::Wide),
        2 => (0.0..4.0f64).prop_map(Shape::Astride),
        1 => Just(Shape::Touching),
    ];
    let tail = prop_oneof![40..250i32, Just(4000)];
    (base(), tail, shape, 0.0..1.0f64).prop_map(|(base, tail, shape, place)| Draw {
        base,
        tail,
        shape,
        place,
    })
}

/// Precisions of ends.
pub fn bits() -> impl Strategy<Value = u32> {
    prop::sample::select(vec![53u32, 64, 100, 128, 192, 256])
}

/// The operations of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
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
    Power(u32),
}

/// Each of them.
pub const OPERATIONS: [Operation; 19] = {
    use Operation::*;
    [
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
        Power(0),
        Power(1),
        Power(2),
        Power(3),
        Power(13),
    ]
};

fn raised<S: Scalar>(x: &S, exponent: u32) -> S {
    (0..exponent).fold(x.constant(1.0), |product, _| product * x)
}

impl Operation {
    /// The operation over any scalar but for powers.
    fn over<S: Scalar>(self, x: &S, y: &S, power: impl Fn(&S, u32) -> S) -> S {
        match self {
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
            Self::Power(exponent) => power(x, exponent),
        }
    }

    /// The enclosure.
    pub fn enclosure<E: Endpoint>(self, x: &Interval<E>, y: &Interval<E>) -> Interval<E> {
        self.over(x, y, Interval::power)
    }

    /// The operation over any scalar, powers by multiplication.
    pub fn of<S: Scalar>(self, x: &S, y: &S) -> S {
        self.over(x, y, raised)
    }

    /// The base moved to where the operation is defined.
    pub fn within_domain(self, draw: Draw) -> Draw {
        let base = draw.base;
        let shape = match (self, draw.shape) {
            (Self::Ln | Self::Sqrt, Shape::Astride(factor)) => Shape::Wide(factor),
            (_, shape) => shape,
        };
        let base = match self {
            Self::Ln | Self::Sqrt => base.abs(),
            Self::Ln1p | Self::DivergenceKernel if base < -1.0 => 1.0 / base,
            // to where f64's exponential is, and ten times as far
            Self::Exp | Self::ExpM1 if base.abs() > 7500.0 => base % 7500.0,
            _ => base,
        };
        Draw {
            base,
            shape,
            ..draw
        }
    }

    /// The true value, or none where the operation is not defined.
    pub fn truth(self, x: &Judge, y: &Judge) -> Option<Judge> {
        let (zero, minus_one) = (Judge::new(0.0), Judge::new(-1.0));
        let is_defined = match self {
            Self::Divide => !y.is_zero(),
            Self::Sqrt => *x >= zero,
            Self::Ln => *x > zero,
            Self::Ln1p => *x > minus_one,
            Self::DivergenceKernel => *x >= minus_one,
            _ => true,
        };
        is_defined.then(|| self.of(x, y))
    }

    /// The places besides the ends at which an operation on one number may be largest or smallest.
    fn turning_points(self) -> Vec<Judge> {
        let turn = Judge::new(-1.0).exp();
        match self {
            Self::XLnX => vec![-turn.clone(), turn],
            Self::DivergenceKernel | Self::Abs | Self::Square | Self::Power(_) => {
                vec![Judge::new(0.0)]
            }
            _ => Vec::new(),
        }
    }

    /// The exact range over x × y, or none if it is not defined or not continuous everywhere, or
    /// has no bound.
    pub fn range<E: Judged>(self, x: &Interval<E>, y: &Interval<E>) -> Option<[Judge; 2]> {
        if !(x.is_bounded() && y.is_bounded()) {
            return None;
        }
        let zero = Judge::new(0.0);
        let ends = |interval: &Interval<E>| [interval.lower().exact(), interval.upper().exact()];
        let ([x_lower, x_upper], [y_lower, y_upper]) = (ends(x), ends(y));
        let has_jump = match self {
            Self::Divide => y_lower <= zero && zero <= y_upper,
            Self::Atan2 => x_lower <= zero && zero <= x_upper && y_lower <= zero,
            _ => false,
        };
        if has_jump {
            return None;
        }
        let turns = self.turning_points().into_iter();
        let mut places: Vec<_> = turns
            .filter(|turn| x_lower < *turn && *turn < x_upper)
            .collect();
        places.extend([x_lower, x_upper]);
        let others = [y_lower, y_upper];
        let pairs = places
            .iter()
            .flat_map(|x| others.iter().map(move |y| (x, y)));
        let values = pairs.map(|(x, y)| self.truth(x, y));
        let values = values.collect::<Option<Vec<_>>>()?;
        let extreme = |side: Ordering| {
            let beyond = |a: Judge, b: &Judge| match b.partial_cmp(&a) {
                Some(order) if order == side => b.clone(),
                _ => a,
            };
            values[1..].iter().fold(values[0].clone(), beyond)
        };
        Some([extreme(Ordering::Less), extreme(Ordering::Greater)])
    }
}

/// Whether `number` is certainly on the wrong side of an end.
fn is_beyond(number: &Judge, end: &Judge, side: Ordering) -> bool {
    let slack = number.abs() * &slack();
    match side {
        Ordering::Less => number.clone() + &slack < *end,
        _ => number.clone() - &slack > *end,
    }
}

/// Whether the interval misses this number.
pub fn misses<E: Judged>(interval: &Interval<E>, number: &Judge) -> bool {
    let (lower, upper) = (interval.lower(), interval.upper());
    lower.partial_cmp(upper).is_none_or(Ordering::is_gt)
        || is_beyond(number, &lower.exact(), Ordering::Less)
        || is_beyond(number, &upper.exact(), Ordering::Greater)
}

/// The largest number of units in the last place by which the ends lie outside this range.
pub fn excess<E: Judged>(interval: &Interval<E>, [lower, upper]: &[Judge; 2]) -> f64 {
    let units = |excess: Judge, end: &E| {
        if excess <= Judge::new(0.0) {
            0.0
        } else {
            (excess / end.unit()).to_f64()
        }
    };
    let (low, high) = (interval.lower(), interval.upper());
    units(lower.clone() - low.exact(), low).max(units(high.exact() - upper, high))
}

/// Whether part of the range lies beyond the largest number of the type.
pub fn overflows<E: Judged>(like: &E, [lower, upper]: &[Judge; 2]) -> bool {
    let largest = like.constant(1.0).scaled(i32::MAX, Direction::Down).exact();
    *upper > largest || *lower < -largest
}

/// The number of times that a property is tried: as often as asked for, by default fewer times than
/// usual, since the judge is slow without optimisation.
pub fn cases(default: u32) -> ProptestConfig {
    let asked = std::env::var("PROPTEST_CASES").ok();
    ProptestConfig::with_cases(
        asked
            .and_then(|cases| cases.parse().ok())
            .unwrap_or(default),
    )
}

/// The operation as it reads in a failure.
pub fn shown<E: Endpoint>(interval: &Interval<E>) -> String {
    let (lower, upper) = interval.to_doubles();
    format!("[{lower:e}, {upper:e}] of {} bits", interval.lower().bits())
}
