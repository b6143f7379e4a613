//! Extremes of numbers pass NaN on, where `f64::max` does not.

use infoscene::numeric::{larger, largest, smaller};

#[test]
fn extremes_pass_nan_on() {
    for [a, b] in [[1.0, f64::NAN], [f64::NAN, 1.0]] {
        assert!(larger(a, b).is_nan() && smaller(a, b).is_nan());
        assert!(!a.max(b).is_nan(), "the control");
    }
    assert!(largest([0.5, f64::NAN, 2.0]).is_nan());
}

#[test]
fn extremes_of_numbers_are_one_of_them() {
    let bits = [larger(-2.0, 1.5), smaller(-2.0, 1.5), largest([0.5, 2.0])].map(f64::to_bits);
    assert_eq!(bits, [1.5f64, -2.0, 2.0].map(f64::to_bits));
    assert_eq!(largest([]).to_bits(), 0.0f64.to_bits());
}
