//! The cuts across a radiosity gradient (§4.2): of one patch, or of many side by side.

use crate::numeric::tolerance;
use crate::question::{CutAnswer, CutsAnswer, IrradianceExponent};
use crate::report::{
    Axis, Figure, Line, Report, ReportError, Table, certain_digits, enclosed_digits,
};

/// The names of both measures.
const MEASURES: [&str; 2] = ["mutual information", "mean square"];

/// The answer to [`Cut`](crate::question::Cut): a line for each cut, and their bounds if they were
/// enclosed.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn cut_report(answer: &CutAnswer) -> Result<Report, ReportError> {
    let row = |name: &str, position: f64, numbers: [f64; 3]| {
        let mut row = vec![
            name.to_owned(),
            certain_digits(position, tolerance::POSITION),
        ];
        row.extend(numbers.map(|number| format!("{number:.11e}")));
        row
    };
    let information = [
        answer.mutual_information_complement,
        answer.mutual_information_gain,
        answer.error_at_mutual_information_cut,
    ];
    let square = [
        answer.mean_square_complement,
        answer.gain_at_mean_square_cut,
        answer.mean_square_error,
    ];
    let enclosed = answer.enclosures.as_ref();
    let enclosed = enclosed.map(|cuts| [&cuts.mutual_information_cut, &cuts.mean_square_cut]);
    let enclosed = enclosed.into_iter().flatten().zip(MEASURES);
    let enclosed = enclosed.filter_map(|(position, name)| {
        let bounds = position.every_decimal()?;
        let between = format!("between {} and {}", bounds.lower, bounds.upper);
        Some((name.to_owned(), between))
    });
    let cost = format!(
        "the mean-square cut keeps {} of the gain; the other has {} more than the least square \
         error",
        percent(answer.gain_kept),
        percent(answer.error_excess)
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
            row(MEASURES[0], answer.mutual_information_cut, information),
            row(MEASURES[1], answer.mean_square_cut, square),
        ],
        notes: enclosed.chain([("cost".to_owned(), cost)]).collect(),
        ..Table::default()
    };
    Report::one(table, answer)
}

/// The line of one patch among many.
fn line(cuts: &CutAnswer) -> Vec<String> {
    let [information, square] = match &cuts.enclosures {
        Some(enclosed) => {
            [&enclosed.mutual_information_cut, &enclosed.mean_square_cut].map(enclosed_digits)
        }
        None => [
            position(
                cuts.mutual_information_cut,
                cuts.mutual_information_complement,
            ),
            position(cuts.mean_square_cut, cuts.mean_square_complement),
        ],
    };
    vec![
        exponent(cuts.exponent),
        exponent(cuts.irradiance_exponent),
        information,
        square,
        format!("{:.3e}", cuts.distance),
        format!("{:.5e}", cuts.mutual_information_gain),
        percent(cuts.gain_kept),
        format!("{:.5e}", cuts.mean_square_error),
        percent(cuts.error_excess),
    ]
}

/// The answer to [`Cuts`](crate::question::Cuts): a line for each patch, records under `cuts` in
/// JSON.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn cuts_report(answer: &CutsAnswer) -> Result<Report, ReportError> {
    let notes = [
        (
            "n, m",
            "radiosity grows as lⁿ, irradiance as lᵐ; the unit of the error is the square of the \
             radiosity at l = 1",
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
        rows: answer.cuts.iter().map(line).collect(),
        notes: notes
            .map(|(name, note)| (name.to_owned(), note.to_owned()))
            .to_vec(),
        ..Table::default()
    };
    Report::list(table, "cuts", &answer.cuts)
}

/// The position, by its distance from 1 where that is small.
fn position(position: f64, complement: f64) -> String {
    if complement < 1e-4 {
        format!("1 − {complement:.11e}")
    } else {
        certain_digits(position, tolerance::POSITION)
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

/// The figure of the cuts against the exponent of the radiosity: a line for each exponent of the
/// irradiance, and the mean-square cut.
#[must_use]
pub fn cuts_figure(answer: &CutsAnswer) -> Figure {
    let line = |name: String, cuts: &[&CutAnswer], position: fn(&CutAnswer) -> f64| Line {
        name,
        points: cuts
            .iter()
            .map(|cuts| [cuts.exponent, position(cuts)])
            .collect(),
    };
    let irradiance = answer.irradiance.iter().enumerate();
    let mut lines: Vec<Line> = irradiance
        .map(|(index, irradiance)| {
            let name = format!("mutual information, irradiance ∝ {}", power(*irradiance));
            line(name, &answer.rising(index), |cuts| {
                cuts.mutual_information_cut
            })
        })
        .collect();
    if !answer.irradiance.is_empty() {
        let name = "mean square error".to_owned();
        lines.push(line(name, &answer.rising(0), |cuts| cuts.mean_square_cut));
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
        ..Figure::default()
    }
}

/// The irradiance as a power of the position.
fn power(irradiance: IrradianceExponent) -> String {
    match irradiance {
        IrradianceExponent::OfRadiosity => "lⁿ".to_owned(),
        IrradianceExponent::Fixed(m) if (m - 1.0).abs() <= 0.0 => "l".to_owned(),
        IrradianceExponent::Fixed(m) => format!("l^{m}"),
    }
}
