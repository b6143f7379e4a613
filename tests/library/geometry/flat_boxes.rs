//! A flat box is a rectangle with all corners exactly at its ends.

use glam::DVec3;
use infoscene::geometry::{FlatBox, Patch, Rectangle};

fn patch(corners: [[f64; 3]; 4]) -> Patch {
    Patch::try_new(corners.map(DVec3::from_array).to_vec()).unwrap()
}

#[test]
fn a_flat_box_is_bounded_by_its_corners_wherever_they_begin() {
    let corners = [
        [0.1, 0.7, 0.3],
        [0.1, 0.2, 0.3],
        [0.6, 0.2, 0.3],
        [0.6, 0.7, 0.3],
    ];
    for start in 0..4 {
        let mut turned = corners;
        turned.rotate_left(start);
        let flat = FlatBox::of(&patch(turned)).unwrap();
        assert_eq!((flat.axis, flat.faces_along), (2, true));
        assert_eq!((flat.lower, flat.upper), ([0.1, 0.2, 0.3], [0.6, 0.7, 0.3]));
        turned.reverse();
        assert!(!FlatBox::of(&patch(turned)).unwrap().faces_along);
    }
}

/// Three corners are exact and the fourth is off by a rounding: a rectangle with aligned edges, but
/// no flat box.
#[test]
fn a_corner_off_by_a_rounding_makes_no_flat_box() {
    let off = f64::from_bits(0.6_f64.to_bits() + 1);
    let almost = patch([
        [0.1, 0.2, 0.3],
        [0.6, 0.2, 0.3],
        [off, 0.7, 0.3],
        [0.1, 0.7, 0.3],
    ]);
    assert!(Rectangle::try_from(&almost).unwrap().aligned().is_some());
    assert_eq!(FlatBox::of(&almost), None);
}
