//! The formulas that claims are about, in Unicode.
//!
//! `data/formulas.toml` has each once, in the letters of the paper, with what the letters mean; a
//! claim that is about another one's formula is listed beside it.

use std::collections::BTreeMap;

const DATA: &str = include_str!("../../data/formulas.toml");

/// A formula, with its letters explained.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Formula {
    /// The formula, one line or several.
    pub text: String,
    /// The meaning of its letters.
    pub letters: String,
    /// The ids of the claims that are about it.
    #[serde(skip_serializing)]
    pub claims: Vec<String>,
}

#[derive(serde::Deserialize)]
struct File {
    formula: Vec<Formula>,
}

/// The formulas by the ids of their claims.
///
/// # Errors
/// A message if the data are not in order, or a claim has two.
pub(super) fn formulas() -> Result<BTreeMap<String, Formula>, String> {
    let file: File = toml::from_str(DATA).map_err(|error| error.to_string())?;
    let mut named = BTreeMap::new();
    for formula in file.formula {
        for id in &formula.claims {
            if named.insert(id.clone(), formula.clone()).is_some() {
                return Err(format!("claim {id} has two formulas"));
            }
        }
    }
    Ok(named)
}
