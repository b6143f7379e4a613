//! Time and memory against the number of patches, and the model of a cluster: a table.

use crate::report::{Report, ReportError, Table};
use crate::study::scale::{Basis, ScaleRow};

/// A line for each number, with what it rests on.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn scale_report(rows: &[ScaleRow]) -> Result<Report, ReportError> {
    let count = |count: Option<usize>| count.map_or_else(String::new, |count| count.to_string());
    let line = |row: &ScaleRow| {
        let basis = match row.basis {
            Basis::Measured => "measured",
            Basis::Assumed => "assumed",
            Basis::Predicted => "predicted",
        };
        vec![
            row.case.clone(),
            basis.to_owned(),
            count(row.patches),
            row.nodes.to_string(),
            row.ranks.to_string(),
            row.threads.to_string(),
            format!("{:.2e} {}", row.value, row.unit)
                .trim_end()
                .to_owned(),
            row.memory
                .map_or_else(String::new, |bytes| format!("{:.3}", bytes / 1e9)),
        ]
    };
    let notes = [
        (
            "memory",
            "of a rank; of what was measured, the most that one ever had",
        ),
        (
            "predicted",
            "from the terms above, by the model of study::scale::model; nothing was run on a \
             cluster",
        ),
    ];
    let table = Table {
        columns: vec![
            "work",
            "basis",
            "patches",
            "nodes",
            "ranks",
            "threads",
            "value",
            "memory, GB",
        ],
        rows: rows.iter().map(line).collect(),
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "scale"))
}
