//! Theorems of a Coq text, and all that are stated.

use crate::files;
use std::collections::BTreeMap;
use std::fs;

/// A Coq text without its comments, which nest.
pub(crate) fn without_comments(text: &str) -> String {
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
pub(crate) fn theorems(text: &str) -> BTreeMap<String, String> {
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

/// All theorems that are stated again, with their statements.
pub(crate) fn stated() -> BTreeMap<String, String> {
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
fn a_theorem_in_a_comment_is_none() {
    let text = "(* Theorem a : True. (* b *) *)\nTheorem c :\n  True.\nProof. exact I. Qed.\n";
    let found = theorems(text);
    assert_eq!(found.keys().collect::<Vec<_>>(), ["c"]);
    assert!(found["c"].ends_with("True.\n"));
}
