//! Whole scenes at tolerances from 1e-2 to 1e-12, in multiples of the textbook's sixteen terms a
//! pair, timed beside it, on one thread.
//!
//! `cargo bench --bench tolerances` prints a cube of 600 squares and a street of boxes, turned, so
//! that no edge is along an axis, with every pair computed and with values shared; `-- 1e-4` one
//! tolerance alone. Limits that are aimed at for every pair of the cube: 0.4 at 1e-4, 0.6 at 1e-6,
//! 1.2 at 1e-9, 2.2 at 1e-12.
//!
//! The cube's matrix is checked: down to 1e-10 all bounds meet the tolerance, and rows sum to 1
//! within theirs. By `cargo test --benches` small scenes are checked, and nothing is
//! timed.
#![expect(
    clippy::unwrap_used,
    clippy::cast_precision_loss,
    reason = "a bench may panic, and counts little"
)]

mod textbook;

use infoscene::exchange::{Congruence, ExchangeAreas, ScenePairs};
use infoscene::scene::{Occlusion, Scene};
use infoscene::study::form_factors::tolerances::turned_scenes;
use std::hint::black_box;
use std::time::Instant;
use textbook::textbook_parallel;

/// The tolerances, unless others are among the arguments.
const TOLERANCES: [f64; 6] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-12];

/// The tolerance below which the rounding of turned corners may be more.
const LEAST_CERTAIN: f64 = 1e-10;

/// Times that a matrix is computed, and the textbook's formula timed for as long.
const ROUNDS: usize = 9;

fn main() {
    let is_timed = std::env::args().any(|argument| argument == "--bench");
    let numbers = std::env::args().filter_map(|argument| argument.parse().ok());
    let mut tolerances: Vec<f64> = numbers.collect();
    if tolerances.is_empty() {
        tolerances.extend(TOLERANCES);
    }
    let sizes = if is_timed { [10, 40] } else { [3, 3] };
    let [cube, street] = turned_scenes(sizes).unwrap();
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    one.unwrap().install(|| {
        for tolerance in tolerances {
            for congruence in [Congruence::Ignored, Congruence::Shared] {
                let way = (tolerance, congruence);
                measured((cube.name, &cube.turned), true, way, is_timed);
                measured((street.name, &street.turned), false, way, is_timed);
            }
        }
    });
}

/// Computes all pairs, checks them, and prints the time a pair that is not left out.
fn measured(
    (name, scene): (&str, &Scene),
    is_closed: bool,
    (tolerance, congruence): (f64, Congruence),
    is_timed: bool,
) {
    let matrix = || {
        let unseen = Occlusion::Ignore;
        let pairs = ScenePairs::try_new(scene, tolerance, congruence, unseen).unwrap();
        pairs.exchange_areas().unwrap()
    };
    let missed = check(&matrix(), is_closed, tolerance);
    if !is_timed {
        return;
    }
    let mut ratios: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            let plan = black_box(matrix()).summary().plan.clone();
            let seconds = start.elapsed().as_secs_f64();
            let seen = (plan.computed + plan.congruent) as f64;
            seconds / seen / textbook_seconds(seconds)
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    println!(
        "{name:<14} {tolerance:.0e} {congruence:?}: {:.2} × the textbook, {:.2} at least; {missed} missed",
        ratios[ROUNDS / 2],
        ratios[0],
    );
}

/// Asserts that bounds of a closed scene meet the tolerance, if the rounding of corners does not
/// forbid it, and that its rows sum to 1 within them; the pairs that miss the tolerance.
fn check(areas: &ExchangeAreas, is_closed: bool, tolerance: f64) -> usize {
    let rows = areas.rows();
    for from in 0..rows {
        let (mut sum, mut bound) = (0.0, 0.0);
        for to in 0..rows {
            let exchange = areas.get(from, to).exchange;
            let is_met = exchange.error <= tolerance * exchange.value;
            // of the street, walls that rounding alone turns towards each other exchange nothing
            let is_judged = is_closed && tolerance >= LEAST_CERTAIN;
            assert!(is_met || !is_judged, "{from} {to}: {exchange:?}");
            sum += exchange.value;
            bound += exchange.error;
        }
        let area = areas.areas()[from];
        assert!(!is_closed || (sum - area).abs() <= bound + 1e-14 * area);
    }
    areas.summary().unreached
}

/// Seconds of the textbook's formula, the mean over so long a time.
fn textbook_seconds(during: f64) -> f64 {
    let unit = || black_box([0.0, 1.0]);
    let formula = || textbook_parallel(unit(), unit(), black_box([0.25, 2.0]), unit(), 1.0);
    let start = Instant::now();
    let mut calls = 0;
    loop {
        for _ in 0..1000 {
            black_box(formula());
        }
        calls += 1000;
        let seconds = start.elapsed().as_secs_f64();
        if seconds >= during {
            return seconds / f64::from(calls);
        }
    }
}
