//! Whatever stands between two patches is found, and nothing else is.

use super::support::rooms::{
    L, any_polygon, facing, level, mapped, mapped_patch, placing, polygon, prism,
};
use glam::DVec3;
use infoscene::geometry::{Outline, Patch, Plane, Shaft};
use infoscene::numeric::tolerance;
use infoscene::scene::{Blocker, Blockers, NamedPatch, Obstacle, Scene, SceneError};
use proptest::prelude::*;
use rand::{Rng, SeedableRng};

fn found(patches: &[NamedPatch], obstructions: &[NamedPatch]) -> Option<(usize, usize, Obstacle)> {
    let Blocker {
        first,
        second,
        obstacle,
        ..
    } = Blockers::new(patches, obstructions).first()?;
    Some((first, second, obstacle))
}

/// Two unit squares that face each other at distance 1.
fn squares() -> Vec<NamedPatch> {
    Scene::facing_squares(1.0).unwrap().patches().to_vec()
}

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
    assert_eq!(found(&tetrahedron, &[]), None);
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
    assert_eq!(found(&patches, &[]), None);
}

proptest! {
    /// Turned, sized and shifted rooms, whose corners are off by some ε of their coordinates.
    #[test]
    fn rotated_rooms_have_no_blocker((turn, size, shift) in placing(), cells in 1..9u32) {
        let place = |corner: DVec3| turn * corner * size + shift;
        let cube = Scene::built_in(&format!("cube:{cells}")).unwrap();
        prop_assert_eq!(mapped(&cube, place).blocker(), None);
    }

    /// The same with patches outside that see nothing, but put every wall's plane between patches, so that no wall is
    /// settled by its plane alone.
    #[test]
    fn rotated_rooms_among_others_have_no_blocker((turn, size, shift) in placing(), cells in 1..4u32) {
        let mut patches = Scene::built_in(&format!("cube:{cells}")).unwrap().patches().to_vec();
        patches.push(level("above", [0.2, 0.7], [0.1, 0.8], 1.5, true));
        patches.push(level("below", [0.2, 0.7], [0.1, 0.8], -0.5, false));
        let scene = Scene::try_new(patches).unwrap();
        prop_assert_eq!(mapped(&scene, |corner| turn * corner * size + shift).blocker(), None);
    }

    /// Any three patches of a turned room, each in the plane that its own few corners give, at the noise of the
    /// coordinates alone.
    #[test]
    fn patches_of_a_rotated_room_only_touch((turn, size, shift) in placing(), seed: u64) {
        let cube = Scene::built_in("cube:8").unwrap();
        let room = mapped(&cube, |corner| turn * corner * size + shift);
        let corners = room.patches().iter().flat_map(|patch| patch.shape().corners());
        let largest = corners.map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
        let unit = largest.log2().floor().exp2();
        let noise = tolerance::TOUCHING * largest / unit;
        let outlines: Vec<Outline> = room.patches().iter().map(|patch| outline(patch.shape(), unit)).collect();
        let mut dice = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        for _ in 0..2000 {
            let [i, j, k] = [(); 3].map(|()| dice.random_range(0..outlines.len()));
            if let Some(shaft) = Shaft::between(&outlines[i], &outlines[j], noise) {
                prop_assert!(k == i || k == j || !shaft.is_entered_by(&outlines[k]), "{} {} {}", i, j, k);
            }
        }
    }

    /// Whenever a segment between inner points of two patches that see each other crosses a third, the pair is blocked,
    /// and so is the scene, by a pair and a surface that come no later.
    #[test]
    fn what_a_segment_hits_is_found(patches in proptest::collection::vec(any_polygon(), 3..7), seed: u64) {
        let mut dice = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let (seen, obstructions) = patches.split_at(patches.len() - 1);
        let search = Blockers::new(seen, obstructions);
        for _ in 0..300 {
            let [i, j] = [(); 2].map(|()| dice.random_range(0..seen.len()));
            let Some(hit) = (i != j).then(|| sampled_hit(&patches, i, j, &mut dice)).flatten() else {
                continue;
            };
            let pair = search.of_pair(i, j);
            prop_assert!(pair.is_some(), "{} and {} by {}", i, j, hit);
            prop_assert!(surface(pair.unwrap().obstacle, seen.len()) <= hit);
            prop_assert!(search.of_row(i).is_some_and(|row| row.second <= j));
            let first = search.first();
            prop_assert!(first.is_some_and(|first| (first.first, first.second) <= (i.min(j), i.max(j))));
        }
    }

    /// The same answer on one thread and on several, in any unit.
    #[test]
    fn the_first_blocker_is_the_same_for_any_threads_and_unit(
        patches in proptest::collection::vec(any_polygon(), 24),
        power in -490..490i32,
    ) {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| found(&patches, &[]))
        };
        prop_assert_eq!(on(1), on(3));
        let scale = 2f64.powi(power);
        let scaled: Vec<NamedPatch> =
            patches.iter().map(|patch| mapped_patch(patch, |corner| corner * scale)).collect();
        prop_assert_eq!(found(&scaled, &[]), on(1));
    }
}

fn outline(patch: &Patch, unit: f64) -> Outline {
    let plane = Plane {
        normal: patch.normal(),
        origin: patch.corners()[0] / unit,
    };
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

/// A screen that reaches 1e-9 into the space between two squares blocks them, one that stays 1e-9 outside does not.
#[test]
fn a_screen_is_found_to_the_billionth() {
    // the shaft of unequal squares is slanted: at half height it ends at x = 1.5
    let wide = [
        level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true),
        level("ceiling", [0.0, 2.0], [0.0, 1.0], 1.0, false),
    ];
    for (pair, end) in [(squares(), 1.0), (wide.to_vec(), 1.5)] {
        for (start, blocks) in [(end - 1e-9, true), (end, false), (end + 1e-9, false)] {
            let screen = level("screen", [start, 3.0], [0.2, 0.3], 0.5, true);
            let by = |obstacle| blocks.then_some((0, 1, obstacle));
            assert_eq!(
                found(&pair, &[screen.clone()]),
                by(Obstacle::Obstruction(0)),
                "{start}"
            );
            let mut with_patch = pair.clone();
            with_patch.push(screen);
            assert_eq!(found(&with_patch, &[]), by(Obstacle::Patch(2)), "{start}");
        }
        // an upright one, whose plane cuts the squares, and an edge only dips into the shaft's end
        for (start, blocks) in [(end - 1e-9, true), (end, false), (end + 1e-9, false)] {
            let corners = [[start, 0.5, 0.5], [3.0, 0.5, 0.4], [3.0, 0.5, 0.6]];
            let by = blocks.then_some((0, 1, Obstacle::Obstruction(0)));
            assert_eq!(found(&pair, &[polygon("fin", &corners)]), by, "{start}");
        }
    }
}

/// `MayBeBlocked` names pair, blocker and mend; indices are checked.
#[test]
fn a_blocked_scene_is_refused_by_name() {
    let mut patches = squares();
    patches.push(level("screen", [0.2, 0.4], [0.2, 0.4], 0.5, true));
    let scene = Scene::try_new(patches).unwrap();
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
    for part in ["patches 0 and 1", "patch 2 (screen)", "--unoccluded"] {
        assert!(text.contains(part), "{text}");
    }
    let of = |first, second| {
        scene
            .blocker_of(first, second)
            .unwrap()
            .map(|b| (b.first, b.second))
    };
    assert_eq!(of(0, 1), Some((0, 1)));
    assert_eq!(of(1, 0), Some((1, 0)));
    assert_eq!(of(0, 0), None);
    assert_eq!(of(1, 2), None);
    assert_eq!(scene.blocker_of_row(1).unwrap().map(|b| b.second), Some(0));
    assert_eq!(scene.blocker_of_row(2).unwrap(), None);
    let none = SceneError::NoSuchPatch { index: 3, last: 2 };
    assert_eq!(scene.blocker_of(0, 3).unwrap_err(), none);
    assert_eq!(scene.blocker_of_row(3).unwrap_err(), none);
    assert_eq!(Scene::built_in("cube:2").unwrap().check_unblocked(), Ok(()));
}

/// In an L the arms' ends do not see each other fully; the walls of the corner stand between.
#[test]
fn an_l_shaped_room_has_a_blocker() {
    let room = prism(&L);
    // the floor is one concave patch, and the ceiling another: from one arm to the other the corner's walls are between
    let Blocker {
        first,
        second,
        name,
        ..
    } = room.blocker().unwrap();
    assert_eq!((first, second, name.as_str()), (0, 1, "wall 2"));
    // the ends of the arms: walls 1 (x = 2) and 4 (y = 2) are patches 3 and 6
    assert_eq!(
        room.blocker_of(3, 6).unwrap().unwrap().obstacle,
        Obstacle::Patch(4)
    );
    // within one arm nothing is between: walls 0 and 2 (y = 0 and y = 1, 1 ≤ x ≤ 2)
    assert_eq!(room.blocker_of(2, 4).unwrap(), None);
}

/// What lies in a wall, behind it, or along the side of a shaft has points with the shaft's boundary in common only.
#[test]
fn what_only_touches_does_not_block() {
    let cube = Scene::built_in("cube:1").unwrap();
    let none = |patches: &[NamedPatch], obstruction: NamedPatch| {
        assert_eq!(
            found(patches, &[obstruction.clone()]),
            None,
            "{}",
            obstruction.name()
        );
    };
    none(
        cube.patches(),
        level("carpet", [0.2, 0.4], [0.1, 0.3], 0.0, true),
    );
    none(
        cube.patches(),
        level("underlay", [0.2, 0.4], [0.1, 0.3], 0.0, false),
    );
    none(
        cube.patches(),
        level("roof", [-1.0, 2.0], [-1.0, 2.0], 1.0, true),
    );
    none(
        cube.patches(),
        level("cellar", [-1.0, 2.0], [-1.0, 2.0], -0.1, true),
    );
    let side = [
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [1.0, 1.0, 1.0],
        [1.0, 0.0, 1.0],
    ];
    for as_given in [true, false] {
        none(&squares(), facing("curtain", side, as_given));
    }
    // its plane cuts the shaft, its edge lies in the shaft's side
    none(
        &squares(),
        level("balcony", [1.0, 2.0], [-1.0, 2.0], 0.5, true),
    );
    // control: the same obstructions a little inside
    let shelf = level("shelf", [0.2, 0.4], [0.1, 0.3], 1e-9, true);
    assert!(found(cube.patches(), &[shelf]).is_some());
    let curtain = side.map(|[x, y, z]| [x - 1e-9, y, z]);
    assert!(found(&squares(), &[polygon("curtain", &curtain)]).is_some());
}

/// A third patch in the plane of one of the pair, edge to edge, is no obstacle, and neither are the two themselves.
#[test]
fn neighbours_in_one_plane_do_not_block() {
    let mut patches = squares();
    patches.push(level("beside", [1.0, 2.0], [0.0, 1.0], 0.0, true));
    patches.push(level("beyond", [-0.3, 0.0], [0.1, 0.3], 1.0, false));
    assert_eq!(found(&patches, &[]), None);
    // around a notch
    let l = L.map(|[x, y]| [x, y, 0.0]);
    let notch = [
        polygon("l", &l),
        level("in the notch", [1.0, 2.0], [1.0, 2.0], 0.0, true),
        level("ceiling", [0.0, 2.0], [0.0, 2.0], 1.0, false),
    ];
    assert_eq!(found(&notch, &[]), None);
}

/// Between patches that exchange nothing anything may stand.
#[test]
fn pairs_that_exchange_nothing_are_not_blocked() {
    let screen = level("screen", [0.2, 0.4], [0.2, 0.4], 0.5, true);
    let away = [
        level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true),
        level("turned away", [0.0, 1.0], [0.0, 1.0], 1.0, true),
    ];
    assert_eq!(found(&away, &[screen.clone()]), None);
    let post = facing(
        "post",
        [[1.5, 0.0, 0.0], [1.5, 1.0, 0.0], [1.5, 0.5, 0.5]],
        true,
    );
    let coplanar = [
        level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true),
        level("floor", [2.0, 3.0], [0.0, 1.0], 0.0, true),
    ];
    assert_eq!(found(&coplanar, &[post]), None);
}

/// The part of a patch behind the other's plane sends nothing: what stands before that part only blocks nothing.
#[test]
fn only_the_parts_in_front_count() {
    // the wall x = 2 reaches from z = −1 to 1 and faces the floor z = 0, 0 ≤ x ≤ 1
    let wall = [
        [2.0, 0.0, -1.0],
        [2.0, 0.0, 1.0],
        [2.0, 1.0, 1.0],
        [2.0, 1.0, -1.0],
    ];
    let pair = [
        level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true),
        polygon("wall", &wall),
    ];
    let below = level("below", [1.2, 1.8], [0.2, 0.8], -0.1, true);
    let above = level("above", [1.2, 1.8], [0.2, 0.8], 0.1, true);
    assert_eq!(found(&pair, &[below.clone()]), None);
    assert_eq!(
        found(&pair, &[below, above]),
        Some((0, 1, Obstacle::Obstruction(1)))
    );
    let [floor, wall] = pair.clone();
    assert_eq!(
        found(
            &[wall, floor],
            &[level("below", [1.2, 1.8], [0.2, 0.8], -0.1, true)]
        ),
        None
    );
    // at the floor's own height: the hull of both whole patches is entered, the shaft is not
    assert_eq!(
        found(&pair, &[level("mat", [1.2, 1.8], [0.2, 0.8], 0.0, true)]),
        None
    );
}

/// A notch is a way through: the convex hull of a concave screen, or of concave patches, would refuse too much.
#[test]
fn concave_polygons_are_taken_as_they_are() {
    let u = |gap: [f64; 2]| {
        let [from, to] = gap;
        let outline = [
            [-1.0, -1.0],
            [2.0, -1.0],
            [2.0, 2.0],
            [to, 2.0],
            [to, -0.5],
            [from, -0.5],
            [from, 2.0],
            [-1.0, 2.0],
        ];
        polygon("u", &outline.map(|[x, y]| [x, y, 0.5]))
    };
    assert_eq!(found(&squares(), &[u([0.0, 1.0])]), None);
    assert!(found(&squares(), &[u([0.0, 1.0 - 1e-9])]).is_some());
    // two Ls above each other: a screen in both of their notches
    let l = L.map(|[x, y]| [x, y, 0.0]);
    let pair = |shift: f64| {
        [
            polygon("l", &l),
            facing("l", L.map(|[x, y]| [x + shift, y, 0.1]), false),
        ]
    };
    let screen = level("screen", [1.0, 2.0], [1.0, 2.0], 0.05, true);
    let blocked = found(&pair(0.0), &[screen.clone()]);
    assert!(
        blocked.is_some(),
        "from arm to arm the segments cross the notch"
    );
    let arm = |x: [f64; 2], y: [f64; 2], z: f64, up: bool| level("arm", x, y, z, up);
    let arms = [
        arm([0.0, 1.0], [0.0, 2.0], 0.0, true),
        arm([0.0, 1.0], [0.0, 2.0], 0.1, false),
    ];
    assert_eq!(found(&arms, &[screen]), None);
}

/// Between two triangles turned against each other the shaft has six sides, each through an edge of one and a corner of
/// the other: a spike that ends 1e-9 before a side is outside, 1e-9 behind it inside.
#[test]
fn a_spike_is_judged_by_the_side_it_points_at() {
    let corner = |turn: f64, z: f64| {
        let angle = turn * std::f64::consts::FRAC_PI_3;
        // unequal, so that no two sides are parallel
        let size = if z > 0.5 { 0.9 } else { 1.0 };
        DVec3::new(size * angle.cos(), size * angle.sin(), z)
    };
    let triangle = |name: &str, turns: [f64; 3], z: f64| {
        polygon(name, &turns.map(|turn| corner(turn, z).to_array()))
    };
    let pair = [
        triangle("floor", [0.0, 2.0, 4.0], 0.0),
        triangle("ceiling", [5.0, 3.0, 1.0], 1.0),
    ];
    for side in 0..6u32 {
        let turn = f64::from(side);
        let [low, high] = if side % 2 == 0 {
            [0.0, 1.0]
        } else {
            [1.0, 0.0]
        };
        let corners = [
            corner(turn, low),
            corner(turn + 2.0, low),
            corner(turn + 1.0, high),
        ];
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let across = (corners[1] - corners[0])
            .cross(corners[2] - corners[0])
            .normalize();
        let out = across * across.dot(middle - DVec3::new(0.0, 0.0, 0.5)).signum();
        for (depth, blocks) in [(1e-9, true), (0.0, false), (-1e-9, false)] {
            let tip = middle - depth * out;
            let spike = [
                tip,
                tip + out + 0.01 * DVec3::Z,
                tip + out - 0.02 * DVec3::X,
            ];
            let spike = polygon("spike", &spike.map(|c| c.to_array()));
            let by = blocks.then_some((0, 1, Obstacle::Obstruction(0)));
            assert_eq!(found(&pair, &[spike]), by, "side {side}, {depth:e}");
        }
    }
}

/// An edge that passes by an edge of the shaft: no plane of a face parts the two, only the plane along both edges.
#[test]
fn an_edge_is_judged_by_the_edge_it_passes() {
    for (gap, blocks) in [(1e-9, false), (0.0, false), (-1e-9, true)] {
        let blade = [[0.5, 1.5, 0.4], [1.5, 0.5, 0.6], [1.8, 1.8, 0.5]];
        let blade = polygon("blade", &blade.map(|[x, y, z]| [x + gap, y + gap, z]));
        let by = blocks.then_some((0, 1, Obstacle::Obstruction(0)));
        assert_eq!(found(&squares(), &[blade]), by, "{gap:e}");
    }
}
