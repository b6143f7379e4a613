//! The table of a scene's information.

use crate::exchange::PlanSummary;
use crate::numeric::{Grade, tolerance};
use crate::question::{Contribution, FacePairRecord, MeasureAnswer, PairLossRecord};
use crate::report::{Report, ReportError, Table, certain_digits, scientific};

/// Patches whose contributions a table shows; records carry all.
const MOST_ROWS: usize = 6;

/// Pairs of faces, likewise.
const MOST_PAIRS: usize = 3;

/// A quantity and its value, as texts.
type Line = (String, String);

/// Lines that count the pairs a plan left out and shared.
#[must_use]
pub(crate) fn plan_notes(plan: &PlanSummary) -> Vec<(String, String)> {
    let routes: Vec<String> = plan
        .routes
        .iter()
        .map(|(route, pairs)| format!("{pairs} {route}"))
        .collect();
    let counts = format!(
        "{} of {} planes: {} never looked at, {} congruent to another, {} computed",
        plan.pairs, plan.planes, plan.untouched, plan.congruent, plan.computed
    );
    let stored = match plan.stored {
        0 => String::new(),
        stored => format!(", {stored} read from the store"),
    };
    let mut notes = vec![("pairs", counts + &stored), ("routes", routes.join(", "))];
    notes.extend(plan.occlusion.map(|pairs| {
        let text = format!(
            "{} pairs visible, {} past others in part, {} hidden",
            pairs.visible, pairs.partial, pairs.hidden
        );
        ("occlusion", text)
    }));
    let owned = |(name, note): (&str, String)| (name.to_owned(), note);
    notes.into_iter().map(owned).collect()
}

/// Renders the information of a scene.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn measure_report(answer: &MeasureAnswer) -> Result<Report, ReportError> {
    let mut lines = discrete_lines(answer);
    lines.extend(row_lines(answer));
    lines.extend(continuous_lines(answer));
    lines.extend(loss_lines(answer));
    lines.extend(contribution_lines(answer));
    let rows = lines
        .into_iter()
        .map(|(quantity, value)| vec![quantity, value]);
    let table = Table {
        columns: vec!["quantity", "value"],
        rows: rows.collect(),
        notes: plan_notes(&answer.plan),
        ..Table::default()
    };
    Report::one(table, answer)
}

/// A value in bits, in parentheses unless its error is bounded.
fn bits(answer: &MeasureAnswer, value: f64, error: f64) -> String {
    match answer.error_grade {
        grade if grade >= Grade::Bound => certain_digits(value, error),
        _ => format!("({})", certain_digits(value, error)),
    }
}

fn discrete_lines(answer: &MeasureAnswer) -> Vec<Line> {
    let error = answer.mutual_information_error;
    let entropy_error = tolerance::INFORMATION * (2.0 + answer.positional_entropy);
    let area_error = 8.0 * f64::EPSILON * answer.total_area;
    let closed = match (answer.closed, answer.outside_contribution) {
        (true, _) => "yes",
        (false, Some(_)) => "no: one more state, outside",
        (false, None) => "no: light that escapes has no state",
    };
    let lines = [
        ("patches", answer.patches.to_string()),
        ("total area", certain_digits(answer.total_area, area_error)),
        ("closed", closed.to_owned()),
        (
            "positional entropy, bits",
            bits(answer, answer.positional_entropy, error.max(entropy_error)),
        ),
        (
            "entropy rate, bits",
            bits(answer, answer.entropy_rate, error + entropy_error),
        ),
        (
            "mutual information, bits",
            bits(answer, answer.mutual_information, error),
        ),
        (
            "its error, bits",
            format!("{} ({})", scientific(error), answer.error_grade.name()),
        ),
    ];
    let channel = answer
        .channel
        .map(|channel| ("channel", channel.name().to_owned()));
    let lines = channel.into_iter().chain(lines);
    let resolution = (answer.resolution > 0.0).then(|| {
        let change = answer.resolution_error;
        let change = change.map_or_else(|| "unknown".to_owned(), scientific);
        let change = format!("{change} (coordinates ± {:e})", answer.resolution);
        ("what the resolution can change, bits", change)
    });
    lines
        .chain(resolution)
        .map(|(quantity, value)| (quantity.to_owned(), value))
        .collect()
}

/// The rows that stand out: by their sum, and by their weight.
fn row_lines(answer: &MeasureAnswer) -> Vec<Line> {
    let worst = &answer.closure;
    let sum = format!(
        "{} ({}): {} ± {}",
        worst.patch,
        worst.name,
        certain_digits(worst.row_sum, worst.error),
        scientific(worst.error)
    );
    let mut lines = vec![("row sum farthest from 1".to_owned(), sum)];
    // of equal ones the first
    let heavier = |best: Option<&'_ Contribution>, row: &Contribution| {
        best.is_none_or(|best| row.weight > best.weight)
    };
    let mut largest = None;
    for row in &answer.contributions {
        if heavier(largest, row) {
            largest = Some(row);
        }
    }
    if let Some(Contribution {
        patch,
        name,
        weight,
        ..
    }) = largest
    {
        let weight = format!("{patch} ({name}): {weight:.6}");
        lines.push(("largest weight".to_owned(), weight));
    }
    lines
}

/// The lines that the continuous mutual information adds.
fn continuous_lines(answer: &MeasureAnswer) -> Vec<Line> {
    let number = answer.continuous_mutual_information;
    let number = number.zip(answer.continuous_error);
    let (Some((value, error)), Some(grade)) = (number, answer.continuous_error_grade) else {
        return Vec::new();
    };
    let in_parentheses = |value: f64| format!("({})", certain_digits(value, error));
    let mut lines = vec![
        (
            "continuous mutual information, bits".to_owned(),
            in_parentheses(value),
        ),
        (
            "its error, bits".to_owned(),
            format!("{} ({})", scientific(error), grade.name()),
        ),
    ];
    let lower = answer.continuous_lower_bound;
    let lower = lower.map(|lower| certain_digits(lower, answer.mutual_information_error));
    lines.extend(lower.map(|lower| ("at least, bits".to_owned(), lower)));
    let sampled = answer.continuous_lines.map(|lines| lines.to_string());
    lines.extend(sampled.map(|count| ("random lines".to_owned(), count)));
    let faces = answer.faces;
    lines.extend(faces.map(|faces| ("faces".to_owned(), faces.to_string())));
    let pairs = answer.continuous_contributions.iter().flatten();
    let mut most: Vec<&FacePairRecord> = pairs.collect();
    most.sort_by(|a, b| b.mutual_information.total_cmp(&a.mutual_information));
    for pair in most.into_iter().take(MOST_PAIRS) {
        let [one, other] = &pair.faces;
        let quantity = format!("its part of {one} and {other}, bits");
        lines.push((quantity, in_parentheses(pair.mutual_information)));
    }
    lines
}

/// The pairs of patches that lose the most. Such a scene has no summed rows: a patch is a row.
fn loss_lines(answer: &MeasureAnswer) -> Vec<Line> {
    let mut most: Vec<&PairLossRecord> = answer.pair_losses.iter().flatten().collect();
    most.sort_by(|a, b| b.loss.total_cmp(&a.loss));
    let line = |pair: &PairLossRecord| {
        let [one, other] = pair.patches.map(|row| &answer.contributions[row].name);
        (
            format!("lost between {one} and {other}, bits"),
            format!("({})", certain_digits(pair.loss, pair.error)),
        )
    };
    most.into_iter().take(MOST_ROWS).map(line).collect()
}

/// The rows that contribute the most.
fn contribution_lines(answer: &MeasureAnswer) -> Vec<Line> {
    let mut most: Vec<&Contribution> = answer.contributions.iter().collect();
    most.sort_by(|a, b| b.mutual_information.total_cmp(&a.mutual_information));
    let line = |row: &Contribution| {
        (
            format!("contribution of {} ({}), bits", row.patch, row.name),
            bits(
                answer,
                row.mutual_information,
                answer.mutual_information_error,
            ),
        )
    };
    most.into_iter().take(MOST_ROWS).map(line).collect()
}
