//! Tables of the studies that set several methods side by side: one line per case, records with
//! everything.

use crate::report::{Axis, Figure, Line, Report, ReportError, Table, scientific};
use crate::study::form_factors::accuracy::{AccuracyRow, HALFWAY};
use crate::study::form_factors::extreme_pairs::{CHOSEN, StabilityRow};

/// The digits that naive forms and the routes keep in stiff and extreme cases: a line per case.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn stability_report(rows: &[StabilityRow]) -> Result<Report, ReportError> {
    let table = Table {
        columns: vec!["case", "value", "route", "bound", "error", "digits kept"],
        rows: rows.chunk_by(|a, b| a.case == b.case).map(line).collect(),
        wrapped: Some(5),
        notes: [
            (
                "error",
                "relative, to 256 bits: of the route chosen; of gains of the sum of terms",
            ),
            (
                "digits kept",
                "by each form or route alone; a route that is not named refuses",
            ),
        ]
        .map(|(name, note)| (name.to_owned(), note.to_owned()))
        .to_vec(),
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "stability"))
}

/// The line of one case.
fn line(rows: &[StabilityRow]) -> Vec<String> {
    let best = rows
        .iter()
        .find(|row| row.method == CHOSEN || row.method == "sum-of-terms");
    let number = |number: Option<f64>| number.map_or_else(|| "—".to_owned(), scientific);
    let others = rows.iter().filter(|row| row.method != CHOSEN);
    let others =
        others.filter_map(|row| Some(format!("{} {}", row.method, digits(row.relative_error?))));
    let mut kept = others.collect::<Vec<_>>().join(", ");
    if let Some(error) = rows.iter().find_map(|row| row.input_error) {
        kept += &format!(
            "; the rounded corners keep {} of what was meant",
            digits(error)
        );
    }
    let chosen = best.filter(|row| row.method == CHOSEN);
    let route = chosen.map_or("—", |row| row.route.unwrap_or("refused"));
    vec![
        rows[0].case.clone(),
        significant(rows[0].value),
        route.to_owned(),
        number(best.and_then(|row| row.bound)),
        number(best.and_then(|row| row.relative_error)),
        kept,
    ]
}

/// Three digits.
fn significant(value: f64) -> String {
    format!("{value:.2e}")
}

/// `−log10` of a relative error, at most 17.
fn digits(error: f64) -> String {
    format!("{:.0}", (-error.log10()).clamp(0.0, 17.0).floor())
}

/// Times of one pair that the digest of [`accuracy_report`] asks about, in seconds, and their
/// headings.
const BUDGETS: [(f64, &str); 6] = [
    (1e-6, "1 µs"),
    (1e-5, "10 µs"),
    (1e-4, "100 µs"),
    (1e-3, "1 ms"),
    (1e-2, "10 ms"),
    (1e-1, "100 ms"),
];

/// Error against run time: records for log-log plots, and a table of the error that each method
/// reaches within a time.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn accuracy_report(rows: &[AccuracyRow]) -> Result<Report, ReportError> {
    let mut lines = Vec::new();
    for family in rows.chunk_by(|a, b| a.family == b.family) {
        let mut methods: Vec<&str> = Vec::new();
        for row in family {
            if !methods.contains(&row.method) {
                methods.push(row.method);
            }
        }
        for method in methods {
            let of_method = family.iter().filter(|row| row.method == method);
            let of_method: Vec<_> = of_method.collect();
            let (served, pairs) = coverage(family, &of_method);
            let mut line = vec![
                family[0].family.clone(),
                method.to_owned(),
                format!("{served}/{pairs}"),
            ];
            let cells = BUDGETS.map(|(budget, _)| reached(&of_method, budget));
            line.extend(cells.map(|error| error.map_or_else(String::new, scientific)));
            lines.push(line);
        }
    }
    let mut columns = vec!["family", "method", "pairs"];
    columns.extend(BUDGETS.map(|(_, heading)| heading));
    let note = "largest relative error over the pairs served, by the most accurate setting that \
                takes no longer for any case; empty where every setting does";
    let table = Table {
        columns,
        rows: lines,
        notes: vec![("in a time for one pair".to_owned(), note.to_owned())],
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "accuracy"))
}

/// Errors below this cannot be told from it in `f64`.
const LEAST_ERROR: f64 = 1e-17;

/// Error against run time past plates half-way, a line for each method.
pub(crate) fn accuracy_figure(rows: &[AccuracyRow]) -> Figure {
    let rows = rows.iter().filter(|row| row.family == HALFWAY);
    let rows: Vec<&AccuracyRow> = rows.collect();
    let point = |row: &&AccuracyRow| [row.seconds, row.mean_square_error.max(LEAST_ERROR)];
    let lines = rows
        .chunk_by(|a, b| a.method == b.method)
        .map(|method| Line {
            name: match method[0].method {
                "chooser" => "this route",
                "point-rule" => "rule over the area",
                "local-lines" => "lines",
                "quasi-random" => "quasi-random lines",
                other => other,
            }
            .to_owned(),
            points: method.iter().map(point).collect(),
        });
    let axis = |label: &str| Axis {
        label: label.to_owned(),
        is_logarithmic: true,
    };
    Figure {
        x: axis("seconds for a pair"),
        y: axis("relative error, root mean square"),
        lines: lines.collect(),
        ..Figure::default()
    }
}

/// Pairs that a method serves at some setting, and all pairs of a family.
fn coverage(family: &[AccuracyRow], of_method: &[&AccuracyRow]) -> (usize, usize) {
    let cases = family.chunk_by(|a, b| a.case == b.case);
    cases.fold((0, 0), |(served, pairs), case| {
        let rows = of_method.iter().filter(|row| row.case == case[0].case);
        let most = rows.map(|row| row.served).max().unwrap_or(0);
        (served + most, pairs + case[0].pairs)
    })
}

/// The largest error among the cases, each with the best setting within the time; `None` if a case
/// has none.
fn reached(of_method: &[&AccuracyRow], budget: f64) -> Option<f64> {
    let cases = of_method.chunk_by(|a, b| a.case == b.case);
    let best = cases.map(|case| {
        let within = case.iter().filter(|row| row.seconds <= budget);
        within.map(|row| row.relative_error).reduce(f64::min)
    });
    best.reduce(|a, b| Some(a?.max(b?))).flatten()
}
