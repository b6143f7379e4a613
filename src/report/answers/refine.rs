//! The table of a refinement's steps, and the net of the scene.

use crate::question::{RefineAnswer, RefineStep, RefinedPatch};
use crate::report::{Net, Report, ReportError, Table};

/// Patches that a table shows; records carry all.
const MOST_PATCHES: usize = 40;

/// Renders the steps of a refinement.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn refinement_report(answer: &RefineAnswer) -> Result<Report, ReportError> {
    let shown = answer.patches.iter().take(MOST_PATCHES);
    let mut notes = vec![("oracle".to_owned(), answer.oracle.to_owned())];
    notes.extend(shown.map(patch));
    let left_out = answer.patches.len().saturating_sub(MOST_PATCHES);
    if left_out > 0 {
        notes.push(("patches".to_owned(), format!("{left_out} more, in records")));
    }
    let table = Table {
        columns: vec![
            "elements",
            "links",
            "form factors",
            "seconds",
            "error, bound",
            "error, estimate",
            "information, bits",
        ],
        rows: answer.steps.iter().map(row).collect(),
        notes,
        ..Table::default()
    };
    Report::list_in(table, "steps", answer)
}

fn row(step: &RefineStep) -> Vec<String> {
    let or_none = |value: Option<String>| value.unwrap_or_else(|| "unknown".to_owned());
    let percent = |error: f64| format!("{:.3} %", 100.0 * error);
    let information = step.mutual_information.map(|bits| format!("{bits:.6}"));
    vec![
        step.elements.to_string(),
        step.links.to_string(),
        step.evaluations.to_string(),
        format!("{:.3}", step.seconds),
        or_none(step.error_bound.map(percent)),
        or_none(step.error_estimate.map(percent)),
        or_none(information),
    ]
}

/// The light of a patch in a line.
fn patch(patch: &RefinedPatch) -> (String, String) {
    let gathered = patch.gathered;
    let gathered = gathered.map_or_else(String::new, |light| format!(", gathered {light:.6e}"));
    let error = patch.radiosity_error;
    let error = error.map_or_else(String::new, |error| format!(" ± {error:.1e}"));
    let text = format!(
        "radiosity {:.6e}{error}{gathered}, irradiance {:.6e}, area {:.6}, {} elements",
        patch.radiosity, patch.irradiance, patch.area, patch.elements
    );
    (format!("patch {} ({})", patch.index, patch.name), text)
}

/// The net of the scene with its radiosity; none if it was not asked for.
#[must_use]
pub fn refinement_net(answer: &RefineAnswer, has_outlines: bool) -> Option<Net> {
    let mesh = answer.net.clone()?;
    Some(Net {
        quantity: "radiosity".to_owned(),
        mesh,
        has_outlines,
    })
}
