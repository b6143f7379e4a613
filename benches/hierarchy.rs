//! Hierarchical radiosity, refined and solved, all rounds counted, in multiples of the textbook's
//! sixteen terms a link, timed beside it, on one thread.
//!
//! `cargo bench --bench hierarchy` prints rooms with nothing in the way, and with a plate under the
//! light, from ten thousand links to a million; `-- 10000000` adds ten million. The limits that are
//! aimed at: 8 a link, and at most ten times the time with a plate.
//!
//! Each mesh is checked before its time counts: the power that its walls, the light and the plate
//! absorb is what the light emits, as far as links of points conserve it. With `--test`, or by
//! `cargo test --benches`, a small one is checked, and nothing is timed.
#![expect(
    clippy::unwrap_used,
    clippy::cast_precision_loss,
    reason = "a bench may panic, and counts little"
)]

mod textbook;

use infoscene::hierarchy::{Factors, Goal, Lighting, Link, OracleName, Refinement};
use infoscene::scene::{Channel, Occlusion, Scene};
use std::hint::black_box;
use std::time::Instant;
use textbook::textbook_parallel;

/// The rooms: without anything in the way, and with a plate.
const ROOMS: [&str; 2] = ["lit-cube", "shaded-cube"];
/// The power that links of points may lose.
const LOST: f64 = 0.02;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_timed = arguments.iter().any(|word| word == "--bench");
    let more = arguments
        .iter()
        .filter_map(|word| word.parse::<usize>().ok());
    let mut sizes: Vec<usize> = vec![10_000, 100_000, 1_000_000];
    sizes.truncate(if is_timed { 3 } else { 1 });
    sizes.extend(more);
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    one.install(|| {
        for links in sizes {
            let seconds = ROOMS.map(|name| refined(name, links, is_timed));
            if is_timed {
                println!("with a plate {:.1} times the time", seconds[1] / seconds[0]);
            }
        }
    });
}

/// Refines a room, checks it, and prints the time a link; its seconds a link.
fn refined(name: &str, links: usize, is_timed: bool) -> f64 {
    let scene = Scene::built_in(name).unwrap();
    let lighting = Lighting::of(&scene, Channel::Green).unwrap();
    let oracle = OracleName::Gradient.oracle(None).unwrap();
    let patches = || {
        let light = lighting.clone();
        Refinement::try_new(&scene, light, Occlusion::Exact, Factors::OfPoints).unwrap()
    };
    let mut room = patches();
    let start = Instant::now();
    room.refine(&*oracle, Goal::Links(links), &mut |_| ())
        .unwrap();
    let seconds = start.elapsed().as_secs_f64();
    let found = room.links().count();
    assert!(found >= links, "{name}: {found} links");
    let off = (absorbed(&room) - 1.0).abs();
    assert!(off < LOST, "{name}: {off} of the power");
    if is_timed {
        let textbook = textbook_seconds();
        let megabytes = found * size_of::<Link>() / 1_000_000;
        println!(
            "{name:<12} {:>7} elements {found:>9} links {megabytes:>4} MB {seconds:>8.3} s  {:>5.1} × the textbook a link",
            room.tree().leaf_count(),
            seconds / textbook / found as f64,
        );
    }
    seconds / found as f64
}

/// The share of the emitted power that is absorbed.
fn absorbed(room: &Refinement<'_>) -> f64 {
    let (mut absorbed, mut emitted) = (0.0, 0.0);
    for leaf in room.tree().leaves() {
        let element = &room.tree().elements()[leaf];
        let (area, patch) = (element.shape().area(), element.patch());
        let irradiance = room.solution().received.irradiance[leaf];
        absorbed += area * (1.0 - room.lighting().reflectance(patch)) * irradiance;
        emitted += area * room.lighting().emittance(patch);
    }
    absorbed / emitted
}

/// Seconds of the textbook's formula: the fastest of some runs.
fn textbook_seconds() -> f64 {
    let unit = || black_box([0.0, 1.0]);
    let formula = || textbook_parallel(unit(), unit(), black_box([0.25, 2.0]), unit(), 1.0);
    let run = |_| {
        let start = Instant::now();
        for _ in 0..2000 {
            black_box(formula());
        }
        start.elapsed().as_secs_f64() / 2000.0
    };
    (0..20).map(run).fold(f64::INFINITY, f64::min)
}
