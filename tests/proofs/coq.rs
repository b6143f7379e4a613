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

/// A statement taken apart: `forall variables, hypothesis -> … -> conclusion`.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Parts {
    /// The bound variables and local definitions, those of all quantifiers in a row.
    pub variables: String,
    /// The hypotheses, in order.
    pub hypotheses: Vec<String>,
    /// What follows.
    pub conclusion: String,
}

impl Parts {
    /// The parts of a statement from `Theorem` to its full stop.
    pub(crate) fn of(statement: &str) -> Self {
        let (_, text) = statement.split_once(':').unwrap();
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let mut rest = text.trim_end_matches('.').trim();
        let (mut variables, mut hypotheses) = (Vec::new(), Vec::new());
        loop {
            let (end, opening) = if rest.starts_with("forall ") {
                (",", "forall ")
            } else if rest.starts_with("let ") {
                (" in ", "")
            } else {
                ("->", "")
            };
            let Some(at) = outermost(rest, end) else {
                break;
            };
            let part = rest[opening.len()..at].trim();
            if end == "->" {
                hypotheses.push(part.to_owned());
            } else {
                variables.push(part);
            }
            rest = rest[at + end.len()..].trim();
        }
        Self {
            variables: variables.join("; "),
            hypotheses,
            conclusion: rest.to_owned(),
        }
    }
}

/// The first place of a mark outside brackets and before any inner quantifier.
fn outermost(text: &str, mark: &str) -> Option<usize> {
    let mut depth = 0_u32;
    for (at, own) in text.char_indices() {
        let rest = &text[at..];
        match own {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if depth > 0 {
            continue;
        }
        let is_inner = ["forall ", "exists ", "fun ", "let "]
            .iter()
            .any(|word| rest.starts_with(word));
        if is_inner && mark == "->" {
            return None;
        }
        if rest.starts_with(mark) && !text[..at].ends_with('<') {
            return Some(at);
        }
    }
    None
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

#[test]
fn a_statement_is_taken_apart() {
    let text = "Theorem t : forall n (f : nat -> R), (0 < n)%nat ->\n  \
                (forall i, 0 <= f i) -> let s := sum n f in forall c, a <-> b ->\n  \
                c = s <-> exists x, f x -> x = 0.\n";
    let parts = Parts::of(text);
    assert_eq!(parts.variables, "n (f : nat -> R); let s := sum n f; c");
    assert_eq!(
        parts.hypotheses,
        ["(0 < n)%nat", "(forall i, 0 <= f i)", "a <-> b"]
    );
    assert_eq!(parts.conclusion, "c = s <-> exists x, f x -> x = 0");
}
