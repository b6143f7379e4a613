//! The cuts across a radiosity gradient (§4.2): of one patch, or of many side by side.

use crate::discretize::{CertifiedCut, Cut, CutComparison};
use crate::numeric::interval::DecimalBounds;
use crate::numeric::{Interval, tolerance};
use crate::report::{
    Axis, Figure, Line, Report, ReportError, Table, certain_digits, enclosed_digits,
};

/// Both cuts as a record: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Record {
    exponent: f64,
    irradiance_exponent: f64,
    mutual_information_cut: f64,
    mutual_information_complement: f64,
    mutual_information_gain: f64,
    mean_square_cut: f64,
    mean_square_complement: f64,
    mean_square_error: f64,
    distance: f64,
    gain_at_mean_square_cut: f64,
    error_at_mutual_information_cut: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    enclosures: Option<Enclosures>,
}

/// Decimal bounds of the same quantities.
#[derive(Debug, serde::Serialize)]
struct Enclosures {
    mutual_information_cut: Option<DecimalBounds>,
    mutual_information_complement: Option<DecimalBounds>,
    mutual_information_gain: Option<DecimalBounds>,
    mean_square_cut: Option<DecimalBounds>,
    mean_square_complement: Option<DecimalBounds>,
    mean_square_error: Option<DecimalBounds>,
}

/// More decimals than any precision leaves certain.
const MOST_DECIMALS: u32 = 100_000;

fn bounds(enclosure: &Interval) -> Option<DecimalBounds> {
    enclosure.to_decimal(MOST_DECIMALS)
}

impl From<&[CertifiedCut; 2]> for Enclosures {
    fn from([information, square]: &[CertifiedCut; 2]) -> Self {
        Self {
            mutual_information_cut: bounds(&information.position),
            mutual_information_complement: bounds(&information.complement),
            mutual_information_gain: bounds(&information.value),
            mean_square_cut: bounds(&square.position),
            mean_square_complement: bounds(&square.complement),
            mean_square_error: bounds(&square.value),
        }
    }
}

impl From<&CutComparison> for Record {
    fn from(cuts: &CutComparison) -> Self {
        let (information, square) = (&cuts.information, &cuts.square);
        Self {
            exponent: cuts.patch.exponent(),
            irradiance_exponent: cuts.patch.irradiance_exponent(),
            mutual_information_cut: information.position,
            mutual_information_complement: information.complement,
            mutual_information_gain: information.value,
            mean_square_cut: square.position,
            mean_square_complement: square.complement,
            mean_square_error: square.value,
            distance: cuts.distance(),
            gain_at_mean_square_cut: cuts.gain_at_square,
            error_at_mutual_information_cut: cuts.error_at_information,
            enclosures: cuts.certified.as_ref().map(Enclosures::from),
        }
    }
}

/// The cuts of one patch: a line each, and their bounds if they were enclosed.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn cut_report(cuts: &CutComparison) -> Result<Report, ReportError> {
    let row = |name: &str, cut: &Cut, gain: f64, error: f64| {
        vec![
            name.to_owned(),
            certain_digits(cut.position, tolerance::POSITION),
            format!("{:.11e}", cut.complement),
            format!("{gain:.11e}"),
            format!("{error:.11e}"),
        ]
    };
    let (information, square) = (&cuts.information, &cuts.square);
    let names = ["mutual information", "mean square"];
    let certified = cuts.certified.iter().flatten().zip(names);
    let certified = certified.filter_map(|(cut, name)| {
        let bounds = bounds(&cut.position)?;
        let between = format!("between {} and {}", bounds.lower, bounds.upper);
        Some((name.to_owned(), between))
    });
    let cost = format!(
        "the mean-square cut keeps {} of the gain; the other has {} more than the least square error",
        percent(cuts.gain_kept()),
        percent(cuts.error_excess())
    );
    let table = Table {
        columns: vec![
            "cut by",
            "position l",
            "1 − l",
            "gain (bits)",
            "mean square error",
        ],
        rows: vec![
            row(
                names[0],
                information,
                information.value,
                cuts.error_at_information,
            ),
            row(names[1], square, cuts.gain_at_square, square.value),
        ],
        notes: certified.chain([("cost".to_owned(), cost)]).collect(),
        ..Table::default()
    };
    Report::one(table, &Record::from(cuts))
}

/// The cuts of many patches: a line each, records under `cuts` in JSON.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn cuts_report(all: &[CutComparison]) -> Result<Report, ReportError> {
    let row = |cuts: &CutComparison| {
        let positions = match &cuts.certified {
            Some(certified) => certified
                .each_ref()
                .map(|cut| enclosed_digits(&cut.position)),
            None => [cuts.information, cuts.square].map(|cut| position(&cut)),
        };
        let [information, square] = positions;
        vec![
            exponent(cuts.patch.exponent()),
            exponent(cuts.patch.irradiance_exponent()),
            information,
            square,
            format!("{:.3e}", cuts.distance()),
            format!("{:.5e}", cuts.information.value),
            percent(cuts.gain_kept()),
            format!("{:.5e}", cuts.square.value),
            percent(cuts.error_excess()),
        ]
    };
    let notes = [
        (
            "n, m",
            "radiosity grows as lⁿ, irradiance as lᵐ; the unit of the error is the square of the radiosity at l = 1",
        ),
        ("kept", "gain of the mean-square cut, of the highest"),
        (
            "excess",
            "square error of the mutual-information cut beyond the least, of the least",
        ),
    ];
    let table = Table {
        columns: vec![
            "n",
            "m",
            "mutual-information cut",
            "mean-square cut",
            "apart",
            "gain (bits)",
            "kept",
            "square error",
            "excess",
        ],
        rows: all.iter().map(row).collect(),
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    let records: Vec<Record> = all.iter().map(Record::from).collect();
    Report::list(table, "cuts", &records)
}

/// The position, by its distance from 1 where that is small.
fn position(cut: &Cut) -> String {
    if cut.complement < 1e-4 {
        format!("1 − {:.11e}", cut.complement)
    } else {
        certain_digits(cut.position, tolerance::POSITION)
    }
}

fn exponent(value: f64) -> String {
    if (1e-3..1e6).contains(&value) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// A share in per cent: three digits, of what is missing to all where that is less.
pub(crate) fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    let small = percent.abs().min((100.0 - percent).abs());
    let decimals = 2.0 - small.max(1e-9).log10().floor();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 0 to 11"
    )]
    let decimals = decimals.clamp(0.0, 11.0) as usize;
    if small < 1e-9 {
        format!("{percent:.0} %")
    } else if percent < 1e-3 {
        format!("{percent:.2e} %")
    } else {
        format!("{percent:.decimals$} %")
    }
}

/// The cuts against the exponent: a line for each reading (its name, and the cuts at rising exponents), and the mean-square cut.
#[must_use]
pub fn cuts_figure(readings: &[(String, Vec<CutComparison>)]) -> Figure {
    let line = |name: String, cuts: &[CutComparison], cut: fn(&CutComparison) -> &Cut| Line {
        name,
        points: cuts
            .iter()
            .map(|cuts| [cuts.patch.exponent(), cut(cuts).position])
            .collect(),
    };
    let mut lines: Vec<Line> = readings
        .iter()
        .map(|(reading, cuts)| {
            let name = format!("mutual information, irradiance ∝ {reading}");
            line(name, cuts, |cuts| &cuts.information)
        })
        .collect();
    if let Some((_, cuts)) = readings.first() {
        lines.push(line("mean square error".to_owned(), cuts, |cuts| {
            &cuts.square
        }));
    }
    Figure {
        x: Axis {
            label: "exponent n of the radiosity, B ∝ lⁿ".to_owned(),
            is_logarithmic: true,
        },
        y: Axis {
            label: "best cut l, share of the patch".to_owned(),
            is_logarithmic: false,
        },
        lines,
    }
}
