//! The radiosity of a box at any point, and the errors of meshes judged by it.

use glam::DVec3;
use infoscene::Scene;
use infoscene::form_factor::point_form_factor;
use infoscene::hierarchy::Tree;
use infoscene::reference::{BoxRadiosity, BoxRoomError, relative_error};
use infoscene::scene::{Channel, Material, NamedPatch};

/// A scene's patches with other materials.
fn painted(scene: &Scene, material: impl Fn(&NamedPatch) -> [f64; 2]) -> Scene {
    let paint = |patch: &NamedPatch| {
        let [reflectance, emittance] = material(patch);
        patch
            .clone()
            .with_material(Material::try_new(reflectance, emittance).unwrap())
    };
    Scene::try_new(scene.patches().iter().map(paint).collect()).unwrap()
}

fn solved(scene: &Scene, cells: usize) -> BoxRadiosity {
    BoxRadiosity::try_new(scene, Channel::Red, cells).unwrap()
}

/// Points of each patch, some of them near its edges.
fn places(scene: &Scene) -> Vec<(usize, DVec3)> {
    let patches = scene.patches().iter().enumerate();
    let points = patches.flat_map(|(patch, named)| {
        let corners = named.shape().corners().to_vec();
        let (u, v) = (corners[1] - corners[0], corners[3] - corners[0]);
        let shares = [[0.4, 0.7], [0.003, 0.5], [0.9, 0.96], [0.2, 0.1]];
        shares.map(|[s, t]| (patch, corners[0] + s * u + t * v))
    });
    points.collect()
}

/// In an enclosure of one material, `B = E + R B` everywhere.
#[test]
fn a_box_of_one_material_glows_evenly() {
    let room = painted(&Scene::built_in("lit-hall").unwrap(), |_| [0.6, 1.0]);
    let radiosity = solved(&room, 4);
    for (patch, point) in places(&room) {
        let found = radiosity.radiosity(patch, point);
        // iteration ends at 1e-11 of the largest, with at most 1/(1 − 0.6) of that to come
        assert!((found.value - 2.5).abs() < 1e-9 && found.error < 1e-9);
    }
}

/// Where the floor alone reflects, it shows what it sees of the light, and nothing comes back.
#[test]
fn a_floor_among_black_walls_shows_the_light() {
    for name in ["lit-cube", "lit-hall", "lit-cube-edge"] {
        let is_light = |patch: &NamedPatch| patch.name() == "light";
        let floor = painted(&Scene::built_in(name).unwrap(), |patch| {
            match patch.name() {
                "floor" => [0.5, 0.0],
                _ => [0.0, f64::from(u8::from(is_light(patch)))],
            }
        });
        let light = floor
            .patches()
            .iter()
            .find(|patch| is_light(patch))
            .unwrap();
        let radiosity = solved(&floor, 4);
        for (patch, point) in places(&floor) {
            let shape = floor.patches()[patch].shape();
            let seen = point_form_factor(point, shape.normal(), light.shape()).unwrap();
            let expected = match floor.patches()[patch].name() {
                "floor" => 0.5 * seen,
                "light" => 1.0,
                _ => 0.0,
            };
            let found = radiosity.radiosity(patch, point);
            assert!((found.value - expected).abs() < 1e-12, "{name} {patch}");
        }
    }
}

/// The root mean squares, over evenly spread points, of the difference from a solution on grids
/// twice as fine, of the estimate, and of the better solution.
fn against_finer(room: &Scene, cells: usize) -> [f64; 3] {
    let [coarse, fine] = [cells, 2 * cells].map(|cells| solved(room, cells));
    let mut squares = [0.0; 3];
    for (patch, point, area) in spread(room) {
        let [found, better] = [&coarse, &fine].map(|one| one.radiosity(patch, point));
        let terms = [found.value - better.value, found.error, better.value];
        squares = [0, 1, 2].map(|k| squares[k] + area * terms[k] * terms[k]);
    }
    squares.map(f64::sqrt)
}

/// The estimate is the last correction, which goes towards the solution on finer grids: what is
/// left is less than itself. In the wrong direction it would leave more.
#[test]
fn estimates_hold_against_finer_grids() {
    let room = Scene::built_in("lit-cube").unwrap();
    let [error, estimate, _] = against_finer(&room, 4);
    assert!(error < estimate, "{error:e} {estimate:e}");
}

/// Errors of linear functions about a solution that is linear nowhere: of its own mean and slope,
/// Pythagoras.
#[test]
fn the_best_constants_have_the_least_error() {
    let room = Scene::built_in("lit-cube").unwrap();
    let mut tree = Tree::new(room.patches().iter().map(NamedPatch::shape));
    for leaf in tree.leaves().collect::<Vec<_>>() {
        tree.quarter(leaf).unwrap();
    }
    let radiosity = solved(&room, 4);
    let moments = radiosity.leaf_moments(&tree);
    let light = room
        .patches()
        .iter()
        .position(|patch| patch.name() == "light")
        .unwrap();
    let dark = |leaf: &usize| tree.elements()[*leaf].patch() != light;
    assert!(
        moments
            .iter()
            .map(|(leaf, _)| *leaf)
            .eq(tree.leaves().filter(dark))
    );
    let mean = |leaf: usize| moments.iter().find(|(own, _)| *own == leaf).unwrap().1.mean;
    let best = relative_error(&moments, |leaf| (mean(leaf), DVec3::ZERO));
    for factor in [0.9, 1.1] {
        let other = relative_error(&moments, |leaf| (factor * mean(leaf), DVec3::ZERO));
        assert!(other > best);
    }
    let none = relative_error(&moments, |_| (0.0, DVec3::ZERO));
    assert!((none - 1.0).abs() < 1e-12);
}

#[test]
fn what_is_no_box_is_refused() {
    for name in ["icosahedron", "lit-wings", "shaded-cube", "two-squares"] {
        let scene = Scene::built_in(name).unwrap();
        let refused = BoxRadiosity::try_new(&scene, Channel::Red, 2).map(|_| ());
        assert!(
            matches!(
                refused,
                Err(BoxRoomError::NotOnABox { .. } | BoxRoomError::NotCovered { .. })
            ),
            "{name}"
        );
    }
}

/// Evenly spread points of each patch that is no light, each with the area around it.
fn spread(scene: &Scene) -> Vec<(usize, DVec3, f64)> {
    let patches = scene.patches().iter().enumerate();
    let dark = patches.filter(|(_, named)| named.name() != "light");
    let points = dark.flat_map(|(patch, named)| {
        let corners = named.shape().corners().to_vec();
        let (u, v) = (corners[1] - corners[0], corners[3] - corners[0]);
        let area = named.shape().area() / 36.0;
        (0..36u32).map(move |k| {
            let [s, t] = [k / 6, k % 6].map(|k| (f64::from(k) + 0.5) / 6.0);
            (patch, corners[0] + s * u + t * v, area)
        })
    });
    points.collect()
}

/// The accuracy that is promised, against grids twice as fine: relative to the mean square over all
/// that is no light.
#[test]
#[ignore = "a minute: cargo test --release --test library box_radiosity -- --ignored"]
fn boxes_are_known_to_some_1e4() {
    for name in ["lit-cube", "lit-cube-edge", "lit-hall"] {
        let room = Scene::built_in(name).unwrap();
        let [error, estimate, whole] = against_finer(&room, 4);
        let relative = [error, estimate].map(|square| square / whole);
        println!("{name} {relative:?}");
        assert!(relative[0] < relative[1], "{name} {relative:?}");
        assert!(relative[1] < 5e-4, "{name} {relative:?}");
    }
}
