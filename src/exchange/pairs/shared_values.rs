//! The values that classes of congruent pairs share.
//!
//! ```text
//!   error = error of the first pair, or of its model + what congruent pairs may differ by
//! ```
//!
//! Half of the tolerance is for either part, and for the model of a turned pair what the other part
//! leaves of all; a class whose pairs may differ by more has no value,
//! and each of its pairs is computed by itself.

use super::sights::Sight;
use crate::exchange::plan::Source;
use crate::exchange::plan::model_offset::offset_allowance;
use crate::exchange::plan::perturbation::{allowance, corner_allowance};
use crate::exchange::{ExchangeError, ScenePairs};
use crate::form_factor::{Answer, Polygon};
use crate::geometry::{FlatBox, Patch};
use crate::scene::NamedPatch;
use glam::DVec3;

impl ScenePairs<'_> {
    /// The value of a class; none if its pairs are not equal within the tolerance.
    pub(crate) fn shared_value(
        &self,
        class: usize,
        shapes: &[NamedPatch],
    ) -> Result<Option<Answer>, ExchangeError> {
        let Some(representative) = self.plan.representative(class) else {
            return Ok(None);
        };
        let [first, second] = representative.pair;
        let tolerance = self.relative_tolerance(first, second)?;
        let spread = representative.spread;
        match &representative.source {
            Source::Boxes(models) => Ok(value_of_models(models, spread, tolerance)),
            Source::Image(models) => self.image_value([first, second], models, spread, tolerance),
            Source::Straight => {
                // half of it is for the differences between congruent pairs
                let part = if spread > 0.0 { 0.5 } else { 1.0 };
                let mut answer = self.evaluate(first, second, &Sight::Clear, part * tolerance)?;
                let [one, other] = [first, second].map(|index| shapes[index].shape());
                let apart = allowance(spread, one, other);
                let exchange = &mut answer.exchange;
                exchange.error += apart;
                Ok((apart <= 0.5 * tolerance * exchange.value).then_some(answer))
            }
        }
    }

    /// The value of a pair, if all its translates and mirror images have it within the tolerance.
    fn image_value(
        &self,
        [first, second]: [usize; 2],
        models: &[Vec<DVec3>; 2],
        offset: f64,
        tolerance: f64,
    ) -> Result<Option<Answer>, ExchangeError> {
        let [Ok(one), Ok(other)] = models.clone().map(Patch::try_new) else {
            return Ok(None);
        };
        let apart = corner_allowance(offset, &one, &other);
        let smaller = one.area().min(other.area());
        if apart > tolerance * smaller {
            return Ok(None);
        }
        let part = if apart > 0.0 { 0.5 } else { 1.0 };
        let mut answer = self.evaluate(first, second, &Sight::Clear, part * tolerance)?;
        let exchange = &mut answer.exchange;
        exchange.error += apart;
        let is_met = exchange.error <= tolerance * exchange.value || apart <= 0.0;
        Ok(is_met.then_some(answer))
    }
}

/// The value of two models, if all pairs that they stand for are equal to it within the tolerance.
fn value_of_models(models: &[FlatBox; 2], offset: f64, tolerance: f64) -> Option<Answer> {
    let apart = offset_allowance(offset, &models[0], &models[1]);
    let [one, other] = models
        .each_ref()
        .map(|model| Some(Polygon::new(&Patch::try_new(model.corners()).ok()?)));
    let (one, other) = (one?, other?);
    let smaller = one.area().min(other.area());
    if apart > tolerance * smaller * one.largest_form_factor(&other) {
        return None;
    }
    let mut answer = one.exchange_area(&other, 0.5 * tolerance).ok()?;
    let exchange = &mut answer.exchange;
    exchange.value = exchange.value.min(smaller);
    exchange.error += apart;
    (exchange.error <= tolerance * exchange.value).then_some(answer)
}
