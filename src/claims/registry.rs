//! All claims in paper order, and their judgement.

use super::claim::{Claim, Entry, Printed, Task};
use super::finding::Computation;
use super::{ClaimError, Evidence, Finding, Inputs, Verdict};
use super::{
    appendix, continuous_limit, section_2, section_3, section_3_light, section_4_1, section_4_2,
    section_5,
};
use rayon::prelude::*;

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
        continuous_limit::COMPUTATIONS,
        section_3::COMPUTATIONS,
        section_3_light::COMPUTATIONS,
        section_4_1::COMPUTATIONS,
        section_4_2::COMPUTATIONS,
        section_5::COMPUTATIONS,
        appendix::COMPUTATIONS,
    ]
    .concat()
}

/// A claim with what was found and the verdict.
#[derive(Debug, Clone)]
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
            Task::Proved { is_refuted, .. } => Verdict::of_proof(*is_refuted),
            Task::NotChecked { .. } => Verdict::NotChecked,
        }
    }

    /// The grade of the evidence, if there is any.
    #[must_use]
    pub fn evidence(&self) -> Option<Evidence> {
        match (&self.finding, &self.claim.task) {
            (Some(finding), _) => Some(finding.evidence),
            (None, Task::Proved { .. }) => Some(Evidence::Proof),
            (None, _) => None,
        }
    }

    /// The finding's note, or the reason why there is none.
    #[must_use]
    pub fn note(&self) -> &str {
        match (&self.finding, &self.claim.task) {
            (Some(finding), _) => &finding.note,
            (None, Task::NotChecked { reason }) => reason,
            (None, Task::Proved { note, .. }) => note,
            (None, Task::Compute { .. }) => "",
        }
    }
}

/// Computes a claim, enclosed numbers with ends of `bits` bits, and judges it.
///
/// # Errors
/// [`ClaimError`] if the computation fails.
pub fn judge(claim: &Claim, bits: u32) -> Result<Judgement, ClaimError> {
    judge_with(claim, &Inputs::default(), bits)
}

/// Judges a claim with its control's change of input; a sound computation gives another verdict.
///
/// A control may change `printed`, the printed number itself.
///
/// # Errors
/// [`ClaimError`] if the computation fails.
pub fn judge_control(claim: &Claim, bits: u32) -> Result<Judgement, ClaimError> {
    match &claim.task {
        Task::Compute { control, .. } => judge_with(claim, control, bits),
        Task::Proved { .. } | Task::NotChecked { .. } => judge(claim, bits),
    }
}

/// How far apart neighbours are taken.
const STRIDE: usize = 8;

/// Judges all these claims, in parallel; `progress` is called after each.
///
/// # Errors
/// [`ClaimError`] of a claim whose computation fails.
pub fn judge_all(
    claims: &[Claim],
    bits: u32,
    progress: impl Fn() + Sync,
) -> Result<Vec<Judgement>, ClaimError> {
    // claims that stand beside each other share computations: taken in strides, threads seldom wait for each other
    let mut order: Vec<usize> = (0..claims.len()).collect();
    order.sort_by_key(|index| index % STRIDE);
    let mut judged = order
        .into_par_iter()
        .with_max_len(1)
        .map(|index| {
            let judgement = judge(&claims[index], bits)?;
            progress();
            Ok((index, judgement))
        })
        .collect::<Result<Vec<_>, ClaimError>>()?;
    judged.sort_by_key(|(index, _)| *index);
    Ok(judged.into_iter().map(|(_, judgement)| judgement).collect())
}

fn judge_with(claim: &Claim, changes: &Inputs, bits: u32) -> Result<Judgement, ClaimError> {
    let mut claim = claim.clone();
    let Task::Compute {
        computation,
        input,
        recorded,
        ..
    } = &claim.task
    else {
        let verdict = match &claim.task {
            Task::Proved { is_refuted, .. } => Verdict::of_proof(*is_refuted),
            _ => Verdict::NotChecked,
        };
        return Ok(Judgement {
            claim,
            finding: None,
            verdict,
        });
    };
    let recorded = *recorded;
    let mut input = input.changed_by(changes).with_precision(bits);
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
    let mut finding = compute(&input)?;
    let mut verdict = Verdict::of(&claim, &finding);
    // a theorem is about the claim itself, not about its control; what contradicts it is not hidden by it
    let is_proved = !claim.proof.is_empty() && changes.is_empty();
    let agrees = match recorded {
        Verdict::Refuted => verdict == Verdict::Refuted,
        _ => matches!(verdict, Verdict::Supported | Verdict::Confirmed),
    };
    if is_proved && agrees {
        finding.evidence = Evidence::Proof;
        verdict = Verdict::of(&claim, &finding);
    }
    Ok(Judgement {
        claim,
        finding: Some(finding),
        verdict,
    })
}
