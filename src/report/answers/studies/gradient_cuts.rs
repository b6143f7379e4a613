//! Tables of the studies of cuts across a gradient: their limits, profiles that are no powers,
//! other directions.

use crate::discretize::GradientLimit;
use crate::numeric::{Interval, Scalar};
use crate::question::{DirectionRecord, LimitRecord, ProfileRecord};
use crate::report::answers::cuts::percent;
use crate::report::{Report, ReportError, Table, certain_digits, enclosed_digits};

/// The three cuts at growing exponents, `n (1 − l)`, and the limits.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn limits_report(rows: &[LimitRecord]) -> Result<Report, ReportError> {
    let of = |cut| rows.iter().filter(move |row| row.cut == cut);
    let columns = GradientLimit::ALL.map(|cut| of(cut).collect::<Vec<_>>());
    let [first, ..] = &columns;
    let mut lines = Vec::new();
    for (index, row) in first.iter().enumerate() {
        let same = columns.each_ref().map(|column| column[index]);
        let scaled = same.map(|row| digits(&row.enclosure));
        let differences = same.map(|row| format!("{:.9}", row.scaled_difference));
        let exponent = format!("{:e}", row.exponent);
        lines.push([vec![exponent], scaled.to_vec(), differences.to_vec()].concat());
    }
    let last = columns.each_ref().map(|column| column.last());
    let limits = last.map(|row| row.map_or_else(String::new, |row| digits(&row.limit)));
    let rates =
        last.map(|row| row.map_or_else(String::new, |row| format!("{:.9}", row.rate.to_f64())));
    lines.push([vec!["∞".to_owned()], limits.to_vec(), rates.to_vec()].concat());
    let notes = [
        (
            "n (1 − l)",
            "first three columns, every digit certified; ∞ is the root of x = 2 (1 − e^−x), \
             (1 + eˣ) ln(1 + eˣ) = 2 eˣ, eˣ = 1 + 2x",
        ),
        (
            "× n",
            "what is left to the limit, times n: it tends to a number, so the cuts come \
             near as 1/n",
        ),
    ];
    let table = Table {
        columns: vec![
            "n",
            "m = 1",
            "m = n",
            "mean square",
            "m = 1, × n",
            "m = n, × n",
            "mean square, × n",
        ],
        rows: lines,
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "limits"))
}

fn digits(enclosure: &Interval) -> String {
    let digits = enclosed_digits(enclosure);
    // a certified 0.5 of a dyadic kind has no more
    digits.chars().take(17).collect()
}

/// Both cuts of every profile, side by side.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn profiles_report(rows: &[ProfileRecord]) -> Result<Report, ReportError> {
    let both = rows.chunks_exact(2);
    let lines = both.map(|cuts| profile_line(&cuts[0], &cuts[1]));
    let notes = [
        ("kept", "gain of the mean-square cut, of the highest"),
        (
            "error left",
            "square error of two constants, of that of one: by the mutual-information cut, by the \
             mean-square cut",
        ),
        ("*", "by symmetry 1 − l is as good"),
        (
            "constant irradiance",
            "weights are proportional to fluxes: every cut gains 0, and mutual information prefers \
             none",
        ),
    ];
    let table = Table {
        columns: vec![
            "radiosity B",
            "irradiance",
            "mutual-information cut",
            "mean-square cut",
            "apart",
            "gain (bits)",
            "kept",
            "error left",
            "least",
        ],
        rows: lines.collect(),
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "profiles"))
}

/// The line of one profile, from its cuts by both measures.
fn profile_line(information: &ProfileRecord, square: &ProfileRecord) -> Vec<String> {
    let position = |position: f64| {
        let digits = certain_digits(position, 1e-8);
        if square.has_twin {
            format!("{digits} *")
        } else {
            digits
        }
    };
    let positions = information.value.zip(square.value);
    let apart = positions.map(|(information, square)| square - information);
    let share = |share: Option<f64>| share.map_or_else(|| "—".to_owned(), percent);
    let gain = information.value.map(|_| information.gain);
    vec![
        square.case.to_owned(),
        square.irradiance.to_owned(),
        information.value.map_or_else(|| "any".to_owned(), position),
        square.value.map_or_else(String::new, position),
        apart.map_or_else(|| "—".to_owned(), |apart| certain_digits(apart, 1e-5)),
        gain.map_or_else(|| "0".to_owned(), |gain| format!("{gain:.4}")),
        share(square.gain_share),
        share(information.square_error),
        share(square.square_error),
    ]
}

/// The best gain at each angle, a column for each patch.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub(crate) fn directions_report(rows: &[DirectionRecord]) -> Result<Report, ReportError> {
    let patches: Vec<&[DirectionRecord]> = rows.chunk_by(|a, b| a.case == b.case).collect();
    let mut lines = Vec::new();
    for (index, row) in patches
        .first()
        .copied()
        .unwrap_or_default()
        .iter()
        .enumerate()
    {
        let mut line = vec![row.method.clone()];
        let same = patches.iter().filter_map(|patch| patch.get(index));
        line.extend(same.map(|row| percent(row.gain_share)));
        lines.push(line);
    }
    let notes = [
        (
            "angle",
            "between the cut and the perpendicular to the gradient: 0° cuts across it, 90° \
             along it",
        ),
        (
            "gain",
            "of the best cut at this angle, of the best of all angles; (n, m): radiosity ∝ lⁿ, \
             irradiance ∝ lᵐ",
        ),
    ];
    let table = Table {
        columns: vec!["angle", "(1, 1)", "(2, 1)", "(4, 1)", "(2, 2)", "(4, 4)"],
        rows: lines,
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Ok(Report::list(table, "rows", rows)?.entitled("study", "directions"))
}
