//! Exchange areas in doubles agree with their enclosures, and enclosures of parts stay sound where
//! branches meet.

use crate::support::strategies::rectangle_pair;
use glam::DVec3;
use infoscene::form_factor::{ExchangeArea, FormFactorError, RectanglePair};
use infoscene::geometry::{Rectangle, SplitAxis};
use infoscene::numeric::{Interval, Scalar};
use proptest::prelude::*;

/// Rectangles of any size, up to 1e5 apart and as thin as 1e-10, in the unit of any power of ten.
fn extreme_pair() -> impl Strategy<Value = (Rectangle, Rectangle)> {
    let exponent = || prop_oneof![Just(0.0), -5.0..0.0f64, -2.0..2.0f64, 0.0..5.0f64];
    let place = || {
        (any::<bool>(), exponent())
            .prop_map(|(negative, e)| if negative { -1.0 } else { 1.0 } * 10f64.powf(e))
    };
    let lengths = proptest::array::uniform4(exponent());
    let places = proptest::array::uniform3(place());
    let unit = prop_oneof![Just(0), -40..40i32];
    (lengths, places, unit, any::<bool>()).prop_map(|(lengths, [x, y, z], unit, is_parallel)| {
        let unit = 10f64.powi(unit);
        let [a, b, c, d] = lengths.map(|e| unit * 10f64.powf(e));
        let floor = Rectangle::try_new(DVec3::ZERO, a * DVec3::X, b * DVec3::Y).unwrap();
        let origin = unit * DVec3::new(x, y, z.abs());
        let (u, v) = if is_parallel {
            (d * DVec3::Y, c * DVec3::X)
        } else {
            (c * DVec3::Y, d * DVec3::Z)
        };
        (floor, Rectangle::try_new(origin, u, v).unwrap())
    })
}

/// The value and its bound, also of a pair that is refused because its value is below the bound.
fn computed(pair: &RectanglePair) -> Option<ExchangeArea> {
    match pair.exchange_area() {
        Ok(area) => Some(area),
        Err(FormFactorError::NotResolved { value, error }) => Some(ExchangeArea { value, error }),
        Err(_) => None,
    }
}

/// `|fast − x| ≤ bound` for all x of the enclosure, which is narrower than 1e-30 of itself or of
/// the bound.
fn agree(fast: &ExchangeArea, enclosure: &Interval) -> Result<(), TestCaseError> {
    let off = (enclosure.constant(fast.value) - enclosure).abs();
    let (_, off) = off.to_doubles();
    prop_assert!(
        off <= fast.error,
        "{fast:?} is {off:e} off {:e}: {} of the bound",
        enclosure.to_f64(),
        off / fast.error
    );
    let width = enclosure.width();
    prop_assert!(
        width <= 1e-30 * enclosure.to_f64(),
        "{:e}: width {width:e}",
        enclosure.to_f64()
    );
    Ok(())
}

proptest! {
    /// `|A F − exact| ≤ error` for pairs a few sizes apart, the exact value enclosed with 256
    /// bits.
    #[test]
    fn exchange_areas_agree_with_their_enclosures((first, second) in rectangle_pair()) {
        let Ok(pair) = RectanglePair::try_new(&first, &second) else {
            return Ok(());
        };
        let fast = computed(&pair).unwrap();
        agree(
            &fast,
            &pair
                .lifted(&Interval::precise(1.0, 256))
                .exchange_value()
                .unwrap(),
        )?;
    }

    /// Extreme rectangles are enclosed with 512 bits: their terms cancel by the cube of the
    /// distance.
    #[test]
    fn extreme_exchange_areas_agree_with_their_enclosures((first, second) in extreme_pair()) {
        let Ok(pair) = RectanglePair::try_new(&first, &second) else {
            return Ok(());
        };
        let Some(fast) = computed(&pair) else {
            return Ok(());
        };
        agree(
            &fast,
            &pair
                .lifted(&Interval::precise(1.0, 512))
                .exchange_value()
                .unwrap(),
        )?;
    }
}

/// A floor half behind a wall's plane: a part that ends between the plane and a place before it
/// exchanges from nothing up to what the longest does.
#[test]
fn a_part_that_may_end_on_a_plane_is_not_dark() {
    let floor = Rectangle::try_new(DVec3::NEG_X, 2.0 * DVec3::X, DVec3::Y).unwrap();
    let wall = Rectangle::try_new(DVec3::ZERO, DVec3::Y, DVec3::Z).unwrap();
    let pair = RectanglePair::try_new(&floor, &wall).unwrap();
    let exchange = |lower: f64, upper: f64| {
        let to = Interval::try_new(lower, upper).unwrap();
        let part = pair.lifted(&to).part(SplitAxis::U, &to.zero(), &to);
        part.unwrap().exchange_value()
    };
    let longest = exchange(0.75, 0.75).unwrap();
    assert!(*longest.lower() > 0.1);
    if let Ok(enclosure) = exchange(0.5, 0.75) {
        assert!(enclosure.contains(&longest), "{enclosure:?} {longest:?}");
    }
    // the plane itself and what lies before it stay dark
    for upper in [0.25, 0.5] {
        let dark = exchange(upper, upper).unwrap();
        assert!(dark.is_zero(), "{dark:?}");
    }
    let dark = exchange(0.25, 0.5).unwrap();
    assert!(dark.is_zero(), "{dark:?}");
}
