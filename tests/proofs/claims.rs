//! The theorems that claims name: `data/proved_theorems.toml` against the index, the statements and
//! the claims.
//!
//! `INFOSCENE_REFRESH=1 cargo test --test proofs` rewrites words, hypotheses and conclusions; read
//! the difference. A pair of a claim and its theorem of which either has changed must be read
//! again: `INFOSCENE_READ=ID cargo test --test proofs` records that the pairs of claim ID were
//! (`all` for all).

use crate::coq::{Parts, stated};
use crate::page::words_of_theorems;
use crate::{files, folder, text};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;

const DATA: &str = "data/proved_theorems.toml";

const HEAD: &str = "\
# The theorems of proofs/ that claims name. Words, hypotheses and conclusions are written by
# INFOSCENE_REFRESH=1 cargo test --test proofs from proofs/README.md and proofs/statements;
# read: a digest of each claim and the theorem as they were when last read together.
";

/// A claim as the data have it: id, quantity and verdict, which a theorem must match in words.
struct Claim {
    id: String,
    says: String,
    proof: Vec<String>,
}

fn claims() -> Vec<Claim> {
    let mut all = Vec::new();
    for path in files("data/paper", "toml") {
        let table: toml::Table = fs::read_to_string(&path).unwrap().parse().unwrap();
        for claim in table["claim"].as_array().unwrap() {
            let words = |key: &str| claim.get(key).map_or("", |value| value.as_str().unwrap());
            let proof = claim.get("proof").map_or(&[][..], |list| {
                let list = list.as_array();
                list.expect("proof is a list of names").as_slice()
            });
            all.push(Claim {
                id: words("id").to_owned(),
                says: format!(
                    "{}: {}{}",
                    words("quantity"),
                    words("verdict"),
                    words("on_paper")
                ),
                proof: proof
                    .iter()
                    .map(|name| name.as_str().unwrap().to_owned())
                    .collect(),
            });
        }
    }
    all
}

/// The digest of a claim and a theorem as they stand: FNV-1a of their texts, 64 bits.
fn digest(texts: &[&str]) -> String {
    let bytes = texts.iter().flat_map(|text| text.bytes().chain([0]));
    let hash = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    });
    format!("{hash:016x}")
}

/// A theorem that claims name, as index, statements and claims have it now.
struct Theorem {
    says: String,
    parts: Parts,
    /// The digest of each claim with this theorem.
    now: BTreeMap<String, String>,
}

fn theorems() -> BTreeMap<String, Theorem> {
    let (stated, words) = (stated(), words_of_theorems());
    let mut all: BTreeMap<String, Theorem> = BTreeMap::new();
    for claim in claims() {
        for name in &claim.proof {
            let statement = stated.get(name);
            let statement = statement
                .unwrap_or_else(|| panic!("{} names {name}, which is not stated", claim.id));
            let theorem = all.entry(name.clone()).or_insert_with(|| Theorem {
                says: words[name].clone(),
                parts: Parts::of(statement),
                now: BTreeMap::new(),
            });
            let parts = &theorem.parts;
            let digest = digest(&[
                &claim.id,
                &claim.says,
                name,
                &theorem.says,
                &parts.variables,
                &parts.hypotheses.join(" -> "),
                &parts.conclusion,
            ]);
            theorem.now.insert(claim.id.clone(), digest);
        }
    }
    all
}

/// The digests on record, by theorem and claim.
fn on_record() -> BTreeMap<(String, String), String> {
    let data: toml::Table = text(DATA).parse().unwrap();
    let mut all = BTreeMap::new();
    for theorem in data["theorem"].as_array().unwrap() {
        let name = theorem["name"].as_str().unwrap();
        for (claim, digest) in theorem["read"].as_table().unwrap() {
            let pair = (name.to_owned(), claim.clone());
            all.insert(pair, digest.as_str().unwrap().to_owned());
        }
    }
    all
}

/// Is this claim one of which the caller says that he has just read it with its theorems?
fn just_read(claim: &str) -> bool {
    std::env::var("INFOSCENE_READ").is_ok_and(|read| read == "all" || read == claim)
}

/// The file of theorems, with the digests of the pairs that are recorded as read.
fn written(
    theorems: &BTreeMap<String, Theorem>,
    read: impl Fn(&str, &str, &str) -> String,
) -> String {
    let mut text = HEAD.to_owned();
    for (name, theorem) in theorems {
        let quoted = |text: &str| serde_json::to_string(text).unwrap();
        let hypotheses: Vec<String> = theorem
            .parts
            .hypotheses
            .iter()
            .map(|given| format!("    {},\n", quoted(given)))
            .collect();
        let hypotheses = match hypotheses.as_slice() {
            [] => "[]".to_owned(),
            lines => format!("[\n{}]", lines.concat()),
        };
        let (says, variables) = (quoted(&theorem.says), quoted(&theorem.parts.variables));
        let conclusion = quoted(&theorem.parts.conclusion);
        write!(
            text,
            "\n[[theorem]]\nname = \"{name}\"\nsays = {says}\nvariables = {variables}\n\
             hypotheses = {hypotheses}\nconclusion = {conclusion}\n[theorem.read]\n"
        )
        .unwrap();
        for (claim, now) in &theorem.now {
            writeln!(text, "{claim} = \"{}\"", read(name, claim, now)).unwrap();
        }
    }
    text
}

#[test]
fn theorems_of_claims_are_what_is_stated() {
    let (theorems, recorded) = (theorems(), on_record());
    let current = written(&theorems, |name, claim, now| {
        let pair = (name.to_owned(), claim.to_owned());
        if just_read(claim) {
            now.to_owned()
        } else {
            recorded.get(&pair).cloned().unwrap_or_default()
        }
    });
    if std::env::var_os("INFOSCENE_READ").is_some()
        || std::env::var_os("INFOSCENE_REFRESH").is_some()
    {
        fs::write(folder(DATA), &current).unwrap();
    }
    assert!(
        text(DATA) == current,
        "{DATA} is stale; run INFOSCENE_REFRESH=1 cargo test --test proofs, and read the difference"
    );
}

/// A theorem lifts a claim only while both stand as they were read.
#[test]
fn claims_and_their_theorems_are_as_they_were_read() {
    let recorded = on_record();
    let mut unread = Vec::new();
    for (name, theorem) in theorems() {
        for (claim, now) in theorem.now {
            let pair = (name.clone(), claim.clone());
            if !just_read(&claim) && recorded.get(&pair) != Some(&now) {
                unread.push(format!("{claim} and {name}"));
            }
        }
    }
    assert!(
        unread.is_empty(),
        "changed since they were read together: {unread:#?}; read both, then \
         INFOSCENE_READ=ID cargo test --test proofs"
    );
}

#[test]
fn the_test_sees_the_claims() {
    let claims = claims();
    assert!(claims.len() > 90, "{} claims only", claims.len());
    assert!(theorems().len() > 90);
}

/// Every text that a reader compares changes the digest.
#[test]
fn a_digest_tells_texts_apart() {
    let read = digest(&["a", "bc"]);
    for other in [["ab", "c"], ["a", "bd"], ["bc", "a"]] {
        assert_ne!(digest(&other), read);
    }
    // FNV-1a of the empty text and of "a": Fowler, Noll and Vo's published values
    assert_eq!(digest(&[]), "cbf29ce484222325");
}
