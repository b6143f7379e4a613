//! The exchange area of two polygons, whatever they are.
//!
//! Aligned rectangles have closed forms of their own. All others are clipped at each other's
//! planes, where polygons that face away or lie in one plane exchange nothing, and the chooser
//! finds the route.

use super::clipped_pair::{ClippedPair, with_clipped_pair};
use super::workspace::Workspace;
use super::{Answer, FormFactorError, Polygon, Route};
use crate::numeric::power_of_two_below;

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
