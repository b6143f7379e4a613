//! The tables of a report, each with its title.

use crate::claims::Verdict;
use crate::numeric::Grade;
use crate::question::{GridAnswer, JudgedClaim, ReportAnswer, StudySubject};
use crate::report::answers::claims::{number_and_error, reproduction_report};
use crate::report::answers::cuts::cuts_report;
use crate::report::answers::studies::study_report;
use crate::report::render::page::PageError;
use crate::report::{Format, Report, ReportError, Table, certain_digits};

/// A table with its title, ready to be written in any format.
#[derive(Debug, Clone, PartialEq)]
pub struct BundleTable {
    /// The name of its files, without the ending.
    pub name: &'static str,
    /// The title: what the table shows.
    pub title: &'static str,
    /// The table and its records.
    pub report: Report,
    /// Do run times enter?
    pub is_timed: bool,
}

/// The tables of a report, those of the claims first.
///
/// # Errors
/// [`PageError::Missing`] if there is no claim or no row of a study; [`PageError::Report`] if a
/// number is not finite.
pub fn report_tables(answer: &ReportAnswer) -> Result<Vec<BundleTable>, PageError> {
    let judged = answer.reproduction();
    let plain = |name, title, report| BundleTable {
        name,
        title,
        report,
        is_timed: false,
    };
    let mut tables = vec![
        plain(
            "claims",
            "Claims of the paper",
            reproduction_report(&judged)?,
        ),
        plain(
            "errata",
            "What does not hold as printed",
            errata(&judged.claims)?,
        ),
        plain(
            "section-4-2",
            "The cuts of §4.2 in both readings",
            cuts_report(&answer.cuts)?,
        ),
        plain("grids", "Grids on the faces of a cube", grids(answer)?),
    ];
    for study in &answer.studies {
        let report = study_report(&study.answer)?;
        let csv = report.render(Format::Csv)?;
        let heading = csv.lines().next().unwrap_or_default();
        let (name, title) = named(study.subject);
        if csv.lines().nth(1).is_none() {
            return Err(PageError::without("a row", name));
        }
        tables.push(BundleTable {
            name,
            title,
            is_timed: heading.split(',').any(|key| key == "seconds"),
            report,
        });
    }
    Ok(tables)
}

/// The name and the title of a study's table.
pub(super) const fn named(subject: StudySubject) -> (&'static str, &'static str) {
    match subject {
        StudySubject::Accuracy => ("accuracy", "Error of every route within a time"),
        StudySubject::Tolerances => ("tolerances", "Whole scenes by tolerance"),
        StudySubject::Stability => ("stability", "Digits kept in stiff and extreme cases"),
        StudySubject::Precision => ("precision", "Width of enclosures"),
        StudySubject::Limits => ("limits", "The cuts of §4.2 as the exponent grows"),
        StudySubject::Profiles => ("profiles", "Both cuts for other radiosities"),
        StudySubject::Directions => ("directions", "Straight cuts in any direction"),
        StudySubject::Walks => ("walks", "The variance of random walks"),
        StudySubject::Refinement => ("refinement", "The approach to the continuous value"),
        StudySubject::Sampling => ("sampling", "Estimates from random lines"),
        StudySubject::Figure5 => ("figure-5", "Fig. 5 read as estimates from random lines"),
        StudySubject::Oracles => ("oracles", "Oracles of hierarchical radiosity"),
        StudySubject::Information => ("information", "How information ranks random meshes"),
        StudySubject::Scale => ("scale", "Time and memory, here and on a cluster"),
    }
}

/// The claims that are refuted.
fn errata(claims: &[JudgedClaim]) -> Result<Report, PageError> {
    let refuted = claims
        .iter()
        .filter(|claim| claim.verdict == Verdict::Refuted);
    let refuted: Vec<JudgedClaim> = refuted.cloned().collect();
    if refuted.is_empty() {
        return Err(PageError::without("refuted claim", "the report"));
    }
    let row = |claim: &JudgedClaim| {
        let printed = claim.printed_text.clone();
        let [computed, error] = number_and_error(claim);
        vec![
            claim.place.clone(),
            claim.quantity.clone(),
            printed.unwrap_or_else(|| "in words".to_owned()),
            computed,
            error,
            claim.evidence.map_or("", Grade::name).to_owned(),
        ]
    };
    let table = Table {
        columns: vec![
            "place",
            "paper says",
            "printed",
            "computed",
            "certified ±",
            "evidence",
        ],
        rows: refuted.iter().map(row).collect(),
        wrapped: Some(1),
        ..Table::default()
    };
    Ok(Report::list(table, "claims", &refuted)?)
}

/// Regular and best grids side by side.
fn grids(answer: &ReportAnswer) -> Result<Report, ReportError> {
    let information = |grid: &GridAnswer| certain_digits(grid.mutual_information, grid.error);
    let row = |regular: &GridAnswer| {
        let best = answer
            .best_grids
            .iter()
            .find(|best| best.cells == regular.cells);
        let lines = best.map_or_else(Vec::new, |best| {
            let half = best.lines.iter().filter(|line| **line < 0.5);
            half.map(|line| certain_digits(*line, best.line_error.unwrap_or(1e-9)))
                .collect()
        });
        vec![
            regular.cells.to_string(),
            regular.patches.to_string(),
            information(regular),
            best.map_or_else(String::new, information),
            lines.join(", "),
        ]
    };
    let table = Table {
        columns: vec![
            "cells",
            "patches",
            "regular (bits)",
            "best (bits)",
            "best lines below 1/2",
        ],
        rows: answer.regular_grids.iter().map(row).collect(),
        notes: vec![(
            "grids".to_owned(),
            "the same lines on every face of a cube, an edge being 1".to_owned(),
        )],
        ..Table::default()
    };
    let all = [answer.regular_grids.clone(), answer.best_grids.clone()].concat();
    Report::list(table, "grids", &all)
}
