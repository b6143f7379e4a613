//! Radiosity and importance of a scene.

use crate::exchange::{Closure, ExchangeAreas, PlanSummary};
use crate::numeric::compensated_sum;
use crate::report::{Report, ReportError, Table, certain_digits, plan_notes, scientific};
use crate::scene::Material;
use crate::transport::{Importance, RadiositySolution};

/// Patches that a table shows; records carry all.
const MOST_ROWS: usize = 100;

/// What concerns all patches: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Summary<'r> {
    residual: f64,
    iterations: usize,
    /// Of each radiosity, a bound, for the form factors as computed.
    relative_error: f64,
    closed: bool,
    power: Power,
    plan: &'r PlanSummary,
}

/// One patch: the keys are relied on by scripts.
#[derive(Debug, serde::Serialize)]
struct Patch<'r> {
    index: usize,
    name: &'r str,
    radiosity: f64,
    irradiance: f64,
    importance: Option<f64>,
    /// What the form factors' errors do to the radiosity, a bound; null where none is known.
    form_factor_error: Option<f64>,
}

/// Where the light comes from and goes.
#[derive(Debug, serde::Serialize)]
struct Power {
    emitted: f64,
    absorbed: f64,
    escaped: f64,
}

impl Power {
    fn of(materials: &[Material], exchange: &ExchangeAreas, radiosity: &RadiositySolution) -> Self {
        let areas = exchange.areas();
        let closure = Closure::of_held(exchange);
        let sum = |term: &dyn Fn(usize) -> f64| {
            compensated_sum(areas.iter().enumerate().map(|(i, area)| area * term(i)))
        };
        Self {
            emitted: sum(&|i| materials[i].emittance()),
            absorbed: sum(&|i| (1.0 - materials[i].reflectance()) * radiosity.received[i]),
            escaped: sum(&|i| closure.escaping(i) * radiosity.values[i]),
        }
    }
}

/// What was found of a scene whose rows have these names.
///
/// # Errors
/// [`ReportError::NotFinite`] with the key of a number that is NaN or infinite.
pub fn radiosity_report(
    names: &[&str],
    materials: &[Material],
    exchange: &ExchangeAreas,
    radiosity: &RadiositySolution,
    importance: Option<&Importance>,
) -> Result<Report, ReportError> {
    let form_factor_error = |i: usize| Some(radiosity.form_factor_errors.as_ref()?[i]);
    let patches: Vec<Patch<'_>> = names
        .iter()
        .enumerate()
        .map(|(index, name)| Patch {
            index,
            name,
            radiosity: radiosity.values[index],
            irradiance: radiosity.received[index],
            importance: importance.map(|importance| importance.values[index]),
            form_factor_error: form_factor_error(index),
        })
        .collect();
    let closure = Closure::of_held(exchange);
    let summary = Summary {
        residual: radiosity.residual,
        iterations: radiosity.iterations,
        relative_error: radiosity.relative_error,
        closed: closure.is_closed(),
        power: Power::of(materials, exchange, radiosity),
        plan: &exchange.summary().plan,
    };
    let row = |patch: &Patch<'_>| {
        let solution = radiosity.relative_error * patch.radiosity;
        let known = patch.form_factor_error.map(|error| error + solution);
        let digits = |value: f64| match known {
            Some(error) => certain_digits(value, error.max(f64::MIN_POSITIVE)),
            None => format!("({value:.6e})"),
        };
        let error = |error: Option<f64>| error.map_or_else(|| "unknown".to_owned(), scientific);
        let mut row = vec![
            patch.index.to_string(),
            patch.name.to_owned(),
            digits(patch.radiosity),
            format!("{:.6e}", patch.irradiance),
            scientific(solution),
            error(patch.form_factor_error),
        ];
        row.extend(
            patch
                .importance
                .map(|importance| format!("{importance:.6e}")),
        );
        row
    };
    let mut columns = vec![
        "patch",
        "name",
        "radiosity",
        "irradiance",
        "± solution",
        "± form factors",
    ];
    if importance.is_some() {
        columns.push("importance");
    }
    let Power {
        emitted,
        absorbed,
        escaped,
    } = &summary.power;
    let mut notes = vec![
        (
            "power".to_owned(),
            format!("{emitted:.12e} emitted, {absorbed:.12e} absorbed, {escaped:.12e} escaped"),
        ),
        (
            "solution".to_owned(),
            format!(
                "{} iterations, {} relative at most, residual {}",
                summary.iterations,
                scientific(summary.relative_error),
                scientific(summary.residual)
            ),
        ),
    ];
    if patches.len() > MOST_ROWS {
        let left_out = patches.len() - MOST_ROWS;
        notes.push(("patches".to_owned(), format!("{left_out} more, in records")));
    }
    notes.extend(plan_notes(summary.plan));
    let table = Table {
        columns,
        rows: patches.iter().take(MOST_ROWS).map(row).collect(),
        notes,
        ..Table::default()
    };
    Report::list(table, "patches", &patches)?.summarised(&summary)
}
