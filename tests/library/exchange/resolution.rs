//! What the resolution of coordinates can change of exchange areas: judged by corners that move.

use glam::{DQuat, DVec3};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::geometry::Patch;
use infoscene::scene::{NamedPatch, Occlusion, Scene};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Triangles, which stay plane wherever their corners move: apart, at right angles on a common
/// edge, at a sharp angle, in one plane on a common edge, one above the other, one through the
/// other's plane.
fn families(dice: &mut impl Rng) -> Vec<[[DVec3; 3]; 2]> {
    let mut point = || DVec3::from_array([(); 3].map(|()| dice.random_range(-1.0..1.0)));
    let (o, x) = (DVec3::ZERO, DVec3::X);
    let floor = [o, x, DVec3::new(0.3, 0.9, 0.0)];
    let wing = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        [x, o, DVec3::new(0.6, 0.8 * cos, 0.8 * sin)]
    };
    let mut pairs: Vec<[[DVec3; 3]; 2]> = [0.3, 0.8, 1.57, 2.5, std::f64::consts::PI]
        .map(|angle| [floor, wing(-angle).map(|c| DVec3::new(c.x, -c.y, -c.z))])
        .to_vec();
    let above = [o, DVec3::Y, x].map(|corner| 0.8 * corner + 0.05 * DVec3::Z);
    pairs.push([floor, above]);
    for _ in 0..4 {
        let far = 1.5 * point();
        pairs.push([[(); 3].map(|()| point()), [(); 3].map(|()| point() + far)]);
    }
    pairs
}

fn scene(triangles: [[DVec3; 3]; 2], place: impl Fn(DVec3) -> DVec3) -> Option<Scene> {
    let patches = triangles.map(|corners| {
        let shape = Patch::try_new(corners.map(&place).to_vec()).ok()?;
        Some(NamedPatch::new("triangle".to_owned(), shape))
    });
    Scene::try_new(patches.into_iter().collect::<Option<_>>()?).ok()
}

fn pairs(scene: &Scene) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, 1e-12, Congruence::Ignored, Occlusion::Ignore).unwrap()
}

/// `|ΔJ| ≤ bound` and `|ΔA| ≤ bound`, for corners that move by up to r per coordinate, all to the
/// ends of their ranges or anywhere; and the bound is not absurd: the largest change found is a
/// part of it.
#[test]
fn exchange_areas_change_by_no_more_than_the_bound() {
    let mut dice = ChaCha8Rng::seed_from_u64(1);
    let mut shares = Vec::new();
    for round in 0..6 {
        for (family, triangles) in families(&mut dice).into_iter().enumerate() {
            let turn = DQuat::from_rotation_y(f64::from(round)) * DQuat::from_rotation_z(0.7);
            let r = 10f64.powi(-2 - round % 4);
            let Some(given) = scene(triangles, |corner| turn * corner) else {
                continue;
            };
            let Ok(given) = given.with_resolution(r) else {
                continue;
            };
            let known = pairs(&given);
            let value = known.row_pair(0, 1).unwrap().exchange.value;
            let (bound, of_areas) = (known.resolution_error(0, 1), known.area_resolution_errors());
            let mut largest = 0.0_f64;
            for _ in 0..60 {
                let to_ends = dice.random_bool(0.5);
                let mut off = || {
                    let step = dice.random_range(-1.0..1.0f64);
                    r * if to_ends { step.signum() } else { step }
                };
                let moved = triangles.map(|corners| {
                    corners.map(|corner| turn * corner + DVec3::from_array([off(), off(), off()]))
                });
                let Some(moved) = scene(moved, |corner| corner) else {
                    continue;
                };
                let found = pairs(&moved);
                let change = (found.row_pair(0, 1).unwrap().exchange.value - value).abs();
                assert!(change <= bound, "{family} at {r}: {change} > {bound}");
                let areas = found.areas().iter().zip(known.areas());
                for ((new, old), bound) in areas.zip(&of_areas) {
                    assert!((new - old).abs() <= *bound, "{family} at {r}: {new} {old}");
                }
                largest = largest.max(change);
            }
            if bound > 0.0 && value > 0.0 {
                shares.push(largest / bound);
            }
        }
    }
    shares.sort_by(f64::total_cmp);
    let median = shares[shares.len() / 2];
    // sixty places at random are not the worst one
    assert!(
        shares.len() > 20 && median > 0.02,
        "{median} of {}",
        shares.len()
    );
}

/// Exact scenes have no such error, and a pair back to back has none at any resolution that leaves
/// it back to back.
#[test]
fn exact_and_hidden_pairs_do_not_change() {
    let cube = Scene::built_in("cube:2").unwrap();
    assert_eq!(pairs(&cube).resolution_error(0, 5), 0.0);
    let squares = Scene::facing_squares(1.0).unwrap().reversed();
    let resolved = squares.with_resolution(1e-3).unwrap();
    assert_eq!(pairs(&resolved).resolution_error(0, 1), 0.0);
    let open = Scene::facing_squares(1.0)
        .unwrap()
        .with_resolution(1e-3)
        .unwrap();
    assert!(pairs(&open).resolution_error(0, 1) > 1e-3);
}

/// Twice the resolution, twice the bound, as long as both are small.
#[test]
fn bounds_grow_as_the_resolution() {
    let cube = Scene::built_in("cube:2").unwrap();
    let at = |r: f64| pairs(&cube.clone().with_resolution(r).unwrap()).resolution_error(0, 20);
    let (one, two) = (at(1e-6), at(2e-6));
    assert!((two / one - 2.0).abs() < 1e-3, "{one} {two}");
}
