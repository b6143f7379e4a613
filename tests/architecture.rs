//! The house rules that a machine can check: one direction of flow, short files, no grab-bags.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use std::fs;
use std::path::{Path, PathBuf};

/// Left to right: a module uses only modules before it.
const FLOW: [&str; 12] = [
    "numeric",
    "geometry",
    "form_factor",
    "scene",
    "transport",
    "chain",
    "information",
    "discretize",
    "claims",
    "study",
    "report",
    "cli",
];
const LONGEST: usize = 500;

fn sources(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    found
}

fn module_of(path: &Path) -> Option<usize> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let first = path.strip_prefix(source).unwrap().components().next()?;
    let name = first
        .as_os_str()
        .to_str()?
        .trim_end_matches(".rs")
        .to_owned();
    FLOW.iter().position(|module| *module == name)
}

/// Modules named after `crate::` in code, comments left out.
fn used_modules(text: &str) -> Vec<usize> {
    let code = text
        .lines()
        .map(str::trim_start)
        .filter(|line| !line.starts_with("//"));
    let code: Vec<&str> = code.collect();
    code.join("\n")
        .split("crate::")
        .skip(1)
        .flat_map(|after| {
            let list = after
                .strip_prefix('{')
                .and_then(|rest| rest.split('}').next());
            list.unwrap_or(after)
                .split(',')
                .map(str::trim)
                .map(|name| {
                    name.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
                        .next()
                        .unwrap_or("")
                        .to_owned()
                })
                .collect::<Vec<_>>()
        })
        .filter_map(|name| FLOW.iter().position(|module| *module == name))
        .collect()
}

#[test]
fn modules_use_only_modules_to_their_left() {
    let mut uses = 0;
    for path in sources("src") {
        let Some(own) = module_of(&path) else {
            continue;
        };
        for used in used_modules(&fs::read_to_string(&path).unwrap()) {
            uses += usize::from(used < own);
            assert!(
                used <= own,
                "{}: {} uses {}",
                path.display(),
                FLOW[own],
                FLOW[used]
            );
        }
    }
    assert!(uses > 40, "the check sees {uses} uses only");
}

#[test]
fn a_use_to_the_right_is_seen() {
    assert_eq!(used_modules("use crate::{numeric, chain::X};"), [0, 5]);
    assert_eq!(
        used_modules("let x = crate::report::certain_digits(1.0, 0.0);"),
        [10]
    );
    assert_eq!(used_modules("/// [`crate::cli`]"), [] as [usize; 0]);
}

#[test]
fn every_folder_of_the_library_is_in_the_flow() {
    for path in sources("src") {
        let is_root = ["lib.rs", "main.rs"].contains(&path.file_name().unwrap().to_str().unwrap());
        assert!(
            is_root || module_of(&path).is_some(),
            "{} has no place",
            path.display()
        );
    }
}

#[test]
fn files_are_short_and_well_named() {
    let all = ["src", "tests", "benches"].map(sources).concat();
    for path in all {
        let lines = fs::read_to_string(&path).unwrap().lines().count();
        assert!(lines <= LONGEST, "{} has {lines} lines", path.display());
        let name = path.file_stem().unwrap().to_str().unwrap();
        assert!(
            !["util", "utils", "common", "helper", "helpers", "misc"].contains(&name),
            "{name}"
        );
    }
}

/// A doc comment that cites a test by name, after "by", cites one that exists.
#[test]
fn cited_tests_exist() {
    let tests: Vec<String> = ["tests", "src"]
        .map(sources)
        .concat()
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    let mut cited = 0;
    for path in sources("src") {
        let text = fs::read_to_string(&path).unwrap();
        let text = text
            .replace("\n    ///", "")
            .replace("\n///", "")
            .replace("\n//!", "");
        for after in text.split("by `").skip(1) {
            let name = after.split('`').next().unwrap();
            let is_test_name =
                name.len() > 15 && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            if is_test_name {
                cited += 1;
                let definition = format!("fn {name}(");
                assert!(
                    tests.iter().any(|test| test.contains(&definition)),
                    "{} cites {name}",
                    path.display()
                );
            }
        }
    }
    assert!(cited >= 8, "only {cited} citations are seen");
}
