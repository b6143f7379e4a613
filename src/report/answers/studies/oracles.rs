//! Table and figure of the oracles of refinement.

use crate::hierarchy::OracleName;
use crate::numeric::real;
use crate::report::{Axis, Figure, Line, Report, ReportError, Table};
use crate::study::hierarchy::oracles::OracleRow;

/// The oracles side by side: records with everything, and a table of the errors on the largest mesh
/// of each room, with their ratios to that of greedy refinement by the true error on each mesh.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn oracles_report(rows: &[OracleRow]) -> Result<Report, ReportError> {
    let mut lines = Vec::new();
    for room in rows.chunk_by(|a, b| a.case == b.case) {
        let meshes: Vec<&[OracleRow]> = meshes(room).collect();
        for (k, row) in meshes
            .last()
            .copied()
            .unwrap_or_default()
            .iter()
            .enumerate()
        {
            let ratios = meshes.iter().map(|mesh| ratio(mesh, k));
            lines.push(line(row, &ratios.collect::<Vec<_>>().join(" ")));
        }
    }
    let table = Table {
        columns: vec![
            "room",
            "oracle",
            "elements",
            "links",
            "extra",
            "error, %",
            "best on mesh, %",
            "linear, %",
            "to greedy",
            "seconds",
        ],
        rows: lines,
        notes: [
            (
                "extra",
                "form factors of points and pairs that the oracle asked for",
            ),
            ("best on mesh", "by the best constants on the same mesh"),
            (
                "to greedy",
                "error over that of refinement by the true error, on each mesh in turn",
            ),
        ]
        .map(|(name, note)| (name.to_owned(), note.to_owned()))
        .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "oracles"))
}

/// The rows of a room by meshes: each lists the same methods.
fn meshes(room: &[OracleRow]) -> impl Iterator<Item = &[OracleRow]> {
    let first = room.first().map(|row| row.method.as_str());
    let count = room
        .iter()
        .filter(|row| Some(row.method.as_str()) == first)
        .count();
    room.chunks(room.len() / count.max(1))
}

/// The ratio of an error to that of greedy refinement by the true error.
fn ratio(mesh: &[OracleRow], index: usize) -> String {
    let greedy = mesh
        .iter()
        .find(|row| row.method == OracleName::True.name());
    greedy.map_or_else(String::new, |greedy| {
        format!("{:.2}", mesh[index].relative_error / greedy.relative_error)
    })
}

fn line(row: &OracleRow, ratios: &str) -> Vec<String> {
    let percent = |error: f64| format!("{:.2}", 100.0 * error);
    vec![
        row.case.clone(),
        row.method.clone(),
        row.elements.to_string(),
        row.links.to_string(),
        (row.oracle_points + row.oracle_pairs).to_string(),
        percent(row.relative_error),
        percent(row.projection_error),
        percent(row.linear_error),
        ratios.to_owned(),
        format!("{:.3}", row.seconds),
    ]
}

/// Error against elements in the first room, a line for each oracle.
pub(crate) fn oracles_figure(rows: &[OracleRow]) -> Figure {
    let room: Vec<&OracleRow> = rows
        .chunk_by(|a, b| a.case == b.case)
        .next()
        .unwrap_or_default()
        .iter()
        .collect();
    let mut names: Vec<&str> = Vec::new();
    for row in &room {
        if !names.contains(&row.method.as_str()) {
            names.push(&row.method);
        }
    }
    let lines = names.iter().map(|name| Line {
        name: (*name).to_owned(),
        points: room
            .iter()
            .filter(|row| row.method == *name)
            .map(|row| [real(row.elements), row.relative_error])
            .collect(),
    });
    let axis = |label: &str| Axis {
        label: label.to_owned(),
        is_logarithmic: true,
    };
    Figure {
        x: axis("elements"),
        y: axis("relative error"),
        lines: lines.collect(),
        ..Figure::default()
    }
}
