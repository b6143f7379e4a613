//! A furnished room, a street, and a scene with something in it that blocks nothing.

use crate::fastest;
use glam::DVec3;
use infoscene::exchange::{Closure, Congruence, ScenePairs};
use infoscene::form_factor::DEFAULT_TOLERANCE;
use infoscene::geometry::Patch;
use infoscene::scene::{NamedPatch, Occlusion, Scene};
use std::hint::black_box;
use std::time::Instant;

type Span = [f64; 2];

fn patch(name: &str, mut corners: Vec<DVec3>, as_given: bool) -> NamedPatch {
    if !as_given {
        corners.reverse();
    }
    NamedPatch::new(name.to_owned(), Patch::try_new(corners).unwrap())
}

/// The rectangle `x × y` at height z, facing up or down.
fn level(name: &str, x: Span, y: Span, z: f64, up: bool) -> NamedPatch {
    let around = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
    let corners = around.map(|[x, y]| DVec3::new(x, y, z));
    patch(name, corners.to_vec(), up)
}

/// The four sides of a box, fronts outside or inside.
fn sides(name: &str, [x, y, z]: [Span; 3], out: bool) -> Vec<NamedPatch> {
    let around = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
    let side = |k: usize| {
        let ([a, b], [c, d]) = (around[k], around[(k + 1) % 4]);
        let corners = [(a, b, 0), (c, d, 0), (c, d, 1), (a, b, 1)];
        let corners = corners.map(|(x, y, k)| DVec3::new(x, y, z[k]));
        patch(name, corners.to_vec(), out)
    };
    (0..4).map(side).collect()
}

/// A box without a bottom, fronts outside.
fn standing(name: &str, [x, y, z]: [Span; 3]) -> Vec<NamedPatch> {
    let mut faces = sides(name, [x, y, z], true);
    faces.push(level(name, x, y, z[1], true));
    faces
}

/// A level rectangle without the footprints of what stands on it or hangs from it, in cells between
/// the lines through their edges.
fn cut_out(name: &str, [x, y]: [Span; 2], z: f64, up: bool, feet: &[[Span; 2]]) -> Vec<NamedPatch> {
    let lines = |k: usize, ends: Span| {
        let inner = feet.iter().flat_map(|foot| foot[k]);
        let mut lines: Vec<f64> = ends.into_iter().chain(inner).collect();
        lines.sort_by(f64::total_cmp);
        lines.dedup();
        lines
    };
    let (xs, ys) = (lines(0, x), lines(1, y));
    let is_in = |part: &[f64], whole: Span| whole[0] <= part[0] && part[1] <= whole[1];
    let mut cells = Vec::new();
    for x in xs.windows(2) {
        for y in ys.windows(2) {
            if !feet
                .iter()
                .any(|foot| is_in(x, foot[0]) && is_in(y, foot[1]))
            {
                cells.push(level(name, [x[0], x[1]], [y[0], y[1]], z, up));
            }
        }
    }
    cells
}

/// The inside of a box but its floor.
fn shell([x, y, z]: [Span; 3]) -> Vec<NamedPatch> {
    let mut faces = sides("wall", [x, y, z], false);
    faces.push(level("ceiling", x, y, z[1], false));
    faces
}

/// A room with a table on four legs, a chest and a cupboard; closed, 99 patches.
pub(crate) fn furnished_room() -> Scene {
    let room = [[0.0, 4.0], [0.0, 3.0], [0.0, 2.5]];
    let (mut feet, mut patches) = (Vec::new(), shell(room));
    for x in [[1.25, 1.375], [2.25, 2.375]] {
        for y in [[1.0, 1.125], [1.75, 1.875]] {
            feet.push([x, y]);
            patches.extend(sides("leg", [x, y, [0.0, 0.6875]], true));
        }
    }
    let plate = [[1.25, 2.375], [1.0, 1.875]];
    patches.extend(cut_out("under the table", plate, 0.6875, false, &feet));
    patches.extend(standing("table", [plate[0], plate[1], [0.6875, 0.75]]));
    for (name, foot, height) in [
        ("chest", [[0.25, 1.25], [2.0, 2.625]], 0.5),
        ("cupboard", [[3.0, 3.75], [0.375, 1.0]], 1.75),
    ] {
        feet.push(foot);
        patches.extend(standing(name, [foot[0], foot[1], [0.0, height]]));
    }
    patches.extend(cut_out("floor", [room[0], room[1]], 0.0, true, &feet));
    Scene::try_new(patches).unwrap()
}

/// Blocks of several heights in rows, under a box for the sky, so that rows sum to one.
fn street(side: u32) -> Scene {
    let reach = 1.5 * f64::from(side) + 0.5;
    let mut patches = shell([[0.0, reach], [0.0, reach], [0.0, 4.0]]);
    let mut feet = Vec::new();
    for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
        let foot = [i, j].map(|k| [1.5 * f64::from(k) + 0.5, 1.5 * f64::from(k) + 1.5]);
        let height = 1.0 + f64::from((7 * i + 3 * j) % 5) / 2.0;
        patches.extend(standing("block", [foot[0], foot[1], [0.0, height]]));
        feet.push(foot);
    }
    patches.extend(cut_out("ground", [[0.0, reach]; 2], 0.0, true, &feet));
    Scene::try_new(patches).unwrap()
}

/// The scenes with their tolerances.
pub(crate) fn all(is_test: bool) -> [(&'static str, (Scene, f64)); 2] {
    let (times, side) = if is_test { (0, 3) } else { (1, 5) };
    let room = furnished_room().subdivided(times).unwrap().0;
    [
        ("furnished room", (room, DEFAULT_TOLERANCE)),
        ("street of blocks", (street(side), 1e-6)),
    ]
}

/// All pairs on all threads, once: every row sums to one within its bound.
pub(crate) fn checked(name: &str, scene: &Scene, tolerance: f64) -> String {
    let start = Instant::now();
    let pairs = ScenePairs::try_new(scene, tolerance, Congruence::Shared, Occlusion::Exact);
    let exchange = pairs.unwrap().exchange_areas().unwrap();
    let seconds = start.elapsed().as_secs_f64();
    let (mut off, mut bound) = (0.0_f64, 0.0_f64);
    for row in Closure::of_held(&exchange).rows() {
        let error = (row.sum - 1.0).abs();
        assert!(error <= row.tolerance(), "{name}: {row:?}");
        (off, bound) = (off.max(error), bound.max(row.tolerance()));
    }
    assert!(bound <= 100.0 * tolerance, "{name}: {bound:e}");
    let counts = exchange.summary().plan.occlusion.unwrap();
    format!(
        "{name}, {} patches at {tolerance:e}: {seconds:.2} s on {} threads; {} pairs partial, {} \
         visible, {} hidden; rows sum to one but for {off:.1e}, bound {bound:.1e}",
        exchange.rows(),
        rayon::current_num_threads(),
        counts.partial,
        counts.visible,
        counts.hidden
    )
}

/// The name of the line of a scene with something in it that blocks nothing.
pub(crate) const ASIDE: &str = "none in any shaft of a scene";

/// Two sheets of triangles that see each other, with and without a screen beside them.
pub(crate) fn aside(is_test: bool) {
    let side = if is_test { 2 } else { 10 };
    let mut patches = Vec::new();
    for (z, up) in [(0.0, true), (4.0, false)] {
        for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
            let at = |u: f64, v: f64| {
                let (x, y) = (f64::from(i) + u, f64::from(j) + v);
                DVec3::new(x + 0.25 * y, y, z)
            };
            let halves = [[at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0)], {
                [at(0.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]
            }];
            patches.extend(halves.map(|half| patch("triangle", half.to_vec(), up)));
        }
    }
    let bare = Scene::try_new(patches).unwrap();
    let screen = level("screen", [-9.0, -8.0], [0.0, 1.0], 2.0, true);
    let beside = bare.clone().with_obstructions(vec![screen]);
    let pass = |scene: &Scene| {
        let pairs = ScenePairs::try_new(scene, 1e-12, Congruence::Ignored, Occlusion::Exact);
        pairs.unwrap().exchange_areas().unwrap()
    };
    let [one, other] = [&bare, &beside].map(pass);
    assert_eq!(one.values().entries(), other.values().entries());
    if is_test {
        return;
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    let pool = pool.build().unwrap();
    let seconds = |scene: &Scene| {
        pool.install(|| {
            fastest(5, 1, || {
                black_box(pass(scene));
            })
        })
    };
    let (bare, beside) = (seconds(&bare), seconds(&beside));
    println!(
        "{ASIDE}: {:+.1} % of the scene without (limit 5 %), {:.3} s",
        100.0 * (beside / bare - 1.0),
        bare
    );
}
