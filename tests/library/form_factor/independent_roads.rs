//! Three roads to each form factor: closed form, quadrature of the definition, sampling.

use glam::DVec3;
use infoscene::form_factor::RectanglePair;
use infoscene::geometry::Rectangle;
use infoscene::numeric::integral;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn pairs() -> Vec<(&'static str, Rectangle, Rectangle)> {
    let rectangle = |o: [f64; 3], u: [f64; 3], v: [f64; 3]| {
        Rectangle::try_new(o.into(), u.into(), v.into()).unwrap()
    };
    let floor = rectangle([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    vec![
        (
            "facing",
            floor,
            rectangle([0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]),
        ),
        (
            "facing, offset",
            floor,
            rectangle([0.7, -0.2, 0.5], [0.0, 0.4, 0.0], [2.0, 0.0, 0.0]),
        ),
        (
            "perpendicular",
            floor,
            rectangle([-0.5, 0.2, 0.3], [0.0, 2.0, 0.0], [0.0, 0.0, 1.5]),
        ),
    ]
}

/// `cos θ_x cos θ_y / (π r²)` between two points.
fn kernel(x: DVec3, n_x: DVec3, y: DVec3, n_y: DVec3) -> f64 {
    let r = y - x;
    let squared = r.length_squared();
    let cosines = r.dot(n_x).max(0.0) * (-r.dot(n_y)).max(0.0);
    cosines / (std::f64::consts::PI * squared * squared)
}

fn point(rectangle: &Rectangle, [s, t]: [f64; 2]) -> DVec3 {
    let [v0, v1, _, v3] = rectangle.corners();
    v0 + s * (v1 - v0) + t * (v3 - v0)
}

/// `A F = ∫∫∫∫ kernel`, four nested rules at 1e-8: a formula that shares nothing with the closed
/// form.
#[test]
fn closed_form_agrees_with_quadrature_of_the_kernel() {
    let nested = |f: &dyn Fn([f64; 4]) -> f64| {
        let rule = |f: &dyn Fn(f64) -> f64| integral(f, (0.0, 1.0), 1e-7).unwrap().value;
        rule(&|a| rule(&|b| rule(&|c| rule(&|d| f([a, b, c, d])))))
    };
    for (name, first, second) in pairs() {
        let (n_x, n_y) = (first.normal(), second.normal());
        let f = |[a, b, c, d]: [f64; 4]| {
            kernel(point(&first, [a, b]), n_x, point(&second, [c, d]), n_y)
        };
        let by_rule = first.area() * second.area() * nested(&f);
        let closed = RectanglePair::try_new(&first, &second)
            .unwrap()
            .exchange_area()
            .unwrap()
            .value;
        assert!(
            (by_rule / closed - 1.0).abs() < 1e-6,
            "{name}: {closed} {by_rule}"
        );
    }
}

/// The mean of the kernel over random point pairs, within five standard errors.
#[test]
fn closed_form_agrees_with_sampling() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    for (name, first, second) in pairs() {
        let (n_x, n_y) = (first.normal(), second.normal());
        let count = 200_000;
        let (mut sum, mut squares) = (0.0, 0.0);
        for _ in 0..count {
            let x = point(&first, random.random());
            let value = kernel(x, n_x, point(&second, random.random()), n_y);
            sum += value;
            squares += value * value;
        }
        let n = f64::from(count);
        let (mean, areas) = (sum / n, first.area() * second.area());
        let deviation = ((squares / n - mean * mean) / n).sqrt();
        let closed = RectanglePair::try_new(&first, &second)
            .unwrap()
            .exchange_area()
            .unwrap()
            .value;
        let off = (areas * mean - closed).abs() / (areas * deviation);
        assert!(off < 5.0, "{name}: {off} standard errors");
    }
}

/// A rectangle behind the other's plane, turned away or in the same plane exchanges exactly
/// nothing; half behind it exchanges what its front half does.
#[test]
fn what_lies_behind_exchanges_nothing() {
    let floor = Rectangle::try_new(DVec3::ZERO, DVec3::X, DVec3::Y).unwrap();
    let value = |other: Rectangle| {
        RectanglePair::try_new(&floor, &other)
            .unwrap()
            .exchange_area()
            .unwrap()
            .value
    };
    let at = |o, u, v| Rectangle::try_new(o, u, v).unwrap();
    assert_eq!(value(at(DVec3::Z, DVec3::X, DVec3::Y)), 0.0, "turned away");
    assert_eq!(value(at(-DVec3::Z, DVec3::X, DVec3::Y)), 0.0, "behind");
    assert_eq!(
        value(at(2.0 * DVec3::X, DVec3::X, DVec3::Y)),
        0.0,
        "coplanar"
    );
    let half_below = value(at(-DVec3::Z, DVec3::Y, 2.0 * DVec3::Z));
    assert_eq!(
        half_below,
        value(at(DVec3::ZERO, DVec3::Y, DVec3::Z)),
        "half below the horizon"
    );
    assert!((half_below - 0.200_043_776_075_403_15).abs() < 1e-15);
}
