//! Fixed-size numbers against enclosures: every operation is within a few units of the last of its
//! 256 bits.

use infoscene::numeric::{Interval, Scalar};
use infoscene::reference::fixed_float::{FixedFloat, gauss_rule};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Number = FixedFloat<4>;

/// A number as an interval of no width, by its words.
fn enclosed(number: Number) -> Interval {
    let zero = Interval::precise(0.0, 512);
    let sign = zero.constant(if number.is_negative() { -1.0 } else { 1.0 });
    let words = number.parts().map(|(word, power)| {
        let halves = [word >> 32, word & 0xffff_ffff].map(|half| half as f64);
        let power = i32::try_from(power).unwrap();
        let scale = |x: f64, power: i32| zero.constant(x) * &zero.constant(2f64.powi(power));
        scale(halves[0], power + 32) + &scale(halves[1], power)
    });
    words.fold(zero.clone(), |sum, word| sum + &word) * &sign
}

/// Random doubles of very different sizes, with many or few bits, and their sums and products.
fn numbers() -> Vec<Number> {
    let mut source = ChaCha8Rng::seed_from_u64(26);
    let mut numbers = vec![
        Number::new(1.0),
        Number::new(-3.0),
        Number::new(2f64.powi(-200)),
    ];
    for k in 0..60 {
        let power: i32 = source.random_range(-90..90);
        let double = source.random::<f64>() * 2f64.powi(power);
        let double = if k % 4 == 0 {
            double.round() + 1.0
        } else {
            double
        };
        let number = Number::new(if k % 3 == 0 { -double } else { double });
        let last = numbers[numbers.len() - 1];
        numbers.push(if k % 2 == 0 {
            number
        } else {
            number * Number::new(0.1) + last
        });
    }
    numbers
}

/// Units of the last place that an operation may be off: one for each of the up to four roundings
/// behind a result.
const UNITS: f64 = 16.0;

/// The error of angles is as many times larger: the table that they are reduced by sums up to 512
/// steps, each cut off, and an angle near a right one takes two entries.
const ANGLE: f64 = 64.0;

fn assert_near(found: Number, exact: &Interval, scale: &Interval, what: &str) {
    let error = (enclosed(found) - exact).abs();
    let allowed = scale.abs() * &scale.constant(UNITS * 2f64.powi(-256));
    assert!(
        error.to_f64() <= allowed.to_f64(),
        "{what}: {found:?} off by {:e}",
        error.to_f64()
    );
}

/// `x ∘ y` for the four operations; a sum is judged by the larger operand.
#[test]
fn wide_operations_are_right_to_the_last_bits() {
    let numbers = numbers();
    for x in &numbers {
        for y in &numbers {
            let (a, b) = (enclosed(*x), enclosed(*y));
            let larger = a.abs().larger_of(&b.abs());
            assert_near(*x + *y, &(a.clone() + &b), &larger, "sum");
            assert_near(*x - *y, &(a.clone() - &b), &larger, "difference");
            let product = a.clone() * &b;
            assert_near(*x * *y, &product, &product, "product");
            let quotient = a.clone() / &b;
            assert_near(*x / *y, &quotient, &quotient, "quotient");
            assert_eq!(x < y, a < b);
            if y.is_positive() {
                let angle = a.atan2(&b);
                let scale = angle.constant(ANGLE) * &angle;
                assert_near(Number::atan_of_ratio(*x, *y), &angle, &scale, "angle");
            }
        }
        if x.is_positive() {
            let root = enclosed(*x).sqrt();
            assert_near(x.sqrt(), &root, &root, "root");
        }
        let inverse = enclosed(*x).constant(1.0) / &enclosed(*x);
        assert_near(x.reciprocal(), &inverse, &inverse, "reciprocal");
        let double = x.to_f64();
        let back = (enclosed(*x).to_f64() - double).abs();
        assert!(back <= f64::EPSILON * double.abs(), "{double}");
    }
    let pi = enclosed(Number::pi());
    assert_near(Number::pi(), &pi.pi(), &(pi.constant(ANGLE) * &pi), "π");
}

/// Terms that cancel leave exactly the difference, and zero is zero.
#[test]
fn wide_differences_cancel_exactly() {
    for x in numbers() {
        assert!((x - x).is_zero());
        // a double and a bit 150 places below it fit into 256 bits
        let short = Number::new(x.to_f64());
        let bit = Number::new(1.0).scaled(short.exponent() - 150);
        assert_eq!((short + bit) - short, bit, "{x:?}");
        assert!((x * Number::ZERO).is_zero() && Number::new(0.0).is_zero());
        assert_eq!(x + Number::ZERO, x);
    }
    for double in [5e-324, f64::MIN_POSITIVE / 3.0, f64::MAX, -1.5e-310, 0.1] {
        assert_eq!(Number::new(double).to_f64(), double);
    }
}

/// `∫₋₁¹ xᵏ dx = 2/(k+1)` or 0 for every k below twice the number of points, and not for the next.
#[test]
fn gauss_rules_are_exact_up_to_their_degree() {
    for order in [1, 2, 3, 7, 16, 33] {
        let rule = gauss_rule::<4>(order);
        let integral = |degree: usize| {
            rule.iter().fold(Number::ZERO, |sum, (node, weight)| {
                sum + (0..degree).fold(*weight, |power, _| power * *node)
            })
        };
        for degree in 0..2 * order {
            let exact = if degree % 2 == 0 {
                2.0 / (degree as f64 + 1.0)
            } else {
                0.0
            };
            let exact = if degree % 2 == 0 {
                Number::new(2.0) / Number::new(degree as f64 + 1.0)
            } else {
                Number::new(exact)
            };
            assert!(
                (integral(degree) - exact).abs().to_f64() < 1e-73,
                "{order} {degree}"
            );
        }
        let beyond = Number::new(2.0) / Number::new(2.0 * order as f64 + 1.0);
        assert!(
            (integral(2 * order) - beyond).abs().to_f64() > 1e-25,
            "{order}"
        );
    }
}
