//! One shaft at a time: what enters it blocks, what touches it does not.

use crate::support::rooms::{L, blocked, facing, level, polygon, squares};
use glam::DVec3;
use infoscene::scene::{NamedPatch, Obstacle, Scene};

/// A screen that reaches 1e-9 into the space between two squares blocks them, one that stays 1e-9
/// outside does not.
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
                blocked(&pair, std::slice::from_ref(&screen)),
                by(Obstacle::Obstruction(0)),
                "{start}"
            );
            let mut with_patch = pair.clone();
            with_patch.push(screen);
            assert_eq!(blocked(&with_patch, &[]), by(Obstacle::Patch(2)), "{start}");
        }
        // an upright one, whose plane cuts the squares, and an edge only dips into the shaft's end
        for (start, blocks) in [(end - 1e-9, true), (end, false), (end + 1e-9, false)] {
            let corners = [[start, 0.5, 0.5], [3.0, 0.5, 0.4], [3.0, 0.5, 0.6]];
            let by = blocks.then_some((0, 1, Obstacle::Obstruction(0)));
            assert_eq!(blocked(&pair, &[polygon("fin", &corners)]), by, "{start}");
        }
    }
}

/// A surface in a wall, behind it, or along the side of a shaft has points with the shaft's
/// boundary in common only.
#[test]
fn what_only_touches_does_not_block() {
    let cube = Scene::built_in("cube:1").unwrap();
    let none = |patches: &[NamedPatch], obstruction: NamedPatch| {
        assert_eq!(
            blocked(patches, std::slice::from_ref(&obstruction)),
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
    assert!(blocked(cube.patches(), &[shelf]).is_some());
    let curtain = side.map(|[x, y, z]| [x - 1e-9, y, z]);
    assert!(blocked(&squares(), &[polygon("curtain", &curtain)]).is_some());
}

/// A third patch in the plane of one of the pair, edge to edge, is no obstacle, and neither are the
/// two themselves.
#[test]
fn neighbours_in_one_plane_do_not_block() {
    let mut patches = squares();
    patches.push(level("beside", [1.0, 2.0], [0.0, 1.0], 0.0, true));
    patches.push(level("beyond", [-0.3, 0.0], [0.1, 0.3], 1.0, false));
    assert_eq!(blocked(&patches, &[]), None);
    // around a notch
    let l = L.map(|[x, y]| [x, y, 0.0]);
    let notch = [
        polygon("l", &l),
        level("in the notch", [1.0, 2.0], [1.0, 2.0], 0.0, true),
        level("ceiling", [0.0, 2.0], [0.0, 2.0], 1.0, false),
    ];
    assert_eq!(blocked(&notch, &[]), None);
}

/// Between patches that exchange nothing anything may stand.
#[test]
fn pairs_that_exchange_nothing_are_not_blocked() {
    let screen = level("screen", [0.2, 0.4], [0.2, 0.4], 0.5, true);
    let away = [
        level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true),
        level("turned away", [0.0, 1.0], [0.0, 1.0], 1.0, true),
    ];
    assert_eq!(blocked(&away, std::slice::from_ref(&screen)), None);
    let post = facing(
        "post",
        [[1.5, 0.0, 0.0], [1.5, 1.0, 0.0], [1.5, 0.5, 0.5]],
        true,
    );
    let coplanar = [
        level("floor", [0.0, 1.0], [0.0, 1.0], 0.0, true),
        level("floor", [2.0, 3.0], [0.0, 1.0], 0.0, true),
    ];
    assert_eq!(blocked(&coplanar, &[post]), None);
}

/// The part of a patch behind the other's plane sends nothing: what stands before that part only
/// blocks nothing.
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
    assert_eq!(blocked(&pair, std::slice::from_ref(&below)), None);
    assert_eq!(
        blocked(&pair, &[below, above]),
        Some((0, 1, Obstacle::Obstruction(1)))
    );
    let [floor, wall] = pair.clone();
    assert_eq!(
        blocked(
            &[wall, floor],
            &[level("below", [1.2, 1.8], [0.2, 0.8], -0.1, true)]
        ),
        None
    );
    // at the floor's own height: the hull of both whole patches is entered, the shaft is not
    assert_eq!(
        blocked(&pair, &[level("mat", [1.2, 1.8], [0.2, 0.8], 0.0, true)]),
        None
    );
}

/// A notch is a way through: the convex hull of a concave screen, or of concave patches, would
/// refuse too much.
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
    assert_eq!(blocked(&squares(), &[u([0.0, 1.0])]), None);
    assert!(blocked(&squares(), &[u([0.0, 1.0 - 1e-9])]).is_some());
    // two Ls above each other: a screen in both of their notches
    let l = L.map(|[x, y]| [x, y, 0.0]);
    let pair = |shift: f64| {
        [
            polygon("l", &l),
            facing("l", L.map(|[x, y]| [x + shift, y, 0.1]), false),
        ]
    };
    let screen = level("screen", [1.0, 2.0], [1.0, 2.0], 0.05, true);
    let from_arm_to_arm = blocked(&pair(0.0), std::slice::from_ref(&screen));
    assert!(
        from_arm_to_arm.is_some(),
        "from arm to arm the segments cross the notch"
    );
    let arm = |x: [f64; 2], y: [f64; 2], z: f64, up: bool| level("arm", x, y, z, up);
    let arms = [
        arm([0.0, 1.0], [0.0, 2.0], 0.0, true),
        arm([0.0, 1.0], [0.0, 2.0], 0.1, false),
    ];
    assert_eq!(blocked(&arms, &[screen]), None);
}

/// Between two triangles turned against each other the shaft has six sides, each through an edge of
/// one and a corner of the other: a spike that ends 1e-9 before a side is outside, 1e-9 behind it
/// inside.
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
            assert_eq!(blocked(&pair, &[spike]), by, "side {side}, {depth:e}");
        }
    }
}

/// An edge that passes by an edge of the shaft: no plane of a face parts the two, only the plane
/// along both edges.
#[test]
fn an_edge_is_judged_by_the_edge_it_passes() {
    for (gap, blocks) in [(1e-9, false), (0.0, false), (-1e-9, true)] {
        let blade = [[0.5, 1.5, 0.4], [1.5, 0.5, 0.6], [1.8, 1.8, 0.5]];
        let blade = polygon("blade", &blade.map(|[x, y, z]| [x + gap, y + gap, z]));
        let by = blocks.then_some((0, 1, Obstacle::Obstruction(0)));
        assert_eq!(blocked(&squares(), &[blade]), by, "{gap:e}");
    }
}
