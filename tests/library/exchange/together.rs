//! Pairs that are evaluated together have the answers of pairs alone, to the last bit.

use glam::{DQuat, DVec3};
use infoscene::exchange::{Congruence, ScenePairs, Tolerance};
use infoscene::form_factor::{Answer, Route};
use infoscene::geometry::Patch;
use infoscene::scene::{NamedPatch, Occlusion, Scene};

/// A cube of 54 squares, turned, some of which are cut into triangles or a triangle and a
/// pentagon.
fn mixed_cube() -> Scene {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    let cube = Scene::built_in("cube:3").unwrap();
    let mut patches = Vec::new();
    for (number, patch) in cube.patches().iter().enumerate() {
        let corners: Vec<DVec3> = patch.shape().corners().iter().map(|c| turn * *c).collect();
        let [a, b, c, d] = <[DVec3; 4]>::try_from(corners).unwrap();
        let parts = match number % 7 {
            0 => vec![vec![a, b, c], vec![a, c, d]],
            3 => {
                let (on_b, on_d) = (a.lerp(b, 0.25), a.lerp(d, 0.5));
                vec![vec![a, on_b, on_d], vec![on_b, b, c, d, on_d]]
            }
            _ => vec![vec![a, b, c, d]],
        };
        patches.extend(parts.into_iter().map(|corners| {
            let name = format!("part {number}");
            NamedPatch::new(name, Patch::try_new(corners).unwrap())
        }));
    }
    Scene::try_new(patches).unwrap()
}

/// Triangles on a floor and low on a wall far away, turned: heights that are small beside the
/// distance are taken again.
fn grazing_triangles() -> Scene {
    let turn = DQuat::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
    let mut patches = Vec::new();
    for i in 0..12 {
        // one behind the other by so little that all take the same rules
        let behind = 1e-3 * f64::from(i);
        let (z, x) = (-behind, 90.0 + behind);
        let floor = [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]];
        let wall = [[x, 0.0, 0.1], [x, 0.0, 1.1], [x, 1.0, 0.3]];
        for corners in [floor, wall] {
            let corners = corners.map(|corner| turn * DVec3::from(corner));
            let patch = Patch::try_new(corners.to_vec()).unwrap();
            patches.push(NamedPatch::new(
                format!("triangle {}", patches.len()),
                patch,
            ));
        }
    }
    Scene::try_new(patches).unwrap()
}

#[test]
fn grazing_triangles_together_have_the_bits_of_triangles_alone() {
    let scene = grazing_triangles();
    for tolerance in [1e-11, 1e-12] {
        let own = Congruence::Ignored;
        let pairs = ScenePairs::try_new(&scene, tolerance, own, Occlusion::Ignore).unwrap();
        let together = pairs.exchange_areas().unwrap();
        let mut kernels = 0;
        for (i, j) in (0..24).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let [found, alone] = [together.get(i, j), pairs.row_pair(i, j).unwrap()];
            assert_eq!(bits(&found), bits(&alone), "{i} {j}: {found:?} {alone:?}");
            kernels += usize::from(found.route == Route::Kernel);
        }
        assert!(kernels > 100, "{kernels}");
    }
}

fn bits(answer: &Answer) -> [u64; 2] {
    [answer.exchange.value, answer.exchange.error].map(f64::to_bits)
}

/// A pass evaluates pairs together; `row_pair` evaluates one alone. All bits are compared, at
/// tolerances that take few points and many, and where an absolute error makes each pair's its own.
#[test]
fn pairs_together_have_the_bits_of_pairs_alone() {
    let scene = mixed_cube();
    let relative = [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];
    let absolute = Tolerance {
        relative: 1e-12,
        absolute: Some(1e-5),
    };
    for tolerance in relative.map(Tolerance::from).into_iter().chain([absolute]) {
        let own = Congruence::Ignored;
        let pairs = ScenePairs::try_new(&scene, tolerance, own, Occlusion::Refuse).unwrap();
        let together = pairs.exchange_areas().unwrap();
        let mut routes = std::collections::BTreeSet::new();
        for i in 0..pairs.rows() {
            for j in 0..i {
                let [found, alone] = [together.get(i, j), pairs.row_pair(i, j).unwrap()];
                assert_eq!(
                    bits(&found),
                    bits(&alone),
                    "{tolerance}: {i} {j}, {found:?} {alone:?}"
                );
                assert_eq!(found.route, alone.route, "{tolerance}: {i} {j}");
                routes.insert(found.route.name());
            }
        }
        // nearer than that they take fewer points by another route
        let is_tight = tolerance.relative < 1e-6 && tolerance.absolute.is_none();
        assert!(is_tight || routes.contains("kernel"), "{routes:?}");
        // tiles take the rows in another order
        for tile in pairs.tiles(16) {
            let answers = pairs.tile(&tile).unwrap();
            let mut values = answers.values.iter();
            for (i, j) in answers
                .rows
                .iter()
                .flat_map(|i| answers.columns.iter().map(move |j| (*i, *j)))
            {
                let value = values.next().copied().unwrap();
                assert_eq!(value.to_bits(), together.get(i, j).exchange.value.to_bits());
            }
        }
    }
}
