//! Tables of the studies of cuts across a gradient: their limits, profiles that are no powers, other directions.

use crate::discretize::GradientLimit;
use crate::numeric::interval::DecimalBounds;
use crate::numeric::{Interval, Scalar};
use crate::report::answers::cuts::percent;
use crate::report::{Report, ReportError, Table, certain_digits, enclosed_digits};
use crate::study::cuts::directions::DirectionRow;
use crate::study::cuts::limits::LimitRow;
use crate::study::cuts::profiles::ProfileRow;

/// A row of the limits, as a record.
#[derive(Debug, serde::Serialize)]
struct LimitRecord {
    case: String,
    method: &'static str,
    exponent: f64,
    value: f64,
    relative_error: f64,
    scaled_difference: f64,
    limit: Option<DecimalBounds>,
    rate: Option<DecimalBounds>,
    seconds: f64,
}

/// Decimals of the limits in records.
const DECIMALS: u32 = 60;

const fn name(cut: GradientLimit) -> &'static str {
    match cut {
        GradientLimit::FixedIrradiance => "mutual information, m = 1",
        GradientLimit::EqualExponents => "mutual information, m = n",
        GradientLimit::MeanSquare => "mean square",
    }
}

/// The three cuts at growing exponents, `n (1 − l)`, and the limits.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn limits_report(rows: &[LimitRow]) -> Result<Report, ReportError> {
    let of = |cut| rows.iter().filter(move |row| row.cut == cut);
    let columns = GradientLimit::ALL.map(|cut| of(cut).collect::<Vec<_>>());
    let [first, ..] = &columns;
    let mut lines = Vec::new();
    for (index, row) in first.iter().enumerate() {
        let same = columns.each_ref().map(|column| column[index]);
        let scaled = same.map(|row| digits(&row.scaled));
        let differences = same.map(|row| format!("{:.9}", row.scaled_difference.to_f64()));
        let exponent = format!("{:e}", row.exponent);
        lines.push([vec![exponent], scaled.to_vec(), differences.to_vec()].concat());
    }
    let last = columns.each_ref().map(|column| column.last());
    let limits = last.map(|row| row.map_or_else(String::new, |row| digits(&row.limits.limit)));
    let rates = last.map(|row| {
        row.map_or_else(String::new, |row| {
            format!("{:.9}", row.limits.rate.to_f64())
        })
    });
    lines.push([vec!["∞".to_owned()], limits.to_vec(), rates.to_vec()].concat());
    let notes = [
        (
            "n (1 − l)",
            "first three columns, every digit certified; ∞ is the root of x = 2 (1 − e^−x), (1 + eˣ) ln(1 + eˣ) = 2 eˣ, eˣ = 1 + 2x",
        ),
        (
            "× n",
            "what is left to the limit, times n: it tends to a number, so the cuts come near as 1/n",
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
    let record = |row: &LimitRow| LimitRecord {
        case: format!("n = {:e}", row.exponent),
        method: name(row.cut),
        exponent: row.exponent,
        value: row.scaled.to_f64(),
        relative_error: ((row.scaled.clone() - &row.limits.limit) / &row.limits.limit)
            .abs()
            .to_f64(),
        scaled_difference: row.scaled_difference.to_f64(),
        limit: row.limits.limit.to_decimal(DECIMALS),
        rate: row.limits.rate.to_decimal(DECIMALS),
        seconds: row.seconds,
    };
    let records: Vec<LimitRecord> = rows.iter().map(record).collect();
    Ok(Report::list(table, "rows", &records)?.entitled("study", "limits"))
}

fn digits(enclosure: &Interval) -> String {
    let digits = enclosed_digits(enclosure);
    // a certified 0.5 of a dyadic kind has no more
    digits.chars().take(17).collect()
}

/// One cut of one profile, as a record.
#[derive(Debug, serde::Serialize)]
struct ProfileRecord<'r> {
    case: &'r str,
    irradiance: &'r str,
    method: &'static str,
    value: Option<f64>,
    gain: f64,
    gain_share: Option<f64>,
    square_error: Option<f64>,
    relative_error: Option<f64>,
    has_twin: bool,
    seconds: f64,
}

/// Both cuts of every profile, side by side.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn profiles_report(rows: &[ProfileRow]) -> Result<Report, ReportError> {
    let line = |row: &ProfileRow| {
        let twin = |text: String| {
            if row.is_symmetric {
                format!("{text} *")
            } else {
                text
            }
        };
        let position = |position: f64| twin(certain_digits(position, 1e-8));
        let square = row.square;
        let mut line = vec![row.case.to_owned(), row.irradiance.to_owned()];
        line.extend(match row.information {
            Some(information) => [
                position(information.position),
                position(square.position),
                certain_digits(square.position - information.position, 1e-5),
                format!("{:.4}", information.gain),
                percent(square.gain / information.gain),
                percent(information.square_error),
                percent(square.square_error),
            ],
            None => [
                "any".to_owned(),
                position(square.position),
                "—".to_owned(),
                "0".to_owned(),
                "—".to_owned(),
                "—".to_owned(),
                percent(square.square_error),
            ],
        });
        line
    };
    let notes = [
        ("kept", "gain of the mean-square cut, of the highest"),
        (
            "error left",
            "square error of two constants, of that of one: by the mutual-information cut, by the mean-square cut",
        ),
        ("*", "by symmetry 1 − l is as good"),
        (
            "constant irradiance",
            "weights are proportional to fluxes: every cut gains 0, and mutual information prefers none",
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
        rows: rows.iter().map(line).collect(),
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    let mut records = Vec::new();
    for row in rows {
        let least = row.square.square_error;
        let highest = row.information.map(|cut| cut.gain);
        let cuts = [
            ("mutual information", row.information, row.seconds[0]),
            ("mean square", Some(row.square), row.seconds[1]),
        ];
        for (method, cut, seconds) in cuts {
            records.push(ProfileRecord {
                case: row.case,
                irradiance: row.irradiance,
                method,
                value: cut.map(|cut| cut.position),
                gain: cut.map_or(0.0, |cut| cut.gain),
                gain_share: cut.and_then(|cut| Some(cut.gain / highest?)),
                square_error: cut.map(|cut| cut.square_error),
                relative_error: cut
                    .filter(|_| least > 1e-12)
                    .map(|cut| cut.square_error / least - 1.0),
                has_twin: row.is_symmetric,
                seconds,
            });
        }
    }
    Ok(Report::list(table, "rows", &records)?.entitled("study", "profiles"))
}

/// The best cut at one angle, as a record.
#[derive(Debug, serde::Serialize)]
struct DirectionRecord {
    case: String,
    method: String,
    exponent: f64,
    irradiance_exponent: f64,
    degrees: f64,
    offset: f64,
    gain: f64,
    gain_share: f64,
    seconds: f64,
}

/// The best gain at each angle, a column for each patch.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn directions_report(rows: &[DirectionRow]) -> Result<Report, ReportError> {
    let patches: Vec<&[DirectionRow]> = rows.chunk_by(|a, b| a.patch == b.patch).collect();
    let mut lines = Vec::new();
    for (index, row) in patches
        .first()
        .copied()
        .unwrap_or_default()
        .iter()
        .enumerate()
    {
        let mut line = vec![format!("{}°", row.best.cut.degrees())];
        let same = patches.iter().filter_map(|patch| patch.get(index));
        line.extend(same.map(|row| percent(row.share)));
        lines.push(line);
    }
    let notes = [
        (
            "angle",
            "between the cut and the perpendicular to the gradient: 0° cuts across it, 90° along it",
        ),
        (
            "gain",
            "of the best cut at this angle, of the best of all angles; (n, m): radiosity ∝ lⁿ, irradiance ∝ lᵐ",
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
    let record = |row: &DirectionRow| {
        let (n, m) = (row.patch.exponent(), row.patch.irradiance_exponent());
        DirectionRecord {
            case: format!("n = {n}, m = {m}"),
            method: format!("{}°", row.best.cut.degrees()),
            exponent: n,
            irradiance_exponent: m,
            degrees: row.best.cut.degrees(),
            offset: row.best.cut.offset(),
            gain: row.best.gain,
            gain_share: row.share,
            seconds: row.seconds,
        }
    };
    let records: Vec<DirectionRecord> = rows.iter().map(record).collect();
    Ok(Report::list(table, "rows", &records)?.entitled("study", "directions"))
}
