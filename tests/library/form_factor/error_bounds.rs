//! The running bound of the rectangle closed forms is never below their error.

use crate::support::high_precision::HighPrecision;
use crate::support::strategies::{depth, span};
use infoscene::form_factor::Exchange;
use infoscene::form_factor::rectangles::perpendicular::Plate;
use infoscene::form_factor::rectangles::{parallel, perpendicular};
use infoscene::geometry::Span;
use infoscene::numeric::Scalar;
use proptest::prelude::*;

fn wide(span: &Span) -> Span<HighPrecision> {
    Span::try_new(
        HighPrecision::new(*span.lower()),
        HighPrecision::new(*span.upper()),
    )
    .unwrap()
}

/// The error in units of the bound, and the bound relative to the value.
fn judged(fast: &Exchange<f64>, exact: &HighPrecision) -> (f64, f64) {
    let bound = fast.in_range(1.0).unwrap().error;
    let error = (HighPrecision::new(fast.value) - exact).abs().to_f64();
    (error / bound, bound / exact.to_f64().abs())
}

fn parallel_pair() -> impl Strategy<Value = ([Span; 2], [Span; 2], f64)> {
    let distance = prop_oneof![0.1..3.0f64, (-9.0..2.0f64).prop_map(|e| 10f64.powf(e))];
    ([span(), span()], [span(), span()], distance)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.div_ceil(2)))]

    /// `|A F − exact| ≤ bound` for parallel rectangles, the exact value from the same formula with
    /// 256 bits, whose own error is 2⁻²⁰⁰ of it.
    #[test]
    fn parallel_bound_is_never_below_the_error((first, second, distance) in parallel_pair()) {
        let fast = parallel::exchange_area(&first, &second, &distance).unwrap();
        let [first, second] = [first, second].map(|pair| pair.each_ref().map(wide));
        let exact =
            parallel::exchange_area(&first, &second, &HighPrecision::new(distance)).unwrap();
        let (share, _) = judged(&fast, &exact.value);
        prop_assert!(share <= 1.0, "error is {share} of the bound");
    }

    /// Bounds of perpendicular rectangles are not below their errors.
    #[test]
    fn perpendicular_bound_is_never_below_the_error(
        first in (depth(), span()),
        second in (depth(), span()),
    ) {
        let plate = |(depth, width)| Plate::try_new(depth, width).unwrap();
        let fast = perpendicular::exchange_area(&plate(first), &plate(second));
        let wide_plate = |(depth, width)| Plate::try_new(wide(&depth), wide(&width)).unwrap();
        let exact = perpendicular::exchange_area(&wide_plate(first), &wide_plate(second));
        let (share, _) = judged(&fast, &exact.value);
        prop_assert!(share <= 1.0, "error is {share} of the bound");
    }
}

/// The bound is worth having: for rectangles of sides 0.2 to 2 within two sizes of each other it is
/// below 1e-11 of the value, and below 1e-13 a size apart.
#[test]
fn bounds_of_near_rectangles_are_small() {
    let span = |a: f64, b: f64| Span::try_new(a, b).unwrap();
    for (distance, allowed) in [(0.2, 1e-13), (1.0, 1e-13), (2.0, 1e-12), (4.0, 1e-11)] {
        let square = [span(0.0, 1.0), span(0.0, 1.0)];
        let exchange = parallel::exchange_area(&square, &square, &distance).unwrap();
        let bound = exchange.in_range(1.0).unwrap().error;
        assert!(
            bound <= allowed * exchange.value,
            "{distance}: {:e}",
            bound / exchange.value
        );
    }
}

/// Far away nothing is left of the closed form, and it says so.
#[test]
fn an_unresolved_pair_is_refused() {
    let unit = [0.0, 0.0].map(|lower| Span::try_new(lower, 1.0).unwrap());
    let exchange = parallel::exchange_area(&unit, &unit, &1e7).unwrap();
    assert!(exchange.resolved(1.0).is_err(), "{exchange:?}");
}
