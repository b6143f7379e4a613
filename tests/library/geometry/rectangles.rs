//! Rectangles and their spans: what is refused, and where parts end.

use glam::DVec3;
use infoscene::geometry::{Rectangle, Span, SplitAxis};
use infoscene::numeric::{Dual, Scalar};

#[test]
fn rectangles_have_right_angles_and_are_split_inside() {
    let leaning = Rectangle::try_new(DVec3::ZERO, DVec3::X, DVec3::new(0.1, 1.0, 0.0));
    assert!(leaning.unwrap_err().to_string().contains("leans"));
    let square = Rectangle::try_new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
    for position in [0.0, 1.0, -0.1, f64::NAN] {
        assert!(square.split(SplitAxis::U, position).is_err(), "{position}");
    }
}

#[test]
fn spans_are_finite_and_not_empty() {
    for (lower, upper) in [
        (1.0, 1.0),
        (1.0, 0.0),
        (f64::NAN, 1.0),
        (0.0, f64::INFINITY),
    ] {
        assert!(Span::try_new(lower, upper).is_err());
    }
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
