//! The decimals that are proved: table, definitions, theorems and enclosures.

use crate::coq::stated;
use crate::{folder, text};
use infoscene::discretize::{GradientCut, PatchSplit};
use infoscene::geometry::SplitAxis;
use infoscene::numeric::Interval;
use infoscene::scene::Scene;
use std::fs;

/// Digits in front of the point and behind it, and the number as an integer.
fn digits(decimal: &str) -> (String, usize) {
    let (whole, behind) = decimal.split_once('.').unwrap_or((decimal, ""));
    assert!(
        !whole.is_empty()
            && (whole.to_owned() + behind)
                .bytes()
                .all(|b| b.is_ascii_digit()),
        "{decimal} is no decimal"
    );
    let digits = format!("{whole}{behind}");
    let digits = digits.trim_start_matches('0');
    let digits = if digits.is_empty() { "0" } else { digits };
    (digits.to_owned(), behind.len())
}

/// Exact comparison of decimals, which have more digits than an `f64`.
fn is_below(lower: &str, upper: &str) -> bool {
    const PLACES: usize = 36;
    let scaled = |decimal: &str| {
        let (digits, places) = digits(decimal);
        let zeros = "0".repeat(PLACES.checked_sub(places).unwrap());
        format!("{digits}{zeros}").parse::<i128>().unwrap()
    };
    scaled(lower) < scaled(upper)
}

/// The two definitions of a row of the table.
fn definitions(name: &str, lower: &str, upper: &str) -> [String; 2] {
    [("lower", lower), ("upper", upper)].map(|(end, decimal)| {
        let (digits, places) = digits(decimal);
        format!("Definition {name}_{end} : R := {digits} / 10 ^ {places}.")
    })
}

fn table() -> csv::Reader<fs::File> {
    csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_path(folder("data/proved_decimals.csv"))
        .unwrap()
}

/// The enclosure by interval arithmetic of the number that a row of the table names.
fn enclosed(name: &str) -> Interval {
    const BITS: u32 = 192;
    let best = |scene, against: &[usize]| {
        let scene = Scene::built_in(scene).unwrap();
        let split = PatchSplit::try_new(&scene, 0, against, SplitAxis::U).unwrap();
        split.certified_best(BITS).unwrap()
    };
    match name {
        "fig2_parallel_cut" => best("two-squares", &[1]).position,
        "fig2_parallel_gain" => best("two-squares", &[1]).value,
        "fig3_cut" => best("three-squares", &[1, 2]).position,
        "fig3_gain" => best("three-squares", &[1, 2]).value,
        _ => {
            let (kind, exponent) = name.rsplit_once('_').unwrap();
            let n: f64 = exponent.parse().unwrap();
            let m = if kind.ends_with("corrected") { n } else { 1.0 };
            let cut = GradientCut::try_new(n, m).unwrap();
            let found = if kind == "mean_square_cut" {
                cut.certified_mean_square_cut(BITS)
            } else {
                cut.certified_mutual_information_cut(BITS)
            };
            found.unwrap().position
        }
    }
}

/// Two roads to every decimal: Coq's theorem, and an enclosure that lies between its bounds.
#[test]
fn what_is_proved_contains_what_is_enclosed() {
    for row in table().records() {
        let row = row.unwrap();
        let bound = |column: usize| Interval::parse(&row[column], 192).unwrap();
        let enclosure = enclosed(&row[0]);
        assert!(
            bound(1) < enclosure && enclosure < bound(2),
            "{}: {:?}",
            &row[0],
            enclosure.to_decimal(60)
        );
        assert!(enclosure.width() < 1e-40);
    }
}

#[test]
fn decimals_are_those_of_the_table() {
    let stated = stated();
    let mut rows = table();
    assert_eq!(
        rows.headers().unwrap(),
        vec!["name", "lower", "upper", "theorem"]
    );
    let mut expected = Vec::new();
    for row in rows.records() {
        let row = row.unwrap();
        let [name, lower, upper, theorem] = [0, 1, 2, 3].map(|k| row[k].to_owned());
        assert!(is_below(&lower, &upper), "{name}: {lower} to {upper}");
        let statement = stated
            .get(&theorem)
            .unwrap_or_else(|| panic!("{name}: {theorem} is not stated"));
        for end in ["lower", "upper"] {
            assert!(
                statement.contains(&format!("{name}_{end}")),
                "{theorem} does not speak of {name}_{end}"
            );
        }
        expected.extend(definitions(&name, &lower, &upper));
    }
    assert!(expected.len() >= 32, "{} decimals only", expected.len());
    let decimals = text("proofs/Decimals.v");
    let found: Vec<&str> = decimals
        .lines()
        .filter(|line| line.starts_with("Definition"))
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn decimals_are_compared_to_the_last_digit() {
    assert!(is_below(
        "0.399201026045385125211245596857959",
        "0.399201026045385125211245596857960"
    ));
    assert!(!is_below("0.50", "0.5"));
    assert!(is_below("0.5", "0.51"));
    assert_eq!(
        definitions("x", "0.0482", "1.5"),
        [
            "Definition x_lower : R := 482 / 10 ^ 4.",
            "Definition x_upper : R := 15 / 10 ^ 1."
        ]
    );
}
