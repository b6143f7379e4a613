//! The chooser: the cheapest route whose bound meets the tolerance, and the next one where it does not.
//!
//! ```text
//!   aligned rectangles    closed form
//!   moderate distance     contour, one Gauss rule for all edges apart
//!   apart                 point to polygon (over the smaller one), kernel (over both): whichever needs less work
//!   what cancels in f64   contour in double-double
//! ```
//!
//! Before any of them: polygons that face away or lie in one plane exchange nothing, and what lies behind the other's
//! plane is clipped.

use super::contour::{Scratch, contour, precise_contour};
use super::gauss_points::{self, Rule};
use super::horizon::{HEIGHT_ERROR, Off, Side, precise_outline, side_of};
use super::kernel::kernel;
use super::point_to_polygon::point_to_polygon;
use super::shape::Shape;
use super::{Answer, ExchangeArea, FormFactorError, Polygon, RectanglePair, Route};
use crate::geometry::Rectangle;
use crate::numeric::{DoubleDouble, SQUARED_EPSILON};
use glam::DVec3;
use smallvec::SmallVec;
use std::cell::RefCell;
use std::f64::consts::PI;

/// Relative error that is asked for unless something else is.
pub const DEFAULT_TOLERANCE: f64 = 1e-12;

/// Gauss points per direction from which on other routes are cheaper.
const MOST: usize = 17;

thread_local! {
    static WORK: RefCell<Work> = RefCell::default();
}

/// Room for the work on a pair, kept from one to the next.
#[derive(Debug, Default)]
struct Work {
    scratch: Scratch,
    rules: [Rule; 2],
    sums: Vec<f64>,
}

impl Polygon {
    /// What the two exchange, by the cheapest route whose error bound is within `tolerance` of the value; if none is,
    /// the value with the smallest bound.
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
    /// let leg = |corners: [DVec3; 3]| Ok(Polygon::new(&Patch::try_new(corners.to_vec())?));
    /// let (floor, wall) = (leg([o, x, y])?, leg([o, y, z])?);
    /// let answer = floor.exchange_area(&wall, DEFAULT_TOLERANCE)?;
    /// let exact = (1.0 - 1.0 / 3f64.sqrt()) / 2.0;
    /// assert!((answer.exchange.value / floor.area() - exact).abs() < 1e-15);
    /// # Ok::<(), infoscene::form_factor::FormFactorError>(())
    /// ```
    pub fn exchange_area(&self, other: &Self, tolerance: f64) -> Result<Answer, FormFactorError> {
        let tolerance = if tolerance > 0.0 { tolerance } else { 0.0 };
        let (first, second) = (&self.shape, &other.shape);
        let reach = first.centre.distance(second.centre) + first.radius + second.radius;
        if !(1e-60..1e60).contains(&reach) {
            return self.exchange_in_units(other, tolerance, reach);
        }
        if let (Some(first), Some(second)) = (&self.rectangle, &other.rectangle)
            && let Some(answer) = rectangles(first, second, tolerance)
        {
            return Ok(answer);
        }
        WORK.with_borrow_mut(|work| answer([self, other], tolerance, |view| view.answer(work)))
    }

    /// The same by one route, whether its bound meets the tolerance or not: for studies of the routes.
    ///
    /// # Errors
    /// [`FormFactorError::NotResolved`] if the route does not serve this pair, or leaves no digit;
    /// [`FormFactorError::OutOfRange`] if distances or the value leave the range that the routes work in.
    pub fn exchange_area_by(
        &self,
        route: Route,
        other: &Self,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        let tolerance = if tolerance > 0.0 { tolerance } else { 0.0 };
        let not_served = FormFactorError::NotResolved {
            value: f64::NAN,
            error_bound: f64::INFINITY,
        };
        if let (Some(first), Some(second)) = (&self.rectangle, &other.rectangle)
            && let Some(answer) = rectangles(first, second, f64::INFINITY)
            && answer.route == route
        {
            return Ok(answer);
        }
        WORK.with_borrow_mut(|work| {
            answer([self, other], tolerance, |view| {
                view.answer_by(route, work).ok_or(not_served)
            })
        })
    }

    /// In units of a power of two near the pair's size, so that squares stay in range.
    fn exchange_in_units(
        &self,
        other: &Self,
        tolerance: f64,
        reach: f64,
    ) -> Result<Answer, FormFactorError> {
        let power = reach.log2().floor();
        if !power.is_finite() || power.abs() > 1000.0 {
            return Err(FormFactorError::OutOfRange { value: reach });
        }
        let scale = |polygon: &Self| polygon.scaled((-power).exp2());
        let mut answer = scale(self).exchange_area(&scale(other), tolerance)?;
        let exact = answer.exchange.value <= 0.0;
        for number in [&mut answer.exchange.value, &mut answer.exchange.error_bound] {
            *number = *number * power.exp2() * power.exp2();
        }
        let value = answer.exchange.value;
        if exact || (value.is_normal() && answer.exchange.error_bound.is_finite()) {
            Ok(answer)
        } else {
            Err(FormFactorError::OutOfRange { value })
        }
    }
}

/// The closed form, if its bound meets the tolerance.
fn rectangles(first: &Rectangle, second: &Rectangle, tolerance: f64) -> Option<Answer> {
    let pair = RectanglePair::try_new(first, second).ok()?;
    let mut exchange = pair.exchange_area().ok()?;
    if exchange.value <= 0.0 {
        return None;
    }
    let route = if (first.normal().dot(second.normal())).abs() > 0.5 {
        Route::ParallelRectangles
    } else {
        Route::PerpendicularRectangles
    };
    // the second one's coordinates in the frame of the first are rounded once, unless they are exact there
    let origin = first.origin();
    let far = second.corners()[2];
    let exact = [second.origin(), far].into_iter().all(|corner| {
        let pairs = corner.to_array().into_iter().zip(origin.to_array());
        pairs
            .into_iter()
            .all(|(x, o)| DoubleDouble::difference(x, o).low() == 0.0)
    });
    if !exact {
        let sides = |r: &Rectangle| {
            let [a, b, _, d] = r.corners();
            2.0 * (a.distance(b) + a.distance(d))
        };
        let reach = first
            .corners()
            .iter()
            .map(|c| c.distance(second.origin()))
            .fold(0.0, f64::max);
        let reach = reach + sides(second);
        exchange.error_bound += f64::EPSILON * reach * (sides(first) + sides(second));
    }
    (exchange.error_bound <= tolerance * exchange.value).then_some(Answer { exchange, route })
}

/// What of a pair is in front of the other's plane, with measures that the choice rests on.
struct View<'a> {
    polygons: [&'a Polygon; 2],
    shapes: [&'a Shape; 2],
    heights: [&'a [f64]; 2],
    /// A lower bound on the distance between the two; not positive if they may touch.
    gap: f64,
    /// An upper bound on all distances.
    reach: f64,
    /// What corners may be off.
    off: Off,
    /// What that changes at most, per length: by flux through ribbons; for polygons apart, relative to the value, by other
    /// heights, and by other areas and distances.
    ribbons: f64,
    by_height: f64,
    by_place: f64,
    /// An idea of the value.
    estimate: f64,
    tolerance: f64,
}

fn answer(
    polygons: [&Polygon; 2],
    tolerance: f64,
    route: impl FnOnce(&View) -> Result<Answer, FormFactorError>,
) -> Result<Answer, FormFactorError> {
    let [first, second] = polygons;
    let (above_second, first_off) = side_of(first, second);
    let (above_first, second_off) = side_of(second, first);
    let off = first_off.max(second_off);
    let sides = [&above_second, &above_first];
    let [Some(first_heights), Some(second_heights)] = sides.map(Side::heights) else {
        let within = sides.iter().all(|side| matches!(side, Side::Within));
        return Ok(Answer {
            exchange: ExchangeArea {
                value: 0.0,
                error_bound: 2.0 * off.height * (first.perimeter() + second.perimeter()),
            },
            route: if within {
                Route::Coplanar
            } else {
                Route::BackFacing
            },
        });
    };
    let shapes = [
        above_second.shape(&first.shape),
        above_first.shape(&second.shape),
    ];
    let view = View::new(
        polygons,
        shapes,
        [first_heights, second_heights],
        off,
        tolerance,
    );
    route(&view)
}

impl<'a> View<'a> {
    fn new(
        polygons: [&'a Polygon; 2],
        shapes: [&'a Shape; 2],
        heights: [&'a [f64]; 2],
        off: Off,
        tolerance: f64,
    ) -> Self {
        let [first, second] = shapes;
        let between = second.centre - first.centre;
        let distance = between.length();
        let corners = first
            .corners
            .iter()
            .flat_map(|x| second.corners.iter().map(|y| (*x - *y).length_squared()));
        let reach = corners.fold(0.0, f64::max).sqrt() * (1.0 + 4.0 * f64::EPSILON);
        // planes that have one polygon on one side and the other on the other: across the centres' line, and their own
        let farthest = |shape: &Shape, direction: DVec3| {
            let along = shape
                .corners
                .iter()
                .map(|c| (*c - first.centre).dot(direction));
            along.fold(f64::NEG_INFINITY, f64::max)
        };
        let least = |heights: &[f64]| heights.iter().copied().fold(f64::INFINITY, f64::min);
        let direction = between / distance;
        let apart = -farthest(second, -direction) - farthest(first, direction);
        let gap = apart.max(least(heights[0])).max(least(heights[1])) - 8.0 * f64::EPSILON * reach;
        #[allow(clippy::cast_precision_loss, reason = "a number of corners")]
        let means = heights.map(|heights| heights.iter().sum::<f64>() / heights.len() as f64);
        let gap = if gap > 0.0 { gap } else { 0.0 };
        let spread = if gap > 0.0 {
            (reach / gap).powi(4)
        } else {
            f64::INFINITY
        };
        // heights h weighted by the kernel K: Σ K/Σ h K is at most 1/h_min, and at most (K_max/K_min)/h_mean
        let sensitivities = [0, 1].map(|k| (1.0 / least(heights[k])).min(spread / means[k]));
        let received = |shape: &Shape| (shape.area / (PI * gap * gap)).min(1.0);
        let ribbons = first.perimeter * received(second) + second.perimeter * received(first);
        // corners that are off by δ change heights, areas and r⁴, too: relative to the value
        let by_place = 4.0 / gap + first.perimeter / first.area + second.perimeter / second.area;
        // between the far formula and that of two patches near to each other
        let square = distance * distance + first.area.max(second.area) / PI;
        let cosines = means[0] * means[1] / (distance * distance).max(means[0] * means[1]);
        let estimate = first.area * second.area * cosines / (PI * square);
        Self {
            polygons,
            shapes,
            heights,
            gap,
            reach,
            off,
            ribbons: 2.0 * ribbons,
            by_height: 2.0 * (sensitivities[0] + sensitivities[1]),
            by_place: 2.0 * by_place,
            estimate,
            tolerance,
        }
    }

    fn answer(&self, work: &mut Work) -> Result<Answer, FormFactorError> {
        let mut plans: SmallVec<[(f64, Plan); 3]> = SmallVec::new();
        plans.push((self.contour_work(), Plan::Contour));
        if self.gap > 0.0 {
            let plans_apart = self.plans_apart();
            plans.extend(plans_apart);
        }
        plans.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best: Option<Answer> = None;
        for (_, plan) in plans.iter().filter(|(work, _)| *work < f64::INFINITY) {
            if let Some(done) = self.settle(self.follow(*plan, work), plan.route(), &mut best) {
                return done.in_range();
            }
        }
        let precise = self.precise_contour();
        if let Some(done) = self.settle(precise, Route::DoubleDouble, &mut best) {
            return done.in_range();
        }
        match best {
            Some(best) => best.in_range(),
            None => Err(FormFactorError::NotResolved {
                value: self.estimate,
                error_bound: f64::INFINITY,
            }),
        }
    }

    /// By one route alone.
    fn answer_by(&self, route: Route, work: &mut Work) -> Option<Answer> {
        let exchange = match route {
            Route::Contour => self.follow(Plan::Contour, work),
            Route::DoubleDouble => self.precise_contour(),
            _ if self.gap > 0.0 => {
                let points = [0, 1].map(|k| self.points(k));
                let over = usize::from(points[1] < points[0]);
                match route {
                    Route::PointToPolygon => self.follow(
                        Plan::PointToPolygon {
                            over,
                            points: points[over],
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
    fn settle(
        &self,
        exchange: Option<ExchangeArea>,
        route: Route,
        best: &mut Option<Answer>,
    ) -> Option<Answer> {
        let mut exchange = exchange?;
        if route != Route::DoubleDouble {
            exchange.error_bound += self.slack(self.off, exchange.value, route);
        }
        let ExchangeArea { value, error_bound } = exchange;
        let answer = Answer { exchange, route };
        if error_bound <= self.tolerance * value {
            return Some(answer);
        }
        // of values that are not good enough, the one known best
        if value > error_bound && best.is_none_or(|best| error_bound < best.exchange.error_bound) {
            *best = Some(answer);
        }
        None
    }

    /// What corners that are off may change. The kernel takes its heights from the corners', which are exact where a clip put
    /// them on the plane; for all others a corner out of place is at another height, too.
    fn slack(&self, off: Off, value: f64, route: Route) -> f64 {
        let Off { height, place } = off;
        let heights = if route == Route::Kernel {
            height
        } else {
            height + place
        };
        let relative = heights * self.by_height + (height + place) * self.by_place;
        ((height + place) * self.ribbons).min(relative * value.abs())
    }

    /// The absolute error that truncation may have.
    fn wanted(&self) -> f64 {
        0.1 * self.tolerance.max(4.0 * f64::EPSILON) * self.estimate
    }

    /// Rough work of the contour, in nanoseconds; infinite if cancellation leaves too little.
    fn contour_work(&self) -> f64 {
        let [first, second] = self.shapes;
        let rounding = f64::EPSILON * self.reach * first.perimeter * second.perimeter;
        if rounding > self.tolerance * self.estimate {
            return f64::INFINITY;
        }
        let (longest, corners) = if first.longest_edge <= second.longest_edge {
            (
                first.longest_edge,
                first.corners.len() * second.corners.len(),
            )
        } else {
            (
                second.longest_edge,
                first.corners.len() * second.corners.len(),
            )
        };
        let ratio = 1.0 + 2.0 * self.gap / longest;
        #[allow(clippy::cast_precision_loss, reason = "a number of corners")]
        let corners = corners as f64;
        300.0 + corners * 3.5 * 32.0 / (2.0 * (ratio + (ratio * ratio - 1.0).sqrt()).ln()).max(1.5)
    }

    /// Routes for polygons apart, with their rough work in nanoseconds.
    #[allow(clippy::cast_precision_loss, reason = "some points")]
    fn plans_apart(&self) -> SmallVec<[(f64, Plan); 2]> {
        let mut plans = SmallVec::new();
        let points = [0, 1].map(|k| self.points(k));
        let on = |k: usize| (points[k] * points[k] * self.shapes[k].cells.len()) as f64;
        let k = usize::from(
            on(1) * (self.shapes[0].corners.len() as f64)
                < on(0) * (self.shapes[1].corners.len() as f64),
        );
        let corners = self.shapes[1 - k].corners.len() as f64;
        if points[k] < MOST && self.lambert_rounding(k) < 0.7 * self.tolerance * self.estimate {
            plans.push((
                150.0 + on(k) * corners * 3.0,
                Plan::PointToPolygon {
                    over: k,
                    points: points[k],
                },
            ));
        }
        if points[0].max(points[1]) < MOST {
            plans.push((
                150.0 + 4.0 * (on(0) + on(1)) + on(0) * on(1) * 0.25,
                Plan::Kernel { points },
            ));
        }
        plans
    }

    /// Gauss points per direction on one of the shapes.
    fn points(&self, k: usize) -> usize {
        let (largest, wanted) = (self.largest(), self.wanted());
        (2..MOST)
            .find(|n| self.truncation(k, *n, largest) <= wanted)
            .unwrap_or(MOST)
    }

    /// A bound on the error of a rule on one of the shapes.
    fn truncation(&self, k: usize, points: usize, largest: f64) -> f64 {
        gauss_points::error(points, self.gap / self.shapes[k].half_length) * largest
    }

    /// `area × area × h_max g_max / (π gap⁴)`.
    fn largest(&self) -> f64 {
        let highest = self.heights.map(|h| h.iter().copied().fold(0.0, f64::max));
        let areas = self.shapes[0].area * self.shapes[1].area;
        areas * highest[0] / self.gap * (highest[1] / self.gap) / (PI * self.gap * self.gap)
    }

    fn follow(&self, plan: Plan, work: &mut Work) -> Option<ExchangeArea> {
        match plan {
            Plan::Contour => {
                let range = [self.gap, self.reach];
                contour(
                    self.shapes[0],
                    self.shapes[1],
                    range,
                    self.wanted(),
                    &mut work.scratch,
                )
            }
            Plan::PointToPolygon { over, points } => Some(self.over_one(over, points, work)),
            Plan::Kernel { points } => Some(self.over_both(points, work)),
        }
    }

    fn over_one(&self, k: usize, points: usize, work: &mut Work) -> ExchangeArea {
        let (over, seen) = (self.shapes[k], self.shapes[1 - k]);
        let origin = over.centre;
        let rule = &mut work.rules[0];
        rule.fill(over, self.heights[k], origin, points);
        let corners: SmallVec<[DVec3; 8]> = seen.corners.iter().map(|c| *c - origin).collect();
        let value = point_to_polygon(rule, self.polygons[k].normal, &corners, &mut work.sums);
        let rounding = self.lambert_rounding(k);
        let truncation = self.truncation(k, points, self.largest());
        ExchangeArea {
            value,
            error_bound: rounding + truncation + 4.0 * f64::EPSILON * value,
        }
    }

    /// The rounding of Lambert's formula over shape `k`: in a term `θ n·(a×u)/h` the cross product is within 5 u r of
    /// itself, and θ as in the [potential](super::potential); with `θ r/h ≤ t L/r` (t = θ/sin θ) that is at most
    /// `(14 t + 12) u L/r`.
    fn lambert_rounding(&self, k: usize) -> f64 {
        let (over, seen) = (self.shapes[k], self.shapes[1 - k]);
        let n = seen.corners.len();
        let edge = |b: usize| {
            let (start, end) = (seen.corners[b], seen.corners[(b + 1) % n]);
            let length = start.distance(end);
            let widening = if length <= self.gap { 1.16 } else { PI };
            let away = (end.distance(over.centre) - over.radius).max(self.gap);
            (14.0 * widening + 12.0) * length / away
        };
        0.5 * f64::EPSILON * over.area * (0..n).map(edge).sum::<f64>() / (2.0 * PI)
    }

    #[allow(clippy::cast_precision_loss, reason = "some points")]
    fn over_both(&self, points: [usize; 2], work: &mut Work) -> ExchangeArea {
        let origin = self.shapes[0].centre;
        for k in 0..2 {
            work.rules[k].fill(self.shapes[k], self.heights[k], origin, points[k]);
        }
        let [first, second] = &work.rules;
        let value = kernel(first, second, self.reach, &mut work.sums);
        let largest = self.largest();
        let truncation: f64 = (0..2).map(|k| self.truncation(k, points[k], largest)).sum();
        let terms = 0.5 * (first.weights.len() + second.weights.len()) as f64;
        let relative = (24.0 + terms) * f64::EPSILON + 2.0 * HEIGHT_ERROR;
        ExchangeArea {
            value,
            error_bound: relative * value + truncation,
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
        // the clip is right to 64 ε² of the coordinates; a polygon that is not planar is off by its tilt
        let height = (first.tilt.max(second.tilt) + 64.0 * SQUARED_EPSILON) * self.reach;
        let off = Off { height, place: 0.0 };
        exchange.error_bound += self.slack(off, exchange.value, Route::DoubleDouble);
        Some(exchange)
    }
}

/// A route, and how many points it takes.
#[derive(Debug, Clone, Copy)]
enum Plan {
    Contour,
    PointToPolygon { over: usize, points: usize },
    Kernel { points: [usize; 2] },
}

impl Plan {
    const fn route(self) -> Route {
        match self {
            Self::Contour => Route::Contour,
            Self::PointToPolygon { .. } => Route::PointToPolygon,
            Self::Kernel { .. } => Route::Kernel,
        }
    }
}

impl Answer {
    fn in_range(self) -> Result<Self, FormFactorError> {
        let ExchangeArea { value, error_bound } = self.exchange;
        if value.is_finite() && error_bound.is_finite() {
            Ok(self)
        } else {
            Err(FormFactorError::OutOfRange { value })
        }
    }
}
