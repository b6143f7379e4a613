//! The information of a scene.

use super::{Report, ReportError, Table, certain_digits, scientific};
use crate::information::{ErrorGrade, SceneInformation};
use crate::numeric::tolerance;
use crate::scene::PlanSummary;

/// Patches whose contributions a table shows; records carry all.
const MOST_ROWS: usize = 6;

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
    mutual_information_error: f64,
    error_grade: &'static str,
    closure: WorstRow<'r>,
    contributions: Vec<Contribution<'r>>,
    outside_contribution: Option<f64>,
    plan: &'r PlanSummary,
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

/// What was measured of a scene whose patches, or rows of them, have these names.
///
/// # Errors
/// [`ReportError`] if a number is not finite.
pub fn measure_report(names: &[&str], measured: &SceneInformation) -> Result<Report, ReportError> {
    let worst = measured.closure.worst();
    let closed = measured.closure.is_closed();
    let rows = measured.contributions.iter().zip(measured.closure.rows());
    let contributions: Vec<Contribution<'_>> = rows
        .map(|(information, row)| Contribution {
            patch: row.row,
            name: names[row.row],
            weight: measured.weights[row.row],
            mutual_information: *information,
            row_sum: row.sum,
        })
        .collect();
    let bits = |value: f64, error: f64| match measured.error_grade {
        ErrorGrade::Bound => certain_digits(value, error),
        ErrorGrade::Estimate => format!("({})", certain_digits(value, error)),
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
                measured.error.max(entropy_error),
            ),
        ),
        (
            "entropy rate, bits",
            bits(measured.entropy_rate, measured.error + entropy_error),
        ),
        (
            "mutual information, bits",
            bits(measured.mutual_information, measured.error),
        ),
    ];
    let error = format!(
        "{} ({})",
        scientific(measured.error),
        measured.error_grade.name()
    );
    lines.push(("its error, bits", error));
    let name = |row: usize| format!("{row} ({})", names[row]);
    let row = format!(
        "{}: {} ± {}",
        name(worst.row),
        certain_digits(worst.sum, worst.error_bound),
        scientific(worst.error_bound)
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
    let mut most: Vec<&Contribution<'_>> = contributions.iter().collect();
    most.sort_by(|a, b| b.mutual_information.total_cmp(&a.mutual_information));
    for part in most.into_iter().take(MOST_ROWS) {
        let quantity = format!("contribution of {}, bits", name(part.patch));
        rows.push(vec![
            quantity,
            bits(part.mutual_information, measured.error),
        ]);
    }
    let table = Table {
        columns: vec!["quantity", "value"],
        rows,
        notes: plan_notes(&measured.account.plan),
        ..Table::default()
    };
    let record = Record {
        patches: names.len(),
        total_area: measured.total_area,
        closed,
        positional_entropy: measured.positional_entropy,
        entropy_rate: measured.entropy_rate,
        mutual_information: measured.mutual_information,
        continuous_mutual_information: None,
        mutual_information_error: measured.error,
        error_grade: measured.error_grade.name(),
        closure: WorstRow {
            patch: worst.row,
            name: names[worst.row],
            row_sum: worst.sum,
            error: worst.error_bound,
        },
        contributions,
        outside_contribution: measured.outside_contribution,
        plan: &measured.account.plan,
    };
    Report::one(table, &record)
}
