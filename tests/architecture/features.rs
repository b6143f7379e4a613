//! Features only add: with and without any of them the library computes by the same code. What a
//! feature changes in the crates that it is built upon, `.ci/run` compares.

use crate::{code, sources};
use std::fs;

/// The first word of the item behind each condition on a feature, further attributes left out.
fn added(code: &str) -> Vec<&str> {
    let behind = code.split("#[cfg(").skip(1).filter_map(|rest| {
        let (condition, item) = rest.split_once(")]\n")?;
        condition.contains("feature").then_some(item)
    });
    behind.map(|item| word(item.trim_start())).collect()
}

/// The first word of an item.
fn word(item: &str) -> &str {
    if item.starts_with("#[") {
        let after = item.split_once("]\n").map_or("", |(_, after)| after);
        return word(after.trim_start());
    }
    let end = item.find(|c: char| !c.is_alphanumeric() && c != '_');
    &item[..end.unwrap_or(item.len())]
}

/// What is wrong with a file: code that is there without a feature only, or that a feature adds
/// inside of a function.
fn faults(code: &str) -> Vec<String> {
    let excluded = ["cfg!(", "cfg_attr(", "not(feature", "not(any(", "not(all("];
    let excluded = excluded.iter().filter(|text| code.contains(*text));
    let mut found: Vec<String> = excluded.map(|text| (*text).to_owned()).collect();
    let is_item = |word: &&str| {
        let is_named = word.starts_with(char::is_uppercase);
        ["mod", "pub", "use", "fn"].contains(word) || is_named
    };
    let inside = added(code).into_iter().filter(|word| !is_item(word));
    found.extend(inside.map(|word| format!("cfg before {word}")));
    found
}

#[test]
fn features_only_add() {
    let mut seen = 0;
    for path in sources("src") {
        let code = code(&fs::read_to_string(&path).unwrap());
        seen += added(&code).len();
        let found = faults(&code);
        assert!(found.is_empty(), "{}: {found:?}", path.display());
    }
    assert!(seen >= 15, "only {seen} conditions are seen");
}

/// The features and dependencies that a feature of `Cargo.toml` turns on.
fn turned_on<'m>(manifest: &'m str, feature: &str) -> Vec<&'m str> {
    let features = manifest.split("\n[features]").nth(1).unwrap();
    let features = features.split("\n[").next().unwrap();
    // a list may run over several lines
    let (_, list) = features
        .split_once(&format!("\n{feature} = ["))
        .unwrap_or_default();
    let names = list.split(']').next().unwrap_or("");
    names.split('"').skip(1).step_by(2).collect()
}

#[test]
fn only_who_asks_for_python_or_mpi_compiles_for_it() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = fs::read_to_string(root.join("Cargo.toml")).unwrap();
    let [python, mpi] = ["python", "mpi"].map(|feature| turned_on(&manifest, feature));
    assert_eq!(python, ["dep:numpy", "dep:pyo3", "dep:pythonize"]);
    assert_eq!(mpi, ["dep:mpi"]);
    let edges = [&["python", "mpi"], &python[..], &mpi].concat();
    for feature in ["default", "cli", "report", "proptest"] {
        let on = turned_on(&manifest, feature);
        assert!(!on.is_empty(), "{feature} is not seen");
        let asks = on.iter().any(|name| edges.contains(name));
        assert!(!asks, "{feature} turns on {on:?}");
    }
    for name in [python, mpi].concat() {
        let name = name.trim_start_matches("dep:");
        let line = manifest
            .lines()
            .find(|line| line.starts_with(&format!("{name} = ")));
        assert!(line.unwrap().contains("optional = true"), "{name}");
    }
}

#[test]
fn code_that_depends_on_a_feature_is_seen() {
    let sound = "#[cfg(feature = \"a\")]\n#[error(transparent)]\nStudy(u8),\n\
                 #[cfg(all(feature = \"a\", feature = \"b\"))]\npub mod m;\n";
    assert_eq!(added(sound), ["Study", "pub"]);
    assert!(faults(sound).is_empty());
    for cheat in [
        "let x = if cfg!(feature = \"a\") { 1.0 } else { 2.0 };\n",
        "#[cfg(not(feature = \"a\"))]\nfn f() {}\n",
        "#[cfg(feature = \"a\")]\nlet x = 1.0;\n",
        "#[cfg(feature = \"a\")]\nx += 1.0;\n",
        "#[cfg_attr(feature = \"a\", path = \"b.rs\")]\nmod m;\n",
    ] {
        assert!(!faults(cheat).is_empty(), "{cheat}");
    }
}
