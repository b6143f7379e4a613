//! Any two polygons, by family, in multiples of the textbook's sixteen terms timed beside them.
//!
//! Each family is checked first: a pair taken the other way round agrees within the bounds, and the
//! bounds meet the tolerance. Criterion's means are over whole families, escalated pairs included;
//! the medians over the pairs are printed before.
#![expect(clippy::unwrap_used, reason = "a bench may panic")]

mod textbook;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{DMat3, DVec3};
use infoscene::exchange::{Congruence, ScenePairs};
use infoscene::form_factor::{
    DEFAULT_TOLERANCE, Polygon, Route, point_form_factor, point_form_factor_with_gradient,
};
use infoscene::geometry::Patch;
use infoscene::scene::{NamedPatch, Occlusion, Scene};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::time::Instant;
use textbook::textbook_parallel;

const PAIRS: usize = 256;

type Pair = [Polygon; 2];

fn polygon(corners: impl IntoIterator<Item = DVec3>) -> Polygon {
    Polygon::new(&Patch::try_new(corners.into_iter().collect()).unwrap())
}

fn rotation(random: &mut ChaCha8Rng) -> DMat3 {
    let axis = DVec3::from_array([(); 3].map(|()| random.random_range(-1.0..1.0)));
    DMat3::from_axis_angle(axis.normalize(), random.random_range(0.0..TAU))
}

/// Pairs that exchange something, from a recipe; all but a few meet the tolerance, and both ways
/// round agree.
fn family(seed: u64, mut recipe: impl FnMut(&mut ChaCha8Rng) -> Pair) -> Vec<Pair> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let (mut pairs, mut missed) = (Vec::new(), 0);
    while pairs.len() < PAIRS {
        let pair = recipe(&mut random);
        let [answer, back] = [[0, 1], [1, 0]].map(|[i, j]| {
            let answer = pair[i].exchange_area(&pair[j], DEFAULT_TOLERANCE);
            answer.unwrap().exchange
        });
        if answer.value <= 0.0 {
            continue;
        }
        let bound = answer.error + back.error;
        assert!((answer.value - back.value).abs() <= bound);
        missed += usize::from(answer.error > DEFAULT_TOLERANCE * answer.value);
        pairs.push(pair);
    }
    // turned quadrilaterals are planar to rounding only, which a grazing pair feels
    assert!(missed <= PAIRS / 20, "{missed} pairs miss the tolerance");
    pairs
}

/// The median over a family of the time per pair, in seconds: of each pair the fastest of some
/// runs.
fn median_time(pairs: &[Pair]) -> f64 {
    const CALLS: u32 = 32;
    let fastest = |[first, second]: &Pair| {
        let runs = (0..8).map(|_| {
            let start = Instant::now();
            for _ in 0..CALLS {
                black_box(first.exchange_area(black_box(second), DEFAULT_TOLERANCE)).unwrap();
            }
            start.elapsed().as_secs_f64() / f64::from(CALLS)
        });
        runs.fold(f64::INFINITY, f64::min)
    };
    let mut times: Vec<f64> = pairs.iter().map(fastest).collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The form factor by the textbook's formula.
fn textbook_time() -> f64 {
    const CALLS: u32 = 2000;
    let runs = (0..20).map(|_| {
        let start = Instant::now();
        for _ in 0..CALLS {
            let unit = black_box([0.0, 1.0]);
            black_box(textbook_parallel(
                unit,
                unit,
                black_box([0.25, 2.0]),
                unit,
                black_box(1.0),
            ));
        }
        start.elapsed().as_secs_f64() / f64::from(CALLS)
    });
    runs.fold(f64::INFINITY, f64::min)
}

/// Axis-aligned rectangles, parallel or perpendicular, a size or two apart or touching.
fn rectangles(random: &mut ChaCha8Rng) -> Pair {
    let [w, h, x, y] = [(); 4].map(|()| f64::from(random.random_range(1..=16u32)) / 8.0);
    let [dx, dy] = [(); 2].map(|()| f64::from(random.random_range(-8..=8i32)) / 8.0);
    let z = f64::from(random.random_range(1..=16u32)) / 8.0;
    let at = |o: DVec3, u: DVec3, v: DVec3| polygon([o, o + u, o + u + v, o + v]);
    let floor = at(DVec3::ZERO, w * DVec3::X, h * DVec3::Y);
    if random.random_bool(0.5) {
        [floor, at(DVec3::new(dx, dy, z), y * DVec3::Y, x * DVec3::X)]
    } else {
        let origin = DVec3::new(
            if dx > 0.0 { 0.0 } else { dx },
            dy,
            if dy > 0.0 { 0.0 } else { z },
        );
        [floor, at(origin, y * DVec3::Y, x * DVec3::Z)]
    }
}

/// Two polygons turned at random, their middles some sizes apart.
fn free(random: &mut ChaCha8Rng, corners: usize, distance: f64) -> Pair {
    let place = |random: &mut ChaCha8Rng, middle: DVec3| {
        let frame = rotation(random);
        let start = random.random_range(0.0..TAU);
        #[expect(clippy::cast_precision_loss, reason = "three or four")]
        let angle = |i: usize| start + TAU * (i as f64) / corners as f64;
        polygon((0..corners).map(|i| {
            let (s, c) = angle(i).sin_cos();
            middle + 0.6 * (c * frame.x_axis + s * frame.y_axis)
        }))
    };
    let along = rotation(random).x_axis * distance;
    [place(random, DVec3::ZERO), place(random, along)]
}

/// Two rectangles on both sides of an edge they share, at any angle, turned at random.
fn shared_edge(random: &mut ChaCha8Rng, flattest: f64) -> Pair {
    let frame = rotation(random);
    let angle = random.random_range(0.2..PI - flattest);
    let (s, c) = angle.sin_cos();
    let [w, h] = [(); 2].map(|()| random.random_range(0.3..2.0));
    let (edge, up) = (frame.y_axis, frame.z_axis);
    let out = frame.x_axis;
    let tilted = c * out + s * up;
    [
        polygon([DVec3::ZERO, w * out, w * out + edge, edge]),
        polygon([DVec3::ZERO, edge, edge + h * tilted, h * tilted]),
    ]
}

/// Two triangles in planes that meet, with one corner in common.
fn shared_vertex(random: &mut ChaCha8Rng) -> Pair {
    let frame = rotation(random);
    let mut leg = |u: DVec3, v: DVec3| {
        let [a, b, c, d] = [(); 4].map(|()| random.random_range(0.1..1.5));
        polygon([DVec3::ZERO, a * u + 0.1 * b * v, 0.1 * c * u + d * v])
    };
    let (x, y, z) = (frame.x_axis, frame.y_axis, frame.z_axis);
    [leg(x, y), leg(y, z)]
}

fn families(criterion: &mut Criterion) {
    let families: [(&str, Vec<Pair>); 8] = [
        ("rectangles", family(1, rectangles)),
        ("free triangles", family(2, |random| free(random, 3, 2.5))),
        (
            "free quadrilaterals",
            family(3, |random| free(random, 4, 2.5)),
        ),
        (
            "free quadrilaterals, 8 sizes apart",
            family(4, |random| free(random, 4, 8.0)),
        ),
        (
            "quadrilaterals, 30 sizes apart",
            family(5, |random| free(random, 4, 30.0)),
        ),
        ("shared edge", family(6, |random| shared_edge(random, 0.6))),
        ("shared vertex", family(7, shared_vertex)),
        ("nearly flat shared edge, escalated", family(8, nearly_flat)),
    ];
    // unit squares at distance 1: a 60-digit value
    let naive = textbook_parallel([0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0], 1.0);
    assert!((naive - 0.199_824_895_698_387_38).abs() < 1e-14);

    if !std::env::args().any(|argument| argument == "--test") {
        for (name, pairs) in &families {
            let (before, median) = (textbook_time(), median_time(pairs));
            let textbook = before.min(textbook_time());
            println!(
                "{name}: median {:.0} ns, {:.2} × the textbook's {:.0} ns",
                median * 1e9,
                median / textbook,
                textbook * 1e9
            );
        }
    }

    let mut group = criterion.benchmark_group("polygons");
    group.bench_function("textbook, 16 terms", |bencher| {
        bencher.iter(|| {
            let unit = black_box([0.0, 1.0]);
            textbook_parallel(unit, unit, black_box([0.25, 2.0]), unit, black_box(1.0))
        });
    });
    for (name, pairs) in &families {
        let mut next = pairs.iter().cycle();
        group.bench_function(*name, |bencher| {
            bencher.iter(|| {
                let [first, second] = next.next().unwrap();
                first.exchange_area(black_box(second), DEFAULT_TOLERANCE)
            });
        });
    }
    group.finish();
}

/// Two rectangles on both sides of an edge, at an angle of nearly 180°.
fn nearly_flat(random: &mut ChaCha8Rng) -> Pair {
    let frame = rotation(random);
    let angle = PI - random.random_range(1e-6..1e-3);
    let (s, c) = angle.sin_cos();
    let (edge, out) = (frame.y_axis, frame.x_axis);
    let tilted = c * out + s * frame.z_axis;
    [
        polygon([DVec3::ZERO, out, out + edge]),
        polygon([DVec3::ZERO, edge, edge + tilted]),
    ]
}

/// One pair by each route that serves it, checked against the chooser.
fn routes(criterion: &mut Criterion) {
    let pairs = family(9, |random| free(random, 4, 2.5));
    let pair = &pairs[0];
    let truth = pair[0]
        .exchange_area(&pair[1], DEFAULT_TOLERANCE)
        .unwrap()
        .exchange;
    let mut group = criterion.benchmark_group("routes, one free pair");
    for route in [
        Route::Contour,
        Route::PointToPolygon,
        Route::Kernel,
        Route::DoubleDouble,
    ] {
        let by_route = || pair[0].exchange_area_by(route, black_box(&pair[1]), DEFAULT_TOLERANCE);
        let answer = by_route().unwrap().exchange;
        assert!((answer.value - truth.value).abs() <= answer.error + truth.error);
        group.bench_function(route.name(), |bencher| bencher.iter(by_route));
    }
    group.finish();
}

/// The form factor from a point to a quadrilateral, with and without its gradient.
fn points(criterion: &mut Criterion) {
    let middle = DVec3::new(0.3, 0.4, 1.0);
    let corners = [[0.5, -0.5], [-0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]];
    let corners = corners.map(|[x, y]| middle + DVec3::new(x, y, 0.2 * x));
    let face = Patch::try_new(corners.to_vec()).unwrap();
    let [value, step] = [DVec3::ZERO, 1e-6 * DVec3::X]
        .map(|point| point_form_factor(point, DVec3::Z, &face).unwrap());
    let seen = || point_form_factor_with_gradient(black_box(DVec3::ZERO), DVec3::Z, &face).unwrap();
    assert!((seen().value - value).abs() < 1e-14);
    assert!((seen().gradient.x - (step - value) / 1e-6).abs() < 1e-5);
    let mut group = criterion.benchmark_group("a point and a quadrilateral");
    group.bench_function("value", |bencher| {
        bencher.iter(|| point_form_factor(black_box(DVec3::ZERO), DVec3::Z, &face));
    });
    group.bench_function("value and gradient", |bencher| bencher.iter(seen));
    group.finish();
}

/// The cube of 600 squares, turned about no symmetric axis, its corners rounded to doubles.
fn turned_cube() -> Scene {
    let turn = DMat3::from_axis_angle(DVec3::new(0.3, -0.7, 0.5).normalize(), 1.1);
    let cube = Scene::built_in("cube:10").unwrap();
    let turned = |patch: &NamedPatch| {
        let corners = patch.shape().corners().iter().map(|corner| turn * *corner);
        let shape = Patch::try_new(corners.collect()).unwrap();
        NamedPatch::new(patch.name().to_owned(), shape)
    };
    Scene::try_new(cube.patches().iter().map(turned).collect()).unwrap()
}

/// All pairs of 600 squares inside a cube, on one thread: along the axes, and turned.
fn scenes(criterion: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let mut group = criterion.benchmark_group("cube of 600 faces");
    group.sample_size(10);
    let straight = Scene::built_in("cube:10").unwrap();
    // rounded corners leave cracks
    for (scene, place, open) in [(straight, "", 1e-13), (turned_cube(), ", turned", 1e-12)] {
        let matrix = |congruence| {
            let policy = Occlusion::Refuse;
            let pairs = ScenePairs::try_new(&scene, DEFAULT_TOLERANCE, congruence, policy);
            pairs.unwrap().exchange_areas().unwrap()
        };
        for (name, congruence) in [
            ("every pair", Congruence::Ignored),
            ("congruent pairs shared", Congruence::Shared),
        ] {
            let areas = matrix(congruence);
            for from in 0..600 {
                let sum: f64 = (0..600).map(|to| areas.get(from, to).exchange.value).sum();
                assert!((sum / scene.patches()[from].shape().area() - 1.0).abs() <= open);
            }
            group.bench_function(format!("{name}{place}"), |bencher| {
                bencher.iter(|| pool.install(|| matrix(congruence)));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, families, points, routes, scenes);
criterion_main!(benches);
