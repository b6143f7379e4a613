//! Form factors from points past others: exact values, laws, bounds.

use crate::support::rooms::patch;
use glam::{DQuat, DVec3};
use infoscene::form_factor::{
    FormFactorError, Occluders, Polygon, point_form_factor, point_form_factor_past,
};
use infoscene::geometry::Patch;
use infoscene::numeric::Bounded;
use proptest::prelude::*;
use std::f64::consts::PI;

fn seen(point: DVec3, normal: DVec3, polygon: &Patch, blockers: &[Patch]) -> Bounded {
    let blockers: Vec<Polygon> = blockers.iter().map(Polygon::new).collect();
    let polygons: Vec<&Polygon> = blockers.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    point_form_factor_past(point, normal, &Polygon::new(polygon), &occluders).unwrap()
}

/// `[x0, x1] × [y0, y1]` at height z, facing down.
fn ceiling(x: [f64; 2], y: [f64; 2], z: f64) -> Patch {
    patch(&[
        [x[0], y[1], z],
        [x[1], y[1], z],
        [x[1], y[0], z],
        [x[0], y[0], z],
    ])
}

/// `[a, b]` and `[c, d]`, each an interval, times `factor`.
fn scaled([x, y]: [[f64; 2]; 2], factor: f64) -> [[f64; 2]; 2] {
    [x, y].map(|ends| ends.map(|end| factor * end))
}

fn assert_is(found: Bounded, exact: f64) {
    assert!(
        (found.value - exact).abs() <= found.error,
        "{found:?} against {exact}"
    );
    assert!(found.error <= 4e-15, "{found:?}");
}

/// Howell, B-3: a corner of an a × b rectangle at distance c under the point,
/// `F = (1/2π)[A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))]`, A = a/c, B = b/c.
fn corner_rectangle(a: f64, b: f64, c: f64) -> f64 {
    let (a, b) = (a / c, b / c);
    let (p, q) = ((1.0 + a * a).sqrt(), (1.0 + b * b).sqrt());
    (a / p * (b / p).atan() + b / q * (a / q).atan()) / (2.0 * PI)
}

/// A rectangle over the point, by its four quarters.
fn rectangle_over_origin(x: [f64; 2], y: [f64; 2], z: f64) -> f64 {
    let corner = |x: f64, y: f64| x.signum() * y.signum() * corner_rectangle(x.abs(), y.abs(), z);
    corner(x[1], y[1]) - corner(x[0], y[1]) - corner(x[1], y[0]) + corner(x[0], y[0])
}

/// Without blockers it is Lambert's formula.
#[test]
fn nothing_in_the_way_leaves_lamberts_formula() {
    let face = ceiling([-0.4, 1.3], [-0.7, 0.2], 0.8);
    for (point, normal) in [
        (DVec3::ZERO, DVec3::Z),
        (DVec3::new(0.3, -2.0, 0.1), DVec3::Y),
        (DVec3::new(3.0, 0.2, 0.79), DVec3::new(-0.6, 0.0, 0.8)),
    ] {
        let found = seen(point, normal, &face, &[]);
        let exact = point_form_factor(point, normal, &face).unwrap();
        assert!((found.value - exact).abs() <= found.error + 2e-15);
    }
}

/// Four plates leave a square hole: what is seen through it is the hole's projection.
#[test]
fn a_square_through_a_hole_is_the_holes_projection() {
    let (hole, far) = ([[-0.2, 0.1], [-0.15, 0.3]], 3.0);
    let [x, y] = hole;
    let frame = [
        ceiling([-9.0, 9.0], [y[1], 9.0], 0.5),
        ceiling([-9.0, 9.0], [-9.0, y[0]], 0.5),
        ceiling([-9.0, x[0]], y, 0.5),
        ceiling([x[1], 9.0], y, 0.5),
    ];
    let face = ceiling([-4.0, 4.0], [-4.0, 4.0], far);
    let found = seen(DVec3::ZERO, DVec3::Z, &face, &frame);
    let [x, y] = scaled(hole, far / 0.5);
    assert_is(found, rectangle_over_origin(x, y, far));
    // the frame alone hides the rest
    let alone = frame
        .iter()
        .map(|plate| seen(DVec3::ZERO, DVec3::Z, plate, &[]));
    let sum: f64 = alone.map(|part| part.value).sum();
    let rest = seen(
        DVec3::ZERO,
        DVec3::Z,
        &ceiling([-18.0, 18.0], [-18.0, 18.0], 1.0),
        &frame,
    );
    let whole = rectangle_over_origin([-18.0, 18.0], [-18.0, 18.0], 1.0);
    assert!((rest.value - (whole - sum)).abs() < 1e-14);
}

/// A half-plane up to the axis hides half, whatever its height; two of them all, exactly.
#[test]
fn half_planes_hide_half_and_all() {
    let face = ceiling([-1.0, 1.0], [-1.0, 1.0], 2.0);
    let half = 0.5 * rectangle_over_origin([-1.0, 1.0], [-1.0, 1.0], 2.0);
    for z in [1e-9, 0.3, 1.0, 1.999_999] {
        let right = ceiling([0.0, 1e3], [-1e3, 1e3], z);
        let left = ceiling([-1e3, 0.0], [-1e3, 1e3], 0.5 * z);
        assert_is(
            seen(DVec3::ZERO, DVec3::Z, &face, std::slice::from_ref(&right)),
            half,
        );
        let none = seen(DVec3::ZERO, DVec3::Z, &face, &[right, left]);
        assert_eq!(none.value, 0.0);
        assert!(none.error < 1e-15);
    }
}

/// A blocker in the plane of the receiver, or behind it, hides nothing; nor does one in whose plane
/// the point is.
#[test]
fn what_is_behind_or_edge_on_hides_nothing() {
    let face = ceiling([-1.0, 1.0], [-1.0, 1.0], 2.0);
    let whole = seen(DVec3::ZERO, DVec3::Z, &face, &[]);
    let same = ceiling([-1.0, 0.0], [-1.0, 1.0], 2.0);
    let behind = ceiling([-3.0, 3.0], [-1.0, 1.0], 2.5);
    let edge_on = patch(&[[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0]]);
    let below = ceiling([-3.0, 3.0], [-1.0, 1.0], -0.5);
    assert_eq!(
        seen(
            DVec3::ZERO,
            DVec3::Z,
            &face,
            &[same, behind, edge_on, below]
        ),
        whole
    );
    // a point behind, or on the plane
    assert_eq!(seen(DVec3::Z * 3.0, -DVec3::Z, &face, &[]).value, 0.0);
    assert_eq!(seen(DVec3::Z * 2.0, -DVec3::Z, &face, &[]).value, 0.0);
}

/// A wall through the receiver hides as much as its part in front.
#[test]
fn a_piercing_blocker_counts_up_to_the_receiver() {
    let face = ceiling([-1.0, 1.0], [-1.0, 1.0], 2.0);
    let wall = |top: f64| {
        patch(&[
            [0.3, -2.0, 1.2],
            [0.3, 2.0, 1.2],
            [0.3, 2.0, top],
            [0.3, -2.0, top],
        ])
    };
    let point = DVec3::new(-0.2, 0.1, 0.0);
    let [pierced, touched] = [3.0, 2.0].map(|top| seen(point, DVec3::Z, &face, &[wall(top)]));
    assert!((pierced.value - touched.value).abs() <= pierced.error + touched.error);
    // what is beyond the wall's shadow: x from 0.3 on the plane z = 2, up to (0.3+0.2)/1.2·2 − 0.2
    let shadow = [0.3, 0.5 / 1.2 * 2.0 - 0.2].map(|x| x + 0.2);
    let hidden = rectangle_over_origin(shadow, [-1.1, 0.9], 2.0);
    let whole = rectangle_over_origin([-0.8, 1.2], [-1.1, 0.9], 2.0);
    assert_is(touched, whole - hidden);
}

/// A room with a box that hangs in it, a slab and a concave plate.
fn furnished(turn: DQuat) -> Vec<Patch> {
    let mut room = box_faces(DVec3::ZERO, DVec3::new(4.0, 3.0, 2.5), true);
    room.extend(box_faces(
        DVec3::new(1.2, 0.9, 0.7),
        DVec3::new(2.7, 1.8, 1.1),
        false,
    ));
    room.extend(box_faces(
        DVec3::new(0.4, 2.0, 1.9),
        DVec3::new(2.9, 2.7, 2.0),
        false,
    ));
    let hook = [
        [3.1, 0.2],
        [3.8, 0.2],
        [3.8, 1.2],
        [3.5, 1.2],
        [3.5, 0.6],
        [3.1, 0.6],
    ];
    let front: Vec<[f64; 3]> = hook.iter().map(|[x, y]| [*x, *y, 1.3]).collect();
    let back: Vec<[f64; 3]> = front.iter().rev().copied().collect();
    room.extend([patch(&front), patch(&back)]);
    let turned = |face: &Patch| {
        let corners = face.corners().iter().map(|corner| turn * *corner);
        Patch::try_new(corners.collect()).unwrap()
    };
    room.iter().map(turned).collect()
}

fn box_faces(low: DVec3, high: DVec3, inwards: bool) -> Vec<Patch> {
    let ends = [low.to_array(), high.to_array()];
    let mut faces = Vec::new();
    for axis in 0..3 {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        for end in 0..2 {
            let corner = |i: usize, j: usize| {
                let mut corner = [0.0; 3];
                (corner[axis], corner[u], corner[v]) = (ends[end][axis], ends[i][u], ends[j][v]);
                corner
            };
            let mut corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            if (end == 1) == inwards {
                corners.reverse();
            }
            faces.push(patch(&corners));
        }
    }
    faces
}

/// `Σ_j F_xj = 1`, and each bound is some ε.
fn assert_sums_to_one(room: &[Patch], point: DVec3, normal: DVec3) {
    let parts: Vec<Bounded> = room
        .iter()
        .map(|face| seen(point, normal, face, room))
        .collect();
    let sum: f64 = parts.iter().map(|part| part.value).sum();
    let error: f64 = parts.iter().map(|part| part.error).sum();
    assert!(
        (sum - 1.0).abs() <= error,
        "{point} {normal}: {sum} ± {error:e}"
    );
    assert!(error <= 2e-13, "{error:e}");
    assert!(parts.iter().all(|part| (0.0..=1.0).contains(&part.value)));
}

/// A point in the air of the room, often beside an edge or a face.
fn in_the_air() -> impl Strategy<Value = DVec3> {
    let near = |low: f64, high: f64| {
        prop_oneof![
            low..high,
            Just(low + 1e-9),
            Just(high - 1e-3),
            Just(0.5 * (low + high))
        ]
    };
    // below the furniture, and between it and the wall
    let under = (near(0.0, 4.0), near(0.0, 3.0), near(0.0, 0.7));
    let beside = (near(3.8, 4.0), near(0.0, 3.0), near(0.0, 2.5));
    let above = (near(0.4, 2.9), near(2.0, 2.7), near(2.0, 2.5));
    prop_oneof![under, beside, above].prop_map(DVec3::from)
}

fn direction() -> impl Strategy<Value = DVec3> {
    let any = (-1.0..1.0f64, -1.0..1.0f64, -1.0..1.0f64).prop_map(DVec3::from);
    let axis = prop_oneof![Just(DVec3::X), Just(-DVec3::Z), Just(DVec3::Y)];
    prop_oneof![any, axis].prop_map(|normal| normal.normalize_or(DVec3::Z))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases.div_ceil(8)))]

    /// What a point in a closed room sees is all of it.
    #[test]
    fn a_point_in_a_furnished_room_sees_faces_alone(
        point in in_the_air(),
        normal in direction(),
    ) {
        assert_sums_to_one(&furnished(DQuat::IDENTITY), point, normal);
    }

    /// Likewise where every corner is rounded.
    #[test]
    fn a_turned_room_hides_as_much(
        point in in_the_air(),
        normal in direction(),
        axis in direction(),
        angle in 0.1..3.0f64,
    ) {
        let turn = DQuat::from_axis_angle(axis, angle);
        assert_sums_to_one(&furnished(turn), turn * point, (turn * normal).normalize());
    }

    /// Another blocker never adds to what is seen, and order and cuts of blockers change nothing.
    #[test]
    fn blockers_take_away_in_any_order_and_division(
        corners in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64, 0.2..1.8f64), 9),
        share in 0.1..0.9f64,
    ) {
        let corners: Vec<DVec3> = corners.into_iter().map(DVec3::from).collect();
        let triangles = corners.chunks(3).map(|three| Patch::try_new(three.to_vec()));
        let triangles: Vec<Patch> = triangles.filter_map(Result::ok).collect();
        let face = ceiling([-1.0, 1.0], [-1.0, 1.0], 2.0);
        let past = |blockers: &[Patch]| seen(DVec3::ZERO, DVec3::Z, &face, blockers);
        let mut before = past(&[]);
        for count in 1..=triangles.len() {
            let after = past(&triangles[..count]);
            prop_assert!(after.value <= before.value + before.error + after.error);
            before = after;
        }
        let mut divided = Vec::new();
        for triangle in triangles.iter().rev() {
            let [a, b, c] = [0, 1, 2].map(|i| triangle.corners()[i]);
            let middle = a.lerp(b, share);
            divided.extend(Patch::try_new(vec![a, middle, c]));
            divided.extend(Patch::try_new(vec![middle, b, c]));
        }
        let after = past(&divided);
        // the corner between the halves is rounded
        prop_assert!((after.value - before.value).abs() <= before.error + after.error + 1e-15);
    }
}

/// The refusals.
#[test]
fn directions_and_points_are_checked() {
    let face = Polygon::new(&ceiling([-1.0, 1.0], [-1.0, 1.0], 2.0));
    let nothing = Occluders {
        polygons: &[],
        touching: 0.0,
    };
    let ask = |point, normal| point_form_factor_past(point, normal, &face, &nothing);
    assert_eq!(
        ask(DVec3::ZERO, 2.0 * DVec3::Z),
        Err(FormFactorError::NotAUnitNormal { length: 2.0 })
    );
    assert!(matches!(
        ask(DVec3::ZERO, DVec3::NAN),
        Err(FormFactorError::NotAUnitNormal { .. })
    ));
    assert!(matches!(
        ask(DVec3::INFINITY, DVec3::Z),
        Err(FormFactorError::NotAPoint { .. })
    ));
}
