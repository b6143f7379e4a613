//! Form factors do not change when a scene is moved or scaled.

use crate::support::strategies::{motion, rectangle_pair};
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::Rectangle;
use infoscene::numeric::tolerance;
use proptest::prelude::*;

proptest! {
    /// Scaling by a power of two scales the exchange area by its square, to the last bit.
    #[test]
    fn exchange_area_scales_exactly((first, second) in rectangle_pair(), power in -300..300i32) {
        let scale = 2f64.powi(power);
        let scaled = |r: &Rectangle| {
            let [v0, v1, _, v3] = r.corners();
            Rectangle::try_new(v0 * scale, (v1 - v0) * scale, (v3 - v0) * scale)
        };
        let plain = RectanglePair::try_new(&first, &second)
            .unwrap()
            .exchange_area();
        let pair = RectanglePair::try_new(&scaled(&first).unwrap(), &scaled(&second).unwrap());
        match (plain, pair.unwrap().exchange_area()) {
            (Ok(plain), Ok(scaled)) => {
                prop_assert_eq!(plain.value, scaled.value / scale / scale);
            }
            (plain, scaled) => prop_assert!(plain.is_err() == scaled.is_err()),
        }
    }

    /// A rigid motion moves corners by rounding only: relative change within the alignment
    /// tolerance times the coordinates over the shortest side.
    #[test]
    fn exchange_area_survives_a_rigid_motion(
        (first, second) in rectangle_pair(),
        (turn, shift) in motion(),
    ) {
        let moved = |r: &Rectangle| {
            let [v0, v1, _, v3] = r.corners();
            Rectangle::try_new(turn * v0 + shift, turn * (v1 - v0), turn * (v3 - v0))
        };
        let sides = [first, second].map(|r| {
            let [v0, v1, _, v3] = r.corners();
            (v1 - v0).length().min((v3 - v0).length())
        });
        let shortest = sides[0].min(sides[1]);
        if shortest < 0.01 {
            return Ok(()); // the motion's own rounding of a sliver's direction is not the library's
        }
        let plain = RectanglePair::try_new(&first, &second)
            .unwrap()
            .exchange_area();
        let pair = RectanglePair::try_new(&moved(&first).unwrap(), &moved(&second).unwrap());
        if let (Ok(plain), Ok(moved)) = (plain, pair.unwrap().exchange_area()) {
            // coordinates up to 10 carry 10 ε each, edges that over their length; near a plane the
            // exchange changes by as much, relative to the smaller area
            let allowed = 10.0 * tolerance::ALIGNMENT / shortest * first.area().min(second.area())
                + plain.error
                + moved.error;
            let change = (plain.value - moved.value).abs();
            prop_assert!(
                change <= allowed,
                "{change:e} of {:e}, {allowed:e} allowed",
                plain.value
            );
        }
    }
}
