//! Pairs that a plan leaves out and shares: known by counting, and without a change of any value
//! beyond its bound.

use crate::support::rooms::{mapped, placing};
use glam::DVec3;
use infoscene::exchange::{Congruence, PassSummary, PlanSummary, ScenePairs, Selection};
use infoscene::geometry::Patch;
use infoscene::scene::{NamedPatch, Occlusion, Scene};
use proptest::prelude::*;

/// Reached by every route.
const TOLERANCE: f64 = 1e-6;

/// A plan is of planes and shapes, whatever stands in the way.
fn pairs(scene: &Scene, congruence: Congruence) -> ScenePairs<'static> {
    ScenePairs::try_new(scene, TOLERANCE, congruence, Occlusion::Ignore).unwrap()
}

fn account(scene: &Scene, congruence: Congruence) -> PassSummary {
    let exchange = pairs(scene, congruence).exchange_areas().unwrap();
    exchange.summary().clone()
}

fn cube(cells: usize) -> Scene {
    Scene::built_in(&format!("cube:{cells}")).unwrap()
}

fn rectangle(origin: DVec3, u: DVec3, v: DVec3) -> NamedPatch {
    let corners = vec![origin, origin + u, origin + u + v, origin + v];
    NamedPatch::new("rectangle".to_owned(), Patch::try_new(corners).unwrap())
}

/// The floor and a wall of a room whose grid lines are given, moved.
fn floor_and_wall(lines: &[f64], at: DVec3) -> Scene {
    let mut patches = Vec::new();
    for x in lines.windows(2) {
        for y in lines.windows(2) {
            let corner = |a: f64, b: f64| at + DVec3::new(a, b, 0.0);
            let (low, high) = (corner(x[0], y[0]), corner(x[1], y[1]));
            let (dx, dy) = (high.x - low.x, high.y - low.y);
            patches.push(rectangle(low, DVec3::X * dx, DVec3::Y * dy));
            let wall = at + DVec3::new(0.0, x[0], y[0]);
            let dy = (at.y + x[1]) - wall.y;
            let dz = (at.z + y[1]) - wall.z;
            patches.push(rectangle(wall, DVec3::Y * dy, DVec3::Z * dz));
        }
    }
    Scene::try_new(patches).unwrap()
}

/// N × N cells on six faces: n = 6 N²; 6 · N²(N² − 1)/2 pairs in one plane; 3 N⁴ parallel pairs
/// with offsets |Δu| ≤ |Δv| < N, that is N(N + 1)/2 of them different; 12 N⁴ perpendicular ones
/// with N offsets along the common edge and N(N + 1)/2 pairs of depths. Lines are exact where N is
/// a power of two, so that all congruent pairs share.
#[test]
fn the_plan_of_a_cube_is_known_by_counting() {
    for cells in [1, 2, 4, 8] {
        let squared: usize = cells * cells;
        let half = cells * (cells + 1) / 2;
        let summary = account(&cube(cells), Congruence::Shared).plan;
        let pairs = 6 * squared * (6 * squared - 1) / 2;
        let coplanar = 3 * squared * (squared - 1);
        let computed = half + cells * half;
        assert_eq!(
            (summary.pairs, summary.reciprocal, summary.planes),
            (pairs, pairs, 6)
        );
        assert_eq!((summary.untouched, summary.coplanar), (coplanar, coplanar));
        assert_eq!((summary.computed, summary.back_facing), (computed, 0));
        assert_eq!(summary.congruent, 15 * squared * squared - computed);
        assert_counted_once(&summary);
        let summary = account(&cube(cells), Congruence::Ignored).plan;
        assert_eq!(
            (summary.computed, summary.congruent),
            (15 * squared * squared, 0)
        );
        assert_counted_once(&summary);
    }
}

/// Lines at thirds are rounded, the pairs congruent within some 1e-16: they share at 1e-6 and at
/// 1e-12, and not at 1e-16.
#[test]
fn rounded_lines_share_within_the_tolerance() {
    let scene = cube(3);
    let computed = |tolerance: f64| {
        let pairs =
            ScenePairs::try_new(&scene, tolerance, Congruence::Shared, Occlusion::Refuse).unwrap();
        pairs.exchange_areas().unwrap().summary().plan.computed
    };
    assert_eq!(computed(1e-6), 6 + 3 * 6);
    // near pairs do not: the bound on what their corners' rounding does is cruder there
    assert!((6 + 3 * 6..1215 / 2).contains(&computed(1e-12)));
    assert_eq!(computed(1e-16), 15 * 81);
}

/// Every pair is counted once: pairs = untouched + congruent + computed = Σ routes.
fn assert_counted_once(summary: &PlanSummary) {
    let parts = summary.untouched + summary.congruent + summary.computed;
    assert_eq!(parts, summary.pairs);
    assert_eq!(summary.routes.values().sum::<usize>(), summary.pairs);
}

/// Back to back, in one plane, and facing each other.
#[test]
fn planes_that_see_nothing_are_not_looked_at() {
    for (distance, counts) in [(-1.0, [1, 0, 1]), (0.0, [1, 1, 0]), (1.0, [0, 0, 0])] {
        let summary = account(
            &Scene::facing_squares(distance).unwrap(),
            Congruence::Shared,
        )
        .plan;
        let found = [summary.untouched, summary.coplanar, summary.back_facing];
        assert_eq!((found, summary.planes), (counts, 2), "{distance}");
        assert_counted_once(&summary);
    }
    // the walls of a table's top and bottom: all of a room's floor is behind the top
    let mut patches = floor_and_wall(&[0.0, 0.5, 1.0], DVec3::ZERO)
        .patches()
        .to_vec();
    patches.push(rectangle(
        DVec3::new(0.2, 0.2, 0.5),
        DVec3::X * 0.3,
        DVec3::Y * 0.3,
    ));
    let summary = account(&Scene::try_new(patches).unwrap(), Congruence::Shared).plan;
    // six pairs in the floor, six in the wall; the floor's four patches behind the table, and,
    // found by looking, the lower two of the wall
    assert_eq!(
        (summary.coplanar, summary.back_facing, summary.untouched),
        (12, 6, 16)
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The walls of a turned cube are six planes, however many patches they are divided into: all
    /// pairs in one wall are left out, 6 · N²(N² − 1)/2.
    #[test]
    fn the_walls_of_a_turned_room_are_one_plane_each(
        (turn, size, shift) in placing(),
        cells in 1..7usize,
    ) {
        let turned = mapped(&cube(cells), |corner| turn * corner * size + shift);
        let pairs =
            ScenePairs::try_new(&turned, 0.5, Congruence::Ignored, Occlusion::Ignore).unwrap();
        let plan = pairs.entries(&Selection::default()).unwrap().1.plan;
        let coplanar = 3 * cells * cells * (cells * cells - 1);
        prop_assert_eq!(
            (plan.planes, plan.untouched, plan.coplanar),
            (6, coplanar, coplanar)
        );
    }
}

/// A value shared and the same computed differ by less than their bounds, which the rounding of
/// lines widens: far from the origin coordinates are rounded to 1e-13.
#[test]
fn congruence_changes_no_value_beyond_its_bound() {
    let lines = [0.0, 0.1, 0.2, 0.3, 0.7, 1.0];
    let far = DVec3::new(1000.1, 700.3, -300.7);
    let scenes = [
        cube(2),
        cube(3),
        floor_and_wall(&lines, DVec3::ZERO),
        floor_and_wall(&lines, far),
    ];
    for (index, scene) in scenes.iter().enumerate() {
        let exchange = |congruence| {
            let pairs = ScenePairs::try_new(scene, 1e-9, congruence, Occlusion::Refuse).unwrap();
            pairs.exchange_areas().unwrap()
        };
        let (shared, apart) = (exchange(Congruence::Shared), exchange(Congruence::Ignored));
        let congruent = shared.summary().plan.congruent;
        assert!(congruent > 0, "{index}: nothing is shared");
        let n = scene.patches().len();
        for i in 0..n {
            for j in 0..i {
                let (one, other) = (shared.get(i, j).exchange, apart.get(i, j).exchange);
                let difference = (one.value - other.value).abs();
                let bounds = one.error + other.error;
                assert!(
                    difference <= bounds,
                    "{index}: {i} {j} {difference} {bounds}"
                );
            }
        }
    }
}

/// Negative control: sizes that differ by 1e-9 do not share.
#[test]
fn nearly_congruent_pairs_do_not_share() {
    let even = account(
        &floor_and_wall(&[0.0, 0.5, 1.0], DVec3::ZERO),
        Congruence::Shared,
    )
    .plan;
    let uneven = floor_and_wall(&[0.0, 0.5 + 1e-9, 1.0], DVec3::ZERO);
    let uneven = account(&uneven, Congruence::Shared).plan;
    // of 16 pairs: 3 pairs of depths and 2 offsets; else 4 pairs of depths, 4 pairs of spans
    assert_eq!((even.computed, uneven.computed), (6, 10));
}

/// One value per pair: `A_i F_ij = A_j F_ji` to the last bit, shared or not, in a row, in the
/// matrix, and alone.
#[test]
fn reciprocity_is_exact() {
    for congruence in [Congruence::Shared, Congruence::Ignored] {
        let pairs = pairs(&cube(3), congruence);
        let held = pairs.exchange_areas().unwrap();
        let account = pairs
            .for_each_row(|i, row| -> Result<(), infoscene::exchange::ExchangeError> {
                for (j, answer) in row.iter().enumerate() {
                    assert_eq!(*answer, pairs.row_pair(j, i)?);
                    assert_eq!(answer.exchange, held.get(j, i).exchange);
                    // 0 ≤ F ≤ 1
                    let most = pairs.areas()[i].min(pairs.areas()[j]);
                    assert!((0.0..=most).contains(&answer.exchange.value));
                }
                Ok(())
            })
            .unwrap();
        assert_eq!(&account, held.summary());
        let (entries, account) = pairs.entries(&Selection::default()).unwrap();
        assert_eq!(&account, held.summary());
        assert_eq!(entries.len(), 54 * 53);
    }
}
