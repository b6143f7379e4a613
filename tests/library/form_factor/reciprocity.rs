//! Reciprocity: light that one patch sends to another comes back: `A_i F_ij = A_j F_ji`.

use crate::support::strategies::rectangle_pair;
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::SplitAxis;
use proptest::prelude::*;

proptest! {
    /// The exchange area is the same from either frame, within the bounds and what the rounding of
    /// coordinates in either frame can change: a shift by δ moves at most the flux through a rim of
    /// that width.
    #[test]
    fn exchange_area_is_the_same_from_both_sides((first, second) in rectangle_pair()) {
        let there = RectanglePair::try_new(&first, &second)
            .unwrap()
            .exchange_area();
        let back = RectanglePair::try_new(&second, &first)
            .unwrap()
            .exchange_area();
        if let (Ok(there), Ok(back)) = (there, back) {
            let coordinates = [first, second].map(|r| r.corners().map(|c| c.abs().max_element()));
            let coordinate = coordinates.into_iter().flatten().fold(0.0, f64::max);
            let rim = 2.0
                * SplitAxis::ALL
                    .map(|axis| first.edge(axis).length())
                    .iter()
                    .sum::<f64>();
            let rounding = 2.0 * f64::EPSILON * coordinate * rim;
            let allowed = there.error + back.error + rounding;
            prop_assert!(
                (there.value - back.value).abs() <= allowed,
                "{there:?} {back:?}"
            );
        }
    }
}
