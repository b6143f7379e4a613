//! The information of a scene.

use crate::exchange::PlanSummary;
use crate::information::{ContinuousInformation, FacePair, PairLoss, SceneInformation};
use crate::numeric::{Bounded, Grade, tolerance};
use crate::report::{Report, ReportError, Table, certain_digits, scientific};

/// Patches whose contributions a table shows; records carry all.
const MOST_ROWS: usize = 6;

/// Pairs of faces, likewise.
const MOST_PAIRS: usize = 3;

/// The answer as a record: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Record<'r> {
    patches: usize,
    total_area: f64,
    closed: bool,
    positional_entropy: f64,
    entropy_rate: f64,
    mutual_information: f64,
    continuous_mutual_information: Option<f64>,
    continuous_error: Option<f64>,
    continuous_error_grade: Option<Grade>,
    /// What pairs of faces contribute to it, both directions together.
    continuous_contributions: Option<Vec<PairRecord<'r>>>,
    /// What pairs of patches contribute to both, and lose.
    pair_losses: Option<Vec<LossRecord>>,
    mutual_information_error: f64,
    error_grade: Grade,
    closure: WorstRow<'r>,
    contributions: Vec<Contribution<'r>>,
    outside_contribution: Option<f64>,
    plan: &'r PlanSummary,
}

/// Two faces of a convex room, each named by its first patch.
#[derive(Debug, serde::Serialize)]
struct PairRecord<'r> {
    faces: [&'r str; 2],
    patches: [usize; 2],
    probability: f64,
    mutual_information: f64,
}

/// Two patches, both directions together.
#[derive(Debug, serde::Serialize)]
struct LossRecord {
    patches: [usize; 2],
    probability: f64,
    mutual_information: f64,
    continuous_mutual_information: f64,
    loss: f64,
    error: f64,
}

impl From<&PairLoss> for LossRecord {
    fn from(pair: &PairLoss) -> Self {
        Self {
            patches: [pair.first, pair.second],
            probability: pair.probability,
            mutual_information: pair.mutual_information,
            continuous_mutual_information: pair.continuous_mutual_information,
            loss: pair.loss,
            error: pair.error,
        }
    }
}

/// The pairs of patches that lose the most.
fn loss_rows(names: &[&str], losses: &[PairLoss]) -> Vec<Vec<String>> {
    let mut most: Vec<&PairLoss> = losses.iter().collect();
    most.sort_by(|a, b| b.loss.total_cmp(&a.loss));
    let row = |pair: &PairLoss| {
        let [one, other] = [pair.first, pair.second].map(|index| names[index]);
        let quantity = format!("lost between {one} and {other}, bits");
        vec![
            quantity,
            format!("({})", certain_digits(pair.loss, pair.error)),
        ]
    };
    most.into_iter().take(MOST_ROWS).map(row).collect()
}

/// The row of form factors whose sum is farthest from one.
#[derive(Debug, serde::Serialize)]
struct WorstRow<'r> {
    patch: usize,
    name: &'r str,
    row_sum: f64,
    error: f64,
}

/// A patch's part of eq. (3).
#[derive(Debug, serde::Serialize)]
struct Contribution<'r> {
    patch: usize,
    name: &'r str,
    /// Its stationary probability.
    weight: f64,
    mutual_information: f64,
    row_sum: f64,
}

/// Lines that say what a plan left out and shared.
#[must_use]
pub fn plan_notes(plan: &PlanSummary) -> Vec<(String, String)> {
    let routes: Vec<String> = plan
        .routes
        .iter()
        .map(|(route, pairs)| format!("{pairs} {route}"))
        .collect();
    let counts = format!(
        "{} of {} planes: {} never looked at, {} congruent to another, {} computed",
        plan.pairs, plan.planes, plan.untouched, plan.congruent, plan.computed
    );
    [("pairs", counts), ("routes", routes.join(", "))]
        .map(|(name, note)| (name.to_owned(), note))
        .to_vec()
}

/// Pairs of faces as records.
fn pair_records<'r>(names: &[&'r str], continuous: &ContinuousInformation) -> Vec<PairRecord<'r>> {
    let first = |face: usize| {
        continuous
            .face_of
            .iter()
            .position(|of| *of == face)
            .unwrap_or(0)
    };
    let record = |pair: &FacePair| {
        let patches = [first(pair.first), first(pair.second)];
        PairRecord {
            faces: patches.map(|patch| names[patch]),
            patches,
            probability: pair.probability,
            mutual_information: pair.mutual_information,
        }
    };
    continuous.pairs.iter().map(record).collect()
}

/// The rows of the table that the continuous mutual information adds.
fn continuous_rows(
    continuous: &ContinuousInformation,
    pairs: &[PairRecord<'_>],
) -> Vec<Vec<String>> {
    let Bounded {
        value,
        error,
        grade,
    } = continuous.mutual_information;
    let in_parentheses = |value: f64| format!("({})", certain_digits(value, error));
    let error = format!("{} ({})", scientific(error), grade.name());
    let mut rows = vec![
        vec![
            "continuous mutual information, bits".to_owned(),
            in_parentheses(value),
        ],
        vec!["its error, bits".to_owned(), error],
        vec!["faces".to_owned(), continuous.faces.to_string()],
    ];
    let mut most: Vec<&PairRecord<'_>> = pairs.iter().collect();
    most.sort_by(|a, b| b.mutual_information.total_cmp(&a.mutual_information));
    for pair in most.into_iter().take(MOST_PAIRS) {
        let [one, other] = pair.faces;
        let quantity = format!("its part of {one} and {other}, bits");
        rows.push(vec![quantity, in_parentheses(pair.mutual_information)]);
    }
    rows
}

/// What was measured of a scene whose patches, or rows of them, have these names; with the continuous mutual information
/// if it was asked for, whose faces have the names of patches, and what pairs of these lose against it.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn measure_report(
    names: &[&str],
    measured: &SceneInformation,
    continuous: Option<(&[&str], &ContinuousInformation)>,
    losses: Option<&[PairLoss]>,
) -> Result<Report, ReportError> {
    let worst = measured.closure.worst();
    let closed = measured.closure.is_closed();
    let rows = measured.contributions.iter().zip(measured.closure.rows());
    let contributions: Vec<Contribution<'_>> = rows
        .map(|(contribution, row)| Contribution {
            patch: row.row,
            name: names[row.row],
            weight: measured.weights[row.row],
            mutual_information: *contribution,
            row_sum: row.sum,
        })
        .collect();
    let information = measured.mutual_information;
    let bits = |value: f64, error: f64| match information.grade {
        grade if grade >= Grade::Bound => certain_digits(value, error),
        _ => format!("({})", certain_digits(value, error)),
    };
    let entropy_error = tolerance::INFORMATION * (2.0 + measured.positional_entropy);
    let mut lines = vec![
        ("patches", names.len().to_string()),
        (
            "total area",
            certain_digits(
                measured.total_area,
                8.0 * f64::EPSILON * measured.total_area,
            ),
        ),
        (
            "closed",
            match (closed, measured.outside_contribution) {
                (true, _) => "yes",
                (false, Some(_)) => "no: one more state, outside",
                (false, None) => "no: light that escapes has no state",
            }
            .to_owned(),
        ),
        (
            "positional entropy, bits",
            bits(
                measured.positional_entropy,
                information.error.max(entropy_error),
            ),
        ),
        (
            "entropy rate, bits",
            bits(measured.entropy_rate, information.error + entropy_error),
        ),
        (
            "mutual information, bits",
            bits(information.value, information.error),
        ),
    ];
    let error = format!(
        "{} ({})",
        scientific(information.error),
        information.grade.name()
    );
    lines.push(("its error, bits", error));
    let name = |row: usize| format!("{row} ({})", names[row]);
    let row = format!(
        "{}: {} ± {}",
        name(worst.row),
        certain_digits(worst.sum, worst.error),
        scientific(worst.error)
    );
    lines.push(("row sum farthest from 1", row));
    let mut largest = 0;
    for (patch, weight) in measured.weights.iter().enumerate() {
        if *weight > measured.weights[largest] {
            largest = patch;
        }
    }
    let weight = format!("{}: {:.6}", name(largest), measured.weights[largest]);
    lines.push(("largest weight", weight));
    let mut rows: Vec<Vec<String>> = lines
        .into_iter()
        .map(|(quantity, value)| vec![quantity.to_owned(), value])
        .collect();
    let pairs = continuous.map(|(patches, found)| pair_records(patches, found));
    if let (Some((patches, found)), Some(pairs)) = (continuous, &pairs) {
        rows.extend(continuous_rows(found, pairs));
        rows.extend(
            losses
                .into_iter()
                .flat_map(|losses| loss_rows(patches, losses)),
        );
    }
    let mut most: Vec<&Contribution<'_>> = contributions.iter().collect();
    most.sort_by(|a, b| b.mutual_information.total_cmp(&a.mutual_information));
    for part in most.into_iter().take(MOST_ROWS) {
        let quantity = format!("contribution of {}, bits", name(part.patch));
        rows.push(vec![
            quantity,
            bits(part.mutual_information, information.error),
        ]);
    }
    let table = Table {
        columns: vec!["quantity", "value"],
        rows,
        notes: plan_notes(&measured.summary.plan),
        ..Table::default()
    };
    let record = Record {
        patches: names.len(),
        total_area: measured.total_area,
        closed,
        positional_entropy: measured.positional_entropy,
        entropy_rate: measured.entropy_rate,
        mutual_information: information.value,
        continuous_mutual_information: continuous.map(|(_, found)| found.mutual_information.value),
        continuous_error: continuous.map(|(_, found)| found.mutual_information.error),
        continuous_error_grade: continuous.map(|(_, found)| found.mutual_information.grade),
        continuous_contributions: pairs,
        pair_losses: losses.map(|losses| losses.iter().map(LossRecord::from).collect()),
        mutual_information_error: information.error,
        error_grade: information.grade,
        closure: WorstRow {
            patch: worst.row,
            name: names[worst.row],
            row_sum: worst.sum,
            error: worst.error,
        },
        contributions,
        outside_contribution: measured.outside_contribution,
        plan: &measured.summary.plan,
    };
    Report::one(table, &record)
}
