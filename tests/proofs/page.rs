//! The page `proofs/README.md` against the files: its index and its counts.

use crate::coq::{stated, theorems, without_comments};
use crate::{files, folder, text};
use std::collections::BTreeMap;
use std::fs;

/// One row of the index: what it says, its theorems, and the files it says they are in.
struct Row {
    says: String,
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
                says: cells[0].trim_start_matches("| ").to_owned(),
                theorems: theorems.map(str::to_owned).collect(),
                files: files.map(str::to_owned).collect(),
            }
        })
        .collect()
}

/// What the index says of each theorem.
pub(crate) fn words_of_theorems() -> BTreeMap<String, String> {
    let rows = index(&text("proofs/README.md")).into_iter();
    rows.flat_map(|Row { says, theorems, .. }| {
        let named = theorems.into_iter();
        named.map(move |name| (name, says.clone()))
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

/// The numbers of the page's first sentences.
#[test]
fn counts_of_the_page_are_those_of_the_files() {
    let page = text("proofs/README.md");
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    let stated = stated();
    let words = stated
        .keys()
        .filter(|name| name.starts_with("words_of_"))
        .count();
    let folders = fs::read_dir(folder("proofs")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path());
    let inside: usize = folders
        .filter(|path| path.is_dir())
        .map(|path| files(path, "v").len())
        .sum();
    let all = inside + files("proofs", "v").len();
    for part in [
        format!("{} theorems in Coq", stated.len() - words),
        format!("in {all} files."),
        format!("with {words} more that say what their words mean"),
    ] {
        assert!(page.contains(&part), "the page does not say \"{part}\"");
    }
    let changes = text("CHANGELOG.md");
    let changes = changes.split_whitespace().collect::<Vec<_>>().join(" ");
    let part = format!("{} statements in Coq", stated.len());
    assert!(
        changes.contains(&part),
        "the changelog does not say \"{part}\""
    );
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
