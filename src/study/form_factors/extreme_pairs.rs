//! Digits that the routes to a form factor keep of stiff and extreme pairs.
//!
//! Aspect ratios, gaps, angles, distances, sizes, slivers and needles, each far beyond what scenes
//! hold. Every route is asked for all it can give (tolerance 0), the chooser for the default
//! tolerance; each value is judged by the [`Truth`] of the corners as they are in `f64`, computed
//! in the run.
//!
//! Where rounding of the corners took digits before any route saw them, the row says how many:
//! `input_error` is the relative difference between the exact values of the pair as rounded and of
//! the same pair before its move.

use super::extreme_cases::{Effort, ExtremePair, PAIRS};
use crate::form_factor::{Answer, DEFAULT_TOLERANCE, Polygon, Route};
use crate::geometry::Patch;
use crate::numeric::try_parallel_map;
use crate::reference::Truth;
use crate::study::run_time::mean_time;
use crate::study::{Row, StudyError};

/// One measurement: a gain, or a pair by one route.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct StabilityRow {
    /// The pair or gain computed.
    pub case: String,
    /// The method; `chosen` for the chooser.
    pub method: String,
    /// The exact value.
    pub value: f64,
    /// |computed − exact| / exact; none if the chooser refused.
    pub relative_error: Option<f64>,
    /// Time of one evaluation, in seconds.
    pub seconds: f64,
    /// The bound on the relative error, where the method has one.
    pub bound: Option<f64>,
    /// The route, of a pair.
    pub route: Option<&'static str>,
    /// The relative change of the exact value by rounding of the corners, where the pair was moved.
    pub input_error: Option<f64>,
    /// The relative uncertainty of the exact value: an enclosure's width, or a reference's
    /// estimate.
    pub uncertainty: Option<f64>,
    /// The exact value without what is in the way, of a pair past others.
    pub unoccluded: Option<f64>,
}

impl From<Row> for StabilityRow {
    fn from(row: Row) -> Self {
        Self {
            case: row.case,
            method: row.method,
            value: row.value,
            relative_error: Some(row.relative_error),
            seconds: row.seconds,
            bound: None,
            route: None,
            input_error: None,
            uncertainty: None,
            unoccluded: None,
        }
    }
}

/// The routes that serve any polygons.
pub const ROUTES: [Route; 4] = [
    Route::Contour,
    Route::PointToPolygon,
    Route::Kernel,
    Route::DoubleDouble,
];

/// The rows of the study: for each pair the chooser's and those of the routes that serve it.
///
/// Each evaluation is repeated `repetitions` times for its time; `is_quick` leaves out the pairs
/// whose exact value takes a second and more.
///
/// # Errors
/// [`StudyError`] if a pair has no exact value, which the tests exclude.
pub fn route_stability(repetitions: u32, is_quick: bool) -> Result<Vec<StabilityRow>, StudyError> {
    let pairs = PAIRS
        .iter()
        .filter(|pair| !is_quick || pair.effort == Effort::Little);
    let cases = pairs.map(Case::of).collect::<Result<Vec<_>, _>>()?;
    let exact = try_parallel_map(cases.len(), &|case| cases[case].judged())?;
    let mut rows = Vec::new();
    for (case, (truth, input_error)) in cases.iter().zip(exact) {
        let [first, second] = case.pair.each_ref().map(Polygon::new);
        let mut add = |method: &str, form: &dyn Fn() -> Option<Answer>| {
            let (answer, seconds) = mean_time(repetitions, form);
            if answer.is_none() && method != CHOSEN {
                return;
            }
            let exact = truth.value();
            let exchange = answer.map(|answer| answer.exchange);
            rows.push(StabilityRow {
                case: case.name.to_owned(),
                method: method.to_owned(),
                value: exact,
                relative_error: exchange.map(|found| truth.relative_error_of(found.value)),
                seconds,
                bound: exchange.map(|found| found.error / exact),
                route: answer.map(|answer| answer.route.name()),
                input_error,
                uncertainty: Some(truth.uncertainty()),
                unoccluded: None,
            });
        };
        add(CHOSEN, &|| {
            first.exchange_area(&second, DEFAULT_TOLERANCE).ok()
        });
        for route in ROUTES {
            add(route.name(), &|| {
                // nothing but a refusal comes by another route than asked
                let answer = first.exchange_area_by(route, &second, 0.0);
                answer.ok().filter(|answer| answer.route == route)
            });
        }
    }
    Ok(rows)
}

/// The method that is the chooser.
pub const CHOSEN: &str = "chosen";

/// The patches of an extreme pair, and those before a move rounded them.
struct Case {
    name: &'static str,
    pair: [Patch; 2],
    meant: Option<[Patch; 2]>,
}

impl Case {
    fn of(extreme: &ExtremePair) -> Result<Self, StudyError> {
        Ok(Self {
            name: extreme.name,
            pair: extreme.patches()?,
            meant: extreme.meant()?,
        })
    }

    /// Computes the exact value, and the relative change of it by rounding.
    fn judged(&self) -> Result<(Truth, Option<f64>), StudyError> {
        let truth = self.truth(&self.pair)?;
        let input_error = match &self.meant {
            Some(meant) => Some(self.truth(meant)?.relative_difference(&truth)),
            None => None,
        };
        Ok((truth, input_error))
    }

    fn truth(&self, pair: &[Patch; 2]) -> Result<Truth, StudyError> {
        Truth::of(pair).map_err(|source| StudyError::FormFactor {
            case: self.name.to_owned(),
            source,
        })
    }
}
