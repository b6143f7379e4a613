//! Error of every route to a form factor, against its run time.
//!
//! Cases are the pairs of `form_factors.csv` with their 30 digits, and pairs of each
//! [`Family`](super::families::Family) with the [`Truth`](crate::reference::Truth) computed in the
//! run; past others, the pairs of `occlusion.json`, plates half-way between two squares with their
//! exact values, and pairs of each [`OccludedFamily`](super::occluded::OccludedFamily) judged by
//! the rule over the area. Methods are each route alone at several tolerances, the chooser at the
//! same ones, Gauss rules of fixed order, lines at random, and past others a Gauss rule of fixed
//! order over one polygon, from whose points the rest is seen in closed form. A row is one case by
//! one method at one setting; log-log plots take `seconds` and `relative_error` of rows with the
//! same case and method.
//!
//! A family's row has the largest error and the root of the mean square over its pairs, the mean
//! time of a pair, and how many pairs the method served. Errors of the lines are of one seed. The
//! corners in the file are decimals: in `f64` they move a value by some ε.

mod cases;
mod methods;

use crate::numeric::real;
use crate::study::StudyError;
use crate::study::run_time::median_time;
use cases::{Case, known_cases, occluded_cases, random_cases};
use methods::Method;
use std::time::Duration;

/// The family of plates half-way between two squares, whose exchange is known exactly.
pub const HALFWAY: &str = "past others: plates half-way";

/// One measurement.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct AccuracyRow {
    /// A pair, or a family of pairs.
    pub case: String,
    /// The kind of the case.
    pub family: String,
    /// The method.
    pub method: &'static str,
    /// The origin of the exact value.
    pub judge: &'static str,
    /// The exact exchange area, or the mean of a family's.
    pub value: f64,
    /// The relative uncertainty of the exact value, the largest of a family.
    pub uncertainty: f64,
    /// |computed − exact| / exact, the largest of a family.
    pub relative_error: f64,
    /// The root of its mean square.
    pub mean_square_error: f64,
    /// The largest bound on it, where the method has one.
    pub bound: Option<f64>,
    /// The largest standard error over the value, where the method samples.
    pub standard_error: Option<f64>,
    /// Time of one pair, in seconds.
    pub seconds: f64,
    /// The tolerance asked for.
    pub tolerance: Option<f64>,
    /// Points per direction.
    pub order: Option<usize>,
    /// Lines.
    pub samples: Option<u32>,
    /// Pairs that the method gave a value for.
    pub served: usize,
    /// Pairs of the case.
    pub pairs: usize,
}

/// The rows of the study; `is_quick` takes few pairs of each family, judged by the double-double
/// route with its bound, few lines, and each time once.
///
/// # Errors
/// [`StudyError`] if a case has no exact value, which the tests exclude.
pub fn accuracy(is_quick: bool) -> Result<Vec<AccuracyRow>, StudyError> {
    let (count, most_lines, least) = if is_quick {
        (2, 1000, Duration::ZERO)
    } else {
        (8, 1_000_000, Duration::from_millis(2))
    };
    let mut cases = known_cases()?;
    cases.extend(random_cases(count, is_quick)?);
    cases.extend(occluded_cases(is_quick)?);
    let methods = Method::all(most_lines);
    let rows = cases
        .iter()
        .flat_map(|case| methods.iter().map(move |method| (case, *method)))
        .filter_map(|(case, method)| measured(case, method, least));
    Ok(rows.collect())
}

/// One row; `None` if the method serves no pair of the case.
fn measured(case: &Case, method: Method, least: Duration) -> Option<AccuracyRow> {
    // no method judges itself
    if case.pairs.first()?.truth.origin() == method.name() {
        return None;
    }
    let mut row = AccuracyRow {
        case: case.name.clone(),
        family: case.family.clone(),
        method: method.name(),
        judge: case.pairs.first()?.truth.origin(),
        value: 0.0,
        uncertainty: 0.0,
        relative_error: 0.0,
        mean_square_error: 0.0,
        bound: None,
        standard_error: None,
        seconds: 0.0,
        tolerance: method.tolerance(),
        order: method.order(),
        samples: method.samples(),
        served: 0,
        pairs: case.pairs.len(),
    };
    let largest = |old: Option<f64>, new: Option<f64>| old.into_iter().chain(new).reduce(f64::max);
    for pair in &case.pairs {
        let (found, seconds) = median_time(least, || method.apply(pair));
        let Some(found) = found else {
            continue;
        };
        let exact = pair.truth.value();
        let error = pair.truth.relative_error_of(found.value);
        row.value += exact;
        row.uncertainty = row.uncertainty.max(pair.truth.uncertainty());
        row.relative_error = row.relative_error.max(error);
        row.mean_square_error += error * error;
        row.bound = largest(row.bound, found.bound.map(|bound| bound / exact));
        row.standard_error = largest(row.standard_error, found.standard_error.map(|e| e / exact));
        row.seconds += seconds;
        row.served += 1;
    }
    let served = real(row.served);
    row.value /= served;
    row.mean_square_error = (row.mean_square_error / served).sqrt();
    row.seconds /= served;
    (row.served > 0).then_some(row)
}
