//! Scenes are evaluated past as few screens as will do, and groups of pairs are left out at once:
//! every answer is judged by its pair past all surfaces, each as it stands in the scene.

use crate::support::furnished::{shelf, standing, table};
use crate::support::rooms::{among, level};
use crate::support::streets::{Street, cut};
use glam::DVec3;
use infoscene::exchange::{Closure, Congruence, ExchangeAreas, OcclusionCounts, ScenePairs};
use infoscene::form_factor::{Occluders, Polygon, Route};
use infoscene::scene::{Blockers, NamedPatch, Obstacle, Occlusion, Scene};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const STREET: Street = Street {
    rows: 2,
    blocks: 3,
    facets: [2, 2],
    gap: 4.0,
    back: 0.5,
};

const TOLERANCE: f64 = 1e-9;

fn exact(scene: &Scene, congruence: Congruence) -> ExchangeAreas {
    let pairs = ScenePairs::try_new(scene, TOLERANCE, congruence, Occlusion::Exact).unwrap();
    pairs.exchange_areas().unwrap()
}

/// Every `stride`th pair against the same past all surfaces that enter its shaft.
fn judged(name: &str, scene: &Scene, stride: usize) -> OcclusionCounts {
    let exchange = exact(scene, Congruence::Shared);
    let blockers = Blockers::of(scene);
    let surface = |obstacle: Obstacle| match obstacle {
        Obstacle::Patch(index) => Polygon::new(scene.patches()[index].shape()),
        Obstacle::Obstruction(index) => Polygon::new(scene.obstructions()[index].shape()),
    };
    let polygon = |index: usize| Polygon::new(scene.patches()[index].shape());
    let n = exchange.rows();
    let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
    let (mut partial, mut wide) = (0, 0);
    for (i, j) in pairs.step_by(stride) {
        let found = exchange.get(i, j);
        if matches!(found.route, Route::BackFacing | Route::Coplanar) {
            continue;
        }
        let between: Vec<Polygon> = blockers.obstacles(i, j).map(surface).collect();
        let polygons: Vec<&Polygon> = between.iter().collect();
        let occluders = Occluders {
            polygons: &polygons,
            touching: scene.noise_length(),
        };
        let past = polygon(i).exchange_area_past(&polygon(j), &occluders, TOLERANCE);
        let (past, found_exchange) = (past.unwrap().exchange, found.exchange);
        let off = (past.value - found_exchange.value).abs();
        let bound = past.error + found_exchange.error;
        assert!(off <= bound, "{name}, {i} {j}: {off:e} {past:?} {found:?}");
        if found.route == Route::Occluded {
            partial += 1;
            let bare = polygon(i).exchange_area(&polygon(j), TOLERANCE);
            let bare = bare.unwrap().exchange;
            assert!(
                found_exchange.error <= bare.value + 2.0 * bare.error,
                "{name}, {i} {j}: {found:?}"
            );
            // an answer that says nothing is within any bound; past a gap of 1e-9 bounds say little
            wide += usize::from(found_exchange.error > (1e-6 * found_exchange.value).max(1e-12));
        }
        if found.route == Route::Hidden {
            assert_unlit(name, scene, [i, j]);
        }
    }
    assert!(
        name == "a gap" || 10 * wide <= partial,
        "{name}: {wide} of {partial} bounds are wide"
    );
    exchange.summary().plan.occlusion.unwrap()
}

/// No random segment between two patches that see nothing of each other misses all surfaces.
fn assert_unlit(name: &str, scene: &Scene, ends: [usize; 2]) {
    let mut dice = ChaCha8Rng::seed_from_u64(19);
    let shapes = ends.map(|end| scene.patches()[end].shape());
    let mut draw = |k: usize| {
        let corners = shapes[k].corners();
        let (u, v) = (
            corners[1] - corners[0],
            corners[corners.len() - 1] - corners[0],
        );
        corners[0] + u * dice.random::<f64>() + v * dice.random::<f64>()
    };
    for _ in 0..20 {
        let [from, to] = [draw(0), draw(1)];
        let is_facing =
            (to - from).dot(shapes[0].normal()) > 0.0 && (from - to).dot(shapes[1].normal()) > 0.0;
        let surfaces = scene.patches().iter().chain(scene.obstructions());
        let is_lit = !surfaces
            .into_iter()
            .any(|surface| is_cut(surface, from, to));
        assert!(!is_facing || !is_lit, "{name}, {ends:?}: {from} {to}");
    }
}

/// Whether a segment crosses a parallelogram.
fn is_cut(surface: &NamedPatch, from: DVec3, to: DVec3) -> bool {
    let corners = surface.shape().corners();
    let normal = surface.shape().normal();
    let [above, below] = [from, to].map(|end| (end - corners[0]).dot(normal));
    if above * below >= 0.0 {
        return false;
    }
    let met = from.lerp(to, above / (above - below)) - corners[0];
    let (u, v) = (
        corners[1] - corners[0],
        corners[corners.len() - 1] - corners[0],
    );
    let [s, t] = [u, v].map(|edge| met.dot(edge) / edge.length_squared());
    (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t)
}

fn scene(patches: Vec<NamedPatch>) -> Scene {
    Scene::try_new(patches).unwrap()
}

#[test]
fn a_street_is_what_its_pairs_are_past_all_surfaces() {
    let counts = judged("street", &scene(STREET.patches()), 5);
    assert!(counts.hidden > 50 && counts.partial > 100, "{counts:?}");
}

/// Blocks that touch, that leave a gap of 1e-9, that touch along an edge only, and that are flush.
#[test]
fn blocks_that_nearly_touch_neither_leak_nor_hide_too_much() {
    for (name, rows, gap, back) in [
        ("touching", 2, 0.0, 0.5),
        ("a gap", 2, 1e-9, 0.5),
        ("an edge", 1, 0.0, 8.0),
        ("flush", 2, 0.0, 0.0),
    ] {
        let street = Street {
            rows,
            blocks: 2,
            facets: [1, 2],
            gap,
            back,
        };
        let counts = judged(name, &scene(street.patches()), 3);
        // past an edge that two blocks share nothing is seen that they would hide
        assert_eq!(counts.partial > 0, name != "an edge", "{name}: {counts:?}");
    }
}

/// A facade with a window: eight of nine facets, through which a wall behind is seen.
#[test]
fn a_facade_with_a_window_lets_through_what_the_window_does() {
    let plate = level("facade", [0.0, 3.0], [0.0, 3.0], 1.0, true);
    let mut facets = cut(&plate, [3, 3]);
    facets.remove(4);
    let floor = level("floor", [0.0, 3.0], [0.0, 3.0], 0.0, true);
    let mut patches = cut(&floor, [2, 2]);
    patches.extend(cut(
        &level("ceiling", [0.0, 3.0], [0.0, 3.0], 2.0, false),
        [2, 2],
    ));
    let open = among(&patches, &facets);
    let counts = judged("window", &open, 1);
    assert_eq!((counts.hidden, counts.partial), (0, 16));
    // the window closed: nothing is left
    let closed = among(&patches, &cut(&plate, [3, 3]));
    let counts = judged("no window", &closed, 1);
    assert_eq!((counts.hidden, counts.partial), (16, 0));
}

/// Facets whose planes hold the edge of a roof, and an obstruction that is one sheet of several.
#[test]
fn facets_flush_with_a_roof_and_obstructions_in_pieces_are_seen_past() {
    let mut patches = cut(&level("floor", [0.0, 8.0], [0.0, 8.0], 0.0, true), [2, 2]);
    patches.extend(standing("block", [3.0, 5.0], [3.0, 5.0], [0.0, 2.0]));
    // at the height of the roof, and with its edge in their plane
    patches.push(level("ledge", [6.0, 8.0], [3.0, 5.0], 2.0, false));
    patches.push(level("ceiling", [0.0, 8.0], [0.0, 8.0], 4.0, false));
    let sheet = level("sheet", [1.0, 4.0], [1.0, 7.0], 3.0, true);
    let counts = judged("ledge", &among(&patches, &cut(&sheet, [3, 3])), 1);
    assert!(counts.partial > 10, "{counts:?}");
}

/// What lies in the side that a solid is open on, and looks away from it, is not hidden by it.
#[test]
fn a_solid_hides_nothing_from_what_lies_under_it() {
    let mut patches = cut(&level("floor", [0.0, 8.0], [0.0, 8.0], 0.0, true), [2, 2]);
    patches.extend(standing("block", [3.0, 5.0], [3.0, 5.0], [1.0, 2.0]));
    // one under all of the block, one under a part
    for under in [[2.0, 6.0], [3.0, 4.0]] {
        let mut all = patches.clone();
        all.push(level("under", under, under, 1.0, false));
        judged("under", &scene(all), 1);
    }
    judged("table", &table(), 3);
}

/// `Σ_j F_ij = 1` where walls are cut into facets, and screens put together again.
#[test]
fn a_room_in_facets_is_closed() {
    let (scene, _) = shelf().subdivided(1).unwrap();
    let exchange = exact(&scene, Congruence::Shared);
    for row in Closure::of_held(&exchange).rows() {
        let off = (row.sum - 1.0).abs();
        assert!(
            off <= row.tolerance() && row.tolerance() <= 1e-7,
            "{off:e} {row:?}"
        );
    }
}

/// Congruent configurations have one value to the last bit; each on its own, the same within the
/// bounds.
#[test]
fn congruent_pairs_past_congruent_screens_share_a_value() {
    // heights and setbacks come again after fifteen blocks
    let street = Street {
        rows: 1,
        blocks: 20,
        facets: [1, 1],
        ..STREET
    };
    let scene = scene(street.patches());
    let (shared, alone) = (
        exact(&scene, Congruence::Shared),
        exact(&scene, Congruence::Ignored),
    );
    let mut alike = 0;
    for (i, j) in (0..25).flat_map(|i| (0..i).map(move |j| (i, j))) {
        let [one, other] = [shared.get(i, j), shared.get(i + 75, j + 75)];
        assert_eq!(one.route, other.route, "{i} {j}");
        if one.route == Route::Occluded {
            assert_eq!(one, other, "{i} {j}");
            alike += 1;
        }
        let own = alone.get(i, j).exchange;
        let off = (own.value - one.exchange.value).abs();
        assert!(off <= own.error + one.exchange.error, "{i} {j}: {off:e}");
    }
    assert!(alike > 0);
}
