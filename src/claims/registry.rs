//! All claims in paper order, and their judgement.

use super::claim::{Claim, Entry, Printed, Task};
use super::finding::Computation;
use super::{ClaimError, Finding, Inputs, Verdict};
use super::{appendix, section_2, section_3, section_4_1, section_4_2, section_5};

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
    let mut claims: Vec<Claim> = Vec::new();
    for (file, text) in FILES {
        let invalid = |reason: String| ClaimError::InvalidData { file, reason };
        let entries: File = toml::from_str(text).map_err(|error| invalid(error.to_string()))?;
        for entry in entries.claim {
            let claim = Claim::try_from(entry).map_err(invalid)?;
            if claims.iter().any(|other| other.id == claim.id) {
                return Err(invalid(format!("claim {} stands there twice", claim.id)));
            }
            claims.push(claim);
        }
    }
    Ok(claims)
}

/// Every computation by its name.
#[must_use]
pub fn computations() -> Vec<(&'static str, Computation)> {
    [
        section_2::COMPUTATIONS,
        section_3::COMPUTATIONS,
        section_4_1::COMPUTATIONS,
        section_4_2::COMPUTATIONS,
        section_5::COMPUTATIONS,
        appendix::COMPUTATIONS,
    ]
    .concat()
}

/// A claim with what was found and the verdict.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The claim.
    pub claim: Claim,
    /// What was found; `None` if it is not checked.
    pub finding: Option<Finding>,
    /// The verdict by the rule.
    pub verdict: Verdict,
}

impl Judgement {
    /// The verdict on record.
    #[must_use]
    pub const fn recorded(&self) -> Verdict {
        match &self.claim.task {
            Task::Compute { recorded, .. } => *recorded,
            Task::NotChecked { .. } => Verdict::NotChecked,
        }
    }

    /// The finding's note, or the reason why there is none.
    #[must_use]
    pub fn note(&self) -> &str {
        match (&self.finding, &self.claim.task) {
            (Some(finding), _) => &finding.note,
            (None, Task::NotChecked { reason }) => reason,
            (None, Task::Compute { .. }) => "",
        }
    }
}

/// Computes a claim and judges it.
///
/// # Errors
/// [`ClaimError`] if the computation fails.
pub fn judge(claim: &Claim) -> Result<Judgement, ClaimError> {
    judge_with(claim, &Inputs::default())
}

/// Judges a claim with its control's change of input; a sound computation gives another verdict.
///
/// A control may change `printed`, the printed number itself.
///
/// # Errors
/// [`ClaimError`] if the computation fails.
pub fn judge_control(claim: &Claim) -> Result<Judgement, ClaimError> {
    match &claim.task {
        Task::Compute { control, .. } => judge_with(claim, control),
        Task::NotChecked { .. } => judge(claim),
    }
}

fn judge_with(claim: &Claim, changes: &Inputs) -> Result<Judgement, ClaimError> {
    let mut claim = claim.clone();
    let Task::Compute {
        computation, input, ..
    } = &claim.task
    else {
        return Ok(Judgement {
            claim,
            finding: None,
            verdict: Verdict::NotChecked,
        });
    };
    let mut input = input.changed_by(changes);
    let found = computations()
        .into_iter()
        .find(|(name, _)| name == computation);
    let (_, compute) = found.ok_or_else(|| ClaimError::Input {
        name: "computation",
        reason: format!("\"{computation}\" of claim {} does not exist", claim.id),
    })?;
    if let Some(value) = input.take("printed") {
        let decimals = claim.printed.as_ref().map_or(0, |printed| printed.decimals);
        claim.printed = Some(Printed {
            text: value.to_string(),
            value,
            decimals,
        });
    }
    let finding = compute(&input)?;
    let verdict = Verdict::of(&claim, &finding);
    Ok(Judgement {
        claim,
        finding: Some(finding),
        verdict,
    })
}
