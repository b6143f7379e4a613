//! Decimals of scene files, the module itself: nothing of it is public.

#[path = "../../../../src/scene/files/decimal.rs"]
mod decimal;

use decimal::complement;

/// Values found by hand; the last is 1 − 2⁻⁵⁴, which no `f64` holds.
#[test]
fn one_less_a_decimal_has_no_rounding() {
    for (value, expected) in [
        ("0.9", "0.1"),
        (".9", "0.1"),
        ("9e-1", "0.1"),
        ("90E-2", "0.1"),
        ("0.00009e4", "0.1"),
        ("1", "0"),
        ("1.000", "0"),
        ("0", "1"),
        ("0.000e7", "1"),
        ("1e-3", "0.999"),
        ("1e-99999", "1"),
        (
            "5.55111512312578270211815834045410156250e-17",
            "0.9999999999999999444888487687421729788184165954589843750",
        ),
    ] {
        let expected = expected.trim_end_matches('0');
        let expected = if expected.is_empty() { "0" } else { expected };
        assert_eq!(complement(value).as_deref(), Some(expected), "{value}");
    }
    for value in ["", ".", "-1", "1.1", "2", "nan", "inf", "1e", "0x1", "10"] {
        assert_eq!(complement(value), None, "{value}");
    }
}
