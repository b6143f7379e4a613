//! The claims as the page shows them.

use crate::claims::{Claim, Formula, Task, Theorem};
use crate::numeric::Grade;
use crate::question::{ReportAnswer, ReportedClaim};
use crate::report::answers::claims::number_and_certainty;
use crate::report::bundle::artefact::run_time;
use crate::report::bundle::figure::BundleFigure;

/// A claim with everything that its entry shows, in words.
#[derive(Debug, serde::Serialize)]
pub(super) struct PageClaim<'a> {
    id: &'a str,
    place: &'a str,
    quantity: &'a str,
    printed: Option<&'a str>,
    computed: String,
    certainty: String,
    /// The ends of the enclosure, with every certified digit.
    ends: Option<[&'a str; 2]>,
    verdict: &'static str,
    verdict_words: String,
    evidence: &'static str,
    evidence_means: &'static str,
    note: &'a str,
    formula: &'a Formula,
    task: PageTask,
    theorems: &'a [Theorem],
    on_paper: Option<&'a str>,
    figures: Vec<&'a str>,
    is_left_out: bool,
    run_time: Option<String>,
}

/// The road to a verdict: the inputs and the code of the computation, its control and its tests.
#[derive(Debug, Default, serde::Serialize)]
struct PageTask {
    function: Option<&'static str>,
    file: Option<String>,
    inputs: String,
    control: String,
    members: Vec<String>,
    tests: Vec<&'static str>,
}

const RECORDED: &str = "tests/library/claims/verdicts.rs: every_verdict_is_the_recorded_one";
const TURNED: &str = "tests/library/claims/verdicts.rs: every_verdict_turns_under_its_control";
const NARROW: &str = "tests/library/claims/enclosures.rs: enclosures_are_narrow";
const PROVED: &str = "proofs/check: every theorem compiled by Coq, with its axioms";

/// The claims of a report, with the figures among these that show them.
pub(super) fn claims<'a>(
    answer: &'a ReportAnswer,
    figures: &'a [BundleFigure],
) -> Vec<PageClaim<'a>> {
    answer
        .claims
        .iter()
        .map(|claim| entry(claim, figures))
        .collect()
}

fn entry<'a>(reported: &'a ReportedClaim, figures: &'a [BundleFigure]) -> PageClaim<'a> {
    let claim = &reported.claim;
    let judged = reported.judged.as_ref();
    let [computed, certainty] = judged.map(number_and_certainty).unwrap_or_default();
    let ends = judged.and_then(|judged| judged.lower.as_deref().zip(judged.upper.as_deref()));
    let evidence = judged.and_then(|judged| judged.evidence);
    PageClaim {
        id: &claim.id,
        place: &claim.place,
        quantity: &claim.quantity,
        printed: claim.printed.as_ref().map(|printed| printed.text.as_str()),
        computed,
        certainty,
        ends: ends.map(|(lower, upper)| [lower, upper]),
        verdict: reported.verdict().name(),
        verdict_words: reported.verdict().name().replace('_', " "),
        evidence: evidence.map_or("", Grade::name),
        evidence_means: evidence.map_or("", Grade::meaning),
        note: judged.map_or("", |judged| judged.note.as_str()),
        formula: &claim.formula,
        task: task(claim, evidence),
        theorems: &claim.proof,
        on_paper: claim.on_paper.as_deref(),
        figures: figures_of(&claim.id, figures),
        is_left_out: judged.is_none(),
        run_time: reported.seconds.map(run_time),
    }
}

fn task(claim: &Claim, evidence: Option<Grade>) -> PageTask {
    let mut tests = vec![RECORDED];
    let mut task = match &claim.task {
        Task::Compute {
            computation,
            input,
            control,
            ..
        } => {
            tests.push(TURNED);
            let mut changes = control.inputs.to_string();
            if let Some(printed) = &control.printed {
                let comma = if changes.is_empty() { "" } else { ", " };
                changes += &format!("{comma}printed {}", printed.text);
            }
            PageTask {
                function: Some(computation.name()),
                file: Some(format!("src/claims/sections/{}.rs", computation.section())),
                inputs: input.to_string(),
                control: changes,
                ..PageTask::default()
            }
        }
        Task::AllOf { members, .. } => PageTask {
            members: members.clone(),
            ..PageTask::default()
        },
        Task::Proved { .. } | Task::NotChecked { .. } => PageTask::default(),
    };
    if evidence == Some(Grade::Enclosure) {
        tests.push(NARROW);
    }
    if !claim.proof.is_empty() {
        tests.push(PROVED);
    }
    task.tests = tests;
    task
}

/// The beginnings of claims' names, and of the names of the figures that show them.
const SHOWN: [(&str, &str); 17] = [
    ("fig1-dark", "fig1-dark"),
    ("eq13", "fig1-dark"),
    ("fig1-lit", "fig1-lit"),
    ("eq14", "fig1-lit"),
    ("fig2", "fig2"),
    ("fig3", "fig3"),
    ("fig4", "fig4"),
    ("fig5", "fig5"),
    ("s42", "section-4-2"),
    ("eq4-limit", "convergence"),
    ("corollary-1", "convergence"),
    ("s2-discretizing", "convergence"),
    ("s2-finer", "fig5-cells"),
    ("s5-unstable", "stability-gains"),
    ("s5-printed-gain", "stability-gains"),
    ("s5-full-gain", "oracles"),
    ("s6-oracle", "oracles"),
];

fn figures_of<'a>(id: &str, figures: &'a [BundleFigure]) -> Vec<&'a str> {
    let shown = SHOWN.iter().filter(|(claim, _)| id.starts_with(claim));
    let named = shown.flat_map(|(_, name)| {
        let figures = figures.iter();
        figures
            .filter(move |figure| figure.name.starts_with(name))
            .map(|figure| figure.name)
    });
    named.collect()
}
