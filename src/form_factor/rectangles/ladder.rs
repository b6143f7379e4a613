//! Ladders for rectangles with edges along common axes: the cheapest rung whose bound is good
//! enough.
//!
//! ```text
//!   polygons of a scene    rules if far → closed form → (other routes) → closed form in intervals
//!   cells of a grid        rules if far → closed form → closed form in double-double
//! ```
//!
//! Closed forms lose the fourth power of the distance in sizes, so that far rectangles take rules.
//! Polygons count as far by their centres, before they are placed beside each other; cells by the
//! gap between them, whose places are known. Extreme rectangles, thousands of millions of times
//! longer than wide or apart, cancel by more than 106 bits hold: an enclosure of the closed form
//! answers, in half a millisecond. For cells of a grid double-double is the last rung.

use super::far::exchange_by_rules;
use super::{parallel, perpendicular};
use crate::form_factor::clipped_pair::shape::Shape;
use crate::form_factor::{
    Answer, ExchangeArea, FormFactorError, Layout, Polygon, RectanglePair, Route,
};
use crate::geometry::{AlignedRectangle, Offsets, Span};
use crate::numeric::{DoubleDouble, Interval, SQUARED_EPSILON, Scalar, tolerance, vectorised};
use std::f64::consts::PI;

/// Bits of the closed forms in intervals.
const ENCLOSED: u32 = 256;

impl Polygon {
    /// Aligned rectangles, with what the rounding of their places adds to the bound: closed forms,
    /// or rules along the sides where they meet the tolerance; `None` for other polygons, and where
    /// nothing is exchanged.
    pub(crate) fn rectangles(&self, other: &Self, tolerance: f64) -> Option<Answer> {
        let (first, second) = (self.rectangle.as_ref()?, other.rectangle.as_ref()?);
        let by_rules = if self.is_far_from(other) {
            self.by_rules(other, tolerance)
        } else {
            None
        };
        if by_rules.is_some() {
            return by_rules;
        }
        // from the places to the bound in vector code: numbers pass from one step to the next in
        // registers
        let exchange = vectorised(
            #[inline(always)]
            || {
                let pair = RectanglePair::along_axes(first, second);
                pair.and_then(
                    #[inline(always)]
                    |pair| pair.closed_form(),
                )
                .unwrap_or(ExchangeArea::NOTHING)
            },
        );
        self.answer(other, exchange, route_of(first, second))
    }

    /// Aligned rectangles by rules along the sides.
    #[inline(never)]
    fn by_rules(&self, other: &Self, tolerance: f64) -> Option<Answer> {
        let (first, second) = (self.rectangle.as_ref()?, other.rectangle.as_ref()?);
        let pair = RectanglePair::along_axes(first, second).ok()?;
        let exchange = pair.exchange_by_rules(tolerance)?;
        self.answer(other, exchange, Route::Kernel)
    }

    /// The answer, if its value is positive, with the effect of rounded places in the bound.
    #[inline(always)]
    fn answer(&self, other: &Self, mut exchange: ExchangeArea, route: Route) -> Option<Answer> {
        if exchange.value <= 0.0 {
            return None;
        }
        exchange.error += self.misplacement(other);
        Some(Answer { exchange, route })
    }

    /// The closed form of aligned rectangles in intervals: for extreme ones, whose terms cancel by
    /// more than 106 bits hold.
    pub(crate) fn enclosed_rectangles(&self, other: &Self) -> Option<Answer> {
        let (first, second) = (self.rectangle.as_ref()?, other.rectangle.as_ref()?);
        let pair = RectanglePair::along_axes(first, second).ok()?;
        let like = Interval::precise(1.0, ENCLOSED);
        let enclosure = pair.lifted(&like).exchange_value().ok()?;
        let value = enclosure.to_f64();
        let error = enclosure.width() + f64::EPSILON * value + self.misplacement(other);
        let is_number = value > 0.0 && value.is_finite() && error.is_finite();
        is_number.then_some(Answer {
            exchange: ExchangeArea { value, error },
            route: route_of(first, second),
        })
    }

    /// Bounds the effect of rounding the second one's coordinates in the frame of the first once;
    /// 0 if they are exact there.
    fn misplacement(&self, other: &Self) -> f64 {
        let (Some(first), Some(second)) = (&self.rectangle, &other.rectangle) else {
            return 0.0;
        };
        if first.places_exactly(second) {
            return 0.0;
        }
        let (first, second) = (&self.shape, &other.shape);
        let distance = first.centre.distance(second.centre);
        let radii = first.radius + second.radius;
        let gap = (distance - radii).max(0.0);
        let received = |shape: &Shape| (shape.area / (PI * gap * gap)).min(1.0);
        let ribbons = first.perimeter * received(second) + second.perimeter * received(first);
        f64::EPSILON * (distance + radii) * ribbons
    }

    /// Tells whether the rectangles are so many sizes apart that closed forms, which lose the
    /// fourth power of that ratio, lose more than rules do.
    fn is_far_from(&self, other: &Self) -> bool {
        let (first, second) = (&self.shape, &other.shape);
        let size = first.longest_edge.max(second.longest_edge);
        first.centre.distance_squared(second.centre) > 12.0 * size * size
    }
}

/// The route of the closed form: for parallel or for perpendicular rectangles.
const fn route_of(first: &AlignedRectangle, second: &AlignedRectangle) -> Route {
    if first.is_parallel_to(second) {
        Route::ParallelRectangles
    } else {
        Route::PerpendicularRectangles
    }
}

/// The factor of ε² in the bound of a closed form in double-double: each term takes some twenty
/// operations within 64 ε².
const DOUBLE_DOUBLE_TERMS: f64 = 64.0 * tolerance::RECTANGLE_TERMS;

impl Layout<'_, f64> {
    /// The exchange area by the closed form in double-double.
    ///
    /// # Errors
    /// As for [`closed_form`](Self::closed_form).
    fn in_double_double(&self) -> Result<ExchangeArea, FormFactorError> {
        let lifted = |span: &Span| span.lifted(&DoubleDouble::from(0.0));
        let exchange = match self {
            Self::Parallel { spans, distance } => {
                let [[x, xi], [y, eta]] = spans.map(|pair| pair.map(lifted));
                parallel::exchange_area(&[x, y], &[xi, eta], &DoubleDouble::from(**distance))?
            }
            Self::Perpendicular { depths, widths, .. } => {
                let ([x, z], [y, eta]) = (depths.map(lifted), widths.map(lifted));
                perpendicular::exchange_area_at([&x, &z], &Offsets::between(&y, &eta))
            }
        };
        let cancelled = DOUBLE_DOUBLE_TERMS * SQUARED_EPSILON * exchange.magnitude.to_f64();
        let value = exchange.value.to_f64();
        Ok(ExchangeArea {
            value,
            error: cancelled + f64::EPSILON * value.abs(),
        })
    }

    /// Tells whether the rectangles are farther apart than they are long. Nearer ones would take
    /// rules with too many points.
    fn is_far(&self) -> bool {
        let gap = |[a, b]: &[&Span; 2]| {
            let gap = (b.lower() - a.upper()).max(a.lower() - b.upper()).max(0.0);
            (gap * gap, a.length().max(*b.length()))
        };
        let (square, longest) = match self {
            Self::Parallel { spans, distance } => {
                let [(u, a), (v, b)] = spans.each_ref().map(gap);
                (u + v + *distance * *distance, a.max(b))
            }
            Self::Perpendicular { depths, widths, .. } => {
                let (v, longest) = gap(widths);
                let [x, z] = depths;
                let square = v + x.lower() * x.lower() + z.lower() * z.lower();
                (square, longest.max(*x.length()).max(*z.length()))
            }
        };
        square > longest * longest
    }

    /// The exchange area by the first rung whose bound is within `allowed` of it and of `product`,
    /// a value to compare it with; else by the one with the least bound. The rungs are rules along
    /// the sides of far rectangles, the closed form, and the same in double-double.
    ///
    /// # Errors
    /// As for [`closed_form`](Self::closed_form); [`FormFactorError::OutOfRange`] if the value
    /// leaves the range of `f64`.
    pub(crate) fn exchange_area(
        &self,
        product: f64,
        allowed: f64,
    ) -> Result<ExchangeArea, FormFactorError> {
        let by_rules = if self.is_far() {
            exchange_by_rules(self, allowed)
        } else {
            None
        };
        let found = match by_rules {
            Some(found) => found,
            None => self.closed_form()?.in_range(1.0)?,
        };
        if found.error <= allowed * (found.value.abs() + product) {
            return Ok(found);
        }
        let precise = self.in_double_double()?;
        Ok(if precise.error < found.error {
            precise
        } else {
            found
        })
    }
}
