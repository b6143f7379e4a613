//! The exchange area of two rows: a sum over pairs of polygons.
//!
//! ```text
//!   G_gh = Σ_k Σ_l c_gk c_hl G_kl ,     |error| ≤ Σ_k Σ_l (e_kl + 2 ε G_kl)
//! ```
//!
//! with the signs of [`RowTerms`](crate::exchange::rows::terms::RowTerms); the rounding of the sum
//! is the last term ([`CompensatedSum`]). A pair of rows has one value, whichever way it is asked
//! for, so that `A_i F_ij = A_j F_ji` holds exactly. It is at least 0 and at most the smaller area,
//! so that `0 ≤ F ≤ 1`: a value beyond a limit is off by more than the limit is, and moving it
//! there brings it nearer to the exact one. Where a base's remainder cancels below its bound, that
//! bound stands beside the remainder.
//!
//! Cancellation costs digits: where the bound misses the tolerance, the terms are computed again to
//! a finer one.

use super::polygon_pair::Known;
use crate::exchange::plan::facing::Facing;
use crate::exchange::rows::terms::RowTerm;
use crate::exchange::{ExchangeError, PassCounts, ScenePairs};
use crate::form_factor::{Answer, ExchangeArea, Route};
use crate::numeric::CompensatedSum;
use crate::scene::SceneError;

/// No route reaches a finer relative tolerance.
const FINEST: f64 = 4.0 * f64::EPSILON;

/// The answer for two rows whose planes do not face each other; a row that cannot see itself counts
/// as coplanar with itself.
pub(crate) const fn nothing(facing: Facing, is_diagonal: bool) -> Answer {
    let route = match facing {
        Facing::BackFacing if !is_diagonal => Route::BackFacing,
        _ => Route::Coplanar,
    };
    let exchange = ExchangeArea {
        value: 0.0,
        error: 0.0,
    };
    Answer { exchange, route }
}

/// The form factor from an exchange area: what a row of this area exchanges, in units of the area.
/// It is 0 for a row without area, which exchanges nothing.
pub(crate) fn per_area(exchange: f64, area: f64) -> f64 {
    if area > 0.0 { exchange / area } else { 0.0 }
}

impl Answer {
    /// The form factor from a row of this area, with the bound on its rounding and the quotient's,
    /// and the bound on its error.
    pub(crate) fn quotient(&self, [area, bound]: [f64; 2]) -> [f64; 2] {
        let value = per_area(self.exchange.value, area);
        let error = per_area(self.exchange.error, area) + per_area(bound, area) * value;
        [value, error]
    }
}

/// A sum over pairs of polygons.
struct Sum {
    value: f64,
    bound: f64,
    /// The sum of the terms' sizes.
    size: f64,
    /// The route of the term with the largest bound.
    route: Route,
}

impl ScenePairs<'_> {
    /// The exchange area of two rows, and the route that found it: for a sum, the route of its
    /// least certain term. A row exchanges something with itself only if it is summed of patches in
    /// several planes.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`ExchangeError::Pair`] if two patches are refused.
    pub fn row_pair(&self, first: usize, second: usize) -> Result<Answer, ExchangeError> {
        self.check(first)?;
        self.check(second)?;
        self.counted_row_pair(first, second, &mut PassCounts::default())
    }

    /// The exchange area of two rows, counted if their planes face each other.
    pub(crate) fn counted_row_pair(
        &self,
        first: usize,
        second: usize,
        counts: &mut PassCounts,
    ) -> Result<Answer, ExchangeError> {
        match self.facing(first, second) {
            Facing::Visible => self.visible_row_pair(first, second, None, counts),
            hidden => Ok(nothing(hidden, first == second)),
        }
    }

    /// Refuses a row that does not exist.
    pub(crate) fn check(&self, row: usize) -> Result<(), ExchangeError> {
        let last = self.rows() - 1;
        if row > last {
            return Err(SceneError::NoSuchPatch { index: row, last }.into());
        }
        Ok(())
    }

    /// The exchange area of two rows whose planes face each other, counted.
    #[inline]
    pub(crate) fn visible_row_pair(
        &self,
        first: usize,
        second: usize,
        known: Option<Known>,
        counts: &mut PassCounts,
    ) -> Result<Answer, ExchangeError> {
        let answer = match self.terms().single(first, second) {
            Some([one, other]) => self.polygon_pair(one, other, known, counts)?,
            None => self.summed_row_pair(first.min(second), first.max(second), counts)?,
        };
        let smaller = self.areas()[first].min(self.areas()[second]);
        let is_accepted = self
            .tolerance()
            .accepts(&answer.exchange, smaller, self.rows());
        if !is_accepted && answer.exchange.error > self.unfelt(first, second) {
            counts.unreached([first, second], &answer.exchange, smaller);
        }
        Ok(answer)
    }

    /// The exchange area of two rows of which one at least is a sum.
    fn summed_row_pair(
        &self,
        first: usize,
        second: usize,
        counts: &mut PassCounts,
    ) -> Result<Answer, ExchangeError> {
        let mut sum = self.sum_of_terms(first, second, |one, other| {
            // a part is counted in its own row
            let mut own = PassCounts::default();
            let answer = self.polygon_pair(one.polygon, other.polygon, None, &mut own)?;
            if one.sign > 0.0 && other.sign > 0.0 {
                counts.merge(&own);
            }
            Ok(answer)
        })?;
        let wanted = self.tolerance().relative * sum.value.max(0.0);
        if sum.bound > wanted {
            let finer = (0.5 * wanted / sum.size).max(FINEST);
            let again = self.sum_of_terms(first, second, |one, other| {
                let counts = &mut PassCounts::default();
                let known = self.polygon_pair(one.polygon, other.polygon, None, counts)?;
                if known.exchange.error <= finer * known.exchange.value {
                    return Ok(known);
                }
                let sight = self.sight(one.polygon, other.polygon);
                self.evaluate(one.polygon, other.polygon, &sight, finer)
            })?;
            if again.bound < sum.bound {
                sum = again;
            }
        }
        let [areas, bounds] = [self.areas(), self.area_bounds()];
        let smaller = if areas[second] < areas[first] {
            second
        } else {
            first
        };
        let exchange = if sum.value > areas[smaller] {
            ExchangeArea {
                value: areas[smaller],
                error: sum.bound.max(bounds[smaller]),
            }
        } else {
            ExchangeArea {
                value: sum.value.max(0.0),
                error: sum.bound,
            }
        };
        let route = sum.route;
        Ok(Answer { exchange, route })
    }

    /// Sums over the pairs of polygons of two rows.
    fn sum_of_terms(
        &self,
        first: usize,
        second: usize,
        mut term: impl FnMut(&RowTerm, &RowTerm) -> Result<Answer, ExchangeError>,
    ) -> Result<Sum, ExchangeError> {
        let [mut value, mut bound, mut size] = [CompensatedSum::default(); 3];
        let (mut route, mut largest) = (Route::Coplanar, -1.0);
        let times = if first == second { 2.0 } else { 1.0 };
        for [one, other] in self.terms().pairs(first, second) {
            if self.facing_polygons(one.polygon, other.polygon) != Facing::Visible {
                continue;
            }
            let answer = term(&one, &other)?;
            let ExchangeArea {
                value: exchange,
                mut error,
            } = answer.exchange;
            for (part, whole) in [(&one, &other), (&other, &one)] {
                if part.sign < 0.0 {
                    error += self.offset_allowance(part.polygon, whole.polygon);
                }
            }
            value.add(times * one.sign * other.sign * exchange);
            bound.add(times * error);
            size.add(times * exchange);
            if error > largest {
                (route, largest) = (answer.route, error);
            }
        }
        let size = size.total();
        Ok(Sum {
            value: value.total(),
            bound: bound.total() + 2.0 * f64::EPSILON * size,
            size,
            route,
        })
    }
}
