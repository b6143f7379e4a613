//! Exchange areas add up over the parts of a patch.

use crate::support::strategies::rectangle_pair;
use glam::DVec3;
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::{Rectangle, SplitAxis};
use proptest::prelude::*;

proptest! {
    /// `A F = A_near F_near + A_far F_far`, within the three bounds, by relative parts of the pair
    /// and by cutting the rectangle itself.
    #[test]
    fn exchange_of_the_parts_is_the_exchange_of_the_whole(
        (first, second) in rectangle_pair(),
        axis in prop_oneof![Just(SplitAxis::U), Just(SplitAxis::V)],
        eighth in 1..8u32,
    ) {
        let position = f64::from(eighth) / 8.0;
        let pair = RectanglePair::try_new(&first, &second).unwrap();
        let Ok(whole) = pair.exchange_area() else {
            return Ok(());
        };
        let near = pair.part(axis, &0.0, &position).unwrap();
        let far = pair.part(axis, &position, &1.0).unwrap();
        let [cut_near, cut_far] = first
            .split(axis, position)
            .unwrap()
            .map(|part| RectanglePair::try_new(&part, &second).unwrap());
        // the cut rectangle's new corner is rounded: the line moves by ε of its coordinates
        let coordinate = first
            .corners()
            .iter()
            .map(|c| c.abs().max_element())
            .fold(0.0, f64::max);
        let moved = 2.0 * f64::EPSILON * coordinate / first.edge(axis).length();
        let strip = pair.strip_exchange(axis, &position).unwrap().abs();
        for ([near, far], rounding) in [([near, far], 0.0), ([cut_near, cut_far], moved * strip)] {
            let (Ok(near), Ok(far)) = (near.exchange_area(), far.exchange_area()) else {
                return Ok(());
            };
            let allowed = whole.error + near.error + far.error + rounding;
            let gap = (near.value + far.value - whole.value).abs();
            prop_assert!(
                gap <= allowed,
                "gap {gap:e}, allowed {allowed:e} of {:e}",
                whole.value
            );
        }
    }
}

/// Negative control: parts that leave a gap do not add up.
#[test]
fn parts_with_a_gap_between_them_do_not_add_up() {
    let scene = infoscene::scene::Scene::built_in("two-squares").unwrap();
    let (floor, wall) = (scene.rectangle(0).unwrap(), scene.rectangle(1).unwrap());
    let pair = RectanglePair::try_new(&floor, &wall).unwrap();
    let part = |from, to| {
        pair.part(SplitAxis::U, &from, &to)
            .unwrap()
            .exchange_area()
            .unwrap()
    };
    let whole = pair.exchange_area().unwrap();
    let gap = whole.value - part(0.0, 0.4).value - part(0.4001, 1.0).value;
    assert!(gap > 1e-6 && gap > whole.error);
}

/// A part 2⁻⁴⁰ wide exchanges what its strip does: its width is not recomputed from its rounded
/// ends, which would be off by 1e-4 of it.
#[test]
fn thin_parts_keep_their_digits() {
    let floor = Rectangle::try_new(DVec3::ZERO, 0.7 * DVec3::X, 0.9 * DVec3::Y).unwrap();
    let wall = Rectangle::try_new(DVec3::ZERO, 0.9 * DVec3::Y, DVec3::Z).unwrap();
    let ceiling = Rectangle::try_new(DVec3::Z, DVec3::Y, DVec3::X).unwrap();
    let width = 2f64.powi(-40);
    for other in [wall, ceiling] {
        let pair = RectanglePair::try_new(&floor, &other).unwrap();
        for axis in SplitAxis::ALL {
            let part = pair
                .part(axis, &0.5, &(0.5 + width))
                .unwrap()
                .exchange_area()
                .unwrap();
            let strip = pair.strip_exchange(axis, &0.5).unwrap() * width;
            // the strip changes by its relative slope, of order one, times the width
            assert!(
                (part.value / strip - 1.0).abs() < 1e-11,
                "{axis:?}: {} {strip}",
                part.value
            );
        }
    }
}
