//! Table of a study that measures one number per row.

use crate::report::{Report, ReportError, Table, scientific};
use crate::study::Row;

/// The rows of a study, with the heading of their errors.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn measurements_report(
    study: &'static str,
    error: &'static str,
    rows: &[Row],
) -> Result<Report, ReportError> {
    let line = |row: &Row| {
        vec![
            row.case.clone(),
            row.method.clone(),
            scientific(row.value),
            scientific(row.relative_error),
            scientific(row.seconds),
        ]
    };
    let table = Table {
        columns: vec!["case", "method", "value", error, "seconds"],
        rows: rows.iter().map(line).collect(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", study))
}
