//! Form factors of polygons past others that stand in the way, with bounds.
//!
//! ```text
//!   A_P F = (1/2π) Σ_g ∫_g dy · W(R_g(y)),     W(R) = Σ ∮_∂R ln|x − y| dx
//! ```
//!
//! over the edges g of Q *and of the screens*, the polygons in the way. R_g(y) is the set of points
//! x of P that see y as a boundary of what they see of Q:
//!
//! ```text
//!   y on an edge of Q        P without the shadows of the screens, as cast from y
//!   y on an edge of a screen P ∩ (Q mirrored through y), without the shadows of screens below y
//!                            and the mirrored shadows of those above
//! ```
//!
//! Both are Stokes' theorem: once for the part of Q that x sees, once over P. A rule over P needs
//! N² nodes, this one N, and nothing is singular where a screen touches P, stands on it, pierces it
//! or lies close above it. As W is known in closed form for a polygon R, what is left is an
//! integral along g of a function that is analytic between the places where the shape of R changes.
//!
//! | step | file |
//! |---|---|
//! | the pair in P's frame, clipped, in convex faces, with shared edges | `view/{frame, setting}` |
//! | stretches of edges, and the faces through them, between which x looks | `view/{outer, pages}` |
//! | planes of sight through y(t) and an edge, linear in t | `view/{trace, sight, region}` |
//! | the boundary of R at one t, by chords of lines | `shape/{arrangement, boundary, slice, chord}` |
//! | the boundary that is convex as seen; what shadows cover of a line | `shape/{convex, covers}` |
//! | the range of t in which it keeps this shape | `shape/validity` |
//! | its corners as rational functions of t, and their displacement | `integral/{corner, reach}` |
//! | Gauss rules with a-priori bounds | `integral/{rule, bound}` |
//! | all shapes along a stretch, and the sum of their rules | `integral/{stretch, share, gap}` |
//! | the change by displaced corners | `integral/slack` |
//! | the view from a point, in closed form | `point` |
//!
//! **Two forms.** Over the edges of Q the part of P in shadow gives what is hidden, which is taken
//! from the unoccluded value; where a quarter or less is left of that, so that digits cancel, the
//! lit part gives what is seen, and the better of the two is the answer. Screens that no line of
//! sight meets are left out before.
//!
//! **Two orders.** Either polygon can be P. Taken is the one from whose plane the screens are
//! farther; where that says nothing, as a stretch lies where nothing can be told, the other one is
//! asked.
//!
//! **Bounds.** The error is the sum of the truncation of each rule, of what lies between shapes
//! that change at almost one place, of rounding, and of the rounding of corners. Shapes are decided
//! by signs of polynomials of degree 2 away from their zeros, and a boundary that does not close is
//! none; where nothing can be told, `|W| ≤ 2 √(π A_P) |v|` is added. A gap between two ranges is
//! not looked into; there W is taken as beside it, and the product of its rate of change and the
//! squared width is added. Rounding is counted term by term: of normals, of corners, along lines
//! that are nearly parallel and across them, of each side's terms and of their sums. Corners are
//! displaced by what their rounding was measured to be, each by its own.
//!
//! **Accuracy** within 1e-14 of two independent integrals for 54 pairs of 20 kinds, but for values
//! below 1e-5 of the unoccluded one, where 1e-16 of that is left
//! (`pairs_past_others_are_right_to_twelve_digits`). Rounding leaves bounds of some 1e-14 of the
//! squared size of the pair and its distance; the answer says where that misses the tolerance. Of a
//! pair of size s at a distance d the shape of R is known to ε d, and W, of order s², is a sum of
//! terms of order s d: bounds are about 1e-12 (d/s)² of the value where P and Q are opposite, and
//! more where they are seen aslant (`bounds_of_small_pairs_fall_with_their_size`). Slits and edges
//! that cross at small angles lose nothing
//! (`edges_that_cross_at_a_small_angle_keep_their_digits`).
//!
//! **Not covered**: screens that let light through; curved ones. Lines of sight that coincide up to
//! 64 ε of the terms in their determinant count as one: the strip between them, some 1e-14 of the
//! size for edges as long as the pair, is not in the bound.
//!
//! Reference: Nishita and Nakamae, "Continuous tone representation of three-dimensional objects
//! taking account of shadows and interreflection", *SIGGRAPH* 1985, for the contour of what a
//! point sees.

mod integral;
mod occluders;
mod point;
mod shape;
mod view;

pub use occluders::Occluders;

pub use point::point_form_factor_past;
pub(crate) use point::{Sight, Viewpoint};

use super::{Answer, ExchangeArea, FormFactorError, Polygon, Route};
use integral::share::Share;
use integral::slack::slack;
use integral::stretch::stretch;
use smallvec::SmallVec;
use std::f64::consts::TAU;
use view::outer::outers;
use view::pages::Wanted;
use view::setting::Setting;

impl Polygon {
    /// The exchange area of two polygons past others, which block from both sides.
    ///
    /// **Arguments** `tolerance`: relative, 0 or more.
    /// **Returns** the value, in squared units of length, from 0 to the unoccluded one, with a
    /// bound on its error, which may exceed the tolerance. It is the same for either order of the
    /// pair.
    /// **Accuracy** see the module's text.
    ///
    /// # Errors
    /// As [`exchange_area`](Self::exchange_area).
    ///
    /// # Examples
    /// ```
    /// use glam::DVec3;
    /// use infoscene::form_factor::{Occluders, Polygon};
    /// use infoscene::geometry::{GeometryError, Patch};
    /// let square = |z: f64, mut corners: Vec<[f64; 2]>, is_up: bool| {
    ///     if !is_up {
    ///         corners.reverse();
    ///     }
    ///     let corners = corners.iter().map(|[x, y]| DVec3::new(*x, *y, z)).collect();
    ///     Ok::<_, GeometryError>(Polygon::new(&Patch::try_new(corners)?))
    /// };
    /// let whole = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let (floor, ceiling) = (square(0.0, whole.clone(), true)?, square(1.0, whole, false)?);
    /// // a plate from one wall to the middle hides half of what the two exchange
    /// let half = vec![[0.5, -9.0], [9.0, -9.0], [9.0, 9.0], [0.5, 9.0]];
    /// let plate = square(0.5, half, true)?;
    /// let polygons = [&plate];
    /// let occluders = Occluders { polygons: &polygons, touching: 0.0 };
    /// let past = floor.exchange_area_past(&ceiling, &occluders, 1e-12)?.exchange;
    /// let bare = floor.exchange_area(&ceiling, 1e-12)?.exchange;
    /// assert!((past.value - 0.5 * bare.value).abs() <= past.error + 0.5 * bare.error);
    /// assert!(past.error <= 1e-12 * past.value);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn exchange_area_past(
        &self,
        other: &Self,
        occluders: &Occluders,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        let near: Vec<&Self> = occluders.near([self, other]).collect();
        if near.is_empty() {
            return self.exchange_area(other, tolerance);
        }
        let occluders = &Occluders {
            polygons: &near,
            ..*occluders
        };
        // a pair has one value, whichever way it is asked for
        let [first, second] = if is_first([other, self], &near) {
            [other, self]
        } else {
            [self, other]
        };
        let found = first.exchange_area_past_over(second, occluders, tolerance)?;
        let scale = LEAST_SHARE * first.area().min(second.area());
        if found.exchange.error <= VAGUE * found.exchange.value.max(scale) {
            return Ok(found);
        }
        // where something could not be told, it may be from the other side
        let other = second.exchange_area_past_over(first, occluders, tolerance)?;
        let is_better = other.exchange.error < found.exchange.error;
        Ok(if is_better { other } else { found })
    }

    /// The exchange area of two polygons past others, over the points of `self` and along the edges
    /// of the other one; it depends on the order of the pair within the bound only.
    ///
    /// [`exchange_area_past`](Self::exchange_area_past) takes one of the two orders, by what it
    /// costs. The other one is an independent integral, to judge by.
    ///
    /// # Errors
    /// As [`exchange_area`](Self::exchange_area).
    pub fn exchange_area_past_over(
        &self,
        other: &Self,
        occluders: &Occluders,
        tolerance: f64,
    ) -> Result<Answer, FormFactorError> {
        let tolerance = tolerance.max(FINEST);
        let whole = self.exchange_area(other, tolerance)?;
        if whole.exchange.value <= 0.0 {
            return Ok(whole);
        }
        let setting = Setting::of([self, other], occluders);
        if setting.screens.is_empty() && setting.lost == 0.0 {
            return Ok(whole);
        }
        let finer = |tolerance| Ok(self.exchange_area(other, tolerance)?.exchange);
        let exchange = if setting.first.is_empty() || setting.second.is_empty() {
            // too small for what counts as touching: nothing is known but the limits
            let ExchangeArea { value, error } = whole.exchange;
            ExchangeArea {
                value: 0.5 * value,
                error: 0.5 * value + error,
            }
        } else {
            exchange_past(&setting, whole.exchange, tolerance, finer)?
        };
        if !(exchange.value.is_finite() && exchange.error.is_finite()) {
            // sizes whose squares leave the range
            return Err(FormFactorError::OutOfRange {
                value: whole.exchange.value,
            });
        }
        Ok(Answer {
            exchange,
            route: Route::Occluded,
        })
    }
}

/// Whether the first of two polygons is better taken as P: what is in the way is farther from its
/// plane, and edges that come down to P's plane take more panels. Of two alike the corners tell.
fn is_first([one, other]: [&Polygon; 2], screens: &[&Polygon]) -> bool {
    let height = |polygon: &Polygon| {
        let origin = polygon.shape.corners[0];
        let corners = screens.iter().flat_map(|screen| &screen.shape.corners);
        let heights = corners.map(|corner| (*corner - origin).dot(polygon.normal).abs());
        heights.sum::<f64>()
    };
    let corners = |polygon: &Polygon| {
        let corners = polygon.shape.corners.iter();
        let corners = corners.map(|corner| corner.to_array().map(f64::to_bits));
        corners.collect::<SmallVec<[[u64; 3]; 8]>>()
    };
    let order = height(one).total_cmp(&height(other));
    order
        .then_with(|| corners(other).cmp(&corners(one)))
        .is_gt()
}

/// The exchange area of two polygons past the screens.
///
/// **Arguments** the unoccluded value, and what has it to a finer tolerance: its last digits are
/// dear, and are asked for if the rest of the bound leaves room for them.
fn exchange_past(
    setting: &Setting,
    mut whole: ExchangeArea,
    tolerance: f64,
    finer: impl Fn(f64) -> Result<ExchangeArea, FormFactorError>,
) -> Result<ExchangeArea, FormFactorError> {
    let in_units = |found: ExchangeArea| ExchangeArea {
        value: found.value * setting.unit * setting.unit,
        error: found.error * setting.unit * setting.unit,
    };
    let accuracy = |error: f64| error / (setting.unit * setting.unit);
    let wanted = accuracy(0.05 * tolerance * whole.value);
    let hidden = in_units(exchange(setting, Wanted::Hidden, wanted));
    let left = |whole: ExchangeArea| ExchangeArea {
        value: whole.value - hidden.value,
        error: whole.error + hidden.error,
    };
    let mut best = left(whole);
    let is_met = |found: ExchangeArea| found.error <= tolerance * found.value;
    if !is_met(best) && best.value < MOST_CANCELLED * whole.value {
        let wanted = 0.2 * tolerance * best.value.max(1e-9 * whole.value);
        let seen = in_units(exchange(setting, Wanted::Seen, accuracy(wanted)));
        if seen.error < best.error {
            best = seen;
        }
    }
    let room = tolerance * best.value - hidden.error;
    if !is_met(best) && room > 0.0 {
        let refined = finer(0.9 * room / whole.value)?;
        if refined.error < whole.error {
            whole = refined;
        }
        if left(whole).error < best.error {
            best = left(whole);
        }
    }
    let value = best.value.clamp(0.0, whole.value);
    let error = best.error + (value - best.value).abs();
    // nothing is less than none of it or more than all
    let most = value.max(whole.value - value) + whole.error;
    Ok(ExchangeArea {
        value,
        error: error.min(most),
    })
}

/// The share of the unoccluded value below which digits are lost by taking away what is hidden.
const MOST_CANCELLED: f64 = 0.25;

/// A bound on the relative error past which the integral over the other polygon is tried, too.
const VAGUE: f64 = 1e-6;

/// The share of an area below which an exchange area counts as this share of it.
const LEAST_SHARE: f64 = 1e-6;

/// No finer relative tolerance is worked for.
const FINEST: f64 = 4.0 * f64::EPSILON;

/// The exchange area of what is wanted.
fn exchange(setting: &Setting, wanted: Wanted, accuracy: f64) -> ExchangeArea {
    let mut stretches = Vec::new();
    for first in &setting.first {
        for second in &setting.second {
            stretches.extend(outers(setting, [first, second], wanted));
        }
    }
    let total: f64 = stretches
        .iter()
        .map(|outer| outer.sight.along.length())
        .sum();
    let mut sum = Share::default();
    for outer in &stretches {
        for piece in &outer.pieces {
            let share = stretch(outer, piece, accuracy * TAU / total);
            sum.add(Share {
                value: piece.sign * share.value,
                ..share
            });
        }
    }
    ExchangeArea {
        value: sum.value / TAU,
        error: (sum.truncation + sum.rounding) / TAU + slack(setting, &stretches) + setting.lost,
    }
}
