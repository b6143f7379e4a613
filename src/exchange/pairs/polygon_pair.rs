//! The exchange area of two polygons: shared, past what stands between, or none.
//!
//! ```text
//!   clear     the value of the class of congruent pairs, or computed
//!   partial   computed past the screens in the way; left between nothing and all where the
//!             absolute error that is accepted allows it
//!   hidden    0
//! ```
//!
//! Where occlusion is ignored, pairs that something stands between are counted.
//!
//! **Not covered**: the signs of polygons in rows (`row_pair`).

use super::sights::{Sight, Sights};
use crate::exchange::plan::facing::Facing;
use crate::exchange::{ExchangeError, PassCounts, ScenePairs};
use crate::form_factor::together::{Asked, TOGETHER, exchange_areas};
use crate::form_factor::{Answer, ExchangeArea, Polygon, Route};
use smallvec::SmallVec;

/// The answer for a pair that sees nothing of each other.
const HIDDEN: Answer = Answer {
    exchange: ExchangeArea {
        value: 0.0,
        error: 0.0,
    },
    route: Route::Hidden,
};

/// An answer that a pass has for a pair before it comes to it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    answer: Answer,
    /// Whether congruent pairs share it.
    is_shared: bool,
}

impl ScenePairs<'_> {
    /// The lines of sight between two polygons.
    pub(crate) fn sight(&self, first: usize, second: usize) -> Sight {
        let Some(sights) = &self.sights else {
            return Sight::Clear;
        };
        let [first, second] = [first, second].map(|polygon| self.terms.patches()[polygon]);
        sights.between(first, second)
    }

    /// The lines of sight between two polygons that their exchange area is computed along.
    pub(crate) fn exact_sight(&self, first: usize, second: usize, facing: Facing) -> Sight {
        let exact = self.sights.as_ref().filter(|sights| sights.are_exact());
        if exact.is_some() && facing == Facing::Visible {
            self.sight(first, second)
        } else {
            Sight::Clear
        }
    }

    /// The exchange area of two polygons whose planes face each other, counted.
    #[inline]
    pub(crate) fn polygon_pair(
        &self,
        first: usize,
        second: usize,
        known: Option<Known>,
        counts: &mut PassCounts,
    ) -> Result<Answer, ExchangeError> {
        match &self.sights {
            None => self.clear_pair(first, second, known, counts),
            Some(sights) => self.sighted_pair(sights, [first, second], known, counts),
        }
    }

    /// The exchange area of two polygons that nothing stands between, counted.
    #[inline]
    fn clear_pair(
        &self,
        first: usize,
        second: usize,
        known: Option<Known>,
        counts: &mut PassCounts,
    ) -> Result<Answer, ExchangeError> {
        let known = match known {
            Some(known) => known,
            None => self.clear_answer(first, second)?,
        };
        counts.polygons(known.answer.route, !known.is_shared);
        Ok(known.answer)
    }

    /// The value of the pair's class, or else its own.
    fn clear_answer(&self, first: usize, second: usize) -> Result<Known, ExchangeError> {
        let class = self.class(first, second);
        if let (Some(sights), Some(class)) = (&self.sights, class) {
            sights.take(class);
        }
        if let Some(answer) = class.and_then(|class| self.shared[class]) {
            return Ok(Known {
                answer,
                is_shared: true,
            });
        }
        let tolerance = self.relative_tolerance(first, second)?;
        Ok(Known {
            answer: self.evaluate(first, second, &Sight::Clear, tolerance)?,
            is_shared: false,
        })
    }

    /// The exchange area of two polygons that something may stand between, counted.
    fn sighted_pair(
        &self,
        sights: &Sights,
        [first, second]: [usize; 2],
        known: Option<Known>,
        counts: &mut PassCounts,
    ) -> Result<Answer, ExchangeError> {
        let sight = self.sight(first, second);
        if sight == Sight::Clear {
            return self.clear_pair(first, second, known, counts);
        }
        if !sights.are_exact() {
            let answer = self.clear_pair(first, second, known, counts)?;
            counts.ignored(&answer.exchange);
            return Ok(answer);
        }
        let answer = match sight {
            Sight::Hidden => HIDDEN,
            _ => {
                let tolerance = self.relative_tolerance(first, second)?;
                self.evaluate(first, second, &sight, tolerance)?
            }
        };
        counts.occluded(answer.route, sight == Sight::Hidden);
        Ok(answer)
    }

    /// Looks up the values that a row shares with others, and evaluates those of the rest that are
    /// quicker evaluated together: no sums, and none that something may stand between.
    ///
    /// **Arguments** `others`: rows whose planes face that of the row, or none; `known`: an answer
    /// for each of the others, if it is found here.
    pub(crate) fn evaluate_together(
        &self,
        row: usize,
        others: impl Iterator<Item = Option<usize>>,
        known: &mut [Option<Known>],
    ) {
        known.fill(None);
        if self.sights.as_ref().is_some_and(Sights::are_exact) {
            return;
        }
        let mut places: SmallVec<[usize; TOGETHER]> = SmallVec::new();
        let mut pairs: SmallVec<[Asked<'_>; TOGETHER]> = SmallVec::new();
        for (place, other) in others.enumerate() {
            let single = other.and_then(|other| self.terms.single(row, other));
            let Some([one, other]) = single else {
                continue;
            };
            let class = self.class(one, other);
            if class.is_some() && self.sights.is_some() {
                // the class is told there that it is taken
                continue;
            }
            if let Some(answer) = class.and_then(|class| self.shared[class]) {
                known[place] = Some(Known {
                    answer,
                    is_shared: true,
                });
                continue;
            }
            let Ok(polygons) = self.both(one.min(other), one.max(other)) else {
                continue;
            };
            places.push(place);
            pairs.push((
                polygons,
                self.tolerance.relative_of(polygons[0], polygons[1]),
            ));
        }
        exchange_areas(&pairs, |at, answer| {
            let [one, other] = pairs[at].0;
            let most = one.area().min(other.area());
            known[places[at]] = answer.ok().map(|mut answer| {
                answer.exchange.value = answer.exchange.value.min(most);
                Known {
                    answer,
                    is_shared: false,
                }
            });
        });
    }

    /// Two polygons, if they are among those that were made ready.
    fn both(&self, first: usize, second: usize) -> Result<[&Polygon; 2], ExchangeError> {
        let both = self.polygons.get(first).zip(self.polygons.get(second));
        let [first, second] = [first, second].map(|polygon| self.terms.patches()[polygon]);
        both.map(<[&Polygon; 2]>::from)
            .ok_or(ExchangeError::NotSelected { first, second })
    }

    /// The relative error to which two polygons are evaluated.
    pub(crate) fn relative_tolerance(
        &self,
        first: usize,
        second: usize,
    ) -> Result<f64, ExchangeError> {
        let [one, other] = self.both(first, second)?;
        Ok(self.tolerance.relative_of(one, other))
    }

    /// Computes the exchange area of two polygons: one value per pair, between 0 and the smaller
    /// area.
    pub(crate) fn evaluate(
        &self,
        first: usize,
        second: usize,
        sight: &Sight,
        tolerance: f64,
    ) -> Result<Answer, ExchangeError> {
        let (first, second) = (first.min(second), first.max(second));
        let [one, other] = self.both(first, second)?;
        let answer = match (sight, &self.sights) {
            (Sight::Past(screens), Some(sights)) if sights.are_exact() => {
                if let Some(nothing_to_all) = self.accepted_unseen(one, other, tolerance) {
                    return Ok(nothing_to_all);
                }
                let patches = [first, second].map(|polygon| self.terms.patches()[polygon]);
                sights.exchange(patches, [one, other], screens, tolerance)
            }
            (Sight::Hidden, Some(sights)) if sights.are_exact() => Ok(HIDDEN),
            _ => one.exchange_area(other, tolerance),
        };
        let mut answer = answer.map_err(|source| ExchangeError::Pair {
            first: self.terms.patches()[first],
            second: self.terms.patches()[second],
            source,
        })?;
        let most = one.area().min(other.area());
        answer.exchange.value = answer.exchange.value.min(most);
        Ok(answer)
    }

    /// The answer between nothing and all that two polygons exchange, if the absolute error that is
    /// accepted leaves it at that: what stands between need not be looked at.
    fn accepted_unseen(&self, one: &Polygon, other: &Polygon, tolerance: f64) -> Option<Answer> {
        self.tolerance.absolute?;
        let all = one.exchange_area(other, tolerance).ok()?.exchange;
        let half = 0.5 * (all.value + all.error);
        let exchange = ExchangeArea {
            value: half,
            error: half,
        };
        let smaller = one.area().min(other.area());
        let is_accepted = self.tolerance.accepts(&exchange, smaller, self.rows());
        is_accepted.then_some(Answer {
            exchange,
            route: Route::Occluded,
        })
    }

    /// The class whose value a pair of polygons takes if nothing stands between them.
    #[inline]
    pub(crate) fn class(&self, first: usize, second: usize) -> Option<usize> {
        let place = self.plan.shared(first, second)?;
        self.shared[place].map(|_| place)
    }

    /// Whether a pair of polygons takes the value of its class, if it has one.
    pub(crate) fn takes_class(&self, first: usize, second: usize) -> bool {
        self.exact_sight(first, second, Facing::Visible) == Sight::Clear
    }
}
