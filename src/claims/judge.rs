//! The judgement of claims: compute, let theorems raise the evidence, apply the rule.

use super::claim::{Claim, Task};
use super::registry::registry;
use super::rule::Agreement;
use super::{Case, ClaimError, Context, Finding, Inputs, OneSided, Verdict};
use crate::numeric::Grade;
use rayon::prelude::*;
use std::time::{Duration, Instant};

/// A claim with its finding and its verdict.
#[derive(Debug, Clone)]
pub struct Judgement {
    /// The claim.
    pub claim: Claim,
    /// The finding of the computation alone; `None` if the claim is not computed.
    pub finding: Option<Finding>,
    /// Does a theorem prove the claim as it stands, or its contrary?
    pub is_proved: bool,
    /// The claims of which this one says that all hold; empty for others.
    pub members: Vec<Self>,
    /// The verdict by the rule.
    pub verdict: Verdict,
}

impl Judgement {
    /// The verdict on record.
    #[must_use]
    pub const fn recorded(&self) -> Verdict {
        match &self.claim.task {
            Task::Compute { recorded, .. } | Task::AllOf { recorded, .. } => *recorded,
            Task::Proved { is_refuted, .. } => Verdict::of_proof(*is_refuted),
            Task::NotChecked { .. } => Verdict::NotChecked,
        }
    }

    /// The grade of the evidence, if there is any.
    #[must_use]
    pub fn evidence(&self) -> Option<Grade> {
        if self.is_proved {
            return Some(Grade::Proof);
        }
        let weakest = self.members.iter().map(Self::evidence).min();
        let own = self.finding.as_ref().map(|finding| finding.grade);
        own.or(weakest.flatten())
    }

    /// The verdict of the computation alone, without the theorems that the claim names; `None` if
    /// nothing is computed.
    #[must_use]
    pub fn by_computation(&self) -> Option<Verdict> {
        let finding = self.finding.as_ref();
        finding.map(|finding| Verdict::of(&self.claim, finding))
    }

    /// The only side to which the computation can decide; `None` for both, and if nothing is
    /// computed.
    #[must_use]
    pub fn one_sided(&self) -> Option<OneSided> {
        let finding = self.finding.as_ref()?;
        let refutes = finding.grade >= Grade::Enclosure && self.claim.complete;
        finding
            .one_sided
            .or((!refutes).then_some(OneSided::Confirm))
    }

    /// The finding's note, or the reason why there is none.
    #[must_use]
    pub fn note(&self) -> &str {
        match (&self.finding, &self.claim.task) {
            (Some(finding), _) => &finding.note,
            (None, Task::NotChecked { reason }) => reason,
            (None, Task::Proved { note, .. }) => note,
            (None, Task::AllOf { note, .. }) => note,
            (None, Task::Compute { .. }) => "",
        }
    }
}

/// Computes a claim, or those that it consists of, and judges it.
///
/// # Errors
/// [`ClaimError`] if a computation fails.
pub fn judge(claim: &Claim, context: &Context) -> Result<Judgement, ClaimError> {
    match &claim.task {
        Task::AllOf { members, .. } => {
            let members = members.iter().map(|id| judge(&named(id)?, context));
            let members = members.collect::<Result<Vec<_>, ClaimError>>()?;
            Ok(of_members(claim, members))
        }
        _ => judge_with(claim.clone(), &Inputs::default(), Theorems::Count, context),
    }
}

/// The claim of a name.
fn named(id: &str) -> Result<Claim, ClaimError> {
    let found = registry()?.into_iter().find(|claim| claim.id == id);
    found.ok_or_else(|| ClaimError::UnknownClaim {
        id: id.to_owned(),
        nearest: None,
    })
}

/// A claim that says that all these hold.
fn of_members(claim: &Claim, members: Vec<Judgement>) -> Judgement {
    let verdicts: Vec<Verdict> = members.iter().map(|member| member.verdict).collect();
    Judgement {
        claim: claim.clone(),
        finding: None,
        is_proved: false,
        verdict: Verdict::of_all(&verdicts),
        members,
    }
}

/// Judges a claim with its control's changes, of which the theorems say nothing; a sound
/// computation gives another verdict than [`Judgement::by_computation`] does for the claim.
///
/// # Errors
/// [`ClaimError`] if the computation fails.
pub fn judge_control(claim: &Claim, context: &Context) -> Result<Judgement, ClaimError> {
    let mut changed = claim.clone();
    let Task::Compute { control, .. } = &claim.task else {
        return judge(claim, context);
    };
    if control.printed.is_some() {
        changed.printed.clone_from(&control.printed);
    }
    judge_with(changed, &control.inputs, Theorems::AreElsewhere, context)
}

/// Judges all these claims, in parallel; `told` hears of each when it is judged, with the time that
/// took. What several claims share is counted with the first that asks for it.
///
/// # Errors
/// [`ClaimError`] of a claim whose computation fails.
pub fn judge_all(
    claims: &[Claim],
    context: &Context,
    told: impl Fn(&Claim, Duration) + Sync,
) -> Result<Vec<Judgement>, ClaimError> {
    let judged = tasks(claims, context)
        .into_par_iter()
        .with_max_len(1)
        .map(|task| {
            let judged = task.into_iter().map(|index| {
                let start = Instant::now();
                let judgement = judge(&claims[index], context)?;
                told(&claims[index], start.elapsed());
                Ok((index, judgement))
            });
            judged.collect::<Result<Vec<_>, ClaimError>>()
        })
        .collect::<Result<Vec<_>, ClaimError>>()?;
    let mut judged = judged.concat();
    for (index, claim) in claims.iter().enumerate() {
        let Task::AllOf { members, .. } = &claim.task else {
            continue;
        };
        let start = Instant::now();
        let member = |id: &String| {
            let found = judged.iter().find(|(_, other)| other.claim.id == *id);
            found.map_or_else(
                || judge(&named(id)?, context),
                |(_, other)| Ok(other.clone()),
            )
        };
        let members = members.iter().map(member);
        let members = members.collect::<Result<Vec<_>, ClaimError>>()?;
        told(claim, start.elapsed());
        judged.push((index, of_members(claim, members)));
    }
    judged.sort_by_key(|(index, _)| *index);
    Ok(judged.into_iter().map(|(_, judgement)| judgement).collect())
}

/// Indices of the claims, those that share a grid together: one thread judges them, no other waits
/// for the grid.
fn tasks(claims: &[Claim], context: &Context) -> Vec<Vec<usize>> {
    let mut tasks: Vec<(Option<u32>, Vec<usize>)> = Vec::new();
    for (index, claim) in claims.iter().enumerate() {
        let grid = match &claim.task {
            Task::Compute {
                computation, input, ..
            } => computation.shared_grid(&Case::new(input.clone(), context)),
            Task::Proved { .. } | Task::NotChecked { .. } => None,
            // after those it consists of
            Task::AllOf { .. } => continue,
        };
        match tasks
            .iter_mut()
            .find(|(of, _)| grid.is_some() && *of == grid)
        {
            Some((_, task)) => task.push(index),
            None => tasks.push((grid, vec![index])),
        }
    }
    tasks.into_iter().map(|(_, task)| task).collect()
}

/// Whether the theorems that a claim names bear on the case at hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Theorems {
    /// The case is the claim itself.
    Count,
    /// The case is a control, of which the theorems say nothing.
    AreElsewhere,
}

fn judge_with(
    claim: Claim,
    changes: &Inputs,
    theorems: Theorems,
    context: &Context,
) -> Result<Judgement, ClaimError> {
    let (finding, is_proved, verdict) = match &claim.task {
        Task::Proved { is_refuted, .. } => (None, true, Verdict::of_proof(*is_refuted)),
        Task::NotChecked { .. } | Task::AllOf { .. } => (None, false, Verdict::NotChecked),
        Task::Compute {
            computation,
            input,
            recorded,
            ..
        } => {
            let case = Case::new(input.changed_by(changes), context);
            let finding = computation.compute(&case)?;
            let is_proved = theorems == Theorems::Count && is_proved(&claim, *recorded, &finding);
            let mut raised = finding.clone();
            if is_proved {
                raised.grade = Grade::Proof;
            }
            let verdict = Verdict::of(&claim, &raised);
            (Some(finding), is_proved, verdict)
        }
    };
    Ok(Judgement {
        claim,
        finding,
        is_proved,
        verdict,
        members: Vec::new(),
    })
}

/// Whether a theorem stands behind a finding: one that contradicts the theorem is not hidden by it.
///
/// The theorems of a claim on record as refuted prove its contrary.
fn is_proved(claim: &Claim, recorded: Verdict, finding: &Finding) -> bool {
    let proved = match recorded {
        Verdict::Refuted => Agreement::Outside,
        _ => Agreement::Inside,
    };
    !claim.proof.is_empty() && Agreement::of(claim, finding) == proved
}
