//! The methods of the study: routes, rules of fixed order, lines at random.

use super::cases::Pair;
use crate::form_factor::sampling::{global_lines, local_lines_past, quasi_random_lines_past};
use crate::form_factor::{Occluders, Polygon, Route};
use crate::study::form_factors::gauss_order;
use crate::study::form_factors::occluded::point_rule;

/// Tolerances asked for.
const TOLERANCES: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];
/// Points per direction of rules of fixed order.
const ORDERS: [usize; 7] = [1, 2, 3, 4, 6, 8, 12];
/// Points per direction of rules over one polygon.
const POINTS: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];
/// Numbers of lines.
const LINES: [u32; 5] = [100, 1000, 10_000, 100_000, 1_000_000];
/// An arbitrary seed.
const SEED: u64 = 1999;

/// A method of computing an exchange area.
#[derive(Debug, Clone, Copy)]
pub(super) enum Method {
    /// The chooser, at a tolerance.
    Chooser(f64),
    /// One route alone, at a tolerance.
    Alone(Route, f64),
    /// A Gauss rule of fixed order.
    Order(usize),
    /// A Gauss rule of fixed order over the first polygon, past others.
    Points(usize),
    /// Lines at random, so many.
    Lines(Sampler, u32),
}

/// A kind of lines.
#[derive(Debug, Clone, Copy)]
pub(super) enum Sampler {
    Local,
    Global,
    QuasiRandom,
}

/// The result of a method.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    pub(super) value: f64,
    pub(super) bound: Option<f64>,
    pub(super) standard_error: Option<f64>,
}

impl Method {
    pub(super) fn all(most_lines: u32) -> Vec<Self> {
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
        let is_quick = most_lines < LINES[4];
        let points = POINTS.into_iter().filter(|order| !is_quick || *order <= 16);
        all.extend(points.map(Self::Points));
        for sampler in samplers {
            all.extend(lines().map(|lines| Self::Lines(sampler, lines)));
        }
        all
    }

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Chooser(_) => "chooser",
            Self::Alone(route, _) => route.name(),
            Self::Order(_) => "gauss-order",
            Self::Points(_) => "point-rule",
            Self::Lines(Sampler::Local, _) => "local-lines",
            Self::Lines(Sampler::Global, _) => "global-lines",
            Self::Lines(Sampler::QuasiRandom, _) => "quasi-random",
        }
    }

    pub(super) fn tolerance(self) -> Option<f64> {
        match self {
            Self::Chooser(tolerance) | Self::Alone(_, tolerance) => {
                Some(tolerance).filter(|tolerance| *tolerance < 1.0)
            }
            _ => None,
        }
    }

    /// Points per direction.
    pub(super) const fn order(self) -> Option<usize> {
        match self {
            Self::Order(order) | Self::Points(order) => Some(order),
            _ => None,
        }
    }

    /// Number of lines.
    pub(super) const fn samples(self) -> Option<u32> {
        match self {
            Self::Lines(_, lines) => Some(lines),
            _ => None,
        }
    }

    /// The exchange area of a pair; `None` if the method does not serve it.
    pub(super) fn apply(self, pair: &Pair) -> Option<Found> {
        let is_occluded = !pair.blockers.is_empty();
        match self {
            Self::Chooser(tolerance) => chosen(pair, tolerance),
            Self::Points(order) => {
                let rule = || point_rule::exchange_area(&pair.patches, &pair.blocking, order);
                is_occluded.then(rule).flatten().map(Found::of)
            }
            Self::Lines(sampler, lines) => sampled(pair, sampler, lines),
            // the others know nothing of what is in the way
            _ if is_occluded => None,
            Self::Order(order) => gauss_order::exchange_area(&pair.patches, order).map(Found::of),
            Self::Alone(route, tolerance) => alone(pair, route, tolerance),
        }
    }
}

impl Found {
    /// A value without a bound.
    const fn of(value: f64) -> Self {
        Self {
            value,
            bound: None,
            standard_error: None,
        }
    }

    const fn bounded(value: f64, bound: f64) -> Self {
        Self {
            bound: Some(bound),
            ..Self::of(value)
        }
    }
}

/// The chooser's value, past what is in the way.
fn chosen(pair: &Pair, tolerance: f64) -> Option<Found> {
    let [first, second] = &pair.polygons;
    let polygons: Vec<&Polygon> = pair.blocking.iter().collect();
    let occluders = Occluders {
        polygons: &polygons,
        touching: 0.0,
    };
    let answer = first.exchange_area_past(second, &occluders, tolerance);
    let exchange = answer.ok()?.exchange;
    Some(Found::bounded(exchange.value, exchange.error))
}

/// A route's value, if it serves the pair: it may say by another route's name that it does not.
fn alone(pair: &Pair, route: Route, tolerance: f64) -> Option<Found> {
    let [first, second] = &pair.polygons;
    let answer = first.exchange_area_by(route, second, tolerance).ok()?;
    let exchange = answer.exchange;
    (answer.route == route).then(|| Found::bounded(exchange.value, exchange.error))
}

/// An estimate by lines past what is in the way.
fn sampled(pair: &Pair, sampler: Sampler, lines: u32) -> Option<Found> {
    let [from, to] = &pair.patches;
    let ends = [from, to];
    let sample = match sampler {
        Sampler::Local => local_lines_past(ends, &pair.blockers, lines, SEED),
        Sampler::Global if pair.blockers.is_empty() => {
            global_lines(from, to, lines, SEED).form_factor()
        }
        Sampler::Global => None,
        Sampler::QuasiRandom => quasi_random_lines_past(ends, &pair.blockers, lines, SEED),
    }?;
    Some(Found {
        standard_error: Some(sample.standard_error * from.area()),
        ..Found::of(sample.value * from.area())
    })
}
