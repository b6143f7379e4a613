//! The folder `proofs` without Coq: page, files, claims and decimals name the same theorems and the
//! same numbers, and intervals enclose what is proved. That the proofs hold is what `proofs/check`
//! checks.
#![expect(clippy::unwrap_used, reason = "a test may panic")]

use infoscene::discretize::{GradientCut, PatchSplit};
use infoscene::geometry::SplitAxis;
use infoscene::numeric::Interval;
use infoscene::scene::Scene;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn text(name: &str) -> String {
    fs::read_to_string(folder(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn files(name: &str, extension: &str) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = fs::read_dir(folder(name))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|own| own == extension))
        .collect();
    found.sort();
    found
}

/// A Coq text without its comments, which nest.
fn without_comments(text: &str) -> String {
    let (mut kept, mut depth, mut rest) = (String::new(), 0_u32, text);
    while let Some(next) = rest.chars().next() {
        if rest.starts_with("(*") {
            depth += 1;
            rest = &rest[2..];
        } else if depth > 0 && rest.starts_with("*)") {
            depth -= 1;
            rest = &rest[2..];
        } else {
            if depth == 0 {
                kept.push(next);
            }
            rest = &rest[next.len_utf8()..];
        }
    }
    kept
}

/// The theorems of a Coq text: name, and statement up to its proof.
fn theorems(text: &str) -> BTreeMap<String, String> {
    let text = without_comments(text);
    let mut found = BTreeMap::new();
    let mut rest = text.as_str();
    while let Some(line_end) = rest.find('\n').or((!rest.is_empty()).then_some(rest.len())) {
        let line = rest[..line_end].trim_start();
        let keyword = line.split(' ').next().unwrap_or("");
        if ["Theorem", "Lemma", "Corollary"].contains(&keyword) {
            let name: String = line[keyword.len()..]
                .trim_start()
                .chars()
                .take_while(|c| c.is_ascii_alphanumeric() || *c == '_')
                .collect();
            let statement = rest.split("Proof.").next().unwrap_or("");
            assert!(
                found.insert(name.clone(), statement.to_owned()).is_none(),
                "{name} stands twice"
            );
        }
        rest = rest.get(line_end + 1..).unwrap_or("");
    }
    found
}

/// One row of the index: its theorems, and the files it says they are in.
struct Row {
    theorems: Vec<String>,
    files: Vec<String>,
}

/// The rows of the index of `proofs/README.md`: statement, paper, theorem, file, uses, axioms,
/// status.
fn index(page: &str) -> Vec<Row> {
    let table = page.split("\n## Index\n").nth(1).unwrap_or("");
    let rows = table.lines().filter(|line| line.starts_with("| "));
    rows.map(|line| line.split(" | ").collect::<Vec<_>>())
        .filter(|cells| cells[0] != "| statement")
        .map(|cells| {
            assert_eq!(cells.len(), 7, "{}", cells[0]);
            let theorems = cells[2].split('`').skip(1).step_by(2);
            let files = cells[3]
                .split("](")
                .skip(1)
                .filter_map(|link| link.split(')').next());
            Row {
                theorems: theorems.map(str::to_owned).collect(),
                files: files.map(str::to_owned).collect(),
            }
        })
        .collect()
}

/// The fault of a row, given the theorems of a file.
fn faults(row: &Row, theorems_of: impl Fn(&str) -> Vec<String>) -> Vec<String> {
    let held: Vec<(&String, Vec<String>)> = row
        .files
        .iter()
        .map(|file| (file, theorems_of(file)))
        .collect();
    let mut faults = Vec::new();
    for name in &row.theorems {
        if !held.iter().any(|(_, own)| own.contains(name)) {
            faults.push(format!("{name} is not in {:?}", row.files));
        }
    }
    for (file, own) in &held {
        if !row.theorems.iter().any(|name| own.contains(name)) {
            faults.push(format!("{file} has none of {:?}", row.theorems));
        }
    }
    faults
}

/// All theorems that are stated again, with their statements.
fn stated() -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    for path in files("proofs/statements", "v") {
        for (name, statement) in theorems(&fs::read_to_string(path).unwrap()) {
            assert!(
                all.insert(name.clone(), statement).is_none(),
                "{name} is stated twice"
            );
        }
    }
    all
}

#[test]
fn every_theorem_of_the_index_is_in_the_file_it_names() {
    let rows = index(&text("proofs/README.md"));
    assert!(rows.len() > 100, "the index has {} rows only", rows.len());
    let theorems_of = |file: &str| {
        theorems(&text(&format!("proofs/{file}")))
            .into_keys()
            .collect()
    };
    let wrong: Vec<String> = rows
        .iter()
        .flat_map(|row| faults(row, theorems_of))
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn index_and_statements_have_the_same_theorems() {
    let mut indexed: Vec<String> = index(&text("proofs/README.md"))
        .into_iter()
        .flat_map(|row| row.theorems)
        .collect();
    indexed.sort();
    let stated: Vec<String> = stated().into_keys().collect();
    let missing: Vec<&String> = stated
        .iter()
        .filter(|name| !indexed.contains(name))
        .collect();
    assert!(missing.is_empty(), "not in the index: {missing:#?}");
    let unstated: Vec<&String> = indexed
        .iter()
        .filter(|name| !stated.contains(name))
        .collect();
    assert!(unstated.is_empty(), "not stated again: {unstated:#?}");
    assert_eq!(indexed, stated, "a theorem stands in two rows");
}

#[test]
fn statements_collect_every_section() {
    let collected = without_comments(&text("proofs/Statements.v"));
    let (_, names) = collected.split_once("Require Export").unwrap();
    let mut names: Vec<&str> = names
        .trim()
        .trim_end_matches('.')
        .split_whitespace()
        .collect();
    names.sort_unstable();
    let sections = files("proofs/statements", "v");
    let sections: Vec<&str> = sections
        .iter()
        .map(|path| path.file_stem().unwrap().to_str().unwrap())
        .collect();
    assert_eq!(names, sections);
}

/// The theorems that a claim names under a key, if it has that key.
fn named<'a>(claim: &'a toml::Value, key: &str) -> Vec<&'a str> {
    claim.get(key).map_or_else(Vec::new, |list| {
        let list = list
            .as_array()
            .unwrap_or_else(|| panic!("{key} is no list"));
        list.iter().map(|name| name.as_str().unwrap()).collect()
    })
}

#[test]
fn proofs_of_claims_are_stated() {
    let stated = stated();
    let mut claims = 0;
    for path in files("data/paper", "toml") {
        let table: toml::Table = fs::read_to_string(&path).unwrap().parse().unwrap();
        for claim in table["claim"].as_array().unwrap() {
            claims += 1;
            for name in named(claim, "proof") {
                assert!(
                    stated.contains_key(name),
                    "{} names {name}, which is not stated",
                    claim["id"].as_str().unwrap()
                );
            }
        }
    }
    assert!(claims > 90, "the test sees {claims} claims only");
}

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
fn a_theorem_in_a_comment_is_none() {
    let text = "(* Theorem a : True. (* b *) *)\nTheorem c :\n  True.\nProof. exact I. Qed.\n";
    let found = theorems(text);
    assert_eq!(found.keys().collect::<Vec<_>>(), ["c"]);
    assert!(found["c"].ends_with("True.\n"));
}

#[test]
fn a_wrong_row_is_seen() {
    let page = "\n## Index\n\n| statement | paper | theorem | file | uses | axioms | \
                status |\n|---|\n\
                | s | eq. (1) | `one`, `two` | [A.v](a/A.v), [B.v](b/B.v) |  | R | proved |\n";
    let rows = index(page);
    assert_eq!(rows.len(), 1);
    let files = |file: &str| {
        let own: &[&str] = if file == "a/A.v" {
            &["one"]
        } else {
            &["three"]
        };
        own.iter().map(|name| (*name).to_owned()).collect()
    };
    let found = faults(&rows[0], files);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found[0].starts_with("two is not in"));
    assert!(found[1].starts_with("b/B.v has none of"));
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
