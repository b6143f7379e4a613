//! The studies: what they measure is complete, finite, and within the bounds.

use crate::json;
use serde_json::Value;
use std::collections::BTreeSet;
use std::sync::LazyLock;

static STABILITY: LazyLock<Value> = LazyLock::new(|| json(&["study", "stability", "--quick"]));
static ACCURACY: LazyLock<Value> = LazyLock::new(|| json(&["study", "accuracy", "--quick"]));

fn rows(study: &Value) -> &[Value] {
    study["rows"].as_array().unwrap()
}

fn number(row: &Value, key: &str) -> f64 {
    row[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} is no number: {row}"))
}

/// Pairs past others of which the route knows little, and says so: the form along edges has few
/// digits of squares a million sizes apart, and of strips a billionth as wide as long.
const UNKNOWN: [&str; 3] = [
    "half-plane between squares 1e6 apart",
    "half-plane between strips 1e-9 wide",
    "plate, squares 1e6 apart",
];

/// Every pair's bound holds against the exact value, by every route; the chosen route refuses none
/// and reaches 1e-12, or 1e-15 of the unoccluded value, of all but some known pairs.
fn assert_stable(rows: &[Value]) -> usize {
    // other solvers of radiosities have no bound, nor have rules and lines past others
    let others = ["elimination", "bounces", "point-rule", "quasi-random"];
    let judged = rows.iter().filter(|row| {
        !row["uncertainty"].is_null() && !others.contains(&row["method"].as_str().unwrap())
    });
    let mut chosen = 0;
    for row in judged {
        let error = number(row, "relative_error");
        assert!(number(row, "value") > 0.0, "{row}");
        // doubles nearest to the exact value and to the quotient by it
        let known = number(row, "uncertainty") + f64::EPSILON;
        assert!(error <= number(row, "bound") + known, "{row}");
        if row["method"] == "chosen" {
            chosen += 1;
            let whole = row["unoccluded"].as_f64().unwrap_or(0.0);
            let allowed = f64::max(1e-12, 1e-15 * whole / number(row, "value"));
            let is_unknown = UNKNOWN.contains(&row["case"].as_str().unwrap());
            assert!(error <= allowed || is_unknown, "{row}");
        } else {
            assert_eq!(row["method"], row["route"]);
        }
    }
    chosen
}

/// The pairs whose exact value is quick, and what their rounded corners keep.
#[test]
fn stability_study_finds_every_bound_to_hold() {
    assert_eq!(STABILITY["study"], "stability");
    let rows = rows(&STABILITY);
    // pairs, stiff rooms, and pairs past others
    assert!(assert_stable(rows) >= 20 + 13 + 19);
    let moved = |case: &str| {
        let row = rows.iter().find(|row| row["case"] == case);
        number(row.unwrap(), "input_error")
    };
    // coordinates near 3e8 are rounded to 2^-24 or so
    assert!((1e-10..1e-6).contains(&moved("triangles, moved by 1e9")));
    assert!(moved("triangles, moved by 1e3") < 1e-12);
}

/// A row is wrong if its bound is below its error, or if the chooser left it out.
#[test]
fn a_broken_bound_is_seen() {
    assert_stable(rows(&STABILITY));
    let broken = |key: &str, value: Value| {
        let mut rows = rows(&STABILITY).to_vec();
        let row = rows
            .iter_mut()
            .find(|row| row["method"] == "chosen" && row["relative_error"].as_f64() > Some(0.0));
        row.unwrap()[key] = value;
        std::panic::catch_unwind(|| assert_stable(&rows)).is_err()
    };
    assert!(broken("relative_error", 1e-3.into()));
    assert!(broken("relative_error", Value::Null));
    assert!(broken("bound", Value::from(-1.0)));
}

#[test]
#[ignore = "a minute in release: cargo test --release --test command all_extreme -- --ignored"]
fn all_extreme_pairs_keep_their_bounds() {
    let answer = json(&["study", "stability"]);
    assert!(assert_stable(rows(&answer)) >= 40 + 13 + 20);
}

/// Every case has the chooser at all tolerances and lines at random; no number is missing; what was
/// asked for is met.
#[test]
fn accuracy_study_meets_what_was_asked_for() {
    assert_eq!(ACCURACY["study"], "accuracy");
    let rows = rows(&ACCURACY);
    let cases: BTreeSet<&str> = rows
        .iter()
        .map(|row| row["case"].as_str().unwrap())
        .collect();
    // of values past others the kinds with at most two blockers, and the plates half-way
    assert_eq!(cases.len(), 26 + 8 + 23 + 1);
    for case in cases {
        let of = |method: &str| {
            let rows = rows.iter();
            rows.filter(|row| row["case"] == case && row["method"] == method)
                .count()
        };
        assert_eq!(of("chooser"), 7, "{case}");
        assert!(of("local-lines") > 0 && of("quasi-random") > 0, "{case}");
    }
    for row in rows {
        let keys = ["value", "relative_error", "mean_square_error", "seconds"];
        assert!(keys.iter().all(|key| number(row, key) >= 0.0), "{row}");
        let (error, square) = (
            number(row, "relative_error"),
            number(row, "mean_square_error"),
        );
        assert!(square <= error * (1.0 + 4.0 * f64::EPSILON), "{row}");
        // corners in the file are decimals: rounding them moves a value by some ε, as the
        // reference's own test has it
        let known = 4.0 * f64::EPSILON + number(row, "uncertainty");
        if row["bound"].is_number() {
            assert!(error <= number(row, "bound") + known, "{row}");
        }
        if row["method"] == "chooser" {
            assert_eq!(row["served"], row["pairs"], "{row}");
            // past others a bound may miss the tolerance, and says so
            let is_past = row["family"].as_str().unwrap().starts_with("past others");
            let missed = if is_past { number(row, "bound") } else { 0.0 };
            let asked = number(row, "tolerance").max(missed);
            assert!(error <= asked + known, "{row}");
        }
        if row["samples"].is_number() && row["pairs"] == 1 {
            assert!(error <= 6.0 * number(row, "standard_error"), "{row}");
        }
    }
}

/// Errors of whole scenes are within their bounds, and bounds within the tolerance where none is
/// said to miss it; a loose tolerance is used.
#[test]
fn tolerances_study_has_errors_within_bounds() {
    let answer = json(&["study", "tolerances", "--quick"]);
    assert_eq!(answer["study"], "tolerances");
    // two scenes, two ways, every third of thirteen tolerances
    assert_eq!(rows(&answer).len(), 2 * 2 * 5);
    for row in rows(&answer) {
        let (error, bound) = (number(row, "error"), number(row, "bound"));
        // turned corners are rounded: ε of the room's size, over the size of a square
        assert!(error <= bound + 64.0 * f64::EPSILON, "{row}");
        assert!(number(row, "median_error") <= error && number(row, "median_bound") <= bound);
        let tolerance = number(row, "tolerance");
        assert!(
            bound <= tolerance * (1.0 + bound) || number(row, "unreached") > 0.0,
            "{row}"
        );
        if row["method"] == "every pair" && tolerance >= 1e-6 {
            assert!(
                error > 1e-6 * tolerance,
                "more digits than asked for: {row}"
            );
        }
    }
    let table = crate::stdout(&["study", "tolerances", "--quick"]);
    assert!(table.contains("turned street, 120 squares"), "{table}");
}

/// Past plates the route reaches what the rule over the area and the lines do not.
#[test]
fn accuracy_study_has_other_methods_past_others() {
    let plates: Vec<&Value> = rows(&ACCURACY)
        .iter()
        .filter(|row| row["family"] == "past others: plates half-way")
        .collect();
    let errors = |method: &str| -> Vec<f64> {
        let rows = plates.iter().filter(|row| row["method"] == method);
        rows.map(|row| number(row, "relative_error")).collect()
    };
    for method in ["point-rule", "local-lines", "quasi-random"] {
        // known to fail: none comes near twelve digits with plates in the way
        let errors = errors(method);
        assert!(errors.len() >= 2, "{method}");
        assert!(
            errors.iter().all(|error| *error > 1e-9),
            "{method}: {errors:?}"
        );
    }
    // its finest tolerances come last
    assert!(errors("chooser").last() < Some(&1e-11));
}

/// The table is a digest: one line per family and method.
#[test]
fn accuracy_table_is_a_digest() {
    let families: BTreeSet<(&str, &str)> = rows(&ACCURACY)
        .iter()
        .map(|row| {
            (
                row["family"].as_str().unwrap(),
                row["method"].as_str().unwrap(),
            )
        })
        .collect();
    let table = crate::stdout(&["study", "accuracy", "--quick", "--format", "markdown"]);
    let lines = table.lines().filter(|line| line.starts_with('|')).count();
    assert_eq!(lines, families.len() + 2);
    assert!(!table.contains("NaN"));
}

/// Digits that the naive forms lose and the sum of terms keeps, from gains of 1 bit to 1e-30.
#[test]
fn stability_study_shows_what_naive_forms_lose() {
    let rows = rows(&STABILITY);
    let errors = |method: &str| -> Vec<(f64, f64)> {
        let of_method = rows.iter().filter(|row| row["method"] == method);
        of_method
            .map(|row| (number(row, "value"), number(row, "relative_error")))
            .collect()
    };
    let kept = errors("sum-of-terms");
    assert_eq!(kept.len(), 16);
    assert!(kept.iter().all(|(_, error)| *error < 1e-14), "{kept:?}");
    assert!(kept.last().unwrap().0 < 1e-29);
    assert!(
        errors("sum-of-terms, single")
            .iter()
            .all(|(_, error)| *error < 1e-6)
    );
    // known failures: from 1e-17 bit on nothing is left of the naive forms
    for method in ["difference", "equation-5"] {
        assert!(
            errors(method)
                .iter()
                .filter(|(gain, _)| *gain < 1e-16)
                .all(|(_, error)| *error > 0.1)
        );
    }
    let single = errors("equation-5, single");
    assert!(
        single
            .iter()
            .filter(|(gain, _)| *gain < 1e-8)
            .all(|(_, error)| *error > 0.1)
    );
}

/// More bits, narrower enclosures, of every quantity.
#[test]
fn precision_study_shows_what_certainty_costs() {
    let answer = json(&["study", "precision", "--quick"]);
    assert_eq!(answer["study"], "precision");
    let rows = answer["rows"].as_array().unwrap();
    let cases: BTreeSet<&str> = rows
        .iter()
        .map(|row| row["case"].as_str().unwrap())
        .collect();
    assert_eq!(cases.len(), 5);
    for case in cases {
        let width = |bits: i32| {
            let method = format!("enclosure, {bits} bits");
            let mut rows = rows.iter();
            let row = rows.find(|row| row["case"] == case && row["method"] == method.as_str());
            row.unwrap()["relative_error"].as_f64().unwrap()
        };
        // the conditioning of each costs a few bits, 30 at most
        for bits in [53, 128, 256, 512] {
            let least = 2f64.powi(-bits - 2);
            let width = width(bits);
            assert!(
                (least..least * 2f64.powi(30)).contains(&width),
                "{case}, {bits} bits: {width:e}"
            );
        }
    }
}

/// Discrete values stay below the continuous one, in the records, in the table with its last line,
/// and drawn.
#[test]
fn refinement_study_is_a_table_and_a_figure() {
    let folder = tempfile::tempdir().unwrap();
    let figure = folder.path().join("gaps.svg");
    let path = figure.to_str().unwrap();
    let table = crate::stdout(&["study", "refinement", "--quick", "--figure", path]);
    assert!(std::fs::read_to_string(&figure).unwrap().contains("<svg"));
    assert!(
        table.contains('∞') && table.contains("(1.610473346"),
        "{table}"
    );
    crate::infoscene(&["study", "limits", "--figure", path])
        .assert()
        .code(2);
}

/// Meshes whose radiosity is farther from even have less error, nearly by Pythagoras; rows are
/// complete.
#[test]
fn information_study_ranks_random_meshes() {
    let answer = json(&["study", "information", "--quick"]);
    assert_eq!(answer["study"], "information");
    let rows = rows(&answer);
    assert_eq!(rows.len(), 2 * 4);
    for row in rows {
        let ranks = number(row, "rank_correlation");
        assert!((-1.0..=1.0).contains(&ranks), "{row}");
        if row["method"] == "order-2 divergence" {
            assert!(ranks < -0.95, "{row}");
        }
        assert!(number(row, "least_error") < number(row, "largest_error"));
        assert!(number(row, "meshes") >= 30.0 && number(row, "seconds") > 0.0);
    }
}

/// What is predicted follows from the terms: a pass on one node of 32 threads sends nothing, and
/// takes n²/2 pairs of a term's time over 32; terms are measured or assumed, and all are positive.
#[test]
fn the_scale_study_predicts_from_its_terms() {
    let study = json(&["study", "scale", "--quick"]);
    let rows = rows(&study);
    let of = |basis: &str| rows.iter().filter(|row| row["basis"] == basis).count();
    assert!(of("measured") > 10 && of("assumed") == 4);
    // six works, two numbers of patches, four of nodes
    assert_eq!(of("predicted"), 48);
    assert!(
        rows.iter()
            .all(|row| number(row, "value") > 0.0 || row["case"] == "a patch in memory")
    );
    let term = |case: &str| {
        let row = rows.iter().find(|row| row["case"] == case).unwrap();
        number(row, "value")
    };
    let pass = rows.iter().find(|row| {
        let is_of = row["basis"] == "predicted" && row["case"] == "measure, pairs computed";
        is_of && row["patches"] == 1_000_000 && row["nodes"] == 1
    });
    let expected = 5e11 * term("t, a pair computed") / 32.0;
    let found = number(pass.unwrap(), "value");
    assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
}
