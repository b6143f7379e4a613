//! Coordinates that are rounded to decimals: rooms stay rooms, and what is there stays there.

use crate::support::breadth::some_of;
use crate::support::rounded_rooms::{Room, read};
use glam::DVec3;
use infoscene::exchange::{Closure, Congruence, ExchangeError, ScenePairs};
use infoscene::information::{OpenScene, scene_information};
use infoscene::numeric::tolerance;
use infoscene::scene::files::{Reading, Source, read_view3d};
use infoscene::scene::{Blocker, Material, Obstacle, Occlusion, Scene, SceneError};
use infoscene::transport::RadiositySystem;

fn pairs(scene: &Scene, occlusion: Occlusion) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, 1e-12, Congruence::Shared, occlusion).unwrap()
}

/// The laws of a room, whatever its turn and its decimals: it is read without a flag, closed, a
/// furnace has B = 1 to what the resolution allows, and the mutual information is that of the room
/// before it was turned and rounded, to what the resolution allows.
///
/// A room that is a parallelepiped to the last bit, as roundings may have it, is exact: its mutual
/// information is its own.
fn is_a_room(seed: u64) {
    let room = Room::any(seed);
    let (scene, exact) = (read(&room.rounded()), read(&room.exact()));
    assert_eq!(exact.resolution(), 0.0, "{seed}");
    let resolution = scene.resolution();
    assert!(resolution <= room.half_unit(), "{seed}: {resolution}");
    let pairs_of = |scene: &Scene| pairs(scene, Occlusion::Refuse);
    let found = scene_information(&pairs_of(&scene), OpenScene::Refuse).unwrap();
    let before = scene_information(&pairs_of(&exact), OpenScene::Refuse).unwrap();
    let unoccluded = pairs(&scene, Occlusion::Ignore);
    let [found_information, before] = [&found, &before].map(|found| found.mutual_information);
    let moved = found.resolution.unwrap().mutual_information;
    let allowed = moved + found_information.error + before.error;
    let change = (found_information.value - before.value).abs();
    assert!(
        resolution == 0.0 || change <= allowed,
        "{seed}: {change} > {allowed}"
    );
    let exchange = unoccluded.exchange_areas().unwrap();
    assert!(Closure::of_held(&exchange).is_closed(), "{seed}");
    let materials = vec![Material::try_new(0.5, 0.5).unwrap(); exchange.rows()];
    let system = RadiositySystem::of(&exchange, &materials).unwrap();
    let emittances = vec![0.5; exchange.rows()];
    let light = system.radiosity(&emittances).unwrap();
    let moved = match exchange.resolution_errors() {
        Some(bounds) => system
            .resolution_errors(bounds, &light.values, &emittances)
            .unwrap()
            .unwrap(),
        None => vec![0.0; exchange.rows()],
    };
    for (value, moved) in light.values.iter().zip(moved) {
        assert!(
            (value - 1.0).abs() <= moved + 1e-12,
            "{seed}: {value} ± {moved}"
        );
    }
}

#[test]
fn rounded_rooms_are_rooms() {
    for seed in some_of(0..12) {
        is_a_room(seed);
    }
}

#[test]
#[ignore = "a minute: cargo test --release --test library scene::resolution -- --ignored"]
fn a_thousand_rounded_rooms_are_rooms() {
    for seed in 1000..2000 {
        is_a_room(seed);
    }
}

/// Far from the origin, coordinates have fewer digits after the point: a room in a national grid,
/// to the millimetre.
#[test]
fn rooms_far_from_the_origin_are_rooms() {
    for seed in 0..4 {
        let room = Room {
            shift: DVec3::new(432_100.0, 5_811_234.0, 37.0),
            ..Room::whole([5.0, 4.0, 3.0], seed, 3)
        };
        let scene = read(&room.rounded());
        assert_eq!(scene.resolution(), 0.0005);
        let found = scene_information(&pairs(&scene, Occlusion::Refuse), OpenScene::Refuse);
        assert!(found.is_ok(), "{seed}: {found:?}");
    }
}

/// Whole numbers of millimetres are decimals, too.
#[test]
fn whole_millimetres_are_decimals() {
    let room = Room::whole([5000.0, 4000.0, 3000.0], 3, 0);
    let scene = read(&room.rounded());
    assert_eq!(scene.resolution(), 0.5);
    assert_eq!(scene.blocker(), None);
}

/// A polygon of the plane z = 0 on [0, 1]², at the place `(x, y, z)` of the room's own.
fn plate(x: [f64; 2], y: [f64; 2], z: f64) -> Vec<DVec3> {
    let corners = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
    corners.map(|[x, y]| DVec3::new(x, y, z)).to_vec()
}

/// The noise of a room of three decimals: what is well above it is there.
const NOISE: f64 = tolerance::RESOLVED_NOISE * 0.0005;

/// Negative control: a ceiling that is lifted by ten times the noise leaves the room open.
#[test]
fn a_real_gap_is_open() {
    for seed in 0..4 {
        let mut room = Room::whole([2.0, 2.0, 2.0], seed, 3);
        for corner in &mut room.polygons[5] {
            corner.z += 10.0 * NOISE;
        }
        let scene = read(&room.rounded());
        assert_eq!(scene.resolution(), 0.0005);
        let found = scene_information(&pairs(&scene, Occlusion::Refuse), OpenScene::Refuse);
        let error = found.unwrap_err().to_string();
        assert!(error.contains("the scene is open"), "{error}");
    }
}

/// Negative control: a plate in the room blocks what is behind it, at ten times the noise, too.
#[test]
fn a_real_plate_blocks() {
    for (seed, height) in [(0, 1.0), (1, 10.0 * NOISE), (2, 2.0 * NOISE)] {
        let mut room = Room::whole([2.0, 2.0, 2.0], seed, 3);
        room.polygons.push(plate([0.5, 1.5], [0.5, 1.5], height));
        let scene = read(&room.rounded());
        let plate = Some(Obstacle::Patch(6));
        let found = scene.blocker().map(|Blocker { obstacle, .. }| obstacle);
        assert_eq!(found, plate, "{height}");
    }
}

/// Negative control: panels that reach over each other by ten times the noise overlap; that far
/// below it they touch.
#[test]
fn a_real_overlap_is_refused() {
    for (over, expected) in [(10.0 * NOISE, Some((4, 6))), (0.1 * NOISE, None)] {
        let mut room = Room::whole([2.0, 2.0, 2.0], 5, 3);
        room.polygons[4] = plate([0.0, 1.0 + over], [0.0, 2.0], 0.0);
        room.polygons.push(plate([1.0, 2.0], [0.0, 2.0], 0.0));
        assert_eq!(read(&room.rounded()).overlap(), expected, "{over}");
    }
}

/// Decimals are no proof of rounding: nothing misses here.
///
/// A box, a box with a plate a millionth above its floor, and a floor of which a panel is sunk by
/// one unit of the last place.
#[test]
fn exact_files_have_no_resolution() {
    let six = |polygons: Vec<Vec<DVec3>>| Room {
        polygons,
        turn: glam::DQuat::IDENTITY,
        ..Room::whole([1.0, 1.0, 1.0], 0, 6)
    };
    let cube = six(Room::whole([1.0, 1.0, 1.0], 0, 6).polygons);
    assert_eq!(read(&cube.rounded()).resolution(), 0.0);

    let mut polygons = cube.polygons.clone();
    polygons.push(plate([0.25, 0.75], [0.25, 0.75], 1e-6));
    let scene = read(&six(polygons).rounded());
    assert_eq!(scene.resolution(), 0.0);
    let found = scene.blocker().map(|Blocker { obstacle, .. }| obstacle);
    assert_eq!(found, Some(Obstacle::Patch(6)));

    let mut polygons = cube.polygons;
    polygons[4] = plate([0.0, 0.5], [0.0, 1.0], 0.0);
    polygons.push(plate([0.5, 1.0], [0.0, 1.0], -1e-6));
    assert_eq!(read(&six(polygons).rounded()).resolution(), 0.0);
}

/// A resolution that is given is used as it is; one that tells nothing apart is refused.
#[test]
fn a_given_resolution_is_used() {
    let text = Room::whole([5.0, 4.0, 3.0], 1, 3).rounded();
    let read_with = |resolution: f64| {
        let reading = Reading {
            resolution: Some(resolution),
            ..Reading::default()
        };
        let library = |name: &str| panic!("{name} is not asked for");
        infoscene::scene::files::read_obj(
            &Source::new("room.obj", text.as_str()),
            &library,
            reading,
        )
    };
    assert_eq!(read_with(0.002).unwrap().scene.resolution(), 0.002);
    let refusal = read_with(0.0).unwrap_err().to_string();
    assert!(
        refusal.contains("off the plane") && refusal.contains("unless"),
        "{refusal}"
    );
    let scene = Scene::built_in("cube:2").unwrap();
    for resolution in [0.1, -1.0, f64::NAN, f64::INFINITY] {
        let refusal = scene.clone().with_resolution(resolution).unwrap_err();
        assert!(
            matches!(refusal, SceneError::Resolution { .. }),
            "{refusal}"
        );
    }
}

/// Walls of two triangles each, rounded to the fourth decimal and turned again: nine decimals say
/// nothing of it. The refusal names a resolution, and with it the scene is accepted.
#[test]
fn a_refusal_names_the_resolution_that_mends_it() {
    let mut room = Room::whole([5.0, 4.0, 3.0], 1, 9);
    let (turn, rounded) = (room.turn, |x: f64| (x * 1e4).round() / 1e4);
    let walls = std::mem::take(&mut room.polygons);
    for wall in walls {
        let wall: Vec<DVec3> = wall.iter().map(|c| (turn * *c).map(rounded)).collect();
        let halves = [[0, 1, 2], [0, 2, 3]].map(|half| half.map(|k: usize| wall[k]).to_vec());
        room.polygons.extend(halves);
    }
    let scene = read(&room.rounded());
    let refusal = scene.check_unblocked().unwrap_err();
    let SceneError::MayBeBlocked { resolution, .. } = refusal else {
        panic!("{refusal}")
    };
    let mended = scene.with_resolution(resolution.unwrap()).unwrap();
    assert_eq!(mended.check_unblocked(), Ok(()));
}

/// A part of a base in a View3D file, both rounded to the millimetre.
#[test]
fn rounded_parts_lie_in_their_bases() {
    let text = "T a\nF 3\n\
                V 1 0.000 0.000 0.000\nV 2 3.059 2.577 0.000\nV 3 3.059 2.577 3.000\n\
                V 4 0.000 0.000 3.000\nV 5 1.021 0.859 1.000\nV 6 2.040 1.717 1.000\n\
                V 7 2.040 1.717 2.000\nV 8 1.021 0.859 2.000\n\
                S 1 1 2 3 4 0 0 .9 wall\nS 2 5 6 7 8 1 0 .9 window\nEnd of data\n";
    let loaded = read_view3d(&Source::new("wall.vs3", text), Reading::default()).unwrap();
    assert_eq!(loaded.scene.resolution(), 0.0005);
    assert_eq!(loaded.scene.base_of(1), Some(0));
    assert!(
        loaded.notes.iter().any(|note| note.contains("± 5e-4")),
        "{:?}",
        loaded.notes
    );
}

/// The error of an open scene says what of the gap the resolution explains.
#[test]
fn an_open_room_says_what_is_explained() {
    let mut room = Room::whole([5.0, 4.0, 3.0], 2, 3);
    room.polygons.pop();
    let scene = read(&room.rounded());
    let pairs = pairs(&scene, Occlusion::Refuse);
    let refusal = Closure::of(&pairs).unwrap().require_closed();
    let Err(ExchangeError::OpenScene {
        resolution_error, ..
    }) = &refusal
    else {
        panic!("{refusal:?}")
    };
    // beside a fifth and more of the light that escapes
    assert!(
        (1e-6..0.05).contains(resolution_error),
        "{resolution_error}"
    );
    assert!(
        refusal
            .unwrap_err()
            .to_string()
            .contains("for the resolution")
    );
}
