//! The folder `proofs` without Coq: page, files, claims and decimals name the same theorems and the
//! same numbers, intervals enclose what is proved, and `proofs/check` is not talked round. That the
//! proofs hold is what `proofs/check` checks.
#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[cfg(unix)]
mod cheats;
mod claims;
mod coq;
mod decimals;
mod page;

use std::fs;
use std::path::{Path, PathBuf};

fn folder(name: impl AsRef<Path>) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn text(name: &str) -> String {
    fs::read_to_string(folder(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn files(name: impl AsRef<Path>, extension: &str) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = fs::read_dir(folder(name))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|own| own == extension))
        .collect();
    found.sort();
    found
}
