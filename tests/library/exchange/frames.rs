//! Congruent pairs along turned axes: known by counting, and equal within their bounds.

use crate::support::rooms::{mapped, placing, polygon, tiled_box};
use glam::{DQuat, DVec3};
use infoscene::exchange::{Congruence, ExchangeAreas, ScenePairs};
use infoscene::scene::{NamedPatch, Occlusion, Scene};
use proptest::prelude::*;

/// Turns about no symmetric axes.
pub(super) fn turns() -> [DQuat; 3] {
    let about =
        |axis: [f64; 3], angle| DQuat::from_axis_angle(DVec3::from_array(axis).normalize(), angle);
    [
        about([0.3, -0.7, 0.5], 1.1),
        about([0.0, 0.0, 1.0], 0.4),
        about([-0.9, 0.2, 0.1], 2.6),
    ]
}

fn cube(cells: usize) -> Scene {
    Scene::built_in(&format!("cube:{cells}")).unwrap()
}

pub(super) fn exchange(scene: &Scene, tolerance: f64, congruence: Congruence) -> ExchangeAreas {
    let pairs = ScenePairs::try_new(scene, tolerance, congruence, Occlusion::Ignore).unwrap();
    pairs.exchange_areas().unwrap()
}

/// Numbers of pairs that were computed and that took the value of another.
pub(super) fn counts(scene: &Scene, tolerance: f64, congruence: Congruence) -> [usize; 2] {
    let plan = exchange(scene, tolerance, congruence)
        .summary()
        .plan
        .clone();
    assert_eq!(plan.pairs, plan.untouched + plan.congruent + plan.computed);
    [plan.computed, plan.congruent]
}

/// N × N cells on six faces have N(N + 1)/2 pairs of parallel and N · N(N + 1)/2 of perpendicular
/// cells that are not congruent (`the_plan_of_a_cube_is_known_by_counting`), whichever way the cube
/// is turned and wherever it stands.
#[test]
fn a_turned_cube_is_computed_like_a_straight_one() {
    for (turn, cells) in turns().into_iter().zip([1, 4, 7]) {
        let at = DVec3::new(3.0, -2.0, 0.5);
        let turned = mapped(&cube(cells), |corner| turn * corner + at);
        let half = cells * (cells + 1) / 2;
        let visible = 15 * cells.pow(4);
        let computed = (1 + cells) * half;
        let [shared, congruent] = counts(&turned, 1e-6, Congruence::Shared);
        assert_eq!(
            [shared, congruent],
            [computed, visible - computed],
            "{cells}"
        );
        let every = counts(&turned, 1e-6, Congruence::Ignored);
        assert_eq!(every, [visible, 0]);
    }
}

/// Unit cells in a box of edges 1, 2, 3. Parallel pairs at distance 1 have offsets below (2, 3), up
/// to an exchange of the axes 00 01 02 11 12; at distance 2 those below (3, 1), 00 01 02; at
/// distance 3 below (1, 2), 00 01: ten. Perpendicular ones with no offset along the common edge
/// have depths 00 01 02 11 12, as edges of 2 and 3 meet; with offset 1, edges of 1 and 3 or 2 meet,
/// 00 01 02; with offset 2, of 1 and 2, 00 01: ten.
#[test]
fn a_turned_box_is_known_by_counting() {
    let room = tiled_box([1.0, 2.0, 3.0], 1.0);
    for turn in turns() {
        let turned = mapped(&room, |corner| turn * corner);
        let [computed, _] = counts(&turned, 1e-6, Congruence::Shared);
        assert_eq!(computed, 20);
    }
}

/// A shared value and one computed of its own pair differ by no more than their bounds, at every
/// tolerance; near the finest values are no longer shared.
#[test]
fn turned_pairs_share_within_their_bounds() {
    let rooms = [
        (cube(4), 1.0),
        (cube(3), 40.0),
        (tiled_box([1.0, 2.0, 3.0], 2.0), 0.0),
    ];
    for ((room, far), turn) in rooms.iter().zip(turns()) {
        let turned = mapped(room, |corner| turn * (corner + DVec3::splat(*far)));
        for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
            let shared = exchange(&turned, tolerance, Congruence::Shared);
            let apart = exchange(&turned, tolerance, Congruence::Ignored);
            assert!(tolerance < 1e-6 || shared.summary().plan.congruent > 0);
            assert_agree(&shared, &apart);
        }
    }
}

/// Far from the origin corners are rounded to 1e-14, which changes exchange areas by more than the
/// closed form of a model rounds: the bound has room for it.
#[test]
fn rounded_corners_are_in_the_bound() {
    for turn in turns() {
        let turned = mapped(&cube(3), |corner| turn * (corner + DVec3::splat(40.0)));
        let shared = exchange(&turned, 1e-9, Congruence::Shared);
        let exact = exchange(&turned, 1e-14, Congruence::Ignored);
        assert_eq!(shared.summary().plan.computed, 24);
        assert_agree(&shared, &exact);
    }
}

/// Every pair of two matrices agrees within the sum of the bounds.
pub(super) fn assert_agree(shared: &ExchangeAreas, apart: &ExchangeAreas) {
    for i in 0..shared.rows() {
        for j in 0..i {
            let (one, other) = (shared.get(i, j).exchange, apart.get(i, j).exchange);
            let difference = (one.value - other.value).abs();
            let bounds = one.error + other.error;
            assert!(difference <= bounds, "{i} {j}: {difference:e} {bounds:e}");
        }
    }
}

/// At 1e-12 nearly all pairs of a turned cube share, as the rounding of its corners is felt by the
/// nearest ones at most, and every pair meets the tolerance.
#[test]
fn turned_pairs_share_at_the_finest_tolerance() {
    let turned = mapped(&cube(10), |corner| turns()[0] * corner);
    let exchange = exchange(&turned, 1e-12, Congruence::Shared);
    let summary = exchange.summary();
    let [computed, visible] = [summary.plan.computed, 15 * 10_000];
    assert!(computed < visible / 50, "{computed}");
}

/// A floor of 2 × 2 cells and a wall, turned, have 6 pairs of 16 that are not congruent
/// (`nearly_congruent_pairs_do_not_share`); two of them, differently turned, share nothing with
/// each other.
#[test]
fn differently_turned_rooms_have_frames_of_their_own() {
    let corner = tiled_box([1.0, 1.0, 1.0], 2.0);
    let is_wanted = |patch: &&NamedPatch| {
        let normal = patch.shape().normal();
        normal.x > 0.5 || normal.z > 0.5
    };
    let corner: Vec<NamedPatch> = corner.patches().iter().filter(is_wanted).cloned().collect();
    let corner = Scene::try_new(corner).unwrap();
    let [one, _, other] = turns();
    let mut patches = mapped(&corner, |c| one * c).patches().to_vec();
    let there = mapped(&corner, |c| other * c + DVec3::new(5.0, 6.0, 7.0));
    patches.extend(there.patches().iter().cloned());
    let both = Scene::try_new(patches).unwrap();
    let [shared, congruent] = counts(&both, 1e-6, Congruence::Shared);
    let [every, _] = counts(&both, 1e-6, Congruence::Ignored);
    assert_eq!((congruent, every - shared), (20, 20));
}

/// Negative control: cells that are each shorter by another millionth share nothing.
#[test]
fn jittered_cells_share_nothing() {
    let turned = mapped(&cube(3), |corner| turns()[0] * corner);
    let shorter = |(k, patch): (u32, &NamedPatch)| {
        let c = patch.shape().corners();
        let factor = 1.0 - 1e-6 * f64::from(k + 1);
        let [u, v] = [(c[1] - c[0]) * factor, c[3] - c[0]];
        let corners = [c[0], c[0] + u, c[0] + u + v, c[0] + v].map(|c| c.to_array());
        polygon(&k.to_string(), &corners)
    };
    let jittered = Scene::try_new((0..).zip(turned.patches()).map(shorter).collect()).unwrap();
    assert_eq!(counts(&turned, 1e-6, Congruence::Shared)[0], 24);
    assert_eq!(counts(&jittered, 1e-6, Congruence::Shared), [15 * 81, 0]);
}

/// Values are the same to the last bit whatever number of threads finds the classes, and in
/// whatever order pairs are asked for.
#[test]
fn shared_values_do_not_depend_on_the_order() {
    let turned = mapped(&cube(4), |corner| turns()[2] * corner);
    let pool = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let in_pool = |threads: usize| {
        pool(threads)
            .unwrap()
            .install(|| exchange(&turned, 1e-9, Congruence::Shared))
    };
    let (one, four) = (in_pool(1), in_pool(4));
    let pairs = ScenePairs::try_new(&turned, 1e-9, Congruence::Shared, Occlusion::Ignore).unwrap();
    for i in (0..one.rows()).rev() {
        for j in 0..i {
            assert_eq!(one.get(i, j), four.get(i, j));
            assert_eq!(
                one.get(i, j).exchange,
                pairs.row_pair(j, i).unwrap().exchange
            );
        }
    }
}

/// A rectangle and its mirror image on the other side of a turned wall see the wall alike: of
/// 2 + 2 + 2 patches, the images' pairs with the wall's halves are one class each.
#[test]
fn mirror_images_share() {
    let at = |x: [f64; 2], y: [f64; 2]| [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
    // the floor's halves to the left and to the right of x = 0, and shelves above them
    let level = |name: &str, corners: [[f64; 2]; 4], z: f64, up: bool| {
        let mut corners = corners.map(|[x, y]| [x, y, z]);
        if !up {
            corners.reverse();
        }
        polygon(name, &corners)
    };
    let room = Scene::try_new(vec![
        level("left", at([-2.0, 0.0], [0.0, 3.0]), 0.0, true),
        level("right", at([0.0, 2.0], [0.0, 3.0]), 0.0, true),
        level("left shelf", at([-1.7, -0.6], [0.2, 1.1]), 1.3, false),
        level("right shelf", at([0.6, 1.7], [0.2, 1.1]), 1.3, false),
        level("left lamp", at([-1.1, -0.4], [1.9, 2.4]), 2.1, false),
        level("right lamp", at([0.4, 1.1], [1.9, 2.4]), 2.1, false),
    ])
    .unwrap();
    let turned = mapped(&room, |corner| turns()[0] * corner);
    // two halves and four things above them: eight pairs, which are images of each other in twos
    assert_eq!(counts(&turned, 1e-9, Congruence::Shared), [4, 4]);
    let [shared, apart] = [Congruence::Shared, Congruence::Ignored]
        .map(|congruence| exchange(&turned, 1e-9, congruence));
    assert_agree(&shared, &apart);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The rows of a closed room sum to one, wherever it stands: within the bounds, and within what
    /// its rounded corners let through. Cracks are as wide as corners are off, `2 √3 ε` of the
    /// largest coordinate; along the outline of a cell, and of the others in proportion to what it
    /// sends there, they take less than `100` such widths per width of a cell.
    #[test]
    fn rows_of_a_turned_room_sum_to_one((turn, size, shift) in placing(), cells in 1..5usize) {
        let turned = mapped(&cube(cells), |corner| turn * corner * size + shift);
        let corners = turned.patches().iter().flat_map(|patch| patch.shape().corners());
        let largest = corners.fold(0.0_f64, |most, c| most.max(c.abs().max_element()));
        let pairs =
            ScenePairs::try_new(&turned, 1e-9, Congruence::Shared, Occlusion::Ignore).unwrap();
        let (sums, summary) =
            pairs.row_sums(|_, _, exchange| [exchange.value, exchange.error]).unwrap();
        prop_assert!(cells < 2 || summary.plan.congruent > 0);
        #[expect(clippy::cast_precision_loss, reason = "a few cells")]
        let cell = size / cells as f64;
        let cracks = 100.0 * 2.0 * 3f64.sqrt() * f64::EPSILON * largest / cell;
        for ([sum, error], area) in sums.iter().zip(pairs.areas()) {
            let off = (sum / area - 1.0).abs();
            let bound = error / area;
            prop_assert!(off <= bound + cracks + 1e-14, "{off:e} {bound:e} {cracks:e}");
        }
    }
}
