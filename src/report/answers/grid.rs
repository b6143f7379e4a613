//! The mutual information of a grid on a box, and of the best one.

use super::sampled::sampled_rows;
use crate::discretize::{BestGrid, BoxGrid, GridInformation, Spacing};
use crate::information::LineSample;
use crate::numeric::interval::DecimalBounds;
use crate::numeric::{Grade, Interval};
use crate::question::SampledInformation;
use crate::report::{Report, ReportError, Table, certain_digits, enclosed_digits, scientific};

/// What is said about a grid.
#[derive(Debug)]
pub struct GridAnswer<'a> {
    /// The edges of the box, as given.
    pub edges: [f64; 3],
    /// The grid.
    pub grid: &'a BoxGrid,
    /// Its mutual information.
    pub information: GridInformation,
    /// That of the regular grid of as many cells.
    pub regular: GridInformation,
    /// How it was found, if it was.
    pub best: Option<&'a BestGrid>,
    /// What is enclosed of it.
    pub enclosed: Option<GridEnclosures<'a>>,
    /// What random lines say, with their seed and the bias expected of the plug-in estimate, in bits.
    pub sampled: Option<(LineSample, u64, f64)>,
}

/// Enclosures, and what is proved.
#[derive(Debug)]
pub struct GridEnclosures<'a> {
    /// The best lines below 1/2, if they were searched for.
    pub half: &'a [Interval],
    /// Mutual information, in bits.
    pub mutual_information: Interval,
    /// What is proved.
    pub certificate: String,
}

/// The answer as a record: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Record<'a> {
    edges: [f64; 3],
    cells: usize,
    spacing: &'static str,
    lines: &'a [f64],
    mutual_information: f64,
    error: f64,
    error_grade: Grade,
    regular_mutual_information: f64,
    patches: usize,
    pairs: usize,
    classes: usize,
    line_error: Option<f64>,
    line_error_grade: Option<Grade>,
    slope: Option<f64>,
    curvature: Option<f64>,
    curvature_error: Option<f64>,
    starts: Option<usize>,
    starts_at_maximum: Option<usize>,
    starts_lost: Option<usize>,
    other_maxima: Option<&'a [f64]>,
    sampled: Option<SampledInformation>,
    #[serde(skip_serializing_if = "Option::is_none")]
    enclosures: Option<Enclosures>,
}

/// Decimal bounds, and what is proved.
#[derive(Debug, serde::Serialize)]
struct Enclosures {
    half: Vec<DecimalBounds>,
    mutual_information: DecimalBounds,
    certificate: String,
}

/// More decimals than any precision leaves certain.
const MOST_DECIMALS: u32 = 100_000;

impl Enclosures {
    fn new(enclosed: &GridEnclosures<'_>) -> Option<Self> {
        let bounds = |enclosure: &Interval| enclosure.to_decimal(MOST_DECIMALS);
        Some(Self {
            half: enclosed.half.iter().map(bounds).collect::<Option<_>>()?,
            mutual_information: bounds(&enclosed.mutual_information)?,
            certificate: enclosed.certificate.clone(),
        })
    }
}

/// What a grid says.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn grid_report(answer: &GridAnswer<'_>) -> Result<Report, ReportError> {
    let GridAnswer {
        grid,
        information,
        regular,
        best,
        ..
    } = answer;
    let cells = grid.cells();
    let found = best.filter(|best| best.curvature.is_some());
    let line_error = found.map_or(0.0, |best| best.line_error);
    let record = Record {
        edges: answer.edges,
        cells,
        spacing: grid.spacing().name(),
        lines: grid.lines(),
        mutual_information: information.mutual_information,
        error: information.error,
        error_grade: Grade::Bound,
        regular_mutual_information: regular.mutual_information,
        patches: 6 * cells.pow(2),
        pairs: 15 * cells.pow(4),
        classes: information.classes,
        line_error: best.map(|best| best.line_error),
        line_error_grade: best.map(|_| Grade::Estimate),
        slope: best.map(|best| best.slope),
        curvature: best.and_then(|best| best.curvature),
        curvature_error: found.map(|best| best.curvature_error),
        starts: best.map(|best| best.search.starts),
        starts_at_maximum: best.map(|best| best.search.reached),
        starts_lost: best.map(|best| best.search.lost),
        other_maxima: best.map(|best| best.search.others.as_slice()),
        sampled: answer.sampled.as_ref().map(|(sample, seed, bias)| {
            SampledInformation::new(sample, *seed, Some([information.mutual_information, *bias]))
        }),
        enclosures: answer.enclosed.as_ref().and_then(Enclosures::new),
    };
    let line = |line: &f64| match found {
        Some(_) => certain_digits(*line, line_error),
        None => line.to_string(),
    };
    let lines: Vec<String> = record.lines.iter().map(line).collect();
    let is_regular = grid.spacing() == Spacing::Regular;
    let lines = match (lines.len(), found.is_some()) {
        (0, _) => "none".to_owned(),
        (count, _) if is_regular => format!("{count}, equally spaced"),
        (_, true) => format!("({})", lines.join(", ")),
        (_, false) => lines.join(", "),
    };
    let [x, y, z] = answer.edges;
    let gain = information.mutual_information - regular.mutual_information;
    let gain = certain_digits(gain, information.error + regular.error);
    let bits = |of: &GridInformation| certain_digits(of.mutual_information, of.error);
    let mut rows = vec![
        ("edges of the box", format!("{x}, {y}, {z}")),
        ("cells an edge", cells.to_string()),
        ("patches", record.patches.to_string()),
        ("pairs that see each other", record.pairs.to_string()),
        ("classes of congruent ones", record.classes.to_string()),
        ("lines, relative to the edge", lines),
        ("mutual information, bits", bits(information)),
        (
            "its error, bits",
            format!("{} (bound)", scientific(information.error)),
        ),
    ];
    if !is_regular {
        rows.extend([
            ("that of the regular grid, bits", bits(regular)),
            ("more than that, bits", gain),
        ]);
    }
    if let Some(best) = best {
        rows.extend(evidence(best));
    }
    rows.extend(record.sampled.iter().flat_map(sampled_rows));
    let notes = answer.enclosed.iter().flat_map(|enclosed| {
        let lines = (1..).zip(enclosed.half);
        let lines = lines.map(|(k, line)| (format!("line {k}"), enclosed_digits(line)));
        let information = enclosed_digits(&enclosed.mutual_information);
        lines.chain([
            ("mutual information, bits".to_owned(), information),
            ("certificate".to_owned(), enclosed.certificate.clone()),
        ])
    });
    let table = Table {
        columns: vec!["quantity", "value"],
        rows: rows
            .into_iter()
            .map(|(quantity, value)| vec![quantity.to_owned(), value])
            .collect(),
        wrapped: Some(1),
        notes: notes.collect(),
    };
    Report::one(table, &record)
}

/// What speaks for a maximum.
fn evidence(best: &BestGrid) -> Vec<(&'static str, String)> {
    let Some(curvature) = best.curvature else {
        return vec![("evidence", "no line is free".to_owned())];
    };
    let search = &best.search;
    let others = match search.others.as_slice() {
        [] => "no other maximum was found".to_owned(),
        [next, ..] => format!(
            "{} lower ones were found, the highest of ({next:.6}) bits",
            search.others.len()
        ),
    };
    let lost = match search.lost {
        0 => String::new(),
        lost => format!(", {lost} came to no rest"),
    };
    vec![
        (
            "error of the lines",
            format!("({}) (estimate)", scientific(best.line_error)),
        ),
        ("largest derivative left, bits", scientific(best.slope)),
        (
            "largest curvature, bits",
            format!(
                "({}) (estimate): a local maximum",
                certain_digits(curvature, best.curvature_error)
            ),
        ),
        (
            "highest of all (sample)",
            format!(
                "{} of {} starts end there{lost}; {others}",
                search.reached, search.starts
            ),
        ),
    ]
}
