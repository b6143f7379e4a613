//! Rows of scenes as points see them: closed rooms, courtyards, parts, summed rows, obstructions.

use crate::support::rooms::{level, polygon};
use glam::DVec3;
use infoscene::exchange::{PointRow, ScenePoints, Unheard};
use infoscene::form_factor::{ExchangeArea, point_form_factor};
use infoscene::scene::{NamedPatch, Occlusion, Scene};

fn row(scene: &Scene, point: [f64; 3], normal: DVec3) -> PointRow {
    row_under(scene, Occlusion::default(), point, normal)
}

fn row_under(scene: &Scene, policy: Occlusion, point: [f64; 3], normal: DVec3) -> PointRow {
    let points = ScenePoints::try_new(scene, policy).unwrap();
    let found = points.seen_from(&[(DVec3::from_array(point), normal)], &Unheard);
    found.unwrap().remove(0)
}

fn assert_is(found: ExchangeArea, exact: f64) {
    let is_met = (found.value - exact).abs() <= found.error;
    assert!(is_met, "{found:?}, not {exact}");
    assert!(found.error <= 1e-13, "{found:?}");
}

/// Walls of a square courtyard, front inside, over a floor.
fn courtyard(side: f64, height: f64) -> Scene {
    let corners = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]];
    let mut patches = vec![level("floor", [0.0, side], [0.0, side], 0.0, true)];
    for k in 0..4 {
        let ([ax, ay], [bx, by]) = (corners[k], corners[(k + 1) % 4]);
        let wall = [
            [bx, by, 0.0],
            [ax, ay, 0.0],
            [ax, ay, height],
            [bx, by, height],
        ];
        patches.push(polygon(&format!("wall {k}"), &wall));
    }
    Scene::try_new(patches).unwrap()
}

/// The sky-view factor on the floor of a courtyard is the form factor of its opening: Howell, B-3
/// in the middle, Lambert's formula beside it.
#[test]
fn a_courtyard_sees_the_sky_through_its_opening() {
    let (side, height) = (2.0, 3.0);
    let scene = courtyard(side, height);
    let middle = row(&scene, [1.0, 1.0, 0.0], DVec3::Z);
    let a: f64 = 0.5 * side / height;
    let exact =
        4.0 / std::f64::consts::PI * a / (1.0 + a * a).sqrt() * (a / (1.0 + a * a).sqrt()).atan();
    assert_is(middle.unseen.unwrap(), exact);
    assert_eq!(middle.backs.unwrap().value, 0.0);
    let opening = level("", [0.0, side], [0.0, side], height, false);
    for point in [[0.1, 0.2, 0.0], [1.9, 1.0, 0.7], [1e-6, 1.0, 1e-3]] {
        let seen = point_form_factor(DVec3::from_array(point), DVec3::Z, opening.shape());
        let unseen = row(&scene, point, DVec3::Z).unseen.unwrap();
        assert!((unseen.value - seen.unwrap()).abs() <= unseen.error + 4e-15);
    }
}

/// A long street sees `cos β` of the sky from its middle, tan β = height over half the width: two
/// walls of infinite length see `(1 − cos β)/2` each.
#[test]
fn a_long_street_tends_to_the_cosine_of_its_walls() {
    let (width, height) = (2.0, 1.5);
    let exact = (0.5 * width) / (0.5_f64 * width).hypot(height);
    for (length, allowed) in [(1e2, 1e-3), (1e4, 1e-7), (1e6, 1e-11)] {
        let wall = |x: f64, to: f64| {
            let at = |y: f64, z: f64| [x, y, z];
            polygon(
                "wall",
                &[at(-to, 0.0), at(to, 0.0), at(to, height), at(-to, height)],
            )
        };
        let walls = vec![wall(0.0, length), wall(width, -length)];
        let scene = Scene::try_new(walls).unwrap();
        let found = row(&scene, [0.5 * width, 0.0, 0.0], DVec3::Z);
        // walls face the street
        assert_eq!(found.backs.unwrap().value, 0.0);
        let unseen = found.unseen.unwrap().value;
        assert!(
            (unseen - exact).abs() <= allowed,
            "{length}: {unseen}, not {exact}"
        );
    }
}

/// A wall seen from behind, and an obstruction, are unseen, and counted as backs.
#[test]
fn backs_and_obstructions_are_unseen() {
    let up = level("up", [-1.0, 1.0], [-1.0, 1.0], 2.0, true);
    let plate = level("plate", [-0.25, 0.25], [-0.25, 0.25], 0.5, true);
    let far = level("far", [-9.0, 9.0], [-9.0, 9.0], 3.0, false);
    let scene = Scene::try_new(vec![up.clone(), far.clone()]).unwrap();
    let scene = scene.with_obstructions(vec![plate]);
    let found = row(&scene, [0.0; 3], DVec3::Z);
    // the plate hides exactly the square at 2
    let flat = |patch: &NamedPatch| {
        let down = patch.shape().clone().reversed();
        point_form_factor(DVec3::ZERO, DVec3::Z, &down).unwrap()
    };
    let square = flat(&up);
    let backs = found.backs.unwrap();
    assert!((backs.value - square).abs() <= backs.error + 4e-15);
    assert_eq!(found.form_factors[0].value, 0.0);
    let far = point_form_factor(DVec3::ZERO, DVec3::Z, far.shape()).unwrap();
    let seen = found.form_factors[1];
    assert!((seen.value - (far - square)).abs() <= seen.error + 4e-15);
    // as if nothing were in the way, all of it is seen
    let open = row_under(&scene, Occlusion::Ignore, [0.0; 3], DVec3::Z);
    assert!((open.form_factors[1].value - far).abs() <= seen.error + 4e-15);
    assert_eq!((open.unseen, open.backs), (None, None));
}

/// A base counts without what lies in it, and patches of one row add up.
#[test]
fn bases_count_without_their_parts_and_rows_are_summed() {
    let scene = Scene::try_new(vec![
        level("ceiling", [-1.0, 1.0], [-1.0, 1.0], 1.0, false),
        level("lamp", [0.0, 0.5], [0.0, 0.5], 1.0, false),
        level("one", [2.0, 3.0], [-1.0, 1.0], 1.0, false),
        level("other", [-3.0, -2.0], [-1.0, 1.0], 1.0, false),
    ])
    .unwrap()
    .with_base(1, 0)
    .unwrap()
    .with_groups(&["a", "b", "c", "c"])
    .unwrap();
    let found = row(&scene, [0.0; 3], DVec3::Z);
    let seen = |patch: usize| {
        point_form_factor(DVec3::ZERO, DVec3::Z, scene.patches()[patch].shape()).unwrap()
    };
    let exact = [seen(0) - seen(1), seen(1), seen(2) + seen(3)];
    assert_eq!(found.form_factors.len(), 3);
    for (found, exact) in found.form_factors.iter().zip(exact) {
        assert!((found.value - exact).abs() <= found.error + 4e-15);
    }
    let rest = 1.0 - seen(0) - seen(2) - seen(3);
    assert!((found.unseen.unwrap().value - rest).abs() <= 1e-14);
}

/// `Σ_j F_xj = 1` from points on the faces of a closed room, its own face seen edge-on.
#[test]
fn a_point_on_a_face_of_a_closed_room_sees_the_others() {
    let scene = Scene::built_in("cornell-box").unwrap();
    for patch in scene.patches() {
        let shape = patch.shape();
        let corners = shape.corners();
        let middle = corners.iter().sum::<DVec3>() / corners.len() as f64;
        let found = row(&scene, middle.to_array(), shape.normal());
        let unseen = found.unseen.unwrap();
        let backs = found.backs.unwrap();
        let sum: f64 = found.form_factors.iter().map(|part| part.value).sum();
        assert!(
            (sum + unseen.value - 1.0).abs() <= unseen.error,
            "{}",
            patch.name()
        );
        assert!(backs.value <= unseen.value + backs.error + unseen.error);
    }
}

/// The same bits on any number of threads.
#[test]
fn rows_of_points_do_not_depend_on_threads() {
    let scene = courtyard(2.0, 1.0);
    let points: Vec<_> = (1..20)
        .map(|k| (DVec3::new(0.1 * f64::from(k), 0.7, 0.0), DVec3::Z))
        .collect();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| {
            let rows = ScenePoints::try_new(&scene, Occlusion::default()).unwrap();
            rows.seen_from(&points, &Unheard).unwrap()
        })
    };
    assert_eq!(on(1), on(3));
}
