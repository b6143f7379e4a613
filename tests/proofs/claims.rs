//! The theorems that claims name.

use crate::coq::stated;
use crate::files;
use std::fs;

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
