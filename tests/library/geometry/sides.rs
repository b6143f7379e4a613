//! The side of a plane is exact.

use glam::DVec3;
use infoscene::geometry::{Side, side_of_plane};
use proptest::prelude::*;
use proptest::strategy::ValueTree;

/// `det(b − a, c − a, p − a)` in integers.
fn determinant(points: [[i64; 3]; 4]) -> i128 {
    let [a, b, c, p] = points.map(|point| point.map(i128::from));
    let from_a = |q: [i128; 3]| [q[0] - a[0], q[1] - a[1], q[2] - a[2]];
    let [u, v, w] = [from_a(b), from_a(c), from_a(p)];
    u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
}

fn expected(points: [[i64; 3]; 4]) -> Side {
    match determinant(points).signum() {
        1 => Side::Front,
        -1 => Side::Behind,
        _ => Side::On,
    }
}

#[allow(clippy::cast_precision_loss, reason = "below 2⁴⁰")]
fn at(point: [i64; 3], scale: f64) -> DVec3 {
    DVec3::from_array(point.map(|x| x as f64)) * scale
}

/// Three points, and a fourth in their plane or one step off it.
fn near_coplanar() -> impl Strategy<Value = [[i64; 3]; 4]> {
    let point = |most: i64| prop::array::uniform3(-most..=most);
    // a + s(b − a) + t(c − a) stays below 2³⁹
    (
        point(1 << 34),
        point(1 << 34),
        point(1 << 34),
        -4..=4i64,
        -4..=4i64,
        point(1),
    )
        .prop_map(|(a, b, c, s, t, step)| {
            let p = [0, 1, 2].map(|k| a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]) + step[k]);
            [a, b, c, p]
        })
}

proptest! {
    /// Against integers, in units from 2⁻⁹⁰⁰ to 2⁹⁰⁰.
    #[test]
    fn the_side_of_a_plane_is_that_of_integers(points in near_coplanar(), power in -900..900i32) {
        let [a, b, c, p] = points.map(|point| at(point, 2f64.powi(power)));
        prop_assert_eq!(side_of_plane([a, b, c], p), expected(points));
        let mirrored = match expected(points) {
            Side::Front => Side::Behind,
            Side::On => Side::On,
            Side::Behind => Side::Front,
        };
        prop_assert_eq!(side_of_plane([b, a, c], p), mirrored);
    }
}

/// Negative control: of points in one plane, or a step off it, the determinant in `f64` misjudges
/// many.
#[test]
fn the_determinant_in_doubles_is_not_enough() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let mut misjudged = 0;
    for _ in 0..100 {
        let points = near_coplanar().new_tree(&mut runner).unwrap().current();
        let [a, b, c, p] = points.map(|point| at(point, 1.0));
        let rounded = (b - a).cross(c - a).dot(p - a);
        let side = match rounded.partial_cmp(&0.0) {
            Some(std::cmp::Ordering::Greater) => Side::Front,
            Some(std::cmp::Ordering::Less) => Side::Behind,
            _ => Side::On,
        };
        misjudged += u32::from(side != expected(points));
    }
    assert!(misjudged > 0);
}

/// In range down to 1e-150 beside 1; a tiny height decides.
#[test]
fn tiny_heights_and_far_units_are_in_range() {
    for unit in [1e-150, 1.0, 1e150] {
        let floor = [DVec3::ZERO, DVec3::X * unit, DVec3::Y * unit];
        for (height, side) in [
            (1e-150, Side::Front),
            (0.0, Side::On),
            (-1e-150, Side::Behind),
        ] {
            let point = DVec3::new(0.3, 0.3, height) * unit;
            assert_eq!(side_of_plane(floor, point), side, "{unit:e} {height:e}");
        }
    }
    let line = [DVec3::ZERO, DVec3::X, 2.0 * DVec3::X];
    assert_eq!(side_of_plane(line, DVec3::Z), Side::On);
    assert_eq!(side_of_plane([DVec3::ZERO; 3], DVec3::ZERO), Side::On);
}
