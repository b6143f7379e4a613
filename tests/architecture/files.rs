//! Files: their length and names, and what pages and comments say of them.

use crate::sources;
use std::fs;
use std::path::{Path, PathBuf};

const LONGEST: usize = 500;

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

/// A recipe names files and folders that exist; `NAME` and `N` stand for the reader's own.
#[test]
fn recipes_name_files_that_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut named = 0;
    for page in ["CONTRIBUTING.md", "README.md"] {
        let text = fs::read_to_string(root.join(page)).unwrap();
        let quoted = text.split('`').skip(1).step_by(2);
        for path in quoted.filter(|quoted| is_path(quoted)) {
            named += 1;
            let fixed: PathBuf = Path::new(path)
                .components()
                .take_while(|part| {
                    let part = part.as_os_str().to_str().unwrap();
                    !part.contains("NAME") && !part.contains("-N.")
                })
                .collect();
            let places = [root.join(&fixed), root.join("src").join(&fixed)];
            let exists = places.iter().any(|place| place.exists());
            assert!(exists, "{page} names {path}");
        }
    }
    assert!(named > 30, "only {named} paths are seen");
}

/// Whether quoted text is a path of this repository: words joined by slashes, and nothing else.
fn is_path(quoted: &str) -> bool {
    let is_word = |c: char| c.is_ascii_alphanumeric() || "_.-/".contains(c);
    quoted.contains('/') && quoted.chars().all(is_word) && !quoted.starts_with('/')
}
