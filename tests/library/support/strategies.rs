//! Generators of valid rectangles, two thirds of the draws at the hard spots.

use glam::{DQuat, DVec3};
use infoscene::geometry::{Rectangle, Span};
use proptest::prelude::*;

/// A position, often exactly 0 or 1 or next to it.
pub fn position() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => -1.0..2.0f64,
        1 => prop_oneof![Just(0.0), Just(0.5), Just(1.0)],
        1 => (-9.0..-2.0f64, prop_oneof![Just(0.0), Just(1.0)])
            .prop_map(|(exponent, end)| end + 10f64.powf(exponent)),
    ]
}

/// A length, often a thousandth or less of the others.
pub fn length() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => 0.2..2.0f64,
        1 => Just(1.0),
        1 => (-5.0..0.0f64).prop_map(|exponent| 10f64.powf(exponent)),
    ]
}

/// A span at a hard or an easy place.
pub fn span() -> impl Strategy<Value = Span> {
    (position(), length()).prop_map(|(lower, length)| Span::try_new(lower, lower + length).unwrap())
}

/// A span that starts at or above 0.
pub fn depth() -> impl Strategy<Value = Span> {
    (position(), length()).prop_map(|(lower, length)| {
        let lower = lower.max(0.0);
        Span::try_new(lower, lower + length).unwrap()
    })
}

/// A pair of aligned rectangles at most a few sizes apart: parallel ones that face each other, or
/// perpendicular ones that may share an edge, touch or be clipped.
pub fn rectangle_pair() -> impl Strategy<Value = (Rectangle, Rectangle)> {
    let gap = prop_oneof![
        0.3..2.0f64,
        Just(1.0),
        (-4.0..0.0f64).prop_map(|e| 10f64.powf(e))
    ];
    let spans = (span(), span(), span(), span());
    (spans, gap, any::<bool>()).prop_map(|((x, y, s, t), gap, parallel)| {
        let floor = Rectangle::try_new(
            DVec3::new(*x.lower(), *y.lower(), 0.0),
            *x.length() * DVec3::X,
            *y.length() * DVec3::Y,
        )
        .unwrap();
        let other = if parallel {
            Rectangle::try_new(
                DVec3::new(*s.lower(), *t.lower(), gap),
                *t.length() * DVec3::Y,
                *s.length() * DVec3::X,
            )
        } else {
            Rectangle::try_new(
                DVec3::new(0.0, *s.lower(), *t.lower()),
                *s.length() * DVec3::Y,
                *t.length() * DVec3::Z,
            )
        };
        (floor, other.unwrap())
    })
}

/// A rotation and a shift of everything.
pub fn motion() -> impl Strategy<Value = (DQuat, DVec3)> {
    let angle = || -3.0..3.0f64;
    (
        (angle(), angle(), angle()),
        (-2.0..2.0f64, -2.0..2.0f64, -2.0..2.0f64),
    )
        .prop_map(|((a, b, c), (x, y, z))| {
            let turn =
                DQuat::from_rotation_x(a) * DQuat::from_rotation_y(b) * DQuat::from_rotation_z(c);
            (turn, DVec3::new(x, y, z))
        })
}

/// Positive numbers and zeros, at least one of them positive.
pub fn shares(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<f64>> {
    let share = prop_oneof![
        1 => 0.01..1.0f64,
        1 => Just(0.0),
        1 => (-30.0..0.0f64).prop_map(|exponent| 10f64.powf(exponent)),
    ];
    proptest::collection::vec(share, count).prop_map(|mut shares| {
        shares[0] += 0.5;
        shares
    })
}
