//! Error of every route to a form factor, against its run time.
//!
//! Cases are the pairs of `form_factors.csv` with their 30 digits, and pairs of each [`Family`]
//! with the [`Truth`] computed in the run. Methods are each route alone at several tolerances, the
//! chooser at the same ones, Gauss rules of fixed order, and lines at random. A row is one case by
//! one method at one setting; log-log plots take `seconds` and `relative_error` of rows with the
//! same case and method.
//!
//! A family's row has the largest error and the root of the mean square over its pairs, the mean
//! time of a pair, and how many pairs the method served. Errors of the lines are of one seed. The
//! corners in the file are decimals: in `f64` they move a value by some ε.

use super::families::Family;
use super::gauss_order;
use crate::form_factor::sampling::{global_lines, local_lines, quasi_random_lines};
use crate::form_factor::{Polygon, Route};
use crate::geometry::Patch;
use crate::numeric::{real, try_parallel_map};
use crate::reference::Truth;
use crate::study::StudyError;
use glam::DVec3;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Tolerances asked for.
const TOLERANCES: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];
/// Points per direction of rules of fixed order.
const ORDERS: [usize; 7] = [1, 2, 3, 4, 6, 8, 12];
/// Numbers of lines.
const LINES: [u32; 5] = [100, 1000, 10_000, 100_000, 1_000_000];
/// An arbitrary seed.
const SEED: u64 = 1999;

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

/// A method of computing an exchange area.
#[derive(Debug, Clone, Copy)]
enum Method {
    /// The chooser, at a tolerance.
    Chooser(f64),
    /// One route alone, at a tolerance.
    Alone(Route, f64),
    /// A Gauss rule of fixed order.
    Order(usize),
    /// Lines at random, so many.
    Lines(Sampler, u32),
}

#[derive(Debug, Clone, Copy)]
enum Sampler {
    Local,
    Global,
    QuasiRandom,
}

/// The result of a method.
#[derive(Debug, Clone, Copy)]
struct Found {
    value: f64,
    bound: Option<f64>,
    standard_error: Option<f64>,
}

impl Method {
    fn all(most_lines: u32) -> Vec<Self> {
        let closed = [Route::ParallelRectangles, Route::PerpendicularRectangles];
        let routes = [
            Route::Contour,
            Route::PointToPolygon,
            Route::Kernel,
            Route::DoubleDouble,
        ];
        let samplers = [Sampler::Local, Sampler::Global, Sampler::QuasiRandom];
        let lines = || LINES.into_iter().filter(|lines| *lines <= most_lines);
        let mut all: Vec<Self> = closed.map(|route| Self::Alone(route, 1.0)).to_vec();
        all.extend(TOLERANCES.map(Self::Chooser));
        for route in routes {
            all.extend(TOLERANCES.map(|tolerance| Self::Alone(route, tolerance)));
        }
        all.extend(ORDERS.map(Self::Order));
        for sampler in samplers {
            all.extend(lines().map(|lines| Self::Lines(sampler, lines)));
        }
        all
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Chooser(_) => "chooser",
            Self::Alone(route, _) => route.name(),
            Self::Order(_) => "gauss-order",
            Self::Lines(Sampler::Local, _) => "local-lines",
            Self::Lines(Sampler::Global, _) => "global-lines",
            Self::Lines(Sampler::QuasiRandom, _) => "quasi-random",
        }
    }

    fn tolerance(self) -> Option<f64> {
        match self {
            Self::Chooser(tolerance) | Self::Alone(_, tolerance) => {
                Some(tolerance).filter(|tolerance| *tolerance < 1.0)
            }
            _ => None,
        }
    }

    fn apply(self, pair: &Pair) -> Option<Found> {
        let [first, second] = &pair.polygons;
        let answer = match self {
            Self::Chooser(tolerance) => first.exchange_area(second, tolerance),
            Self::Alone(route, tolerance) => first.exchange_area_by(route, second, tolerance),
            Self::Order(order) => {
                return gauss_order::exchange_area(&pair.patches, order).map(|value| Found {
                    value,
                    bound: None,
                    standard_error: None,
                });
            }
            Self::Lines(sampler, lines) => {
                let [from, to] = &pair.patches;
                let sample = match sampler {
                    Sampler::Local => local_lines(from, to, lines, SEED),
                    Sampler::Global => global_lines(from, to, lines, SEED).form_factor(),
                    Sampler::QuasiRandom => quasi_random_lines(from, to, lines, SEED),
                }?;
                return Some(Found {
                    value: sample.value * from.area(),
                    bound: None,
                    standard_error: Some(sample.standard_error * from.area()),
                });
            }
        };
        // a route that does not serve a pair may say so by another route's name
        let asked = match self {
            Self::Alone(route, _) => Some(route),
            _ => None,
        };
        let answer = answer.ok()?;
        if asked.is_some_and(|route| route != answer.route) {
            return None;
        }
        let exchange = answer.exchange;
        Some(Found {
            value: exchange.value,
            bound: Some(exchange.error),
            standard_error: None,
        })
    }
}

/// Two polygons and what they exchange.
#[derive(Debug)]
struct Pair {
    patches: [Patch; 2],
    polygons: [Polygon; 2],
    truth: Truth,
}

impl Pair {
    fn new(patches: [Patch; 2], truth: Truth) -> Self {
        Self {
            polygons: patches.each_ref().map(Polygon::new),
            patches,
            truth,
        }
    }
}

#[derive(Debug)]
struct Case {
    name: String,
    family: String,
    pairs: Vec<Pair>,
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
    for family in Family::ALL {
        let name = family.name();
        let pairs = try_parallel_map(count, &|number| {
            let patches = family.pair(number as u64)?;
            let truth = if is_quick {
                Truth::by_double_double(&patches)
            } else {
                Truth::of(&patches)
            };
            let truth = truth.map_err(|source| StudyError::FormFactor {
                case: format!("{name} {number}"),
                source,
            })?;
            Ok::<_, StudyError>(Pair::new(patches, truth))
        })?;
        cases.push(Case {
            name: format!("{count} pairs: {name}"),
            family: name.to_owned(),
            pairs,
        });
    }
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
        relative_error: 0.0,
        mean_square_error: 0.0,
        bound: None,
        standard_error: None,
        seconds: 0.0,
        tolerance: method.tolerance(),
        order: match method {
            Method::Order(order) => Some(order),
            _ => None,
        },
        samples: match method {
            Method::Lines(_, lines) => Some(lines),
            _ => None,
        },
        served: 0,
        pairs: case.pairs.len(),
    };
    let largest = |old: Option<f64>, new: Option<f64>| old.into_iter().chain(new).reduce(f64::max);
    for pair in &case.pairs {
        let (found, seconds) = timed(least, || method.apply(pair));
        let Some(found) = found else {
            continue;
        };
        let exact = pair.truth.value();
        let error = pair.truth.relative_error_of(found.value);
        row.value += exact;
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

/// Evaluations whose median is a time, at least.
const REPETITIONS: usize = 5;

/// The result, and the median time of as many evaluations as fill the time: of one that fills it
/// alone, its own.
fn timed<T>(least: Duration, evaluate: impl Fn() -> T) -> (T, f64) {
    let once = || {
        let start = Instant::now();
        let result = black_box(evaluate());
        (result, start.elapsed())
    };
    let (mut result, first) = once();
    if least.is_zero() || first > least {
        return (result, first.as_secs_f64());
    }
    // below some µs the clock itself counts: many at a time
    let batch = (20_000 / first.as_nanos().max(20)).clamp(1, 1000);
    let mut times = Vec::new();
    let start = Instant::now();
    while times.len() < REPETITIONS || start.elapsed() < least {
        let begin = Instant::now();
        for _ in 0..batch {
            result = black_box(evaluate());
        }
        #[expect(clippy::cast_precision_loss, reason = "up to 1000")]
        let count = batch as f64;
        times.push(begin.elapsed().as_secs_f64() / count);
    }
    times.sort_by(f64::total_cmp);
    (result, times[times.len() / 2])
}

/// The pairs of `form_factors.csv`, each a case.
fn known_cases() -> Result<Vec<Case>, StudyError> {
    const TABLE: &str = include_str!("../../../data/reference/form_factors.csv");
    /// Significant digits in the file.
    const DIGITS: i32 = 30;
    let mut reader = csv::Reader::from_reader(TABLE.as_bytes());
    let mut cases = Vec::new();
    for record in reader.deserialize() {
        let record: Record = record?;
        let number = |text: &str| StudyError::Number {
            id: record.id.clone(),
            text: text.to_owned(),
        };
        let patch = |text: &str| -> Result<Patch, StudyError> {
            let texts: Vec<[String; 3]> = serde_json::from_str(text)?;
            let corner = |texts: &[String; 3]| {
                let mut parts = [0.0; 3];
                for (part, text) in parts.iter_mut().zip(texts) {
                    *part = text.parse().map_err(|_| number(text))?;
                }
                Ok(DVec3::from_array(parts))
            };
            let corners: Result<_, StudyError> = texts.iter().map(corner).collect();
            Ok(Patch::try_new(corners?)?)
        };
        let (first, second) = record
            .inputs
            .trim_start_matches("P=")
            .split_once(";Q=")
            .ok_or_else(|| number(&record.inputs))?;
        let truth = Truth::from_decimals(&record.exchange_area, DIGITS)
            .ok_or_else(|| number(&record.exchange_area))?;
        let family = match record.id.split('_').nth(1) {
            Some("par") => "known, parallel rectangles",
            Some("perp") => "known, perpendicular rectangles",
            Some("incl") => "known, inclined squares",
            _ => "known, other polygons",
        };
        cases.push(Case {
            pairs: vec![Pair::new([patch(first)?, patch(second)?], truth)],
            name: record.description,
            family: family.to_owned(),
        });
    }
    Ok(cases)
}

/// The columns of the file that are read.
#[derive(Debug, serde::Deserialize)]
struct Record {
    id: String,
    description: String,
    inputs: String,
    exchange_area: String,
}
