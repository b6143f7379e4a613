//! Exchange past what stands between: closed rooms with furniture, hidden pairs, bases, plans.

use crate::support::furnished::{partition, shelf, standing, table, two_boxes, u_room};
use crate::support::rooms::{L, among, level, prism, squares};
use infoscene::exchange::{Closure, Congruence, ExchangeAreas, ScenePairs};
use infoscene::form_factor::Route;
use infoscene::scene::files::{NonPlanarFaces, read};
use infoscene::scene::{Material, NamedPatch, Occlusion, Scene};
use infoscene::transport::RadiositySystem;
use std::path::Path;

/// A room with a box in it, of `data/scenes`.
fn room_table() -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/scenes/room-table.obj");
    read(&path, NonPlanarFaces::Refuse).unwrap().scene
}

fn rooms() -> Vec<(&'static str, Scene)> {
    vec![
        ("room with a box", room_table()),
        ("two boxes", two_boxes()),
        ("table", table()),
        ("shelf", shelf()),
        ("L", prism(&L)),
        ("U", u_room()),
    ]
}

fn pairs(scene: &Scene, congruence: Congruence, occlusion: Occlusion) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, 1e-12, congruence, occlusion).unwrap()
}

fn exact(scene: &Scene) -> ExchangeAreas {
    let pairs = pairs(scene, Congruence::Shared, Occlusion::Exact);
    pairs.exchange_areas().unwrap()
}

/// `Σ_j F_ij = 1` in a closed room, whatever stands in it; and `B = E/(1 − R)` for one material.
fn assert_closed_furnace(name: &str, scene: &Scene) {
    let exchange = exact(scene);
    let closure = Closure::of_held(&exchange);
    for row in closure.rows() {
        let off = (row.sum - 1.0).abs();
        assert!(
            off <= row.tolerance(),
            "{name}, row {}: {off:e} {row:?}",
            row.row
        );
        assert!(row.tolerance() <= 1e-10, "{name}, row {}: {row:?}", row.row);
    }
    let grey = Material::try_new(0.75, 1.0).unwrap();
    let materials = vec![grey; exchange.rows()];
    let system = RadiositySystem::of(&exchange, &materials).unwrap();
    let emittances = vec![1.0; exchange.rows()];
    for radiosity in system.radiosity(&emittances).unwrap().values {
        // a row that sums to 1 + δ changes B by δ R/(1 − R)² at most
        assert!(
            (radiosity - 4.0).abs() <= 12.0 * 1e-10,
            "{name}: {radiosity}"
        );
    }
    let plan = &exchange.summary().plan;
    let counts = plan.occlusion.unwrap();
    assert!(counts.partial > 0, "{name}: {counts:?}");
    let visible = plan.pairs - plan.coplanar - plan.back_facing;
    assert_eq!(
        counts.visible + counts.partial + counts.hidden,
        visible,
        "{name}"
    );
    assert_eq!(
        plan.untouched + plan.congruent + plan.computed,
        plan.pairs,
        "{name}"
    );
}

#[test]
fn furnished_rooms_are_closed_furnaces() {
    for (name, scene) in rooms() {
        assert_closed_furnace(name, &scene);
    }
}

/// Two coincident fronts, whose foot is an edge of two ends.
#[test]
fn a_partition_on_the_line_between_two_patches_keeps_the_room_closed() {
    assert_closed_furnace("partition", &partition());
}

/// `data/reference/room-table.json`: edge integrals in 80-bit arithmetic.
#[test]
fn a_room_with_a_box_has_the_values_of_the_reference() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/reference/room-table.json");
    let text = std::fs::read_to_string(path).unwrap();
    let reference: serde_json::Value = serde_json::from_str(&text).unwrap();
    let scene = room_table();
    let exchange = exact(&scene);
    let row = |name: &serde_json::Value| {
        let name = name.as_str().unwrap().to_owned();
        let mut patches = scene.patches().iter();
        patches
            .position(|patch| patch.wholes().contains(&name))
            .unwrap()
    };
    let values = reference["form_factors"].as_array().unwrap();
    assert_eq!(values.len(), 10);
    for entry in values {
        let [i, j] = ["source", "receiver"].map(|end| row(&entry[end]));
        let value: f64 = entry["value"].as_str().unwrap().parse().unwrap();
        let found = exchange.get(i, j).exchange;
        let area = exchange.areas()[i];
        let off = (found.value / area - value).abs();
        assert!(off <= found.error / area + 1e-15, "{entry}: {off:e}");
        assert!(found.error <= 1e-11 * found.value, "{entry}: {found:?}");
    }
}

/// The square half the way down, a quarter of both: 0.1498686717737905 by brute force and by point
/// factors with the shadow cut out.
#[test]
fn an_obstruction_takes_its_part() {
    let quarter = level("quarter", [0.0, 0.5], [0.0, 0.5], 0.5, true);
    let exchange = exact(&among(&squares(), &[quarter]));
    let found = exchange.get(0, 1);
    assert_eq!(found.route, Route::Occluded);
    let off = (found.exchange.value - 0.149_868_671_773_790_5).abs();
    assert!(off <= found.exchange.error + 1e-15, "{off:e}");
}

/// A plate over all of what two squares see of each other, a box between them, and two boxes that
/// hide together what neither hides: exactly nothing is left, without an integral.
#[test]
fn hidden_pairs_exchange_exactly_nothing() {
    let plate = level("plate", [0.0, 1.0], [0.0, 1.0], 0.5, true);
    let block = standing("box", [-1.0, 2.0], [-1.0, 2.0], [0.25, 0.75]);
    let two = [
        standing("left", [-1.0, 0.875], [-1.0, 2.0], [0.25, 0.5]),
        standing("right", [0.125, 2.0], [-1.0, 2.0], [0.625, 0.75]),
    ];
    for (name, between) in [
        ("plate", vec![plate]),
        ("box", block),
        ("two", two.concat()),
    ] {
        let exchange = exact(&among(&squares(), &between));
        let found = exchange.get(0, 1);
        assert_eq!(
            (found.route, found.exchange.value),
            (Route::Hidden, 0.0),
            "{name}"
        );
        assert_eq!(found.exchange.error, 0.0, "{name}");
        let plan = &exchange.summary().plan;
        assert_eq!((plan.untouched, plan.computed), (1, 0), "{name}");
        assert_eq!(plan.occlusion.unwrap().hidden, 1, "{name}");
    }
    // a slit between two plates, and a plate that ends a little before
    let slit = [[-1.0, 0.5], [0.5 + 1e-9, 2.0]];
    let slit = slit.map(|x| level("half", x, [-1.0, 2.0], 0.5, true));
    let short = [level("short", [0.0, 1.0 - 1e-9], [0.0, 1.0], 0.5, true)];
    for between in [&slit[..], &short] {
        assert_ne!(
            exact(&among(&squares(), between)).get(0, 1).route,
            Route::Hidden
        );
    }
}

/// A mat on the floor, a box on the mat: what is left of the floor is the floor without the mat,
/// cut by hand.
#[test]
fn a_base_is_blocked_as_its_rest_is() {
    let square = |name, low, high| level(name, [low, high], [low, high], 0.0, true);
    let rest = [
        level("rest", [0.0, 0.25], [0.0, 1.0], 0.0, true),
        level("rest", [0.75, 1.0], [0.0, 1.0], 0.0, true),
        level("rest", [0.25, 0.75], [0.0, 0.25], 0.0, true),
        level("rest", [0.25, 0.75], [0.75, 1.0], 0.0, true),
    ];
    let others = || {
        let mut patches = Scene::built_in("cube:1").unwrap().patches()[1..].to_vec();
        patches.extend(standing("box", [0.375, 0.625], [0.375, 0.625], [0.0, 0.5]));
        patches
    };
    let with = |floor: &[NamedPatch]| Scene::try_new([floor, &others()].concat()).unwrap();
    let (floor, mat) = (square("floor", 0.0, 1.0), square("mat", 0.25, 0.75));
    let base = with(&[floor, mat.clone()]).with_base(1, 0).unwrap();
    let cut = with(&[&rest[..], &[mat]].concat());
    let labels = [0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11];
    let cut = cut.with_groups(&labels).unwrap();
    let [base, cut] = [exact(&base), exact(&cut)];
    assert_eq!(base.rows(), cut.rows());
    let mut blocked = 0;
    for j in 1..base.rows() {
        let [one, other] = [&base, &cut].map(|areas| areas.get(0, j));
        let off = (one.exchange.value - other.exchange.value).abs();
        let bounds = one.exchange.error + other.exchange.error;
        assert!(off <= bounds, "{j}: {off:e} {bounds:e}");
        assert!(bounds <= 1e-10, "{j}: {bounds:e}");
        blocked += usize::from(one.route == Route::Occluded);
    }
    assert!(blocked > 3, "{blocked}");
}

/// Values that congruent pairs share are those of pairs that nothing blocks.
#[test]
fn blocked_pairs_share_nothing() {
    for (name, scene) in [("box", room_table()), ("U", u_room())] {
        let shared = pairs(&scene, Congruence::Shared, Occlusion::Exact);
        let alone = pairs(&scene, Congruence::Ignored, Occlusion::Exact);
        let [shared, alone] = [shared, alone].map(|pairs| pairs.exchange_areas().unwrap());
        assert!(shared.summary().plan.congruent > 0, "{name}");
        assert_eq!(alone.summary().plan.congruent, 0, "{name}");
        assert_eq!(
            shared.summary().plan.occlusion,
            alone.summary().plan.occlusion
        );
        for (i, j) in (0..shared.rows()).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let [one, other] = [&shared, &alone].map(|areas| areas.get(i, j).exchange);
            let off = (one.value - other.value).abs();
            assert!(off <= one.error + other.error, "{name}, {i} {j}: {off:e}");
        }
    }
}

#[test]
fn occluded_scenes_are_the_same_on_any_number_of_threads() {
    let scene = two_boxes();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| {
            let pairs = ScenePairs::try_new(&scene, 1e-4, Congruence::Shared, Occlusion::Exact);
            let pairs = pairs.unwrap();
            let sums = pairs.row_sums(|_, _, exchange| [exchange.value, exchange.error]);
            (pairs.exchange_areas().unwrap(), sums.unwrap())
        })
    };
    let [one, two] = [1, 2].map(on);
    assert_eq!(one.0, two.0);
    assert_eq!(one.1, two.1);
    assert_eq!(one.0.summary(), &one.1.1);
}

/// `A_ij` as if nothing were in the way, less what is left, is at most what is said to be ignored.
#[test]
fn what_is_ignored_is_bounded() {
    let scene = room_table();
    let bare = pairs(&scene, Congruence::Shared, Occlusion::Ignore);
    let bare = bare.exchange_areas().unwrap();
    let past = exact(&scene);
    let ignored = bare.summary().plan.ignored.unwrap();
    assert_eq!(bare.summary().plan.occlusion, None);
    assert_eq!(past.summary().plan.ignored, None);
    let counts = past.summary().plan.occlusion.unwrap();
    assert_eq!(ignored.pairs, counts.partial + counts.hidden);
    let all = (0..past.rows()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let excess: f64 = all
        .map(|(i, j)| {
            let [bare, past] = [&bare, &past].map(|areas| areas.get(i, j).exchange.value);
            bare - past
        })
        .sum();
    assert!(
        excess > 1.0 && excess <= ignored.exchange_area,
        "{excess} {ignored:?}"
    );
    // where nothing can be in the way nothing is counted
    let cube = pairs(
        &Scene::built_in("cube:2").unwrap(),
        Congruence::Shared,
        Occlusion::Exact,
    );
    let plan = cube.exchange_areas().unwrap().summary().plan.clone();
    assert_eq!((plan.occlusion, plan.ignored), (None, None));
}
