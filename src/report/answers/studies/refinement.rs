//! Discrete mutual information on its way to the continuous one: a table, and a figure.

use crate::numeric::real;
use crate::report::{Axis, Figure, Line, Report, ReportError, Table, certain_digits, scientific};
use crate::study::refinement::RefinementRow;

/// Lines a figure can tell apart.
const MOST_LINES: usize = 6;

/// A line for each refinement.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn refinements_report(rows: &[RefinementRow]) -> Result<Report, ReportError> {
    let line = |row: &RefinementRow| {
        let digits = |number: Option<f64>, decimals: usize| {
            number.map_or_else(String::new, |number| format!("{number:.decimals$}"))
        };
        vec![
            row.scene.clone(),
            row.patches.to_string(),
            certain_digits(row.mutual_information, row.error),
            digits(Some(row.gap), 6),
            digits(Some(row.gap_per_edge), 3),
            digits(row.ratio, 3),
            row.extrapolated_gap.map_or_else(String::new, scientific),
        ]
    };
    let mut lines: Vec<Vec<String>> = Vec::new();
    for scene in rows.chunk_by(|a, b| a.scene == b.scene) {
        lines.extend(scene.iter().map(line));
        let limit = certain_digits(
            scene[0].continuous_mutual_information,
            scene[0].continuous_error,
        );
        let mut last = vec![scene[0].scene.clone(), "∞".to_owned(), format!("({limit})")];
        last.resize(7, String::new());
        lines.push(last);
    }
    let notes = [
        (
            "gap",
            "continuous mutual information less the discrete one, bits; the patches are \
             quartered from line to line",
        ),
        (
            "per edge",
            "gap × area / (length of all edges × size of a patch): tends to a number of \
             the angles and the shape of the patches",
        ),
        (
            "ratio",
            "the gap before, over this one: 2 where the gap is proportional to the size \
             of the patches",
        ),
        ("extrapolated", "what 2 I less the I before still lacks"),
    ];
    let table = Table {
        columns: vec![
            "scene",
            "patches",
            "I, bits",
            "gap",
            "per edge",
            "ratio",
            "extrapolated",
        ],
        rows: lines,
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "refinement"))
}

/// The gaps against the number of patches, of the first six scenes.
pub(crate) fn refinements_figure(rows: &[RefinementRow]) -> Figure {
    let point = |row: &RefinementRow| [real(row.patches), row.gap];
    let scenes = rows.chunk_by(|a, b| a.scene == b.scene).take(MOST_LINES);
    let lines = scenes.map(|scene| Line {
        name: scene[0].scene.clone(),
        points: scene.iter().map(point).collect(),
    });
    let axis = |label: &str| Axis {
        label: label.to_owned(),
        is_logarithmic: true,
    };
    Figure {
        x: axis("patches"),
        y: axis("mutual information lost, bits"),
        lines: lines.collect(),
        ..Figure::default()
    }
}
