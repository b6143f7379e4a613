//! All claims in paper order, as the data have them.

use super::ClaimError;
use super::claim::{Claim, Entry, Task};
use super::formula::formulas;
use super::theorem::theorems;

const FILES: [(&str, &str); 6] = [
    (
        "section-1.toml",
        include_str!("../../data/paper/section-1.toml"),
    ),
    (
        "section-2.toml",
        include_str!("../../data/paper/section-2.toml"),
    ),
    (
        "section-3.toml",
        include_str!("../../data/paper/section-3.toml"),
    ),
    (
        "section-4.toml",
        include_str!("../../data/paper/section-4.toml"),
    ),
    (
        "section-5.toml",
        include_str!("../../data/paper/section-5.toml"),
    ),
    (
        "appendix.toml",
        include_str!("../../data/paper/appendix.toml"),
    ),
];

#[derive(serde::Deserialize)]
struct File {
    claim: Vec<Entry>,
}

/// Every claim, in paper order.
///
/// # Errors
/// [`ClaimError::InvalidData`] if a file of claims is not in order.
pub fn registry() -> Result<Vec<Claim>, ClaimError> {
    let theorems = theorems().map_err(|reason| ClaimError::InvalidData {
        file: "proved_theorems.toml",
        reason,
    })?;
    let formulas = formulas().map_err(|reason| ClaimError::InvalidData {
        file: "formulas.toml",
        reason,
    })?;
    let mut claims: Vec<Claim> = Vec::new();
    for (file, text) in FILES {
        let invalid = |reason: String| ClaimError::InvalidData { file, reason };
        let entries: File = toml::from_str(text).map_err(|error| invalid(error.to_string()))?;
        for entry in entries.claim {
            let claim = entry.claim(&theorems, &formulas).map_err(invalid)?;
            if claims.iter().any(|other| other.id == claim.id) {
                return Err(invalid(format!("claim {} stands there twice", claim.id)));
            }
            claims.push(claim);
        }
    }
    for claim in &claims {
        let Task::AllOf { members, .. } = &claim.task else {
            continue;
        };
        let is_single = |id: &String| {
            let found = claims.iter().find(|other| other.id == *id);
            found.is_some_and(|other| !matches!(other.task, Task::AllOf { .. }))
        };
        if let Some(id) = members.iter().find(|id| !is_single(id)) {
            let reason = format!("claim {}: {id} is no claim of its own", claim.id);
            return Err(ClaimError::InvalidData {
                file: "all_of",
                reason,
            });
        }
    }
    Ok(claims)
}
