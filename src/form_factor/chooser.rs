//! The chooser: the cheapest route whose bound meets the tolerance, and the next one where it does
//! not.
//!
//! ```text
//!   aligned rectangles    closed form
//!   moderate distance     contour, one Gauss rule for all edges apart
//!   apart                 point to polygon (over the smaller one) or kernel (over both), by work
//!   what cancels in f64   contour in double-double
//!   what cancels there    closed form of aligned rectangles, in intervals of 256 bits
//! ```

use super::clipped_pair::ClippedPair;
use super::contour::contour;
use super::workspace::Workspace;
use super::{Answer, ExchangeArea, FormFactorError, Route};
use crate::form_factor::clipped_pair::horizon::{Displacement, precise_outline};
use crate::form_factor::contour::double_double::precise_contour;
use crate::form_factor::gauss::lambert::LambertRounding;
use crate::form_factor::gauss::points::MOST_PER_DIRECTION;
use crate::numeric::functions::elementary::rough_ln;
use crate::numeric::{LANES, SQUARED_EPSILON, real};
use smallvec::SmallVec;

impl ClippedPair<'_> {
    /// The plan that is tried first.
    pub(super) fn first_plan(&self) -> Plan {
        let mut plans = Plans::new();
        self.plans(&mut plans);
        cheapest(&plans).map_or(Plan::Contour, |k| plans[k].1)
    }

    /// The answer by the cheapest plan that does.
    pub(super) fn answer(&self, work: &mut Workspace) -> Result<Answer, FormFactorError> {
        let mut best: Option<Answer> = None;
        let mut left = Plans::new();
        self.plans(&mut left);
        // what is not expected to do is tried last, before the precise one: expectations rest on an
        // estimate
        let mut put_off: SmallVec<[Plan; 2]> = SmallVec::new();
        while let Some(k) = cheapest(&left) {
            let (cost, mut plan) = left.swap_remove(k);
            let is_hopeless = match &mut plan {
                Plan::PointToPolygon { over, rounding, .. } => {
                    *rounding = self.lambert_rounding(*over);
                    rounding.expected > 0.7 * self.tolerance * self.estimate
                }
                _ => cost == f64::INFINITY,
            };
            if is_hopeless {
                put_off.push(plan);
            } else if let Some(done) = self.settle(self.follow(plan, work), plan.route(), &mut best)
            {
                return done.in_range();
            }
        }
        put_off.push(Plan::Precise);
        for plan in put_off {
            if matches!(plan, Plan::Precise) && best.is_some_and(|best| self.is_hardly_better(best))
            {
                break;
            }
            if let Some(done) = self.settle(self.follow(plan, work), plan.route(), &mut best) {
                return done.in_range();
            }
        }
        match best {
            Some(best) => best.in_range(),
            None => Err(FormFactorError::NotResolved {
                value: self.estimate,
                error: f64::INFINITY,
            }),
        }
    }

    /// The answer of one route alone.
    pub(super) fn answer_by(&self, route: Route, work: &mut Workspace) -> Option<Answer> {
        let exchange = match route {
            Route::Contour => self.follow(Plan::Contour, work),
            Route::DoubleDouble => self.follow(Plan::Precise, work),
            _ if self.gap > 0.0 => {
                let points = [0, 1].map(|k| self.points(k));
                let over = usize::from(points[1] < points[0]);
                match route {
                    Route::PointToPolygon => self.follow(
                        Plan::PointToPolygon {
                            over,
                            points: points[over],
                            rounding: self.lambert_rounding(over),
                        },
                        work,
                    ),
                    Route::Kernel => self.follow(Plan::Kernel { points }, work),
                    _ => None,
                }
            }
            _ => None,
        };
        let mut best = None;
        self.settle(exchange, route, &mut best).or(best)
    }

    /// The answer, if its bound meets the tolerance; else it is kept if it is the best so far.
    pub(super) fn settle(
        &self,
        exchange: Option<ExchangeArea>,
        route: Route,
        best: &mut Option<Answer>,
    ) -> Option<Answer> {
        let mut exchange = exchange?;
        if route != Route::DoubleDouble {
            exchange.error += self.slack(self.displacement, exchange.value, route);
        }
        let ExchangeArea { value, error } = exchange;
        let answer = Answer { exchange, route };
        if error <= self.tolerance * value {
            return Some(answer);
        }
        // of values that are not good enough, the one known best; what rounding left below zero is
        // not
        let value = value.max(0.0);
        let error = error + (value - exchange.value);
        let known = best.map_or(f64::INFINITY, |best| best.exchange.error);
        if error < known {
            let exchange = ExchangeArea { value, error };
            *best = Some(Answer { exchange, route });
        }
        None
    }

    /// Routes with their rough work in nanoseconds; infinite if cancellation leaves too little.
    fn plans(&self, plans: &mut Plans) {
        if self.gap <= 0.0 {
            plans.push((0.0, Plan::Contour));
            return;
        }
        let points = [self.points(0), self.points(1)];
        let on = [0, 1].map(|k| real(LANES * self.rules(k, points[k]).1));
        let corners = self.shapes.map(|shape| real(shape.corners.len()));
        if points[0].max(points[1]) < MOST_PER_DIRECTION {
            let work = 1.0 * (on[0] + on[1]) + on[0] * on[1] * 0.2;
            plans.push((work, Plan::Kernel { points }));
            if work < CHEAP {
                return;
            }
        }
        let over = usize::from(on[1] * corners[0] < on[0] * corners[1]);
        if points[over] < MOST_PER_DIRECTION {
            let work = on[over] * (1.0 + corners[1 - over] * self.lambert_work(over));
            let points = points[over];
            // computed when it is its turn
            let rounding = LambertRounding::default();
            plans.push((
                work,
                Plan::PointToPolygon {
                    over,
                    points,
                    rounding,
                },
            ));
        }
        plans.push((self.contour_work(), Plan::Contour));
    }

    fn contour_work(&self) -> f64 {
        let [first, second] = self.shapes;
        let rounding = f64::EPSILON * self.reach * first.perimeter * second.perimeter;
        if rounding > self.tolerance * self.estimate {
            return f64::INFINITY;
        }
        let corners = real(first.corners.len() * second.corners.len());
        let ratio = 1.0 + 2.0 * self.gap / first.longest_edge.min(second.longest_edge);
        let digits = 2.0 * rough_ln(ratio + (ratio * ratio - 1.0).sqrt());
        150.0 + corners * 240.0 / digits.max(1.5)
    }

    fn follow(&self, plan: Plan, work: &mut Workspace) -> Option<ExchangeArea> {
        match plan {
            Plan::Contour => {
                let range = [self.gap, self.reach];
                let wanted = 0.25 * self.wanted();
                let [first, second] = self.shapes;
                contour(first, second, range, wanted, &mut work.scratch)
            }
            Plan::PointToPolygon {
                over,
                points,
                rounding,
            } => {
                let (blocks, sides) = (&mut work.blocks[0], &mut work.sides);
                Some(self.point_to_polygon(over, points, rounding, (blocks, sides)))
            }
            Plan::Precise => self.precise_contour(),
            Plan::Kernel { points } => Some(self.kernel(points, &mut work.blocks)),
        }
    }

    /// Whether double-double would not halve a bound that misses the tolerance, since what the
    /// corners are off by is most of it.
    fn is_hardly_better(&self, best: Answer) -> bool {
        let ExchangeArea { value, error } = best.exchange;
        let least = self.slack(self.precise_displacement(), value, Route::DoubleDouble);
        least > 0.5 * error && least > self.tolerance * value
    }

    /// The displacement of corners where the clip is right to 64 ε² of the coordinates: a polygon
    /// that is not planar, by its tilt.
    fn precise_displacement(&self) -> Displacement {
        let [first, second] = self.polygons;
        Displacement {
            height: (first.tilt.max(second.tilt) + 64.0 * SQUARED_EPSILON) * self.reach,
            strip: self.displacement.tilted_strip,
            ..Displacement::default()
        }
    }

    fn precise_contour(&self) -> Option<ExchangeArea> {
        let [first, second] = self.polygons;
        let outlines = [
            precise_outline(first, second),
            precise_outline(second, first),
        ];
        let wanted = 0.01 * self.wanted();
        let mut exchange = precise_contour([&outlines[0], &outlines[1]], wanted)?;
        exchange.error += self.slack(
            self.precise_displacement(),
            exchange.value,
            Route::DoubleDouble,
        );
        Some(exchange)
    }
}

/// Work in nanoseconds below which no other route is asked for.
const CHEAP: f64 = 200.0;

/// The place of the plan with the least work.
fn cheapest(plans: &[(f64, Plan)]) -> Option<usize> {
    (0..plans.len()).min_by(|i, j| plans[*i].0.total_cmp(&plans[*j].0))
}

/// Routes with their work.
type Plans = SmallVec<[(f64, Plan); 3]>;

/// A route, and how many points it takes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Plan {
    Contour,
    Precise,
    PointToPolygon {
        over: usize,
        points: usize,
        rounding: LambertRounding,
    },
    Kernel {
        points: [usize; 2],
    },
}

impl Plan {
    const fn route(self) -> Route {
        match self {
            Self::Contour => Route::Contour,
            Self::Precise => Route::DoubleDouble,
            Self::PointToPolygon { .. } => Route::PointToPolygon,
            Self::Kernel { .. } => Route::Kernel,
        }
    }
}

impl Answer {
    pub(super) fn in_range(self) -> Result<Self, FormFactorError> {
        let ExchangeArea { value, error } = self.exchange;
        if value.is_finite() && error.is_finite() {
            Ok(self)
        } else {
            Err(FormFactorError::OutOfRange { value })
        }
    }
}
