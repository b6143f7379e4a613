//! The last places of coordinates, the module itself: nothing of it is public.

#[path = "../../../../src/scene/files/last_place.rs"]
mod last_place;

use last_place::LastPlaces;

/// Half units found by hand, of files as programs and people write them.
#[test]
fn the_last_place_is_that_of_the_longest_numbers() {
    for (coordinates, expected) in [
        ("3.059 2.577 0.000 -3.221 12.345 100.000", 5e-4),
        // the same without zeros at the end
        ("3.059 2.577 0 -3.2 12.34 100", 5e-4),
        // three decimals, written as six
        ("3.059000 2.577000 0.000000", 5e-4),
        ("3059 2577 0 -3221", 0.5),
        // six and nine significant digits
        ("12.3457 0.892223 1 0.5", 5e-5),
        ("432100.125 0.123456789 5811234.38 5811234.25", 5e-3),
        ("0 1 0.5 1e-11", 0.0),
        ("1.5E+3 2.25e1", 5e-2),
        // written by hand, and not rounded
        ("0 1 2.5 0.1", 0.0),
        ("0 1", 0.0),
        ("0 0 0.0", 0.0),
        // sixteen and seventeen digits: exact, as far as f64 goes
        ("0.1234567890123456 1.2345678901234567 1", 5e-17),
        // 32-bit floats written as 64 bits: two units of the largest
        (
            "0.100000001490116 0.300000011920929 0.699999988079071 0.200000002980232 8",
            4.0 * 8.0 * 5.960_464_477_539_063e-8,
        ),
        // eight digits say nothing of 32 bits
        ("10.123456 11.654321 10.777777 10.123451 3.000001", 5e-7),
    ] {
        let mut places = LastPlaces::default();
        for text in coordinates.split(' ') {
            places.note(text, text.parse().unwrap_or(f64::NAN));
        }
        let found = places.half_unit();
        assert!(
            (found - expected).abs() <= 1e-12 * expected,
            "{coordinates}: {found:e}, not {expected:e}"
        );
    }
}
