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
use super::gauss_points::{Convergence, Rule};
use super::horizon::{HEIGHT_ERROR, Side, precise_outline, side_of};
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
            && let Some(answer) = rectangles(first, second, reach, tolerance)
        {
            return Ok(answer);
        }
        WORK.with_borrow_mut(|work| answer([self, other], tolerance, work))
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
fn rectangles(
    first: &Rectangle,
    second: &Rectangle,
    reach: f64,
    tolerance: f64,
) -> Option<Answer> {
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
    let exact = |corner: DVec3| {
        let pairs = corner.to_array().into_iter().zip(origin.to_array());
        pairs.into_iter().all(|(x, o)| DoubleDouble::difference(x, o).low() == 0.0)
    };
    if !second.corners().into_iter().all(exact) {
        let sides = |r: &Rectangle| {
            let [a, b, _, d] = r.corners();
            2.0 * (a.distance(b) + a.distance(d))
        };
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
    off: f64,
    /// What that changes at most, per length: by flux through ribbons, and relative to the value for polygons apart.
    slack: [f64; 2],
    /// An idea of the value.
    estimate: f64,
    tolerance: f64,
}

fn answer(
    polygons: [&Polygon; 2],
    tolerance: f64,
    work: &mut Work,
) -> Result<Answer, FormFactorError> {
    let [first, second] = polygons;
    let (above_second, off_first) = side_of(first, second);
    let (above_first, off_second) = side_of(second, first);
    let off = off_first.max(off_second);
    let sides = [&above_second, &above_first];
    let [Some(first_heights), Some(second_heights)] = sides.map(Side::heights) else {
        let within = sides.iter().all(|side| matches!(side, Side::Within));
        return Ok(Answer {
            exchange: ExchangeArea {
                value: 0.0,
                error_bound: 2.0 * off * (first.perimeter() + second.perimeter()),
            },
            route: if within { Route::Coplanar } else { Route::BackFacing },
        });
    };
    let shapes = [above_second.shape(&first.shape), above_first.shape(&second.shape)];
    let view = View::new(polygons, shapes, [first_heights, second_heights], off, tolerance);
    view.answer(work)
}

impl<'a> View<'a> {
    fn new(
        polygons: [&'a Polygon; 2],
        shapes: [&'a Shape; 2],
        heights: [&'a [f64]; 2],
        off: f64,
        tolerance: f64,
    ) -> Self {
        let [first, second] = shapes;
        let between = second.centre - first.centre;
        let distance = between.length();
        let corners = first.corners.iter().flat_map(|x| second.corners.iter().map(|y| (*x - *y).length_squared()));
        let reach = corners.fold(0.0, f64::max).sqrt() * (1.0 + 4.0 * f64::EPSILON);
        // planes that have one polygon on one side and the other on the other: across the centres' line, and their own
        let farthest = |shape: &Shape, direction: DVec3| {
            let along = shape.corners.iter().map(|c| (*c - first.centre).dot(direction));
            along.fold(f64::NEG_INFINITY, f64::max)
        };
        let least = |heights: &[f64]| heights.iter().copied().fold(f64::INFINITY, f64::min);
        let direction = between / distance;
        let apart = -farthest(second, -direction) - farthest(first, direction);
        let gap = apart.max(least(heights[0])).max(least(heights[1])) - 8.0 * f64::EPSILON * reach;
        #[allow(clippy::cast_precision_loss, reason = "a number of corners")]
        let means = heights.map(|heights| heights.iter().sum::<f64>() / heights.len() as f64);
        let gap = if gap > 0.0 { gap } else { 0.0 };
        let spread = if gap > 0.0 { (reach / gap).powi(4) } else { f64::INFINITY };
        // heights h weighted by the kernel K: Σ K/Σ h K is at most 1/h_min, and at most (K_max/K_min)/h_mean
        let sensitivities = [0, 1].map(|k| (1.0 / least(heights[k])).min(spread / means[k]));
        let received = |shape: &Shape| (shape.area / (PI * gap * gap)).min(1.0);
        let ribbons = first.perimeter * received(second) + second.perimeter * received(first);
        // corners that are off by δ change heights, areas and r⁴, too: relative to the value
        let relative = sensitivities[0] + sensitivities[1] + 4.0 / gap
            + first.perimeter / first.area
            + second.perimeter / second.area;
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
            slack: [2.0 * ribbons, 2.0 * relative],
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
            None => Err(FormFactorError::NotResolved { value: self.estimate, error_bound: f64::INFINITY }),
        }
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
            exchange.error_bound += self.slack(self.off, exchange.value);
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

    /// What corners that are off may change.
    fn slack(&self, off: f64, value: f64) -> f64 {
        off * self.slack[0].min(self.slack[1] * value.abs())
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
            (first.longest_edge, first.corners.len() * second.corners.len())
        } else {
            (second.longest_edge, first.corners.len() * second.corners.len())
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
        let k = usize::from(on(1) * (self.shapes[0].corners.len() as f64) < on(0) * (self.shapes[1].corners.len() as f64));
        let corners = self.shapes[1 - k].corners.len() as f64;
        if points[k] <= 16 {
            plans.push((150.0 + on(k) * corners * 3.0, Plan::PointToPolygon { over: k, points: points[k] }));
        }
        if points[0].max(points[1]) <= 16 {
            plans.push((150.0 + 4.0 * (on(0) + on(1)) + on(0) * on(1) * 0.4, Plan::Kernel { points }));
        }
        plans
    }

    /// Gauss points per direction on one of the shapes.
    fn points(&self, k: usize) -> usize {
        let convergence = self.convergence(k);
        let largest = self.largest();
        let mut points = convergence.points(self.tolerance.max(4.0 * f64::EPSILON)).saturating_sub(1).max(2);
        while points < 17 && convergence.error(points) * largest > self.wanted() {
            points += 1;
        }
        points
    }

    fn convergence(&self, k: usize) -> Convergence {
        let gamma = self.gap / self.shapes[k].half_length();
        Convergence { gamma }
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
                contour(self.shapes[0], self.shapes[1], range, self.wanted(), &mut work.scratch)
            },
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
        // an edge of length L at distance g: angle × (1/h) a ≤ (π/2) L/g, and at most π reach/g
        let angles: f64 = (0..corners.len())
            .map(|b| (corners[(b + 1) % corners.len()] - corners[b]).length())
            .map(|length| (0.5 * PI * length).min(PI * self.reach) / self.gap)
            .sum();
        let rounding = 12.0 * f64::EPSILON * over.area * angles / (2.0 * PI);
        let truncation = self.convergence(k).error(points) * self.largest();
        ExchangeArea {
            value,
            error_bound: rounding + truncation + 4.0 * f64::EPSILON * value,
        }
    }

    #[allow(clippy::cast_precision_loss, reason = "some points")]
    fn over_both(&self, points: [usize; 2], work: &mut Work) -> ExchangeArea {
        let origin = self.shapes[0].centre;
        for k in 0..2 {
            work.rules[k].fill(self.shapes[k], self.heights[k], origin, points[k]);
        }
        let [first, second] = &work.rules;
        let value = kernel(first, second, &mut work.sums);
        let truncation: f64 = (0..2).map(|k| self.convergence(k).error(points[k])).sum();
        let terms = 0.5 * (first.weights.len() + second.weights.len()) as f64;
        let relative = (24.0 + terms) * f64::EPSILON + 2.0 * HEIGHT_ERROR;
        ExchangeArea {
            value,
            error_bound: relative * value + truncation * self.largest(),
        }
    }

    fn precise_contour(&self) -> Option<ExchangeArea> {
        let [first, second] = self.polygons;
        let outlines = [precise_outline(first, second), precise_outline(second, first)];
        let wanted = 0.01 * self.wanted();
        let mut exchange = precise_contour([&outlines[0], &outlines[1]], wanted)?;
        // the clip is right to 64 ε² of the coordinates; a polygon that is not planar is off by its tilt
        let off = (first.tilt.max(second.tilt) + 64.0 * SQUARED_EPSILON) * self.reach;
        exchange.error_bound += self.slack(off, exchange.value);
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
