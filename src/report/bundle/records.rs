//! All records of a report in one file, as `report.schema.json` describes it.

use super::Parts;
use crate::question::{CutAnswer, GridAnswer, JudgedClaim, StudyAnswer};
use crate::report::{ReportError, json_text};

/// The whole file.
#[derive(serde::Serialize)]
struct Records<'a> {
    version: &'static str,
    is_quick: bool,
    claims: Vec<JudgedClaim>,
    left_out: Vec<&'a str>,
    cuts: &'a [CutAnswer],
    regular_grids: &'a [GridAnswer],
    best_grids: &'a [GridAnswer],
    studies: Vec<&'a StudyAnswer>,
    tables: Vec<Entry<'a>>,
    figures: Vec<Entry<'a>>,
}

/// A table or a figure: its name and what it shows.
#[derive(serde::Serialize)]
struct Entry<'a> {
    name: &'a str,
    shows: &'a str,
    is_timed: bool,
}

/// The text of `report.json`.
pub(super) fn records(parts: &Parts<'_>) -> Result<String, ReportError> {
    let answer = parts.answer;
    let tables = parts.tables.iter().map(|table| Entry {
        name: table.name,
        shows: table.title,
        is_timed: table.is_timed,
    });
    let figures = parts.figures.iter().map(|figure| Entry {
        name: figure.name,
        shows: &figure.caption,
        is_timed: figure.is_timed,
    });
    json_text(&Records {
        version: env!("CARGO_PKG_VERSION"),
        is_quick: answer.is_quick,
        claims: answer.reproduction().claims,
        left_out: answer.left_out(),
        cuts: &answer.cuts.cuts,
        regular_grids: &answer.regular_grids,
        best_grids: &answer.best_grids,
        studies: answer.studies.iter().map(|study| &study.answer).collect(),
        tables: tables.collect(),
        figures: figures.collect(),
    })
}
