//! Form factors from points in any format, written point by point: there may be very many.

use crate::question::{PointRecord, PointsAnswer, SeenPatch};
use crate::report::render::finite;
use crate::report::{Format, ReportError, Table, certain_digits, scientific};
use serde::Serialize;
use std::io::Write;

/// Lines that a table shows; records carry all.
const MOST_ROWS: usize = 1000;

/// A form factor as a line, with what JSON has beside the list.
#[derive(Serialize)]
struct CsvRecord<'p> {
    point: usize,
    to: usize,
    value: f64,
    error: f64,
    to_name: &'p str,
    unseen: Option<f64>,
    unseen_error: Option<f64>,
    backs: Option<f64>,
    backs_error: Option<f64>,
}

/// Writes form factors from points in any format: in CSV a line for each point and row, in tables
/// those that are not 0.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite, before anything is
/// written; [`ReportError::Write`], [`ReportError::Csv`] or [`ReportError::Json`] if the text
/// cannot be written.
pub fn write_points(
    answer: &PointsAnswer,
    format: Format,
    mut text: impl Write,
) -> Result<(), ReportError> {
    for (index, patch) in answer.patches.iter().enumerate() {
        finite::check_entry("patches", index, patch)?;
    }
    for (index, point) in answer.points.iter().enumerate() {
        finite::check_entry("points", index, point)?;
    }
    match format {
        Format::Json => {
            serde_json::to_writer_pretty(&mut text, answer)?;
            writeln!(text)?;
        }
        Format::Csv => {
            let mut writer = csv::Writer::from_writer(text);
            for point in &answer.points {
                for seen in &point.form_factors {
                    writer.serialize(CsvRecord {
                        point: point.index,
                        to: seen.to,
                        value: seen.value,
                        error: seen.error,
                        to_name: &answer.patches[seen.to].name,
                        unseen: point.unseen,
                        unseen_error: point.unseen_error,
                        backs: point.backs,
                        backs_error: point.backs_error,
                    })?;
                }
            }
            writer.flush()?;
        }
        Format::Table => text.write_all(table(answer).to_terminal().as_bytes())?,
        Format::Markdown => text.write_all(table(answer).to_markdown().as_bytes())?,
        Format::Latex => text.write_all(table(answer).to_latex().as_bytes())?,
    }
    Ok(())
}

fn table(answer: &PointsAnswer) -> Table {
    let mut rows = answer
        .points
        .iter()
        .flat_map(|point| lines(point, &answer.patches));
    let shown = rows.by_ref().take(MOST_ROWS).collect();
    let more = rows.count();
    let note = format!("{more}: --format csv or json lists all");
    let note = (more > 0).then(|| ("lines not shown".to_owned(), note));
    Table {
        columns: vec!["point", "to", "form factor", "±"],
        rows: shown,
        notes: note.into_iter().collect(),
        ..Table::default()
    }
}

/// The patches that a point sees, and the part that sees none.
fn lines<'p>(
    point: &'p PointRecord,
    patches: &'p [SeenPatch],
) -> impl Iterator<Item = Vec<String>> + 'p {
    let line = move |what: String, value: f64, error: f64| {
        vec![
            point.index.to_string(),
            what,
            certain_digits(value, error),
            scientific(error),
        ]
    };
    let seen = point.form_factors.iter();
    let seen = seen.filter(|seen| seen.value > 0.0);
    let seen = seen.map(move |seen| {
        let what = format!("{} ({})", seen.to, patches[seen.to].name);
        line(what, seen.value, seen.error)
    });
    let unseen = point.unseen.zip(point.unseen_error);
    let unseen = unseen.map(move |(value, error)| line("no patch".to_owned(), value, error));
    let backs = point.backs.filter(|value| *value > 0.0);
    let backs = backs.zip(point.backs_error);
    let backs = backs.map(move |(value, error)| {
        let what = "of these back sides and obstructions".to_owned();
        line(what, value, error)
    });
    seen.chain(unseen).chain(backs)
}
