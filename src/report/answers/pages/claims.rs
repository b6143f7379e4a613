//! The page of all claims, and the short table of the front page.

use crate::claims::{Judgement, Quantity, Theorem, Verdict};
use crate::numeric::Grade;
use crate::question::ReproduceAnswer;
use crate::report::render::page::{PageError, Texts};
use crate::report::{Format, ReportError, Table, certain_digits, reproduction_report};

const TEMPLATE: &str = include_str!("../../templates/claims.md");

/// The page of all claims in Markdown: how to read a verdict, and the table.
///
/// # Errors
/// [`PageError::Report`] if a number is not finite.
pub fn claims_page(judgements: &[Judgement]) -> Result<String, PageError> {
    let mut texts = Texts::default();
    let verdicts = Verdict::ALL.map(|verdict| {
        let name = verdict.name().replace('_', " ");
        format!("| {name} | {} |\n", verdict.meaning())
    });
    let grades = Grade::ALL.map(|grade| format!("| {} | {} |\n", grade.name(), grade.meaning()));
    texts.text("verdicts", verdicts.concat());
    texts.text("grades", grades.concat());
    let table = reproduction_report(&ReproduceAnswer::from(judgements))?;
    texts.text("claims", table.render(Format::Markdown)?);
    texts.text("theorems", proved(judgements));
    texts.filled(TEMPLATE)
}

/// The theorems behind the claims in Markdown, in the order in which claims first name them.
fn proved(judgements: &[Judgement]) -> String {
    let mut named: Vec<(&Theorem, Vec<&str>)> = Vec::new();
    for claim in judgements.iter().map(|judgement| &judgement.claim) {
        for theorem in &claim.proof {
            match named.iter_mut().find(|(own, _)| own.name == theorem.name) {
                Some((_, claims)) => claims.push(&claim.id),
                None => named.push((theorem, vec![&claim.id])),
            }
        }
    }
    let entries = named.iter().map(|(theorem, claims)| {
        let mut entry = format!("### {}\n\n{}.\n\n", theorem.name, theorem.says);
        entry += &format!("* for `{}`\n", claims.join("`, `"));
        let lines = [("for all", &theorem.variables)].into_iter();
        let lines = lines.chain(theorem.hypotheses.iter().map(|given| ("given", given)));
        let lines = lines.chain([("then", &theorem.conclusion)]);
        for (word, text) in lines.filter(|(_, text)| !text.is_empty()) {
            entry += &format!("* {word} `{text}`\n");
        }
        entry + "\n"
    });
    entries.collect::<String>().trim_end().to_owned()
}

/// The claims of the front page: the best cuts of figs. 2 and 3, a pair of cuts of §4.2, a theorem.
const FIRST: [&str; 5] = [
    "fig2-parallel-cut",
    "fig3-cut",
    "s42-information-cut-2",
    "s42-mean-square-cut-2",
    "theorem-1",
];

/// The short table of the front page in Markdown: id, place, printed, computed, verdict. For a
/// claim in words the evidence stands in the place of a number.
///
/// # Errors
/// [`ReportError`] if the table cannot be rendered.
pub fn first_verdicts(judgements: &[Judgement]) -> Result<String, ReportError> {
    let found = FIRST
        .iter()
        .filter_map(|id| judgements.iter().find(|j| j.claim.id == *id));
    let row = |judgement: &Judgement| {
        let claim = &judgement.claim;
        let printed = claim.printed.as_ref().map(|printed| printed.text.clone());
        let finding = judgement.finding.as_ref();
        let computed = finding.map(|finding| match finding.quantity {
            Quantity::Value { value, error } if printed.is_some() => certain_digits(value, error),
            _ => judgement
                .evidence()
                .unwrap_or(finding.grade)
                .name()
                .to_owned(),
        });
        vec![
            claim.id.clone(),
            claim.place.clone(),
            printed.unwrap_or_else(|| "in words".to_owned()),
            computed.unwrap_or_default(),
            judgement.verdict.name().replace('_', " "),
        ]
    };
    let table = Table {
        columns: vec!["claim", "place", "printed", "computed", "verdict"],
        rows: found.map(row).collect(),
        ..Table::default()
    };
    Ok(table.to_markdown())
}
