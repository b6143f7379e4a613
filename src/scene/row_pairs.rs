//! What two rows exchange: a sum over pairs of polygons.
//!
//! ```text
//!   G_gh = Σ_k Σ_l c_gk c_hl G_kl ,     |error| ≤ Σ_k Σ_l (e_kl + 2 ε G_kl)
//! ```
//!
//! with the signs of [`Members`](super::members::Members); the rounding of the sum is the last term ([`CompensatedSum`]). A pair of rows has
//! one value, whichever way it is asked for, so that `A_i F_ij = A_j F_ji` holds exactly. It is at least 0 and
//! at most the smaller area, so that `0 ≤ F ≤ 1`: what lies beyond is the error of a value at the limit, and putting it
//! there brings it nearer to the exact one. Where a base's remainder cancels below its bound, that bound stands beside what is left.
//!
//! Cancellation costs digits: where the bound misses the tolerance, the terms are computed again to a finer one.

use super::facing::Sight;
use super::members::Member;
use super::{ExchangeError, SceneError, ScenePairs, Tally};
use crate::form_factor::{Answer, ExchangeArea, Route};
use crate::numeric::CompensatedSum;

/// No route reaches a finer relative tolerance.
const FINEST: f64 = 4.0 * f64::EPSILON;

/// What two rows exchange whose planes see nothing of each other.
pub(super) const fn nothing(route: Route) -> Answer {
    let exchange = ExchangeArea {
        value: 0.0,
        error_bound: 0.0,
    };
    Answer { exchange, route }
}

/// A sum over pairs of polygons.
struct Terms {
    value: f64,
    bound: f64,
    /// The sum of the terms' sizes.
    size: f64,
    /// That of the term with the largest bound.
    route: Route,
}

impl ScenePairs {
    /// What two rows exchange, and how it was found: of a sum, the way of its least certain term. A row exchanges something with
    /// itself only if it is summed of patches in several planes.
    ///
    /// # Errors
    /// [`SceneError::NoSuchPatch`]; [`ExchangeError::Pair`] if two patches are refused.
    pub fn pair(&self, first: usize, second: usize) -> Result<Answer, ExchangeError> {
        self.check(first)?;
        self.check(second)?;
        self.between(first, second, &mut Tally::default())
    }

    pub(super) fn check(&self, row: usize) -> Result<(), ExchangeError> {
        let last = self.patches() - 1;
        if row > last {
            return Err(SceneError::NoSuchPatch { index: row, last }.into());
        }
        Ok(())
    }

    /// What two rows exchange, counted if they see each other.
    pub(super) fn between(
        &self,
        first: usize,
        second: usize,
        tally: &mut Tally,
    ) -> Result<Answer, ExchangeError> {
        match self.sight(first, second) {
            Sight::Open => self.open(first, second, tally),
            Sight::BackFacing if first != second => Ok(nothing(Route::BackFacing)),
            Sight::BackFacing | Sight::Coplanar => Ok(nothing(Route::Coplanar)),
        }
    }

    /// Two rows that see each other.
    #[inline]
    pub(super) fn open(
        &self,
        first: usize,
        second: usize,
        tally: &mut Tally,
    ) -> Result<Answer, ExchangeError> {
        let answer = match self.members.single(first, second) {
            Some([one, other]) => self.look(one, other, tally)?,
            None => self.sum(first.min(second), first.max(second), tally)?,
        };
        tally.rows([first, second], &answer, self.tolerance());
        Ok(answer)
    }

    fn sum(&self, first: usize, second: usize, tally: &mut Tally) -> Result<Answer, ExchangeError> {
        let mut sum = self.terms(first, second, |one, other| {
            // a part is counted in its own row
            let mut counts = Tally::default();
            let answer = self.look(one.polygon, other.polygon, &mut counts)?;
            if one.sign > 0.0 && other.sign > 0.0 {
                tally.merge(&counts);
            }
            Ok(answer)
        })?;
        let wanted = self.tolerance() * sum.value.max(0.0);
        if sum.bound > wanted {
            let finer = (0.5 * wanted / sum.size).max(FINEST);
            let again = self.terms(first, second, |one, other| {
                let known = self.look(one.polygon, other.polygon, &mut Tally::default())?;
                if known.exchange.error_bound <= finer * known.exchange.value {
                    return Ok(known);
                }
                self.compute(one.polygon, other.polygon, finer)
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
                error_bound: sum.bound.max(bounds[smaller]),
            }
        } else {
            ExchangeArea {
                value: sum.value.max(0.0),
                error_bound: sum.bound,
            }
        };
        let route = sum.route;
        Ok(Answer { exchange, route })
    }

    fn terms(
        &self,
        first: usize,
        second: usize,
        mut term: impl FnMut(&Member, &Member) -> Result<Answer, ExchangeError>,
    ) -> Result<Terms, ExchangeError> {
        let [mut value, mut bound, mut size] = [CompensatedSum::default(); 3];
        let (mut route, mut largest) = (Route::Coplanar, -1.0);
        let times = if first == second { 2.0 } else { 1.0 };
        for [one, other] in self.members.pairs(first, second) {
            if self.plan.sight(one.polygon, other.polygon) != Sight::Open {
                continue;
            }
            let answer = term(&one, &other)?;
            let ExchangeArea {
                value: exchange,
                mut error_bound,
            } = answer.exchange;
            for (part, whole) in [(&one, &other), (&other, &one)] {
                if part.sign < 0.0 {
                    error_bound += self.shifts.allowance(part.polygon, whole.polygon);
                }
            }
            value.add(times * one.sign * other.sign * exchange);
            bound.add(times * error_bound);
            size.add(times * exchange);
            if error_bound > largest {
                (route, largest) = (answer.route, error_bound);
            }
        }
        let size = size.total();
        Ok(Terms {
            value: value.total(),
            bound: bound.total() + 2.0 * f64::EPSILON * size,
            size,
            route,
        })
    }
}
