//! Best cuts of squares at any angle, turned in space and with more corners than they need, against
//! 25-digit values.
//!
//! Rotations have rational entries, so that only the corners' last bits are off.

use crate::support::breadth::some_of;
use crate::support::references::value;
use glam::{DMat3, DVec3};
use infoscene::discretize::PatchSplit;
use infoscene::form_factor::Polygon;
use infoscene::geometry::{Patch, SplitAxis};
use infoscene::numeric::tolerance;
use infoscene::scene::{NamedPatch, Scene};

fn splits(id: &str) -> f64 {
    value("splits.csv", id)
}

/// A rotation by the angles of the triangles 3-4-5 and 5-12-13, about two axes.
fn turned(point: DVec3) -> DVec3 {
    let z = DMat3::from_cols(
        DVec3::new(0.6, 0.8, 0.0),
        DVec3::new(-0.8, 0.6, 0.0),
        DVec3::Z,
    );
    let (s, c) = (5.0 / 13.0, 12.0 / 13.0);
    let x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, c, s), DVec3::new(0.0, -s, c));
    x * (z * point)
}

/// The outlines as a scene; `more` adds the middles of all edges but those at v0, which leaves the
/// shape as it is.
fn scene(outlines: &[Vec<DVec3>], place: fn(DVec3) -> DVec3, more: bool) -> Scene {
    let patches = outlines.iter().enumerate().map(|(index, corners)| {
        let n = corners.len();
        let with_middles = (0..n).flat_map(|i| {
            let middle = 0.5 * (corners[i] + corners[(i + 1) % n]);
            let is_at_v0 = i == 0 || i == n - 1;
            std::iter::once(corners[i]).chain((more && !is_at_v0).then_some(middle))
        });
        let corners = with_middles.map(place).collect();
        NamedPatch::new(index.to_string(), Patch::try_new(corners).unwrap())
    });
    Scene::try_new(patches.collect()).unwrap()
}

fn square(origin: DVec3, u: DVec3, v: DVec3) -> Vec<DVec3> {
    vec![origin, origin + u, origin + u + v, origin + v]
}

fn assert_best(scene: &Scene, axis: SplitAxis, id: &str) {
    let against: Vec<usize> = (1..scene.patches().len()).collect();
    let split = PatchSplit::try_new(scene, 0, &against, axis).unwrap();
    let best = split.best(2).unwrap();
    let (position, gain) = (splits(&format!("{id}_t")), splits(&format!("{id}_U")));
    let u = 0.5 * scene.total_area() * best.gain;
    println!(
        "{id} {:e} {:e}",
        best.positions[0] - position,
        u / gain - 1.0
    );
    assert!(
        (best.positions[0] - position).abs() <= tolerance::POLYGON_POSITION,
        "{id}: {best:?} against {position}"
    );
    assert!(
        (u - gain).abs() <= tolerance::POLYGON_GAIN * gain,
        "{id}: {u} against {gain}"
    );
}

/// Figs. 2 and 3 do not depend on where the scene is put, nor on corners that change no shape.
#[test]
fn turned_scenes_of_the_paper_have_the_papers_cuts() {
    let (x, y, z, o) = (DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO);
    let (floor, wall, side) = (square(o, x, y), square(o, y, z), square(o, z, x));
    let two = [floor.clone(), wall.clone()];
    let deep = [square(o, 2.0 * x, y), wall.clone()];
    let three = [floor, wall, side];
    for place in [turned, |point| point] {
        for more in some_of([true, false]) {
            use SplitAxis::{U, V};
            assert_best(&scene(&two, place, more), U, "split_perp_par_bothdepth1");
            assert_best(&scene(&two, place, more), V, "split_perp_orth_bothdepth1");
            assert_best(&scene(&deep, place, more), U, "split_perp_par_splitdepth2");
            assert_best(&scene(&three, place, more), U, "three_squares");
        }
    }
}

/// Two squares that meet at 60°: cut 47 % from the common edge.
#[test]
fn inclined_squares_have_their_cut() {
    let up = DVec3::new(0.5, 0.0, 0.75_f64.sqrt());
    let outlines = [
        square(DVec3::ZERO, DVec3::X, DVec3::Y),
        square(DVec3::ZERO, DVec3::Y, up),
    ];
    for place in [turned, |point| point] {
        for more in [true, false] {
            assert_best(
                &scene(&outlines, place, more),
                SplitAxis::U,
                "split_incl60_par",
            );
        }
    }
}

/// The part of a triangle with corners 0, p, q between two positions along an axis: between lines
/// parallel to the other one.
fn part([p, q]: [DVec3; 2], axis: SplitAxis, [from, to]: [f64; 2]) -> Polygon {
    let at = |along: f64, aside: f64| match axis {
        SplitAxis::U => along * p + aside * q,
        SplitAxis::V => aside * p + along * q,
    };
    let ends = [
        at(from, 0.0),
        at(to, 0.0),
        at(to, 1.0 - to),
        at(from, 1.0 - from),
    ];
    let mut corners = ends.to_vec();
    corners.dedup();
    if axis == SplitAxis::V {
        // counter-clockwise as the triangle
        corners.reverse();
    }
    Polygon::new(&Patch::try_new(corners).unwrap())
}

/// A triangle on the floor and a wall, cut twice, so that the middle part is thin: what it
/// exchanges is what the parts beside it leave of the whole, `J = J₁ + J₂ + J₃`.
///
/// ```text
///   ½ A_T ΔI = Σ_k J_k log₂(J_k A / (A_k J))
/// ```
///
/// The wall stands on the end of the triangle or beyond it, where strips are smooth. Three exchange
/// areas are within 1e-13 of themselves, so that the thin part is within 3e-13 of the whole, and
/// the terms within some 16 times as much.
#[test]
fn thin_parts_exchange_what_the_parts_beside_them_leave() {
    let (p, q) = (DVec3::X, DVec3::new(0.2, 1.0, 0.0));
    let shape = |corners: [DVec3; 3]| Patch::try_new(corners.to_vec()).unwrap();
    let floor = shape([DVec3::ZERO, p, q]);
    for beyond in [0.0, 0.5] {
        let wall = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let wall = shape(wall.map(|[y, z]| DVec3::new(-beyond, y, z)));
        let named = |name: &str, shape: &Patch| NamedPatch::new(name.to_owned(), shape.clone());
        let scene = Scene::try_new(vec![named("floor", &floor), named("wall", &wall)]).unwrap();
        let other = Polygon::new(&wall);
        let exchange = |polygon: &Polygon| {
            let answer = polygon.exchange_area(&other, 1e-13).unwrap();
            answer.exchange.value
        };
        let whole = exchange(&Polygon::new(&floor));
        for axis in SplitAxis::ALL {
            let split = PatchSplit::try_new(&scene, 0, &[1], axis).unwrap();
            for [from, to] in [[0.2, 0.2005], [0.6, 0.6019], [0.001, 0.002]] {
                let beside = [[0.0, from], [to, 1.0]];
                let beside = beside.map(|ends| exchange(&part([p, q], axis, ends)));
                let thin = whole - beside[0] - beside[1];
                let share = |from: f64, to: f64| (1.0 - from).powi(2) - (1.0 - to).powi(2);
                let terms = [
                    (beside[0], share(0.0, from)),
                    (thin, share(from, to)),
                    (beside[1], share(to, 1.0)),
                ];
                let expected: f64 = terms
                    .iter()
                    .map(|(exchange, share)| exchange * (exchange / (share * whole)).log2())
                    .sum();
                let found = 0.5 * scene.total_area() * split.gain(&[from, to]).unwrap();
                let error = (found - expected).abs() / whole;
                assert!(
                    error <= 5e-12,
                    "{beyond} {axis:?} {from} to {to}: {error:e}"
                );
            }
        }
    }
}
