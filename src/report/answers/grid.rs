//! Table of a grid on a box: its mutual information, and the evidence that it is the best one.

use super::sampled::{SampledRecord, sampled_rows};
use crate::discretize::{BestGrid, BoxGrid, GridInformation, Spacing};
use crate::information::LineSample;
use crate::numeric::interval::DecimalBounds;
use crate::numeric::{Bounded, Grade, Interval};
use crate::question::{GridAnswer, GridEnclosures};
use crate::report::{Report, ReportError, Table, certain_digits, enclosed_digits, scientific};

/// The answer to [`Grid`](crate::question::Grid): a line for each quantity, and a note for each
/// enclosure.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn grid_report(answer: &GridAnswer) -> Result<Report, ReportError> {
    let mut rows = information_rows(answer);
    rows.extend(search_rows(answer));
    rows.extend(answer.sampled.iter().flat_map(sampled_rows));
    let table = Table {
        columns: vec!["quantity", "value"],
        rows: rows
            .into_iter()
            .map(|(quantity, value)| vec![quantity.to_owned(), value])
            .collect(),
        wrapped: Some(1),
        notes: answer.enclosures.iter().flat_map(enclosure_notes).collect(),
    };
    Report::one(table, answer)
}

/// The grid and its mutual information.
fn information_rows(answer: &GridAnswer) -> Vec<(&'static str, String)> {
    let [x, y, z] = answer.edges;
    let mut rows = vec![
        ("edges of the box", format!("{x}, {y}, {z}")),
        ("cells an edge", answer.cells.to_string()),
        ("patches", answer.patches.to_string()),
        ("pairs that see each other", answer.pairs.to_string()),
        ("classes of congruent ones", answer.classes.to_string()),
        ("lines, relative to the edge", lines(answer)),
        (
            "mutual information, bits",
            certain_digits(answer.mutual_information, answer.error),
        ),
        (
            "its error, bits",
            format!("{} (bound)", scientific(answer.error)),
        ),
    ];
    if !answer.is_regular() {
        let [gain, error] = answer.gain_over_regular();
        rows.extend([
            (
                "that of the regular grid, bits",
                certain_digits(answer.regular_mutual_information, answer.regular_error),
            ),
            ("more than that, bits", certain_digits(gain, error)),
        ]);
    }
    rows
}

/// The lines: with the digits that are certain if they were found, as they are if they were given.
fn lines(answer: &GridAnswer) -> String {
    let found = answer.line_error.filter(|_| answer.curvature.is_some());
    let line = |line: &f64| match found {
        Some(error) => certain_digits(*line, error),
        None => line.to_string(),
    };
    let lines: Vec<String> = answer.lines.iter().map(line).collect();
    match (lines.len(), found.is_some()) {
        (0, _) => "none".to_owned(),
        (count, _) if answer.is_regular() => format!("{count}, equally spaced"),
        (_, true) => format!("({})", lines.join(", ")),
        (_, false) => lines.join(", "),
    }
}

/// The evidence for a maximum, if one was searched for.
fn search_rows(answer: &GridAnswer) -> Vec<(&'static str, String)> {
    let (Some(line_error), Some(slope)) = (answer.line_error, answer.slope) else {
        return Vec::new();
    };
    let (Some(curvature), Some(error)) = (answer.curvature, answer.curvature_error) else {
        return vec![("evidence", "no line is free".to_owned())];
    };
    vec![
        (
            "error of the lines",
            format!("({}) (estimate)", scientific(line_error)),
        ),
        ("largest derivative left, bits", scientific(slope)),
        (
            "largest curvature, bits",
            format!(
                "({}) (estimate): a local maximum",
                certain_digits(curvature, error)
            ),
        ),
        ("highest of all (sample)", starts(answer)),
    ]
}

/// The starts of the search, and the other maxima that they found.
fn starts(answer: &GridAnswer) -> String {
    let others = match answer.other_maxima.as_deref().unwrap_or_default() {
        [] => "no other maximum was found".to_owned(),
        others @ [next, ..] => format!(
            "{} lower ones were found, the highest of ({next:.6}) bits",
            others.len()
        ),
    };
    let lost = match answer.starts_lost.unwrap_or(0) {
        0 => String::new(),
        lost => format!(", {lost} came to no rest"),
    };
    let [reached, starts] =
        [answer.starts_at_maximum, answer.starts].map(|count| count.unwrap_or(0));
    format!("{reached} of {starts} starts end there{lost}; {others}")
}

fn enclosure_notes(enclosures: &GridEnclosures) -> Vec<(String, String)> {
    let lines = (1..).zip(&enclosures.half);
    let lines = lines.map(|(k, line)| (format!("line {k}"), enclosed_digits(line)));
    let information = enclosed_digits(&enclosures.mutual_information);
    let others = [
        ("mutual information, bits".to_owned(), information),
        ("certificate".to_owned(), enclosures.certificate.clone()),
    ];
    lines.chain(others).collect()
}
