//! The table of a scene's radiosities and importances.

use crate::question::{PatchLight, Power, RadiosityAnswer};
use crate::report::{Report, ReportError, Table, certain_digits, plan_notes, scientific};
use crate::scene::Channels;

/// Patches that a table shows; records carry all.
const MOST_ROWS: usize = 100;

/// Renders the radiosities of a scene.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn radiosity_report(answer: &RadiosityAnswer) -> Result<Report, ReportError> {
    let mut columns = vec![
        "patch",
        "name",
        "radiosity",
        "irradiance",
        "± solution",
        "± form factors",
    ];
    let is_rounded = answer.resolution > 0.0;
    columns.extend(is_rounded.then_some("± resolution"));
    if answer
        .patches
        .iter()
        .any(|patch| patch.importance.is_some())
    {
        columns.push("importance");
    }
    if answer.channels.is_some() {
        columns.extend(["radiosity r", "radiosity g", "radiosity b"]);
    }
    let shown = answer.patches.iter().take(MOST_ROWS);
    let table = Table {
        columns,
        rows: shown
            .map(|patch| row(patch, answer.relative_error, is_rounded))
            .collect(),
        notes: notes(answer),
        ..Table::default()
    };
    Report::list_in(table, "patches", answer)
}

/// A row of the table, whose radiosity has this relative error; of a scene whose coordinates are
/// rounded, or not.
fn row(patch: &PatchLight, relative_error: f64, is_rounded: bool) -> Vec<String> {
    let solution = relative_error * patch.radiosity;
    let known = patch.form_factor_error.map(|error| error + solution);
    let digits = |value: f64| match known {
        Some(error) => certain_digits(value, error.max(f64::MIN_POSITIVE)),
        None => format!("({value:.6e})"),
    };
    let error = |error: Option<f64>| error.map_or_else(|| "unknown".to_owned(), scientific);
    let importance = patch.importance;
    let importance = importance.map(|importance| format!("{importance:.6e}"));
    let row = [
        patch.index.to_string(),
        patch.name.clone(),
        digits(patch.radiosity),
        format!("{:.6e}", patch.irradiance),
        scientific(solution),
        error(patch.form_factor_error),
    ];
    let resolution = is_rounded.then(|| error(patch.resolution_error));
    let channels = patch.channels.iter().flat_map(Channels::iter);
    let channels = channels.map(|light| format!("{:.6e}", light.radiosity));
    row.into_iter()
        .chain(resolution)
        .chain(importance)
        .chain(channels)
        .collect()
}

fn notes(answer: &RadiosityAnswer) -> Vec<(String, String)> {
    let Power {
        emitted,
        absorbed,
        escaped,
    } = answer.power;
    let power = format!("{emitted:.12e} emitted, {absorbed:.12e} absorbed, {escaped:.12e} escaped");
    let solution = format!(
        "{} iterations, {} relative at most, residual {}",
        answer.iterations,
        scientific(answer.relative_error),
        scientific(answer.residual)
    );
    let mut notes = vec![
        ("power".to_owned(), power),
        ("solution".to_owned(), solution),
    ];
    if answer.patches.len() > MOST_ROWS {
        let left_out = answer.patches.len() - MOST_ROWS;
        notes.push(("patches".to_owned(), format!("{left_out} more, in records")));
    }
    notes.extend(plan_notes(&answer.plan));
    notes
}
