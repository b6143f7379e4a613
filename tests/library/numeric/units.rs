//! Units are powers of two, near what they measure.

use infoscene::numeric::{power_of_two_below, power_of_two_near};
use proptest::prelude::*;

/// Whether a positive number is a power of two; subnormal ones are made normal first.
fn is_power_of_two(number: f64) -> bool {
    let normal = if number < f64::MIN_POSITIVE {
        number * 2f64.powi(60)
    } else {
        number
    };
    normal.to_bits() & ((1 << 52) - 1) == 0
}

proptest! {
    /// `p ≤ |x| < 2p`, for every finite x but 0.
    #[test]
    fn the_unit_below_is_within_a_factor_of_two(bits in any::<u64>()) {
        let number = f64::from_bits(bits);
        prop_assume!(number.is_finite() && number != 0.0);
        let unit = power_of_two_below(number);
        prop_assert!(is_power_of_two(unit));
        // half of both sides, which the largest numbers need
        prop_assert!(unit <= number.abs() && 0.5 * number.abs() < unit);
    }

    /// `p/√2 ≤ x ≤ √2 p`, but for the rounding of √2 x.
    #[test]
    fn the_unit_near_is_within_the_root_of_two(significand in 1.0..2.0, power in -1000..1000) {
        let number = significand * 2f64.powi(power);
        let unit = power_of_two_near(number);
        prop_assert!(is_power_of_two(unit));
        let ratio = number / unit;
        let most = 2f64.sqrt() * (1.0 + 2.0 * f64::EPSILON);
        prop_assert!((1.0 / most..=most).contains(&ratio), "{ratio}");
    }
}

#[test]
fn what_has_no_power_of_two_below_keeps_its_magnitude() {
    assert_eq!(power_of_two_below(-0.0).to_bits(), 0);
    assert_eq!(power_of_two_below(f64::NEG_INFINITY), f64::INFINITY);
    assert!(power_of_two_below(f64::NAN).is_nan());
    assert_eq!(power_of_two_below(5e-324), 5e-324);
}
