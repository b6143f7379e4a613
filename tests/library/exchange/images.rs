//! Translates and mirror images of any polygons: known by counting, and equal within their bounds.

use super::frames::{assert_agree, counts, exchange, turns};
use crate::support::rooms::{L, mapped, polygon};
use glam::DVec3;
use infoscene::exchange::Congruence;
use infoscene::scene::{NamedPatch, Scene};

/// A polygon at height z, facing up or down.
fn level(name: &str, corners: &[[f64; 2]], z: f64, up: bool) -> NamedPatch {
    let mut corners: Vec<[f64; 3]> = corners.iter().map(|[x, y]| [*x, *y, z]).collect();
    if !up {
        corners.reverse();
    }
    polygon(name, &corners)
}

/// A floor of N × N squares, each of two triangles, and a ceiling of the same one above it; `lean`
/// moves the rows along each other.
fn triangles(cells: u32, lean: f64, height: f64) -> Scene {
    let mut patches = Vec::new();
    for (i, j) in (0..cells).flat_map(|i| (0..cells).map(move |j| (i, j))) {
        let at = |di: u32, dj: u32| {
            let (x, y) = (f64::from(i + di), f64::from(j + dj));
            [x + lean * y, height * y]
        };
        for (z, up) in [(0.0, true), (1.5, false)] {
            let name = |kind: &str| format!("{kind} {i} {j} {z}");
            patches.push(level(&name("a"), &[at(0, 0), at(1, 0), at(0, 1)], z, up));
            patches.push(level(&name("b"), &[at(1, 1), at(0, 1), at(1, 0)], z, up));
        }
    }
    Scene::try_new(patches).unwrap()
}

/// Pairs of a triangle in the floor and one in the ceiling: two kinds of each, and offsets below N
/// either way, m = 2 N − 1 along each axis. Three symmetries take them to each other: x and y are
/// exchanged (offset (a, b) → (b, a)), both are reflected (kinds exchanged, offset → −offset),
/// floor and ceiling are exchanged (kinds of the two exchanged, offset → −offset). The eight
/// products leave 4 m², 4 m, 0, 0, 2, 2 m, 2 m², 2 m pairs as they are: (3 m + 1)(m + 1)/4 orbits,
/// by Burnside.
#[test]
fn triangles_that_repeat_are_known_by_counting() {
    for cells in [2, 3, 4] {
        let m = 2 * cells as usize - 1;
        let orbits = (3 * m + 1) * (m + 1) / 4;
        let pairs = 4 * (cells as usize).pow(4);
        let floor = triangles(cells, 0.0, 1.0);
        assert_eq!(
            counts(&floor, 1e-6, Congruence::Shared),
            [orbits, pairs - orbits]
        );
        assert_eq!(counts(&floor, 1e-6, Congruence::Ignored), [pairs, 0]);
        for turn in turns() {
            let turned = mapped(&floor, |corner| turn * corner);
            assert_eq!(
                counts(&turned, 1e-6, Congruence::Shared),
                [orbits, pairs - orbits]
            );
        }
    }
}

/// Shared values and those of each pair agree within their bounds, for triangles with and without a
/// right angle, wherever they are turned.
#[test]
fn images_share_within_their_bounds() {
    for (lean, height) in [(0.0, 1.0), (0.5, 0.75_f64.sqrt()), (0.3, 0.8)] {
        let floor = triangles(3, lean, height);
        for (turn, far) in turns().into_iter().zip([0.0, 1.0, 30.0]) {
            let turned = mapped(&floor, |corner| turn * (corner + DVec3::splat(far)));
            for tolerance in [1e-3, 1e-6, 1e-9] {
                let [shared, apart] = [Congruence::Shared, Congruence::Ignored]
                    .map(|congruence| exchange(&turned, tolerance, congruence));
                let plan = &shared.summary().plan;
                // some 80 classes without a mirror, of 324 pairs
                assert!(tolerance < 1e-8 || plan.congruent > 200, "{plan:?}");
                assert_agree(&shared, &apart);
            }
        }
    }
}

/// An L and its mirror image, under two triangles and their images: eight pairs, which are images
/// of each other in twos.
#[test]
fn mirror_images_of_any_polygons_share() {
    let mirrored = |corners: &[[f64; 2]]| {
        let corners = corners.iter().rev();
        corners.map(|[x, y]| [-x, *y]).collect::<Vec<_>>()
    };
    let wide = L.map(|[x, y]| [x + 0.25, 0.75 * y]);
    let [shelf, lamp] = [
        [[0.5, 0.125], [1.75, 0.25], [1.0, 1.0]],
        [[0.375, 1.0], [1.5, 1.25], [0.75, 1.75]],
    ];
    let mut patches = Vec::new();
    for (name, corners, z, up) in [
        ("floor", wide.as_slice(), 0.0, true),
        ("shelf", &shelf, 1.25, false),
        ("lamp", &lamp, 2.125, false),
    ] {
        patches.push(level(&format!("{name} right"), corners, z, up));
        patches.push(level(&format!("{name} left"), &mirrored(corners), z, up));
    }
    let room = Scene::try_new(patches).unwrap();
    assert_eq!(counts(&room, 1e-9, Congruence::Shared), [4, 4]);
    assert_eq!(counts(&room, 1e-9, Congruence::Ignored), [8, 0]);
    let turned = mapped(&room, |corner| turns()[0] * corner);
    for scene in [&room, &turned] {
        let [shared, apart] = [Congruence::Shared, Congruence::Ignored]
            .map(|congruence| exchange(scene, 1e-9, congruence));
        assert_agree(&shared, &apart);
    }
}

/// Scalene tiles, which no symmetry takes to themselves, share by their offset alone, either way
/// round.
#[test]
fn translates_share_by_their_offsets() {
    let tile = |at: f64, z: f64, up: bool| {
        let corners = [[at, 0.0], [at + 1.0, 0.25], [at + 0.25, 1.0]];
        level(&format!("{at} {z}"), &corners, z, up)
    };
    let scene = Scene::try_new(vec![
        tile(0.0, 0.0, true),
        tile(2.0, 0.0, true),
        tile(4.0, 0.0, true),
        tile(0.0, 1.0, false),
        tile(2.0, 1.0, false),
        tile(4.0, 1.0, true),
    ])
    .unwrap();
    // 3 × 2 pairs face each other, by offsets 0, ±2 and −4; a tile's back and front are no images,
    // so that offset 0 repeats, and 2 and −2 by an exchange of the two
    let [shared, every] = [Congruence::Shared, Congruence::Ignored]
        .map(|congruence| counts(&scene, 1e-9, congruence));
    assert_eq!((shared, every), ([3, 3], [6, 0]));
    let [shared, apart] = [Congruence::Shared, Congruence::Ignored]
        .map(|congruence| exchange(&scene, 1e-9, congruence));
    assert_agree(&shared, &apart);
}

/// Negative control: triangles that are each smaller by another millionth share nothing.
#[test]
fn jittered_triangles_share_nothing() {
    let floor = triangles(3, 0.0, 1.0);
    let smaller = |(k, patch): (u32, &NamedPatch)| {
        let c = patch.shape().corners();
        let factor = 1.0 - 1e-6 * f64::from(k + 1);
        let corner = |corner: &DVec3| (c[0] + (*corner - c[0]) * factor).to_array();
        polygon(&k.to_string(), &c.iter().map(corner).collect::<Vec<_>>())
    };
    let jittered = Scene::try_new((0..).zip(floor.patches()).map(smaller).collect()).unwrap();
    assert_eq!(counts(&jittered, 1e-6, Congruence::Shared), [324, 0]);
}
