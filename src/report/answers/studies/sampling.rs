//! Tables of the studies of sampled lines: error against run time, and fig. 5.

use crate::report::{Report, ReportError, Table, scientific};
use crate::study::lines::figure_5::Figure5Row;
use crate::study::lines::sampling::{SamplingRow, slope};

/// Errors by number of lines, a line for each way to an estimate; records have all.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn sampling_report(rows: &[SamplingRow]) -> Result<Report, ReportError> {
    let mut numbers: Vec<u32> = rows.iter().filter_map(|row| row.lines).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let mut lines = Vec::new();
    for case in rows.chunk_by(|a, b| a.case == b.case) {
        let mut ways: Vec<(&str, Option<&str>)> = Vec::new();
        for row in case {
            if !ways.contains(&(row.method, row.kind)) {
                ways.push((row.method, row.kind));
            }
        }
        for (method, kind) in ways {
            let of_way: Vec<&SamplingRow> = case
                .iter()
                .filter(|row| (row.method, row.kind) == (method, kind))
                .collect();
            let way = kind.map_or_else(|| method.to_owned(), |kind| format!("{method}, {kind}"));
            let mut line = vec![case[0].case.clone(), case[0].patches.to_string(), way];
            line.extend(numbers.iter().map(|number| {
                let row = of_way.iter().find(|row| row.lines == Some(*number));
                row.map_or_else(String::new, |row| format!("{:.1e}", row.error))
            }));
            let last = of_way.last().map(|row| (row.error, row.seconds));
            let (error, seconds) = last.unwrap_or((0.0, 0.0));
            let slope = slope(of_way.iter().copied());
            line.push(match (slope, kind) {
                (Some(slope), _) => format!("{slope:.2}"),
                (None, None) => format!("error {}", scientific(error)),
                (None, Some(_)) => String::new(),
            });
            line.push(scientific(seconds));
            lines.push(line);
        }
    }
    let headings = |number: u32| match number {
        1000 => "10³ lines",
        10_000 => "10⁴",
        100_000 => "10⁵",
        1_000_000 => "10⁶",
        _ => "10⁷",
    };
    let mut columns = vec!["scene", "patches", "estimate"];
    columns.extend(numbers.iter().map(|number| headings(*number)));
    columns.extend(["slope", "seconds"]);
    let notes = [
        ("errors", "roots of mean squares over seeds, in bits"),
        (
            "slope",
            "of log error over log lines, where pairs are met often enough for an interval",
        ),
        ("seconds", "of one estimate from the most lines"),
    ];
    let table = Table {
        columns,
        rows: lines,
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "sampling"))
}

/// Printed, expected and sampled values of the grids of fig. 5.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn figure_5_report(rows: &[Figure5Row]) -> Result<Report, ReportError> {
    let line = |row: &Figure5Row| {
        let runs = f64::from(u32::try_from(row.runs).unwrap_or(u32::MAX)).sqrt();
        vec![
            row.case.to_owned(),
            row.printed
                .map_or_else(String::new, |value| format!("{value:.4}")),
            format!("{:.6}", row.mutual_information),
            format!("{:.4} ± {:.4}", row.expected, row.deviation),
            format!("{:.4} ± {:.4}", row.sampled, row.sampled_deviation / runs),
            row.printed_difference
                .map_or_else(String::new, |value| format!("{value:+.4}")),
            format!("{:+.4} ± {:.4}", row.difference, row.difference_deviation),
            row.samples_for_printed
                .map_or_else(String::new, |[at, from, to]| {
                    format!("{at} ({from} to {to})")
                }),
        ]
    };
    let mut notes = Vec::new();
    if let Some(row) = rows.first() {
        let reading = format!(
            "6 × 6 cells on every face of a cube, plug-in estimates from N = {} lines with the \
             areas known, a round number that is not fitted; the lines at a quarter are a guess: \
             the best explanation found, not a proof",
            row.samples
        );
        let spread = format!(
            "± is the standard deviation of one run, of \"sampled\" that of the mean of {} runs; \
             all grids have the same lines",
            row.runs
        );
        let range = "N at which the printed value is expected, and for half a unit of its last \
                     decimal more and less";
        notes = vec![
            ("reading", reading),
            ("spread", spread),
            ("N", range.to_owned()),
        ];
    }
    let table = Table {
        columns: vec![
            "grid",
            "printed",
            "exact",
            "expected",
            "sampled",
            "printed difference",
            "sampled difference",
            "N",
        ],
        rows: rows.iter().map(line).collect(),
        notes: notes
            .into_iter()
            .map(|(name, note)| (name.to_owned(), note))
            .collect(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "figure-5"))
}
