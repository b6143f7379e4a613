//! Table of information against error over random meshes.

use crate::report::{Report, ReportError, Table};
use crate::study::hierarchy::information::InformationRow;

/// The rank correlation of each measure with the error, room by room.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn information_report(rows: &[InformationRow]) -> Result<Report, ReportError> {
    let percent = |error: f64| format!("{:.2}", 100.0 * error);
    let line = |row: &InformationRow| {
        vec![
            row.case.clone(),
            row.method.clone(),
            row.cuts.clone(),
            row.meshes.to_string(),
            row.rank_correlation
                .map_or_else(|| "–".to_owned(), |ranks| format!("{ranks:.3}")),
            format!(
                "{} to {}",
                percent(row.least_error),
                percent(row.largest_error)
            ),
            format!("{:.1}", row.seconds),
        ]
    };
    let notes = [
        ("ranks", "rank correlation of the measure with the error"),
        ("seconds", "of all meshes of the room, with all measures"),
    ];
    let table = Table {
        columns: vec![
            "room",
            "measure",
            "cuts",
            "meshes",
            "ranks",
            "errors, %",
            "seconds",
        ],
        rows: rows.iter().map(line).collect(),
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "information"))
}
