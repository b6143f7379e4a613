//! Digits that routes keep of extreme pairs past others.
//!
//! Screens at 1e-12, 1e-9 wide, seen edge-on, by the hundred; values of 1e-9 of the unoccluded one.
//! Every exact value follows from a symmetry (`extreme`), as an enclosure with 256 bits. Methods
//! are the route at the default tolerance and at the finest one, with their bounds; a Gauss rule
//! over the first polygon from whose points the rest is seen in closed form, and quasi-random
//! lines, which have none.

use super::extreme::{ExtremeCase, cases};
use super::point_rule;
use crate::form_factor::sampling::quasi_random_lines_past;
use crate::form_factor::{Answer, DEFAULT_TOLERANCE, Occluders, Polygon, Route};
use crate::study::StudyError;
use crate::study::form_factors::extreme_pairs::{CHOSEN, StabilityRow};
use crate::study::run_time::mean_time;

/// Points per direction and triangle of the rule over the first polygon.
const ORDER: usize = 16;
/// Number of lines.
const LINES: u32 = 100_000;
/// An arbitrary seed.
const SEED: u64 = 1999;

/// The methods without a bound.
pub const UNBOUNDED: [&str; 2] = ["point-rule", "quasi-random"];

/// The rows of the study: for each pair those of all methods.
///
/// Each evaluation is repeated `repetitions` times for its time; `is_quick` leaves out the pair
/// that takes longest.
///
/// # Errors
/// [`StudyError`] if a pair has no exact value, which the tests exclude.
pub fn occluded_stability(
    repetitions: u32,
    is_quick: bool,
) -> Result<Vec<StabilityRow>, StudyError> {
    let cases = cases(is_quick)?;
    Ok(cases
        .iter()
        .flat_map(|case| rows(case, repetitions))
        .collect())
}

/// The rows of one pair.
fn rows(case: &ExtremeCase, repetitions: u32) -> Vec<StabilityRow> {
    let [first, second] = case.pair.pair.each_ref().map(Polygon::new);
    let blockers: Vec<Polygon> = case.pair.blockers.iter().map(Polygon::new).collect();
    let polygons: Vec<&Polygon> = blockers.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    let mut rows = Vec::new();
    for (method, tolerance) in [(CHOSEN, DEFAULT_TOLERANCE), (Route::Occluded.name(), 0.0)] {
        let form = || {
            first
                .exchange_area_past(&second, &occluders, tolerance)
                .ok()
        };
        let (answer, seconds) = mean_time(repetitions, form);
        if answer.is_none() && method != CHOSEN {
            continue;
        }
        rows.push(row(case, method, answer.map(Found::of), seconds));
    }
    let pair = &case.pair.pair;
    let [rule, lines] = UNBOUNDED;
    let (found, seconds) = mean_time(1, || point_rule::exchange_area(pair, &blockers, ORDER));
    rows.extend(found.map(|value| row(case, rule, Some(Found::alone(value)), seconds)));
    let sample = || {
        let ends = [&pair[0], &pair[1]];
        let sample = quasi_random_lines_past(ends, &case.pair.blockers, LINES, SEED)?;
        Some(sample.value * pair[0].area())
    };
    let (found, seconds) = mean_time(1, sample);
    rows.extend(found.map(|value| row(case, lines, Some(Found::alone(value)), seconds)));
    rows
}

/// The result of a method.
#[derive(Debug, Clone, Copy)]
struct Found {
    value: f64,
    bound: Option<f64>,
    route: Option<&'static str>,
}

impl Found {
    fn of(answer: Answer) -> Self {
        Self {
            value: answer.exchange.value,
            bound: Some(answer.exchange.error),
            route: Some(answer.route.name()),
        }
    }

    const fn alone(value: f64) -> Self {
        Self {
            value,
            bound: None,
            route: None,
        }
    }
}

fn row(case: &ExtremeCase, method: &str, found: Option<Found>, seconds: f64) -> StabilityRow {
    let exact = case.truth.value();
    StabilityRow {
        case: case.name.to_owned(),
        method: method.to_owned(),
        value: exact,
        relative_error: found.map(|found| case.truth.relative_error_of(found.value)),
        seconds,
        bound: found.and_then(|found| Some(found.bound? / exact)),
        route: found.and_then(|found| found.route),
        input_error: None,
        uncertainty: Some(case.truth.uncertainty()),
        unoccluded: Some(case.unoccluded.value()),
    }
}
