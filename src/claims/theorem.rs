//! The theorems of `proofs/` that claims name, in words and as Coq states them.
//!
//! `data/proved_theorems.toml` has each once: the sentence of the index of `proofs/README.md`, and
//! variables, hypotheses and conclusion as `proofs/statements` has them. A test compares it with
//! both, and asks that each pair of a claim and its theorem be read again when either changes.
//!
//! **Not covered**: whether a theorem says what its claim says. That is checked by reading, not by
//! a machine.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

const DATA: &str = include_str!("../../data/proved_theorems.toml");

/// A theorem of `proofs/Statements.v`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Theorem {
    /// The name of the theorem, unique.
    pub name: String,
    /// The statement in words, which may be shared with the theorems beside it in the index.
    pub says: String,
    /// The variables for which it holds, in Coq's notation, with local definitions.
    pub variables: String,
    /// The hypotheses, in Coq's notation.
    pub hypotheses: Vec<String>,
    /// The conclusion, in Coq's notation.
    pub conclusion: String,
    /// The claims that name it, each with a digest of claim and theorem as last read together.
    #[serde(skip_serializing)]
    pub read: BTreeMap<String, String>,
}

#[derive(Deserialize)]
struct File {
    theorem: Vec<Theorem>,
}

/// All theorems that claims name, by name.
///
/// # Errors
/// A message if the data are not in order.
pub(super) fn theorems() -> Result<BTreeMap<String, Theorem>, String> {
    let file: File = toml::from_str(DATA).map_err(|error| error.to_string())?;
    let named = file.theorem.into_iter().map(|own| (own.name.clone(), own));
    Ok(named.collect())
}
