//! The table of the lines of discontinuity of a patch, a map of them, and curves of the gain.

use crate::numeric::tolerance;
use crate::question::{DiscontinuitiesAnswer, DiscontinuityRecord, GainCurve};
use crate::report::{
    Axis, Figure, Line, Map, MappedLine, Report, ReportError, Table, certain_digits,
};

/// Renders the lines of discontinuity.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn discontinuities_report(answer: &DiscontinuitiesAnswer) -> Result<Report, ReportError> {
    let best = answer.best.iter().map(|best| {
        let at = |position| certain_digits(position, tolerance::OCCLUDED_POSITION);
        let text = format!(
            "by mutual information at {}, {} bit; by mean square at {}",
            at(best.position),
            bits(best.gain),
            at(best.square_position)
        );
        (format!("best cut across {}", best.axis), text)
    });
    let table = Table {
        columns: vec![
            "line",
            "from",
            "to",
            "made by",
            "gain, bits",
            "kept",
            "mean square kept",
        ],
        rows: answer.lines.iter().map(row).collect(),
        notes: best.collect(),
        ..Table::default()
    };
    Report::one(table, answer)
}

fn bits(gain: f64) -> String {
    certain_digits(gain, tolerance::OCCLUDED_GAIN * gain.abs())
}

fn row(line: &DiscontinuityRecord) -> Vec<String> {
    let [from, to] = line.ends.map(|end| {
        // no sign where all decimals are 0
        let shown = end.map(|coordinate| (1e6 * coordinate).round() / 1e6 + 0.0);
        let coordinates = shown.map(|coordinate| format!("{coordinate:.6}"));
        coordinates.join(", ")
    });
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    let others = match line.made_by.len() {
        0 | 1 => String::new(),
        count => format!(", and {} more", count - 1),
    };
    let first = line.made_by.first().map_or("", String::as_str);
    vec![
        line.kind.to_owned(),
        from,
        to,
        format!("{first}{others}"),
        bits(line.gain),
        percent(line.kept),
        percent(line.square_kept),
    ]
}

/// The map of the patch with its lines; none if it was not asked for.
#[must_use]
pub fn discontinuities_map(answer: &DiscontinuitiesAnswer) -> Option<Map> {
    let map = answer.map.as_ref()?;
    let lines = answer.lines.iter().zip(&map.lines);
    let lines = lines.map(|(record, ends)| MappedLine {
        kind: record.kind,
        ends: *ends,
    });
    Some(Map {
        quantity: "form factor".to_owned(),
        outline: map.outline.clone(),
        corner: map.corner,
        cell: map.cell,
        values: map.form_factors.clone(),
        lines: lines.collect(),
    })
}

/// The gain as a function of the cut across an axis, with the lines parallel to it.
#[must_use]
pub fn gain_figure(answer: &DiscontinuitiesAnswer, axis: &str) -> Option<Figure> {
    let map = answer.map.as_ref()?;
    let curve = map.curves.iter().find(|curve| curve.axis == axis)?;
    let points = |values: &[f64]| {
        let points = curve.positions.iter().zip(values);
        points.map(|(x, y)| [*x, *y]).collect()
    };
    let named = |name: &str, points| Line {
        name: name.to_owned(),
        points,
    };
    let mut lines = vec![
        named("mutual information gained by the cut", points(&curve.gains)),
        named("mean square explained by it", points(&curve.square_gains)),
    ];
    lines.extend(marks(curve));
    let axis = |label: String| Axis {
        label,
        is_logarithmic: false,
    };
    Some(Figure {
        x: axis(format!("cut, share of the patch along {}", curve.axis)),
        y: axis("share of the best cut's".to_owned()),
        lines,
        ..Figure::default()
    })
}

/// A line for each kind of discontinuity that runs along the cuts, up and down at each of them.
fn marks(curve: &GainCurve) -> Vec<Line> {
    let kinds = ["lit", "umbra", "sharp", "penumbra"];
    let marks = kinds.into_iter().filter_map(|kind| {
        let at = curve.lines.iter().filter(|(_, own)| *own == kind);
        let points: Vec<[f64; 2]> = at
            .flat_map(|(x, _)| [[*x, 0.0], [*x, 1.0], [*x, 0.0]])
            .collect();
        (!points.is_empty()).then(|| Line {
            name: format!("lines of discontinuity: {kind}"),
            points,
        })
    });
    marks.collect()
}
