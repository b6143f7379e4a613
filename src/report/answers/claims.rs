//! The verdict table: what the paper says, what was computed, and what it comes to.

use crate::claims::{Judgement, Quantity, Verdict};
use crate::numeric::Grade;
use crate::report::{
    Axis, Figure, Line, Report, ReportError, Table, certain_digits, enclosed_digits, power_of_ten,
    scientific,
};

/// One claim as a record: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Record<'j> {
    id: &'j str,
    place: &'j str,
    quantity: &'j str,
    printed: Option<f64>,
    decimals: Option<u32>,
    computed: Option<f64>,
    error: Option<f64>,
    lower: Option<String>,
    upper: Option<String>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    proof: &'j [String],
    evidence: Option<Grade>,
    verdict: Verdict,
    recorded: Verdict,
    note: &'j str,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    curve: &'j [[f64; 2]],
}

impl<'j> From<&'j Judgement> for Record<'j> {
    fn from(judgement: &'j Judgement) -> Self {
        let claim = &judgement.claim;
        let finding = judgement.finding.as_ref();
        let enclosure = finding.and_then(|finding| finding.enclosure.as_ref());
        let bounds = enclosure.and_then(|enclosure| enclosure.to_decimal(MOST_DECIMALS));
        let (lower, upper) = bounds.map(|bounds| (bounds.lower, bounds.upper)).unzip();
        Self {
            id: &claim.id,
            place: &claim.place,
            quantity: &claim.quantity,
            printed: claim.printed.as_ref().map(|printed| printed.value),
            decimals: claim.printed.as_ref().map(|printed| printed.decimals),
            computed: finding.map(|finding| finding.quantity.number()),
            error: finding.map(|finding| match finding.quantity {
                Quantity::Value { error, .. } => error,
                Quantity::Residual { tolerance, .. } => tolerance,
            }),
            lower,
            upper,
            proof: &claim.proof,
            evidence: judgement.evidence(),
            verdict: judgement.verdict,
            recorded: judgement.recorded(),
            note: judgement.note(),
            curve: finding.map_or(&[], |finding| &finding.curve),
        }
    }
}

/// The verdict table of these judgements, in their order, with a note for each that is neither
/// confirmed nor supported, and a count.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn reproduction_report(judgements: &[Judgement]) -> Result<Report, ReportError> {
    let records: Vec<Record<'_>> = judgements.iter().map(Record::from).collect();
    let table = Table {
        columns: vec![
            "id",
            "paper says",
            "computed",
            "certified ±",
            "evidence",
            "verdict",
        ],
        rows: judgements.iter().map(row).collect(),
        wrapped: Some(1),
        notes: notes(judgements),
    };
    Report::list(table, "claims", &records)
}

/// More decimals than any precision leaves certain.
const MOST_DECIMALS: u32 = 100_000;

fn notes(judgements: &[Judgement]) -> Vec<(String, String)> {
    let mut notes: Vec<(String, String)> = Vec::new();
    let settled = |j: &&Judgement| matches!(j.verdict, Verdict::Confirmed | Verdict::Supported);
    for judgement in judgements.iter().filter(|j| !settled(j)) {
        let name = judgement.verdict.name().replace('_', " ");
        match notes.iter_mut().find(|(_, note)| note == judgement.note()) {
            Some((names, _)) => *names += &format!(", {}", judgement.claim.id),
            None => notes.push((
                format!("{name}, {}", judgement.claim.id),
                judgement.note().to_owned(),
            )),
        }
    }
    for judgement in judgements.iter().filter(|j| j.verdict != j.recorded()) {
        let recorded = judgement.recorded().name();
        let text = format!("this run differs from the verdict on record, {recorded}");
        notes.push((judgement.claim.id.clone(), text));
    }
    let counts: Vec<String> = Verdict::ALL
        .into_iter()
        .map(|verdict| {
            (
                verdict,
                judgements.iter().filter(|j| j.verdict == verdict).count(),
            )
        })
        .filter(|(_, count)| *count > 0)
        .map(|(verdict, count)| format!("{count} {}", verdict.name().replace('_', " ")))
        .collect();
    notes.push((format!("{} claims", judgements.len()), counts.join(", ")));
    notes
}

fn row(judgement: &Judgement) -> Vec<String> {
    let claim = &judgement.claim;
    let printed = claim
        .printed
        .as_ref()
        .map_or_else(String::new, |p| format!(": {}", p.text));
    let says = format!("{}: {}{printed}", claim.place, claim.quantity);
    let evidence = judgement.evidence().map_or("", Grade::name).to_owned();
    let [computed, error] = match &judgement.finding {
        None => ["", ""].map(str::to_owned),
        Some(finding) => {
            let (value, error) = match finding.quantity {
                Quantity::Value { value, error } => (value, error),
                Quantity::Residual { value, tolerance } => (value, tolerance),
            };
            match &finding.enclosure {
                Some(enclosure) if enclosure.is_point() => {
                    [enclosed_digits(enclosure), "exact".to_owned()]
                }
                Some(enclosure) => [
                    enclosed_digits(enclosure),
                    power_of_ten(0.5 * enclosure.width()),
                ],
                None if error > 0.0 => [
                    certain_digits(value, error),
                    format!("({})", scientific(error)),
                ],
                None => [certain_digits(value, error), "exact".to_owned()],
            }
        }
    };
    let verdict = judgement.verdict.name().replace('_', " ");
    vec![claim.id.clone(), says, computed, error, evidence, verdict]
}

/// One point of a curve as a record.
#[derive(Debug, serde::Serialize)]
struct Point {
    x: f64,
    y: f64,
}

/// The points of a claim's curve.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn curve_report(curve: &[[f64; 2]]) -> Result<Report, ReportError> {
    let points: Vec<Point> = curve.iter().map(|[x, y]| Point { x: *x, y: *y }).collect();
    let row = |point: &Point| {
        vec![
            format!("{}", point.x),
            certain_digits(point.y, 1e-13 * point.y.abs()),
        ]
    };
    let rows = points.iter().map(row).collect();
    let table = Table {
        columns: vec!["x", "y"],
        rows,
        ..Table::default()
    };
    Report::list(table, "points", &points)
}

/// The figure of a claim's curve, with the labels of its axes.
#[must_use]
pub fn curve_figure(axes: &[String; 2], curve: &[[f64; 2]]) -> Figure {
    let [x, y] = axes.each_ref().map(|label| Axis {
        label: label.clone(),
        is_logarithmic: false,
    });
    let line = Line {
        name: "the curve".to_owned(),
        points: curve.to_vec(),
    };
    Figure {
        x,
        y,
        lines: vec![line],
    }
}
