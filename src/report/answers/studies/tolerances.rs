//! Error against run time of whole scenes, by tolerance: a table, and a figure.

use crate::report::{Axis, Figure, Line, Report, ReportError, Table, scientific};
use crate::study::form_factors::tolerances::ToleranceRow;

/// A line for each scene, method and tolerance.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn tolerances_report(rows: &[ToleranceRow]) -> Result<Report, ReportError> {
    let line = |row: &ToleranceRow| {
        vec![
            row.scene.clone(),
            row.method.to_owned(),
            format!("{:.0e}", row.tolerance),
            format!("{:.0}", 1e9 * row.seconds),
            scientific(row.error),
            scientific(row.median_error),
            scientific(row.bound),
            scientific(row.median_bound),
            row.unreached.to_string(),
        ]
    };
    let notes = [
        (
            "ns",
            "for a pair that sees the other, preparations included, on one thread",
        ),
        (
            "error",
            "relative, to the closed forms of the squares before they are turned",
        ),
        ("missed", "pairs whose bound misses the tolerance"),
    ];
    let table = Table {
        columns: vec![
            "scene",
            "method",
            "tolerance",
            "ns",
            "error",
            "median",
            "bound",
            "median",
            "missed",
        ],
        rows: rows.iter().map(line).collect(),
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "tolerances"))
}

/// Errors below this cannot be told from the rounding of corners.
const LEAST_ERROR: f64 = 1e-17;

/// The largest error and the largest bound against the time for a pair, every pair computed.
pub(crate) fn tolerances_figure(rows: &[ToleranceRow]) -> Figure {
    let scenes = rows.chunk_by(|a, b| (&a.scene, a.method) == (&b.scene, b.method));
    let every = scenes.filter(|rows| rows[0].method == "every pair");
    let lines = every.flat_map(|rows| {
        let line = |name: &str, number: fn(&ToleranceRow) -> f64| Line {
            name: format!("{}: {name}", rows[0].scene),
            points: rows
                .iter()
                .map(|row| [1e9 * row.seconds, number(row).max(LEAST_ERROR)])
                .collect(),
        };
        [
            line("error", |row| row.error),
            line("bound", |row| row.bound),
        ]
    });
    Figure {
        x: Axis::logarithmic("nanoseconds for a pair"),
        y: Axis::logarithmic("relative error, the largest"),
        lines: lines.collect(),
        ..Figure::default()
    }
}
