//! Other roads: quadrature of the definition, sums over parts, random chords, a sphere.

use super::{SOLIDS, information};
use crate::support::breadth::some_of;
use crate::support::rooms::{L, patch, polygon, prism};
use glam::DVec3;
use infoscene::exchange::ExchangeError;
use infoscene::form_factor::{LogMeans, point_kernel};
use infoscene::geometry::{Patch, quartered};
use infoscene::information::chord_information;
use infoscene::numeric::GaussLegendre;
use infoscene::scene::{NamedPatch, Scene};
use std::f64::consts::PI;

/// Points and weights of a product rule over a triangle, or over a quadrilateral as two.
fn points(patch: &Patch) -> Vec<(DVec3, f64)> {
    let gauss = GaussLegendre::with(16);
    let corners = patch.corners();
    let mut points = Vec::new();
    for k in 1..corners.len() - 1 {
        let (a, b, c) = (corners[0], corners[k], corners[k + 1]);
        let doubled = (b - a).cross(c - a).length();
        for (s, v) in gauss.nodes.iter().zip(&gauss.weights) {
            for (t, w) in gauss.nodes.iter().zip(&gauss.weights) {
                let (s, t) = (0.5 + 0.5 * s, 0.5 + 0.5 * t);
                points.push((
                    a + s * (b - a) + s * t * (c - b),
                    0.25 * v * w * s * doubled,
                ));
            }
        }
    }
    points
}

/// `∫∫ F ln r`, `∫∫ F ln cos θ`, `∫∫ F ln cos θ'` as they are written.
fn by_quadrature(first: &Patch, second: &Patch) -> [f64; 3] {
    let mut sums = [0.0; 3];
    let others = points(second);
    for (x, v) in points(first) {
        for (y, w) in &others {
            let r = x.distance(*y);
            let here = first.normal().dot(*y - x) / r;
            let there = second.normal().dot(x - *y) / r;
            let flux = v * w * here * there / (PI * r * r);
            for (sum, number) in sums.iter_mut().zip([r, here, there]) {
                *sum += flux * number.ln();
            }
        }
    }
    sums
}

/// Polygons apart: parallel, perpendicular, and at angles, where 256 points each leave 1e-13.
#[test]
fn pairs_apart_agree_with_quadrature_of_the_definition() {
    let floor = patch(&[
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.2, 0.9, 0.0],
        [0.1, 1.0, 0.0],
    ]);
    let others = [
        patch(&[[0.0, 0.0, 2.0], [0.3, 1.0, 2.0], [1.0, 0.2, 2.0]]),
        patch(&[[3.0, 0.0, 1.0], [3.0, 0.0, 2.0], [3.0, 1.0, 1.5]]),
        patch(&[[2.5, 0.0, 1.0], [1.5, 0.2, 2.5], [2.0, 1.2, 1.75]]),
        patch(&[[0.0, 0.0, 2.0], [0.3, 1.0, 2.4], [1.0, 0.2, 2.2]]),
        patch(&[[-2.0, 0.0, 1.0], [-2.5, 1.0, 1.0], [-1.5, 1.0, 2.0]]),
    ];
    // planes that meet far away or not at all
    let lids = [1e-1, 1e-2, 1e-5, 1e-9, 1e-13].map(|tilt| {
        let lid = [[0.0, 0.0], [0.3, 1.0], [1.0, 0.2]];
        patch(&lid.map(|[x, y]| [x, y, 2.0 + tilt * (x - 2.0 * y)]))
    });
    for other in others.iter().chain(&lids) {
        let found = LogMeans::of(&floor, other).unwrap();
        let expected = by_quadrature(&floor, other);
        let found = [found.distance, found.cosines[0], found.cosines[1]];
        for (found, expected) in found.iter().zip(expected) {
            let off = (found - expected).abs();
            assert!(
                off < 1e-13 + 1e-12 * expected.abs(),
                "{found} {expected} {other:?}"
            );
        }
    }
}

/// Integrals over a pair are sums over pairs of parts, most of which touch elsewhere or not at all.
#[test]
fn parts_of_touching_pairs_sum_to_the_whole() {
    for name in some_of(["tetrahedron", "octahedron", "box:1,2,0.3", "dodecahedron"]) {
        let scene = Scene::built_in(name).unwrap();
        let first = scene.patches()[0].shape();
        for second in &scene.patches()[1..scene.patches().len().min(6)] {
            let whole = LogMeans::of(first, second.shape()).unwrap();
            let mut sums = [0.0; 3];
            for one in quartered(first).unwrap() {
                for other in quartered(second.shape()).unwrap() {
                    let part = LogMeans::of(&one, &other).unwrap();
                    let numbers = [part.distance, part.cosines[0], part.cosines[1]];
                    sums.iter_mut()
                        .zip(numbers)
                        .for_each(|(sum, number)| *sum += number);
                }
            }
            let whole = [whole.distance, whole.cosines[0], whole.cosines[1]];
            for (whole, sum) in whole.iter().zip(sums) {
                assert!(
                    (whole - sum).abs() < 1e-13 * first.area(),
                    "{name}: {whole} {sum}"
                );
            }
        }
    }
}

/// A lid close to its floor and not quite parallel to it, where most parts see it as in
/// `pairs_apart_agree_with_quadrature_of_the_definition`.
#[test]
fn parts_under_a_close_lid_sum_to_the_whole() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.1, 0.9], [0.0, 1.0]];
    let floor = patch(&corners.map(|[x, y]| [x, y, 0.0]));
    for (gap, tilt) in [(0.1, 1e-3), (0.02, 1e-5), (0.02, 5e-4), (0.02, 1e-2)] {
        let mut lid = corners.map(|[x, y]| [x, y, gap + tilt * x * gap / 0.02]);
        lid.reverse();
        let lid = patch(&lid);
        let whole = LogMeans::of(&floor, &lid).unwrap();
        let mut sum = 0.0;
        for one in quartered(&floor).unwrap() {
            for part in quartered(&one).unwrap() {
                sum += LogMeans::of(&part, &lid).unwrap().distance;
            }
        }
        let off = (whole.distance - sum).abs();
        assert!(
            off < 1e-13 * floor.area() * gap.ln().abs(),
            "{gap} {tilt}: {off:e} {}",
            whole.kernel(1.0).error
        );
    }
}

/// Five standard errors, with seeds that are fixed.
#[test]
fn random_chords_agree() {
    for (seed, name) in SOLIDS
        .into_iter()
        .chain(["box:1,1,5", "cornell-box"])
        .enumerate()
    {
        let scene = Scene::built_in(name).unwrap();
        let sample = chord_information(&scene, 40_000, seed as u64).unwrap();
        let off = (sample.mutual_information - information(name).mutual_information.value).abs();
        assert!(
            off < 5.0 * sample.standard_error,
            "{name}: {off} {sample:?}"
        );
        assert!(sample.standard_error < 0.03, "{name}: {sample:?}");
    }
}

/// A wall across a cube that leaves two boxes 1 × 1 × ½: chords stay in their box, which each point
/// knows of the other end. With the wall's own faces `A_T = 8` is twice that of a box, so `I^c` is
/// that of a box and one bit.
#[test]
fn chords_stop_at_what_they_meet() {
    let cube = Scene::built_in("cube:1").unwrap();
    let square = [
        [0.0, 0.0, 0.5],
        [1.0, 0.0, 0.5],
        [1.0, 1.0, 0.5],
        [0.0, 1.0, 0.5],
    ];
    let mut back = square;
    back.reverse();
    let walls = [polygon("above", &square), polygon("below", &back)];
    let patches: Vec<NamedPatch> = cube.patches().iter().cloned().chain(walls).collect();
    let sample = chord_information(&Scene::try_new(patches).unwrap(), 40_000, 1).unwrap();
    let expected = information("box:1,1,0.5").mutual_information.value + 1.0;
    assert!(
        (sample.mutual_information - expected).abs() < 5.0 * sample.standard_error,
        "{sample:?}"
    );
}

/// A concave room is served; a hole in the wall is found.
#[test]
fn chords_serve_concave_rooms_and_refuse_open_ones() {
    let room = prism(&L);
    let sample = chord_information(&room, 20_000, 3).unwrap();
    // more than its hull's: what a corner hides is known
    assert!(sample.mutual_information > 0.0 && sample.standard_error < 0.05);
    let open = Scene::try_new(room.patches()[..4].to_vec()).unwrap();
    let refused = chord_information(&open, 1000, 1).unwrap_err();
    let infoscene::chain::ChainError::Exchange(ExchangeError::LinesEscape { lost, lines }) =
        refused
    else {
        panic!("{refused}");
    };
    assert!(lost > 0 && lines == 1000);
}

/// Inside a sphere `cos θ = cos θ' = r/2R`, so `F = 1/(4πR²) = 1/A_T` everywhere, and every term of
/// (4) is 0. Rooms of triangles that approach it approach 0.
#[test]
fn sphere_is_zero() {
    let points = [
        DVec3::X,
        DVec3::new(0.6, 0.0, 0.8),
        DVec3::new(0.0, -0.28, 0.96),
        -DVec3::Z,
    ];
    for x in points {
        for y in points.into_iter().filter(|y| *y != x) {
            let kernel = point_kernel([x, -x], [y, -y]).unwrap();
            assert!(
                (4.0 * PI * kernel).log2().abs() < 1e-14,
                "{x} {y}: {kernel}"
            );
        }
    }
    let mut room = Scene::built_in("icosahedron").unwrap();
    let mut before = information("icosahedron").mutual_information.value;
    for _ in 0..2 {
        let (fine, _) = room.subdivided(1).unwrap();
        room = crate::support::rooms::mapped(&fine, DVec3::normalize);
        let sample = chord_information(&room, 20_000, 5).unwrap();
        let information = sample.mutual_information;
        assert!(
            information < 0.5 * before + 5.0 * sample.standard_error,
            "{sample:?}, {before}"
        );
        before = information;
    }
    assert!(before < 0.1, "{before}");
}
