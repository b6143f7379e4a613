//! The page of what the verdicts rest on and no program checks.
//!
//! The text is a template, `templates/trusted.md`; counts, ids and links are those of the
//! judgements.

use crate::claims::{Claim, Judgement, OneSided, Task};
use crate::numeric::Grade;
use crate::report::render::page::{PageError, Texts};

const TEMPLATE: &str = include_str!("../../templates/trusted.md");

/// The page in Markdown, from the judgements of all claims.
///
/// # Errors
/// [`PageError`] if a list is empty: the sentence about it would say nothing.
pub fn trusted_page(judgements: &[Judgement]) -> Result<String, PageError> {
    let mut texts = Texts::default();
    let graded = |is_meant: fn(Grade) -> bool| {
        let single = judgements.iter().filter(|j| j.members.is_empty());
        let found = single.filter(move |j| j.evidence().is_some_and(is_meant));
        found.map(|j| &j.claim).collect::<Vec<_>>()
    };
    let enclosed = graded(|grade| grade == Grade::Enclosure);
    let proved = graded(|grade| grade == Grade::Proof);
    let estimated = graded(|grade| grade < Grade::Enclosure);
    let having = |is_meant: &dyn Fn(&Claim) -> bool| {
        let claims = judgements.iter().map(|judgement| &judgement.claim);
        claims.filter(|claim| is_meant(claim)).collect::<Vec<_>>()
    };
    let computed = having(&|claim| matches!(claim.task, Task::Compute { .. }));
    texts.text("claims", judgements.len().to_string());
    texts.text("computed", computed.len().to_string());
    texts.text("enclosures", enclosed.len().to_string());
    texts.text("proofs", proved.len().to_string());
    texts.text("estimates", estimated.len().to_string());
    let links = proved.iter().map(|claim| {
        let names: Vec<String> = claim
            .proof
            .iter()
            .map(|own| format!("`{}`", own.name))
            .collect();
        format!("| {} | {} |\n", claim.id, names.join(", "))
    });
    texts.text("links", links.collect());
    let beside = proved.iter().filter_map(|claim| {
        let text = claim.on_paper.as_ref()?;
        Some(format!("| {} | {text} |\n", claim.id))
    });
    texts.text("on_paper", beside.collect());
    let only = |side: OneSided| {
        move |claim: &Claim| match &claim.task {
            Task::Compute { can_only, .. } => *can_only == Some(side),
            _ => false,
        }
    };
    for (name, claims) in [
        (
            "transcribed",
            having(&|claim| claim.quantity.contains("as transcribed")),
        ),
        ("open", having(&|claim| !claim.complete)),
        ("enclosed", enclosed),
        ("estimated", estimated),
        ("confirm", having(&only(OneSided::Confirm))),
        ("refute", having(&only(OneSided::Refute))),
    ] {
        PageError::unless(!claims.is_empty(), "every list of the page names a claim")?;
        let ids: Vec<String> = claims
            .iter()
            .map(|claim| format!("`{}`", claim.id))
            .collect();
        texts.text(name, ids.join(", "));
    }
    texts.filled(TEMPLATE)
}
