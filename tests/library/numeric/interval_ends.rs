//! Ends of intervals: their range and order, their way into doubles and decimals and back, always
//! outwards.

use crate::support::intervals::{Draw, Judge, Judged, bits, cases, draw, excess, misses};
use infoscene::numeric::interval::{Direction, Endpoint};
use infoscene::numeric::{Expansion, Interval, Precise, Scalar};
use proptest::prelude::*;

fn precise(value: f64) -> Interval {
    Interval::precise(value, 128)
}

/// An interval of any precision, by a power of two out of f64's range or not.
fn interval() -> impl Strategy<Value = Interval> {
    (
        draw(),
        bits(),
        prop_oneof![3 => Just(0), 2 => -1200..1200i32],
    )
        .prop_map(|(draw, bits, power)| {
            let interval = draw.interval(&Precise::new(0.0, bits));
            let scaled = |end: &Precise, direction| end.scaled(power, direction);
            let ends = (
                scaled(interval.lower(), Direction::Down),
                scaled(interval.upper(), Direction::Up),
            );
            Interval::try_new(ends.0, ends.1).unwrap()
        })
}

/// A decimal number of up to 40 digits and a small exponent.
fn decimal() -> impl Strategy<Value = String> {
    "[+-]?([0-9]{1,40}|[0-9]{0,20}\\.[0-9]{1,30}|[0-9]{1,9}\\.)([eE][+-]?[0-9]{1,2})?"
}

proptest! {
    #![proptest_config(cases(400))]

    /// Against exact sums and products: lower ≤ a ∘ b ≤ upper, with at most one double between.
    #[test]
    fn sums_and_products_of_doubles_enclose_the_exact_expansion(
        a in (-1.0..1.0f64, -100..100i32),
        b in (-1.0..1.0f64, -100..100i32),
    ) {
        let [a, b] = [a, b].map(|(value, power)| value * 2f64.powi(power));
        let (x, y) = (Interval::point(a), Interval::point(b));
        let product = &Expansion::from(a) * &Expansion::from(b);
        for (enclosure, exact) in [(x + y, Expansion::sum([a, b])), (x * y, product)] {
            let below = exact.clone() - &Expansion::from(*enclosure.lower());
            let above = Expansion::from(*enclosure.upper()) - &exact;
            prop_assert!(
                below.to_f64() >= 0.0 && above.to_f64() >= 0.0,
                "{a:e} {b:e} {enclosure:?}"
            );
            prop_assert!(enclosure.upper() <= &enclosure.lower().next_up());
        }
    }

    /// `a < b` holds if and only if all of a < all of b, and equality of single numbers only.
    #[test]
    fn comparisons_are_certain(x in draw(), y in draw(), bits in bits()) {
        let a = x.interval(&Precise::new(0.0, bits));
        for other in [
            y,
            x,
            Draw {
                base: x.base.next_up().min(f64::MAX),
                ..x
            },
        ] {
            let b = other.interval(&Precise::new(0.0, bits));
            let [a_ends, b_ends] = [&a, &b].map(|i| [i.lower().exact(), i.upper().exact()]);
            prop_assert_eq!(a < b, a_ends[1] < b_ends[0]);
            prop_assert_eq!(a > b, a_ends[0] > b_ends[1]);
            let all_equal =
                a_ends[0] == a_ends[1] && b_ends[0] == b_ends[1] && a_ends[0] == b_ends[0];
            prop_assert_eq!(a == b, all_equal);
        }
    }

    /// The hull contains both, no less wide hull does; the intersection is in both, and there is
    /// none exactly of intervals that compare.
    #[test]
    fn hulls_and_intersections_are_the_smallest_and_largest(
        x in draw(),
        y in draw(),
        bits in bits(),
    ) {
        let [a, b] = [x, y].map(|draw| draw.interval(&Precise::new(0.0, bits)));
        let hull = a.hull(&b);
        prop_assert!(hull.contains(&a) && hull.contains(&b));
        prop_assert!(
            !a.contains_inside(&a) && !hull.contains_inside(&a) || !hull.contains_inside(&b)
        );
        match a.intersection(&b) {
            None => prop_assert!(a < b || b < a),
            Some(both) => {
                prop_assert!(a.contains(&both) && b.contains(&both));
                prop_assert!(both.lower() == a.lower() || both.lower() == b.lower());
                prop_assert!(both.upper() == a.upper() || both.upper() == b.upper());
            }
        }
    }

    /// The midpoint is a number of the interval; the halves meet in it, cover, and are at most half
    /// as wide and a few units.
    #[test]
    fn halves_cover_and_meet(x in draw(), bits in bits()) {
        halves_are_right(&x.interval(&0.0))?;
        halves_are_right(&x.interval(&Precise::new(0.0, bits)))?;
    }

    /// `to_doubles` are the nearest doubles outside, `to_f64` lies between them, and neither end
    /// crosses 0.
    #[test]
    fn doubles_are_the_nearest_ones_outside(interval in interval()) {
        let (lower, upper) = interval.to_doubles();
        let (low, high) = (interval.lower().exact(), interval.upper().exact());
        prop_assert!(
            Judge::new(lower) <= low && high <= Judge::new(upper),
            "{lower:e} {upper:e}"
        );
        prop_assert!(
            Judge::new(lower.next_up()) > low || lower.is_infinite(),
            "{lower:e} is too low"
        );
        prop_assert!(
            Judge::new(upper.next_down()) < high || upper.is_infinite(),
            "{upper:e} is too high"
        );
        let middle = interval.to_f64();
        prop_assert!(
            !interval.is_bounded() || lower <= middle && middle <= upper,
            "{middle:e}"
        );
    }

    /// Fewer bits: outwards, by less than a unit; as many or more: the same.
    #[test]
    fn changes_of_precision_are_outward(interval in interval(), bits in bits()) {
        let changed = interval.with_precision(bits);
        let ends = [interval.lower().exact(), interval.upper().exact()];
        prop_assert!(!ends.iter().any(|end| misses(&changed, end)));
        let units = if bits < interval.lower().bits() {
            1.0
        } else {
            0.0
        };
        prop_assert!(!interval.is_bounded() || excess(&changed, &ends) <= units);
        prop_assert_eq!(changed.lower().bits(), bits);
        // a number of 53 bits is a double, but for its power of two
        for end in [changed.lower(), changed.upper()] {
            if bits == 53 && end.is_finite() && !Endpoint::is_zero(end) {
                let significand = end.scaled(-end.exponent(), Direction::Down).exact();
                prop_assert!(significand == Judge::new(significand.to_f64()));
            }
        }
    }

    /// A decimal lies in what it is parsed to, two units wide at most.
    #[test]
    fn parsed_decimals_are_narrow_enclosures(text in decimal(), bits in bits()) {
        let exact = Judge::parse(&text).unwrap();
        let interval = Interval::parse(&text, bits).unwrap();
        prop_assert!(!misses(&interval, &exact), "{text} in {interval:?}");
        prop_assert!(
            excess(&interval, &[exact.clone(), exact]) <= 1.0,
            "{text} in {interval:?}"
        );
    }

    /// Written out and read again, an interval only grows: by less than two units of the last
    /// decimal written.
    #[test]
    fn decimals_written_and_read_again_contain_the_interval(
        draw in draw(),
        bits in bits(),
        most_decimals in 0..90u32,
    ) {
        let interval = draw.interval(&Precise::new(0.0, bits));
        prop_assume!(interval.is_bounded());
        let bounds = interval.to_decimal(most_decimals).unwrap();
        let read = |text: &str| Interval::parse(text, 2048).unwrap();
        let (lower, upper) = (read(&bounds.lower), read(&bounds.upper));
        prop_assert!(
            lower.lower().exact() <= interval.lower().exact(),
            "{bounds:?}"
        );
        prop_assert!(
            upper.upper().exact() >= interval.upper().exact(),
            "{bounds:?}"
        );
        let decimals = bounds
            .lower
            .split_once('.')
            .map_or(0, |(_, fraction)| fraction.len());
        prop_assert!(decimals <= most_decimals as usize);
        // 1 = one unit of the last decimal
        let power = read(&format!("1e{decimals}"));
        for excess in [
            Interval::point(interval.lower().clone()) - &lower,
            upper - &Interval::point(interval.upper().clone()),
        ] {
            prop_assert!((excess * &power).to_f64() < 1.0 + 1e-9, "{bounds:?}");
        }
        // and not fewer decimals than the width leaves certain
        let width = interval.upper().exact() - interval.lower().exact();
        let is_short = decimals < most_decimals as usize && !interval.is_point();
        prop_assert!(
            !is_short || width * power.lower().exact() >= Judge::new(5.0),
            "{bounds:?}"
        );
    }

    /// Parsed is what the standard library takes for a number, infinities and NaN aside.
    #[test]
    fn only_plain_decimals_are_parsed(text in "[0-9eE.+ x_-]{0,7}") {
        let is_number = text.trim().parse::<f64>().is_ok();
        prop_assert_eq!(
            Interval::parse(&text, 64).is_some(),
            is_number,
            "{:?}",
            text
        );
    }
}

fn halves_are_right<E: Judged>(interval: &Interval<E>) -> Result<(), TestCaseError> {
    if !interval.is_bounded() {
        return Ok(());
    }
    let middle = Interval::point(interval.midpoint());
    prop_assert!(interval.contains(&middle));
    if let Some([left, right]) = interval.halves() {
        prop_assert!(left.lower() == interval.lower() && right.upper() == interval.upper());
        prop_assert!(left.upper() == right.lower());
        let half = (interval.upper().exact() - interval.lower().exact()) / Judge::new(2.0);
        for part in [left, right] {
            let width = part.upper().exact() - part.lower().exact();
            let unit = interval.upper().unit() + interval.lower().unit();
            prop_assert!(width - &half <= unit * Judge::new(2.0));
        }
    }
    Ok(())
}

/// Text that is no decimal number, and exponents without measure.
#[test]
fn garbage_is_not_parsed() {
    let garbage = [
        "",
        " ",
        "-",
        "+",
        ".",
        "e5",
        "1e",
        "1e+",
        "1.2.3",
        "--1",
        "+-1",
        "1e5e6",
        "1e1.5",
        "inf",
        "nan",
        "0x10",
        "1_000",
        "1,5",
        "½",
        "１",
        "1e999999999",
        "1e-999999999",
        "1e99999999999",
        "1e-2147483648",
    ];
    for text in garbage {
        assert!(Interval::parse(text, 64).is_none(), "{text}");
    }
}

/// Powers of two up to 2^28 either way: beyond, an end is rounded outwards to ∞ or 0, inwards to
/// the last number.
#[test]
fn overflow_and_underflow_are_outward() {
    let largest = Interval::point(Precise::new(1.0, 100).scaled(i32::MAX, Direction::Down));
    let smallest = Interval::point(Precise::new(1.0, 100).scaled(-i32::MAX, Direction::Up));
    let beyond = largest.clone() * &largest;
    assert_eq!(beyond.lower(), largest.lower());
    assert!(!beyond.upper().is_finite());
    assert_eq!((largest.clone() + &largest).lower(), largest.lower());
    assert_eq!(
        (-largest.clone() * &largest).upper(),
        (-largest.clone()).upper()
    );
    let within = smallest.clone() * &smallest;
    assert!(Endpoint::is_zero(within.lower()) && within.upper() == smallest.upper());
    let within = -smallest.clone() / &largest;
    assert!(Endpoint::is_zero(within.upper()) && within.lower() == (-smallest.clone()).lower());
    assert!(smallest.sqrt().square().contains(&smallest));
    assert!(largest.sqrt().is_bounded() && largest.sqrt().square().contains(&largest));
}

/// `ln eˣ ∋ x`, also where eˣ leaves the range of exponents, and a larger x has no smaller bound.
#[test]
fn exponentials_beyond_the_range_are_still_enclosures() {
    let places = [1e3, 1e6, 1.8e8, 1.87e8, 3e8, 8e8, 9.9e8, 1.1e9, 1e15, 1e300];
    let mut before = precise(0.0).exp();
    for place in places {
        let (up, down) = (precise(place).exp(), precise(-place).exp());
        assert!(up.ln().contains(&precise(place)) && up.lower() >= before.lower());
        assert!(down.lower().sign().is_ge() && down.ln().contains(&precise(-place)));
        assert!(up.is_bounded() == (place < 1.86e8));
        before = up;
    }
    for place in [709.0, 710.0, 745.0, 746.0, 1e3, 1e6, 1e300] {
        let (up, down) = (Interval::point(place).exp(), Interval::point(-place).exp());
        assert!(
            up.ln().contains(&Interval::point(place))
                && down.ln().contains(&Interval::point(-place))
        );
        assert!(*down.lower() >= 0.0 && up.lower().is_finite());
    }
}

/// An operation that is defined nowhere gives the whole line.
#[test]
fn undefined_operations_give_the_whole_line() {
    let (zero, two) = (precise(0.0), precise(2.0));
    let undefined = [
        two.clone() / &zero,
        two.clone() / &(-two.clone()).hull(&two),
        (-two.clone()).sqrt(),
        (-two.clone()).ln(),
        zero.ln(),
        (-two.clone()).ln_1p(),
        precise(-1.0).ln_1p(),
        (-two.clone()).divergence_kernel(),
        two.constant(f64::NAN),
        precise(f64::NAN),
    ];
    for (k, interval) in undefined.iter().enumerate() {
        assert!(interval.contains(&two.whole_line()), "{k}: {interval:?}");
    }
    assert!(precise(1e300).power(2000).to_decimal(5).is_none());
    assert!(two.whole_line().to_decimal(5).is_none());
    // beside the pole one side is left
    let right = two.clone() / &zero.hull(&two);
    assert!(*right.lower() == two.constant(1.0).lower().clone() && !right.upper().is_finite());
}
