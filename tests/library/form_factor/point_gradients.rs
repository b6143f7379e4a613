//! Point-to-polygon form factors with their gradients.

use crate::support::high_precision::HighPrecision;
use glam::{DMat3, DVec3};
use infoscene::Scene;
use infoscene::form_factor::{FormFactorError, point_form_factor, point_form_factor_with_gradient};
use infoscene::geometry::Patch;
use infoscene::numeric::{Dual, Scalar};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{PI, TAU};

type Number = Dual<HighPrecision>;
type Point = [Number; 3];

fn number(value: f64) -> Number {
    Number::constant_like(&HighPrecision::new(value))
}

fn dot(a: &Point, b: &Point) -> Number {
    let products = [0, 1, 2].map(|k| a[k].clone() * &b[k]);
    products
        .into_iter()
        .reduce(|sum, next| sum + &next)
        .unwrap()
}

fn cross(a: &Point, b: &Point) -> Point {
    let part = |i: usize, j: usize| a[i].clone() * &b[j] - &(a[j].clone() * &b[i]);
    [part(1, 2), part(2, 0), part(0, 1)]
}

/// Lambert's formula as the textbooks have it, `−(1/2π) Σ θ n·(a × b)/|a × b|`, of a polygon cut at
/// the horizon of a point that moves along one axis: what it is, and how it changes.
fn lambert(point: DVec3, normal: DVec3, corners: &[DVec3], axis: usize) -> Number {
    let normal = normal.to_array().map(number);
    let mut place = point.to_array().map(number);
    place[axis] = Number::variable(HighPrecision::new(point[axis]));
    let from_place = |corner: &DVec3| {
        let corner = corner.to_array().map(number);
        [0, 1, 2].map(|k| corner[k].clone() - &place[k])
    };
    let rays: Vec<Point> = corners.iter().map(from_place).collect();
    let zero = number(0.0);
    let mut above: Vec<Point> = Vec::new();
    for (a, b) in rays.iter().zip(rays.iter().cycle().skip(1)) {
        let [p, q] = [dot(a, &normal), dot(b, &normal)];
        if p >= zero {
            above.push(a.clone());
        }
        if (p > zero) != (q > zero) && p != zero && q != zero {
            let share = p.clone() / &(p - &q);
            let between = |k: usize| a[k].clone() + &((b[k].clone() - &a[k]) * &share);
            above.push([0, 1, 2].map(between));
        }
    }
    let mut sum = zero;
    for (a, b) in above.iter().zip(above.iter().cycle().skip(1)) {
        let c = cross(a, b);
        let length = dot(&c, &c).sqrt();
        sum = sum + &(length.atan2(&dot(a, b)) * &dot(&normal, &c) / &length);
    }
    sum / &(number(-2.0) * &number(0.0).pi())
}

/// Bounds of the errors of value and gradient, over K ε: a corner at r is off by ε r, which an edge
/// at a distance of h shows as ε r/h of itself; an edge d subtends d/h, or some radians.
fn scales(point: DVec3, corners: &[DVec3]) -> [f64; 2] {
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next).map(|(from, to)| {
        let d = *to - *from;
        let share = ((point - *from).dot(d) / d.length_squared()).clamp(0.0, 1.0);
        let h = point.distance(*from + d * share);
        let r = point.distance(*from).max(point.distance(*to));
        let value = r / h * (d.length() / h).min(1.0);
        [value, value / h]
    });
    edges.fold([0.0; 2], |sum, edge| [sum[0] + edge[0], sum[1] + edge[1]])
}

/// Roundings of each edge; `gradients_are_those_of_the_textbook_formula` sees a quarter of it.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;

fn turned(random: &mut ChaCha8Rng) -> DMat3 {
    let axis = DVec3::from_array([(); 3].map(|()| random.random_range(-1.0..1.0)));
    DMat3::from_axis_angle(axis.normalize(), random.random_range(0.0..TAU))
}

/// A polygon of three to six corners around a middle, as an observer at the origin sees its front.
fn facing(random: &mut ChaCha8Rng, middle: DVec3, radius: f64) -> Patch {
    let frame = turned(random);
    let count = random.random_range(3..=6u32);
    let corner = |k: u32| {
        let (s, c) = (TAU * f64::from(k) / f64::from(count)).sin_cos();
        middle + radius * (c * frame.x_axis + 0.8 * s * frame.y_axis)
    };
    let patch = Patch::try_new((0..count).map(corner).collect()).unwrap();
    if patch.normal().dot(middle) < 0.0 {
        patch
    } else {
        patch.reversed()
    }
}

/// Points of a plane z = 0, with polygons: apart, cut at the horizon, far, and close.
fn draws() -> Vec<(DVec3, DVec3, Patch)> {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut draws = Vec::new();
    for round in 0..12u32 {
        let (up, aside) = (
            random.random_range(0.7..2.0),
            random.random_range(-1.0..1.0),
        );
        for (middle, radius) in [
            (DVec3::new(aside, 0.3, up), 0.6),
            (DVec3::new(1.5, aside, 0.1), 0.6),
            (DVec3::new(aside, 1.0, up).normalize() * 300.0, 0.5),
            (DVec3::new(aside, 0.0, 0.05 * up), 2.0),
        ] {
            let origin = f64::from(round % 3) * DVec3::new(0.4, -0.7, 0.2);
            let shape = facing(&mut random, middle, radius);
            let shape = shape.corners().iter().map(|c| *c + origin).collect();
            draws.push((origin, DVec3::Z, Patch::try_new(shape).unwrap()));
        }
    }
    draws
}

/// Value and gradient against derivatives of the textbook's formula in 256 bits, horizon and all.
#[test]
fn gradients_are_those_of_the_textbook_formula() {
    let (mut worst, mut seen) = ([0.0f64; 2], 0);
    for (point, normal, patch) in draws() {
        if (point - patch.corners()[0]).dot(patch.normal()) <= 0.0 {
            continue;
        }
        let found = point_form_factor_with_gradient(point, normal, &patch).unwrap();
        let scales = scales(point, patch.corners());
        for axis in 0..3 {
            let exact = lambert(point, normal, patch.corners(), axis);
            let apart = |value: f64, exact: &HighPrecision| {
                (HighPrecision::new(value) - exact).to_f64().abs()
            };
            worst[0] = worst[0].max(apart(found.value, &exact.value) / scales[0]);
            worst[1] = worst[1].max(apart(found.gradient[axis], &exact.slope) / scales[1]);
        }
        seen += usize::from(found.value > 1e-7);
    }
    assert!(
        worst.into_iter().all(|worst| worst < ROUNDINGS),
        "{worst:?}"
    );
    assert!(seen >= 40);
}

/// A concave polygon whose part above the horizon falls apart: a comb of two teeth that stands in
/// the plane of the point, upside down.
#[test]
fn teeth_of_a_comb_count_one_by_one() {
    let at = |x: f64, z: f64| DVec3::new(x, 1.0, z);
    let comb = [
        at(-2.0, -1.0),
        at(2.0, -1.0),
        at(2.0, 1.0),
        at(1.0, 1.0),
        at(1.0, -0.5),
        at(-1.0, -0.5),
        at(-1.0, 0.5),
        at(-2.0, 0.5),
    ];
    let teeth = [
        [at(1.0, 0.0), at(2.0, 0.0), at(2.0, 1.0), at(1.0, 1.0)],
        [at(-2.0, 0.0), at(-1.0, 0.0), at(-1.0, 0.5), at(-2.0, 0.5)],
    ];
    let seen = |corners: &[DVec3]| {
        let patch = Patch::try_new(corners.to_vec()).unwrap();
        point_form_factor_with_gradient(DVec3::ZERO, DVec3::Z, &patch).unwrap()
    };
    let whole = seen(&comb);
    let [one, other] = teeth.map(|tooth| seen(&tooth));
    assert!(whole.value > 0.01);
    // sixteen edges at a distance of 1 and more
    let rounding = 16.0 * ROUNDINGS;
    assert!((whole.value - one.value - other.value).abs() < rounding);
    let difference = whole.gradient - one.gradient - other.gradient;
    assert!(difference.length() < rounding);
}

/// In a closed room Σ F = 1 at every point, so that Σ ∇F = 0.
#[test]
fn gradients_of_a_closed_room_cancel() {
    for name in ["box:1,2,0.5", "cornell-box", "icosahedron", "lit-cube"] {
        let room = Scene::built_in(name).unwrap();
        for own in room.patches() {
            let corners = own.shape().corners();
            let weights = [0.41, 0.27, 0.32];
            let point: DVec3 = corners.iter().zip(weights).map(|(c, w)| *c * w).sum();
            let normal = own.shape().normal();
            let (mut value, mut gradient, mut scale) = (0.0, DVec3::ZERO, [0.0; 2]);
            for other in room
                .patches()
                .iter()
                .filter(|other| !std::ptr::eq(*other, own))
            {
                let shape = other.shape();
                let seen = point_form_factor_with_gradient(point, normal, shape).unwrap();
                (value, gradient) = (value + seen.value, gradient + seen.gradient);
                let own = scales(point, shape.corners());
                scale = [scale[0] + own[0], scale[1] + own[1]];
                // by two different sums, each within its own
                let known = point_form_factor(point, normal, shape).unwrap();
                assert!((seen.value - known).abs() <= 2.0 * ROUNDINGS * own[0]);
            }
            // the room is closed up to the planarity of its faces, which the corners' decimals bend
            let allowed = ROUNDINGS + 1e-12;
            assert!((value - 1.0).abs() <= allowed * scale[0], "{name} {value}");
            assert!(gradient.length() <= allowed * scale[1], "{name} {gradient}");
        }
    }
}

/// On the axis of a disc's polygon of many corners: F = R²/(R² + z²), F′ = −2 z R²/(R² + z²)².
#[test]
fn polygons_of_many_corners_approach_the_disc() {
    let (count, radius, height) = (2000u32, 1.0f64, 0.7f64);
    let corner = |k: u32| {
        let (s, c) = (-TAU * f64::from(k) / f64::from(count)).sin_cos();
        DVec3::new(radius * c, radius * s, height)
    };
    let disc = Patch::try_new((0..count).map(corner).collect()).unwrap();
    let seen = point_form_factor_with_gradient(DVec3::ZERO, DVec3::Z, &disc).unwrap();
    let square = radius * radius + height * height;
    let slope = 2.0 * height * radius * radius / (square * square);
    // the polygon's area is short of the disc's by (2π/n)²/6 of it; where the rim is it weighs less
    let short = (2.0 * PI / f64::from(count)).powi(2) / 6.0;
    assert!((seen.value - radius * radius / square).abs() < short);
    assert!((seen.gradient.z - slope).abs() < 4.0 * short);
    assert!(seen.gradient.truncate().length() < 1e-12);
}

#[test]
fn a_polygon_that_shows_its_back_is_not_seen() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let up = Patch::try_new(square.map(|[x, y]| DVec3::new(x, y, 1.0)).to_vec()).unwrap();
    let seen = |point, normal| point_form_factor_with_gradient(point, normal, &up).unwrap();
    for (point, normal) in [
        (DVec3::ZERO, DVec3::Z),
        (DVec3::Z + DVec3::X * 3.0, DVec3::X),
    ] {
        assert_eq!(
            (seen(point, normal).value, seen(point, normal).gradient),
            (0.0, DVec3::ZERO)
        );
    }
    let refused = point_form_factor_with_gradient(DVec3::ZERO, 2.0 * DVec3::Z, &up);
    assert!(matches!(
        refused,
        Err(FormFactorError::NotAUnitNormal { .. })
    ));
    let nowhere = point_form_factor_with_gradient(DVec3::NAN, DVec3::Z, &up);
    assert!(nowhere.is_err());
    let distant = DVec3::new(0.0, 0.0, 1e200);
    let lost = point_form_factor_with_gradient(distant, -DVec3::Z, &up);
    assert!(matches!(lost, Err(FormFactorError::OutOfRange { .. })));
}
