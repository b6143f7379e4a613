//! Pairs past polygons in the way, by family, in multiples of the textbook's sixteen terms timed
//! beside them; a furnished room, and a street of blocks.
//!
//! `cargo bench --bench occlusion` prints median and nine in ten over the pairs of each family, at
//! the default tolerance, setup included, beside the limit that is aimed at; words after `--` take
//! the lines whose names contain one of them. No means over whole families: one pair in a hundred
//! takes as long as the others together.
//!
//! Everything is checked before it is timed: pairs of `data/reference/occlusion.json` by their
//! values, random pairs by the other one of the two integrals there are for a pair, scenes by their
//! row sums. With `--test`, or by `cargo test --benches`, little is checked, once, and nothing is
//! timed.
#![expect(clippy::unwrap_used, reason = "a bench may panic")]

mod links;
mod pairs;
mod scenes;
#[path = "../textbook/mod.rs"]
mod textbook;

use pairs::Family;
use std::hint::black_box;
use std::time::Instant;
use textbook::textbook_parallel;

/// What is asked for on the command line.
struct Asked {
    is_test: bool,
    words: Vec<String>,
}

impl Asked {
    fn of(arguments: impl Iterator<Item = String>) -> Self {
        let (flags, words): (Vec<_>, Vec<_>) = arguments.partition(|word| word.starts_with("--"));
        let is_given = |name: &str| flags.iter().any(|flag| flag == name);
        Self {
            // `cargo test --benches` gives no flag
            is_test: is_given("--test") || !is_given("--bench"),
            words,
        }
    }

    fn has(&self, name: &str) -> bool {
        self.words.is_empty() || self.words.iter().any(|word| name.contains(word.as_str()))
    }
}

fn main() {
    let asked = Asked::of(std::env::args().skip(1));
    // unit squares at distance 1: a 60-digit value
    let naive = textbook_parallel([0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0], 1.0);
    assert!((naive - 0.199_824_895_698_387_38).abs() < 1e-14);
    if asked.has("reference values") {
        println!("{}", pairs::checked_reference());
    }
    let count = if asked.is_test { 2 } else { 100 };
    for family in Family::all() {
        if asked.has(family.name) {
            let pairs = family.checked_pairs(count.min(family.most));
            if !asked.is_test {
                family.print(&pairs);
            }
        }
    }
    if asked.has(pairs::ASIDE) {
        pairs::aside(count, asked.is_test);
    }
    for (name, scene) in scenes::all(asked.is_test) {
        if asked.has(name) {
            println!("{}", scenes::checked(name, &scene.0, scene.1));
        }
    }
    if asked.has(links::NAME) {
        links::print(&scenes::furnished_room(), asked.is_test);
    }
    if asked.has(scenes::ASIDE) {
        scenes::aside(asked.is_test);
    }
}

/// Seconds of the textbook's formula.
fn textbook_seconds() -> f64 {
    let unit = || black_box([0.0, 1.0]);
    let formula = || textbook_parallel(unit(), unit(), black_box([0.25, 2.0]), unit(), 1.0);
    fastest(20, 2000, || {
        black_box(formula());
    })
}

/// The fastest of some runs of so many calls, in seconds per call.
fn fastest(runs: u32, calls: u32, call: impl Fn()) -> f64 {
    let run = |_| {
        let start = Instant::now();
        (0..calls).for_each(|_| call());
        start.elapsed().as_secs_f64() / f64::from(calls)
    };
    (0..runs).map(run).fold(f64::INFINITY, f64::min)
}
