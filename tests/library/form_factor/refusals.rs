//! Pairs of rectangles that have no closed form are refused.

use glam::DVec3;
use infoscene::form_factor::rectangles::parallel;
use infoscene::form_factor::{FormFactorError, RectanglePair};
use infoscene::geometry::{GeometryError, Rectangle, Span};

#[test]
fn rectangles_that_are_not_aligned_are_refused() {
    let square = Rectangle::try_new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
    let turned = Rectangle::try_new(
        DVec3::Z,
        DVec3::new(1.0, 1.0, 0.0),
        DVec3::new(1.0, -1.0, 0.0),
    );
    let refusal = RectanglePair::try_new(&square, &turned.unwrap()).unwrap_err();
    assert!(
        matches!(
            refusal,
            FormFactorError::Geometry(GeometryError::NotAligned { .. })
        ),
        "{refusal}"
    );
}

#[test]
fn distances_that_are_not_positive_are_refused() {
    let unit = Span::try_new(0.0, 1.0).unwrap();
    for distance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refusal = parallel::exchange_area(&[unit, unit], &[unit, unit], &distance);
        assert!(
            matches!(refusal, Err(FormFactorError::NonPositiveLength { .. })),
            "{distance}"
        );
    }
}
