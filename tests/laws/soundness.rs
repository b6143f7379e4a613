//! What is said to be proved, where the branches of a formula meet: jumps, kinks, ends.

use glam::DVec3;
use infoscene::discretize::{CertifiedGrid, UNIT_CUBE};
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::{Rectangle, Span, SplitAxis};
use infoscene::numeric::{Dual, Interval, IntervalFunction, Scalar, certified_roots};

/// `y + atan2(y, −1)/100` jumps across 0 and has no root, though its slope is near 1 on either side.
#[test]
fn a_jump_of_the_angle_is_no_root() {
    struct Jump;
    impl IntervalFunction for Jump {
        fn value<S: Scalar>(&self, y: &S) -> Option<S> {
            let angle = y.atan2(&y.constant(-1.0));
            Some(angle * &y.constant(0.01) + y)
        }
    }
    let found = certified_roots(&Jump, (-0.25, 0.25), 128);
    assert!(found.roots.is_empty(), "{found:?}");
    assert!(!found.undecided.is_empty());
}

/// The upper end of a part moves with its position, also where that is 1.
#[test]
fn the_end_of_a_part_moves_at_one_too() {
    let span = Span::try_new(0.0, 2.0).unwrap();
    for position in [0.5, 1.0] {
        let to = Dual::variable(position);
        let part = span.lifted(&to).part(&to.zero(), &to).unwrap();
        assert!(
            (part.upper().slope - 2.0).abs() < 1e-15,
            "{position}: {part:?}"
        );
        assert!((part.length().slope - 2.0).abs() < 1e-15);
    }
}

/// A floor half behind a wall's plane: a part that ends between the plane and a place before it exchanges from nothing up
/// to what the longest does.
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

/// No grid has zero cells.
#[test]
fn a_grid_without_cells_is_refused() {
    assert!(CertifiedGrid::regular(UNIT_CUBE, 0, 128).is_err());
    assert!(CertifiedGrid::best(UNIT_CUBE, 0, 128).is_err());
}
