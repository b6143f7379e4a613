//! Bounds on what changes of the exchange areas do to a solution.

use super::system::row_bounds;
use super::{ExchangeOperator, RadiositySystem, TransportError};

/// Bounds on changes of exchange areas, in the unit of a system.
#[derive(Debug, Clone)]
pub(super) struct ExchangeChanges<O> {
    /// The changes off the diagonal.
    pub(super) exchange: O,
    /// The changes of what rows exchange with themselves.
    pub(super) own: Vec<f64>,
    /// The changes of the rows' areas.
    pub(super) areas: Vec<f64>,
}

impl<O: ExchangeOperator + Clone> RadiositySystem<O> {
    /// Bounds on what such changes bring to the radiosities of this system: the errors of form
    /// factors that they would be; none where no bound is known.
    ///
    /// **Arguments** the bounds, the radiosities of this system, the emittances.
    pub(super) fn changed(
        &self,
        changes: ExchangeChanges<O>,
        values: &[f64],
        sources: &[f64],
    ) -> Result<Option<Vec<f64>>, TransportError> {
        let sums = changes.exchange.gathered(&vec![1.0; changes.own.len()])?;
        let system = Self {
            row_bounds: row_bounds(&sums, &changes.own),
            errors: Some(changes.exchange),
            open_area_bounds: changes.areas,
            ..self.clone()
        };
        let known = system.form_factor_errors(values, sources)?;
        let most = system.brightest(sources);
        if known.is_none() && most.is_infinite() {
            return Ok(None);
        }
        // whatever the form factors are, a patch is as bright as it emits, and no brighter than all
        // would be that emit and reflect the most
        let range = values
            .iter()
            .zip(sources)
            .map(|(value, source)| f64::max(value - source, most - value));
        let bounds = range.enumerate().map(|(patch, range)| match &known {
            Some(known) => known[patch].min(range),
            None => range,
        });
        Ok(Some(bounds.collect()))
    }

    /// The radiosity of a closed room all of whose patches emit and reflect the most of any;
    /// infinite if that reflects all.
    fn brightest(&self, sources: &[f64]) -> f64 {
        let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        largest(sources) / (1.0 - largest(&self.reflectances)).max(0.0)
    }
}
