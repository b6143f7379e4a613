//! The tables of a store: what was written, and its state.

use crate::exchange::StoreState;
use crate::question::StoreAnswer;
use crate::report::{Report, ReportError, Table, scientific};

/// Renders the outcome of filling a store.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn store_report(answer: &StoreAnswer) -> Result<Report, ReportError> {
    let lines = [
        ("folder", answer.folder.display().to_string()),
        ("rows", answer.rows.to_string()),
        ("tiles of the matrix", answer.tiles.to_string()),
        ("tiles that were there", answer.found.to_string()),
        ("tiles computed", answer.written.to_string()),
    ];
    Report::one(table(lines.to_vec()), answer)
}

/// Renders the state of a store.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn store_state_report(state: &StoreState) -> Result<Report, ReportError> {
    let place = |at: Option<[usize; 2]>| at.map(|[i, j]| format!(", the first at ({i}, {j})"));
    let with = |count: usize, at| format!("{count}{}", place(at).unwrap_or_default());
    let or_none = |sum: Option<f64>| sum.map_or("unknown".to_owned(), |sum| format!("{sum:.15}"));
    let bound = state.largest_sum_bound.map(scientific);
    let lines = [
        ("rows", state.rows.to_string()),
        ("rows along a chunk", state.side.to_string()),
        ("tiles", state.tiles.to_string()),
        ("tiles missing", with(state.missing, state.first_missing)),
        (
            "entries that break a law",
            with(state.broken, state.first_broken),
        ),
        ("largest bound", scientific(state.largest_bound)),
        ("least sum of a whole row", or_none(state.least_sum)),
        ("largest sum of a whole row", or_none(state.largest_sum)),
        (
            "largest bound of such a sum",
            bound.unwrap_or("unknown".to_owned()),
        ),
    ];
    Report::one(table(lines.to_vec()), state)
}

fn table(lines: Vec<(&str, String)>) -> Table {
    let rows = lines
        .into_iter()
        .map(|(name, text)| vec![name.to_owned(), text]);
    Table {
        columns: vec!["store", "value"],
        rows: rows.collect(),
        ..Table::default()
    }
}
