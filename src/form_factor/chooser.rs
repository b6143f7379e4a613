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
//!
//! Before any of them: polygons that face away or lie in one plane exchange nothing, and what lies
//! behind the other's plane is clipped.

use super::clipped_pair::{ClippedPair, with_clipped_pair};
use super::contour::contour;
use super::workspace::Workspace;
use super::{Answer, ExchangeArea, FormFactorError, Polygon, Route};
use crate::form_factor::clipped_pair::horizon::{Displacement, precise_outline};
use crate::form_factor::contour::double_double::precise_contour;
use crate::form_factor::gauss::lambert::LambertRounding;
use crate::form_factor::gauss::points::MOST_PER_DIRECTION;
use crate::numeric::functions::elementary::rough_ln;
use crate::numeric::{LANES, SQUARED_EPSILON, power_of_two_below, real};
use smallvec::SmallVec;

/// Relative error that is asked for unless something else is.
pub const DEFAULT_TOLERANCE: f64 = 1e-12;

/// 2⁻¹⁰⁰⁰: sizes of pairs range from here to the inverse.
const SMALLEST_UNIT: f64 = f64::from_bits((1023 - 1000) << 52);

impl Polygon {
    /// The exchange area of the two, by the cheapest route whose error bound is within `tolerance`
    /// of the value; if none is, a value whose bound no other route would halve, which may be
    /// larger than the value where the corners' own rounding is.
    ///
    /// **Arguments** `tolerance`: relative, 0 or more; anything else counts as 0.
    ///
    /// # Errors
    /// [`FormFactorError::OutOfRange`] if the value leaves the range of `f64`;
    /// [`FormFactorError::NotResolved`] if no route finds a digit.
    ///
    /// # Examples
    /// ```
    /// use glam::DVec3;
    /// use infoscene::form_factor::{DEFAULT_TOLERANCE, Polygon};
    /// use infoscene::geometry::Patch;
    /// // the corner of a cube cut off: from one leg to another, (1 − 1/√3)/2
    /// let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    /// let leg = |corners: [DVec3; 3]| {
    ///     Patch::try_new(corners.to_vec()).map(|patch| Polygon::new(&patch))
    /// };
    /// let (floor, wall) = (leg([o, x, y])?, leg([o, y, z])?);
    /// let answer = floor.exchange_area(&wall, DEFAULT_TOLERANCE)?;
    /// let exact = (1.0 - 1.0 / 3f64.sqrt()) / 2.0;
    /// assert!((answer.exchange.value / floor.area() - exact).abs() < 1e-15);
    /// # Ok::<(), infoscene::form_factor::FormFactorError>(())
    /// ```
    pub fn exchange_area(&self, other: &Self, tolerance: f64) -> Result<Answer, FormFactorError> {
        let tolerance = tolerance.max(0.0);
        if let Some(answer) = self.rectangles(other, tolerance)
            && answer.exchange.error <= tolerance * answer.exchange.value
        {
            return Ok(answer);
        }
        let answer = self.in_units(other, |first, second| {
            Workspace::with(|work| {
                with_clipped_pair([first, second], tolerance, |pair| pair.answer(work))
            })
        });
        match answer {
            Ok(found) if found.exchange.error > tolerance * found.exchange.value => {
                let enclosed = self.enclosed_rectangles(other);
                let bound = found.exchange.error;
                let better = enclosed.filter(|enclosed| enclosed.exchange.error < bound);
                Ok(better.unwrap_or(found))
            }
            answer => answer,
        }
    }

    /// The exchange area by one route, whether its bound meets the tolerance or not: for studies of
    /// the routes.
    ///
    /// # Errors
    /// [`FormFactorError::NotResolved`] if the route does not serve this pair, or leaves no digit;
    /// [`FormFactorError::OutOfRange`] if distances or the value leave the range that the routes
    /// work in.
    pub fn exchange_area_by(
        &self,
        route: Route,
        other: &Self,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        let not_served = FormFactorError::NotResolved {
            value: f64::NAN,
            error: f64::INFINITY,
        };
        if let Some(answer) = self
            .rectangles(other, 0.0)
            .filter(|answer| answer.route == route)
        {
            return Ok(answer);
        }
        self.in_units(other, |first, second| {
            Workspace::with(|work| {
                let by_route = |pair: &ClippedPair| pair.answer_by(route, work).ok_or(not_served);
                with_clipped_pair([first, second], tolerance.max(0.0), by_route)
            })
        })
    }

    /// A pair very small or very large is taken in units of a power of two near its size, so that
    /// squares stay in range.
    fn in_units(
        &self,
        other: &Self,
        answer: impl FnOnce(&Self, &Self) -> Result<Answer, FormFactorError>,
    ) -> Result<Answer, FormFactorError> {
        let (first, second) = (&self.shape, &other.shape);
        let reach = first.centre.distance(second.centre) + first.radius + second.radius;
        if (1e-60..1e60).contains(&reach) {
            return answer(self, other);
        }
        let unit = power_of_two_below(reach);
        if !(SMALLEST_UNIT..=1.0 / SMALLEST_UNIT).contains(&unit) {
            return Err(FormFactorError::OutOfRange { value: reach });
        }
        let scale = |polygon: &Self| polygon.scaled(1.0 / unit);
        // one so small beside the other that nothing is left of it
        let (Some(first), Some(second)) = (scale(self), scale(other)) else {
            return Err(FormFactorError::OutOfRange { value: 0.0 });
        };
        let mut answer = answer(&first, &second)?;
        let exact = answer.exchange.value <= 0.0;
        for number in [&mut answer.exchange.value, &mut answer.exchange.error] {
            *number = *number * unit * unit;
        }
        let value = answer.exchange.value;
        if exact || (value.is_normal() && answer.exchange.error.is_finite()) {
            Ok(answer)
        } else {
            Err(FormFactorError::OutOfRange { value })
        }
    }
}

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
    fn answer_by(&self, route: Route, work: &mut Workspace) -> Option<Answer> {
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

    /// What the corners are off by where the clip is right to 64 ε² of the coordinates: a polygon
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
