//! Whatever stands between two patches is found, and nothing else is.

use crate::support::rooms::{
    L, among, any_polygon, blocked, level, mapped, mapped_patch, placing, polygon, prism, squares,
};
use glam::DVec3;
use infoscene::geometry::{Outline, Patch, Plane, Shaft, SplitAxis};
use infoscene::numeric::tolerance;
use infoscene::scene::{Blocker, Blockers, NamedPatch, Obstacle, Scene, SceneError};
use proptest::prelude::*;
use rand::{Rng, SeedableRng};

/// A square cut into n × n, by lines that are multiples of 0.1 if n is 10.
fn floor(n: u32) -> Vec<[f64; 2]> {
    let line = |k: u32| f64::from(k) * (1.0 / f64::from(n));
    (0..n).map(|k| [line(k), line(k + 1)]).collect()
}

/// A convex room: every plane has the room on one side.
#[test]
fn convex_rooms_have_no_blocker() {
    for cells in [1, 2, 3, 5, 7, 10, 32] {
        let cube = Scene::built_in(&format!("cube:{cells}")).unwrap();
        assert_eq!(cube.blocker(), None, "cube:{cells}");
    }
    let box_ = Scene::inside_of_box(0.1, 0.7, 1e-3).unwrap();
    assert_eq!(box_.blocker(), None);
    let apexes = [[0.0; 3], [1.0, 0.0, 0.0], [0.1, 0.9, 0.0], [0.3, 0.3, 0.7]];
    let faces = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let tetrahedron = faces.map(|face| polygon("face", &face.map(|k| apexes[k])));
    assert_eq!(blocked(&tetrahedron, &[]), None);
    let round: Vec<[f64; 2]> = (0..40)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 40.0)
        .map(|angle| [angle.cos(), angle.sin()])
        .collect();
    assert_eq!(prism(&round).blocker(), None);
}

/// Walls whose lines are multiples of 0.1, which no double is: neighbours overlap and gape by ε.
#[test]
fn a_room_on_a_grid_of_tenths_has_no_blocker() {
    let lines = floor(10);
    let cells = || {
        lines
            .iter()
            .flat_map(|x| lines.iter().map(move |y| (*x, *y)))
    };
    let mut patches: Vec<NamedPatch> = cells()
        .flat_map(|(x, y)| {
            [
                level("floor", x, y, 0.1 + 0.2, true),
                level("ceiling", x, y, 1.3, false),
            ]
        })
        .collect();
    patches.extend(cells().map(|(y, z)| {
        let z = z.map(|z| z + (0.1 + 0.2));
        let wall = [
            [0.0, y[0], z[0]],
            [0.0, y[1], z[0]],
            [0.0, y[1], z[1]],
            [0.0, y[0], z[1]],
        ];
        polygon("wall", &wall)
    }));
    assert_eq!(blocked(&patches, &[]), None);
}

proptest! {
    /// Turned, sized and shifted rooms, whose corners are off by some ε of their coordinates.
    #[test]
    fn rotated_rooms_have_no_blocker((turn, size, shift) in placing(), cells in 1..9u32) {
        let place = |corner: DVec3| turn * corner * size + shift;
        let cube = Scene::built_in(&format!("cube:{cells}")).unwrap();
        prop_assert_eq!(mapped(&cube, place).blocker(), None);
    }

    /// Rooms with patches outside that see nothing, but put every wall's plane between patches,
    /// so that no wall is settled by its plane alone.
    #[test]
    fn rotated_rooms_among_others_have_no_blocker(
        (turn, size, shift) in placing(),
        cells in 1..4u32,
    ) {
        let mut patches = Scene::built_in(&format!("cube:{cells}"))
            .unwrap()
            .patches()
            .to_vec();
        patches.push(level("above", [0.2, 0.7], [0.1, 0.8], 1.5, true));
        patches.push(level("below", [0.2, 0.7], [0.1, 0.8], -0.5, false));
        let scene = Scene::try_new(patches).unwrap();
        prop_assert_eq!(
            mapped(&scene, |corner| turn * corner * size + shift).blocker(),
            None
        );
    }

    /// Any three patches of a turned room, each in the plane that its own few corners give, at the
    /// noise of the coordinates alone.
    #[test]
    fn patches_of_a_rotated_room_only_touch((turn, size, shift) in placing(), seed: u64) {
        let cube = Scene::built_in("cube:8").unwrap();
        let room = mapped(&cube, |corner| turn * corner * size + shift);
        let corners = room
            .patches()
            .iter()
            .flat_map(|patch| patch.shape().corners());
        let largest = corners
            .map(|corner| corner.abs().max_element())
            .fold(0.0, f64::max);
        let unit = largest.log2().floor().exp2();
        let noise = tolerance::TOUCHING * largest / unit;
        let outlines: Vec<Outline> = room
            .patches()
            .iter()
            .map(|patch| outline(patch.shape(), unit))
            .collect();
        let mut dice = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        for _ in 0..2000 {
            let [i, j, k] = [(); 3].map(|()| dice.random_range(0..outlines.len()));
            if let Some(shaft) = Shaft::between(&outlines[i], &outlines[j], noise) {
                prop_assert!(
                    k == i || k == j || !shaft.is_entered_by(&outlines[k]),
                    "{} {} {}",
                    i,
                    j,
                    k
                );
            }
        }
    }

    /// Whenever a segment between inner points of two patches that see each other crosses a third,
    /// the third is among the pair's obstacles, the pair is blocked, and so is the scene, by a pair
    /// and a surface that come no later.
    #[test]
    fn what_a_segment_hits_is_blocked(
        patches in proptest::collection::vec(any_polygon(), 3..7),
        seed: u64,
    ) {
        let mut dice = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let (seen, obstructions) = patches.split_at(patches.len() - 1);
        let scene = among(seen, obstructions);
        let search = Blockers::of(&scene);
        for _ in 0..300 {
            let [i, j] = [(); 2].map(|()| dice.random_range(0..seen.len()));
            let Some(hit) = (i != j)
                .then(|| sampled_hit(&patches, i, j, &mut dice))
                .flatten()
            else {
                continue;
            };
            let pair = search.of_pair(i, j);
            prop_assert!(pair.is_some(), "{} and {} by {}", i, j, hit);
            prop_assert!(surface(pair.unwrap().obstacle, seen.len()) <= hit);
            let all: Vec<usize> = search
                .obstacles(i, j)
                .map(|o| surface(o, seen.len()))
                .collect();
            prop_assert!(
                all.is_sorted() && all.contains(&hit),
                "{} and {} by {}: {:?}",
                i,
                j,
                hit,
                all
            );
            prop_assert!(search.of_row(i).is_some_and(|row| row.second <= j));
            let first = search.first();
            prop_assert!(
                first.is_some_and(|first| (first.first, first.second) <= (i.min(j), i.max(j)))
            );
        }
    }

    /// The answer is the same on one thread and on several, in any unit.
    #[test]
    fn the_first_blocker_is_the_same_for_any_threads_and_unit(
        patches in proptest::collection::vec(any_polygon(), 24),
        power in -490..490i32,
    ) {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| blocked(&patches, &[]))
        };
        prop_assert_eq!(on(1), on(3));
        let scale = 2f64.powi(power);
        let scaled: Vec<NamedPatch> = patches
            .iter()
            .map(|patch| mapped_patch(patch, |corner| corner * scale))
            .collect();
        prop_assert_eq!(blocked(&scaled, &[]), on(1));
    }
}

fn outline(patch: &Patch, unit: f64) -> Outline {
    let plane = Plane::new(patch.normal(), patch.corners()[0] / unit);
    Outline::new(patch, unit, plane)
}

fn surface(obstacle: Obstacle, patches: usize) -> usize {
    match obstacle {
        Obstacle::Patch(index) => index,
        Obstacle::Obstruction(index) => patches + index,
    }
}

/// The first polygon that a random segment from i to j crosses, if both of its ends see each other.
fn sampled_hit(patches: &[NamedPatch], i: usize, j: usize, dice: &mut impl Rng) -> Option<usize> {
    let [from, to] = [i, j].map(|k| inner_point(patches[k].shape(), dice));
    let along = to - from;
    let sees = along.dot(patches[i].shape().normal()) > 1e-9
        && along.dot(patches[j].shape().normal()) < -1e-9;
    let crosses = |k: usize| {
        let shape = patches[k].shape();
        let [before, after] = [from, to].map(|p| (p - shape.corners()[0]).dot(shape.normal()));
        if before * after >= 0.0 {
            return false;
        }
        let at = from + along * (before / (before - after));
        is_inside(shape, at)
    };
    let others = (0..patches.len()).filter(|k| *k != i && *k != j);
    sees.then(|| others.into_iter().find(|k| crosses(*k)))
        .flatten()
}

/// A point of a polygon, uniform in its bounding parallelogram and kept if inside.
fn inner_point(shape: &Patch, dice: &mut impl Rng) -> DVec3 {
    let corners = shape.corners();
    let (origin, u) = (corners[0], corners[1] - corners[0]);
    let v = corners[corners.len() - 1] - corners[0];
    loop {
        let point = origin + u * dice.random::<f64>() + v * dice.random::<f64>();
        if is_inside(shape, point) {
            return point;
        }
    }
}

/// The angle under which the outline is seen from a point of its plane is 2π inside and 0 outside.
fn is_inside(shape: &Patch, point: DVec3) -> bool {
    let corners = shape.corners();
    let angle = |k: usize| {
        let [a, b] = [corners[k] - point, corners[(k + 1) % corners.len()] - point];
        a.cross(b).dot(shape.normal()).atan2(a.dot(b))
    };
    (0..corners.len()).map(angle).sum::<f64>() > std::f64::consts::PI
}

/// `MayBeBlocked` names pair, blocker and mend.
#[test]
fn a_blocked_scene_is_refused_by_name() {
    let mut patches = squares();
    patches.push(level("screen", [0.2, 0.4], [0.2, 0.4], 0.5, true));
    let fin = level("fin", [0.6, 0.8], [0.6, 0.8], 0.25, true);
    let scene = among(&patches, &[fin]);
    let refusal = scene.check_unblocked().unwrap_err();
    assert!(matches!(
        refusal,
        SceneError::MayBeBlocked {
            first: 0,
            second: 1,
            obstacle: Obstacle::Patch(2),
            ..
        }
    ));
    let text = refusal.to_string();
    for part in ["patches 0 and 1", "patch 2 (screen)", "unoccluded values"] {
        assert!(text.contains(part), "{text}");
    }
    let search = Blockers::of(&scene);
    let of = |first, second| {
        let found = search.of_pair(first, second);
        found.map(|b| (b.first, b.second))
    };
    assert_eq!(of(0, 1), Some((0, 1)));
    assert_eq!(of(1, 0), Some((1, 0)));
    assert_eq!(of(0, 0), None);
    assert_eq!(of(1, 2), None);
    let all: Vec<Obstacle> = search.obstacles(1, 0).collect();
    assert_eq!(all, [Obstacle::Patch(2), Obstacle::Obstruction(0)]);
    assert_eq!(search.obstacles(1, 2).next(), None);
    assert_eq!(search.of_row(1).map(|b| b.second), Some(0));
    assert_eq!(search.of_row(2), None);
    assert_eq!(Scene::built_in("cube:2").unwrap().check_unblocked(), Ok(()));
}

/// A scene keeps what it has found of its surfaces; with other surfaces it is asked anew.
#[test]
fn surfaces_that_are_changed_later_are_seen() {
    let empty = Scene::try_new(squares()).unwrap();
    assert_eq!((empty.blocker(), empty.overlap()), (None, None));
    let screen = level("screen", [0.2, 0.4], [0.2, 0.4], 0.5, true);
    let blocked = empty.clone().with_obstructions(vec![screen]);
    let found = blocked.blocker().map(|found| found.obstacle);
    assert_eq!(found, Some(Obstacle::Obstruction(0)));
    let cut = blocked.with_patch_split(0, SplitAxis::U, 0.3).unwrap();
    assert_eq!(cut.overlap(), None);
    let found = Blockers::of(&cut).of_pair(1, 2).map(|found| found.second);
    assert_eq!(found, Some(2));
    assert_eq!(cut.with_obstructions(Vec::new()).blocker(), None);
}

/// The ends of an L's arms do not see each other fully; the walls of the corner stand between.
#[test]
fn an_l_shaped_room_has_a_blocker() {
    let room = prism(&L);
    // the floor is one concave patch, and the ceiling another: from one arm to the other the
    // corner's walls are between
    let Blocker {
        first,
        second,
        name,
        ..
    } = room.blocker().unwrap();
    assert_eq!((first, second, name.as_str()), (0, 1, "wall 2"));
    // the ends of the arms: walls 1 (x = 2) and 4 (y = 2) are patches 3 and 6
    let search = Blockers::of(&room);
    let obstacle = search.of_pair(3, 6).unwrap().obstacle;
    assert_eq!(obstacle, Obstacle::Patch(4));
    // within one arm nothing is between: walls 0 and 2 (y = 0 and y = 1, 1 ≤ x ≤ 2)
    assert_eq!(search.of_pair(2, 4), None);
}

/// Several threads reach the last rows before the first are done: still the first
/// blocked pair is named.
#[test]
fn the_first_blocked_pair_is_named_whichever_is_found_first() {
    let away = level("away", [50.0, 51.0], [0.0, 1.0], -50.0, false);
    let tower = |x: f64| {
        [(0.0, true), (1.0, false)].map(|(z, up)| level("tower", [x, x + 1.0], [0.0, 1.0], z, up))
    };
    let mut patches = vec![away; 300];
    patches.extend(tower(0.0));
    patches.extend(tower(0.1));
    patches.extend_from_within(..300);
    let screen = level("screen", [-9.0, 9.0], [-9.0, 9.0], 0.5, true);
    for _ in 0..20 {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(2)
            .build()
            .unwrap();
        let first = pool.install(|| blocked(&patches, std::slice::from_ref(&screen)));
        assert_eq!(first, Some((300, 301, Obstacle::Obstruction(0))));
    }
}
