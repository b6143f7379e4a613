//! The exchange of a scene's rows as a solution reads it: by ranks that hold it, or from a store.
//!
//! A matrix that is stored is read once for each product, block by block; with
//! [`ProductFiles`] a solution that was stopped goes on from the products that were made.
//!
//! **Memory** O(n) and a block a thread, beside what ranks hold.

use super::changes::ExchangeChanges;
use super::products::Products;
use super::system::{ExchangeRows, RadiositySystem};
use super::{ExchangeOperator, TransportError};
use crate::exchange::{
    Closure, ExchangeBlocks, ExchangeError, LowerBlocks, LowerPairs, PassSummary, ProductFiles,
    ScenePairs, StoredMatrix, agreed, unread,
};
use crate::form_factor::ExchangeArea;
use crate::numeric::{DoubleDouble, Scaled};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// Exchange areas of a scene that are held by ranks, or stored, in the unit of a system.
#[derive(Clone)]
pub struct SceneOperator<'e> {
    matrix: Arc<dyn LowerBlocks + Send + 'e>,
    /// The power of two by which the entries are multiplied.
    power: i32,
    /// The files of products, and the name of this matrix in them.
    products: Option<(Arc<ProductFiles>, &'static str)>,
}

/// The entries of a matrix, multiplied by a power of two.
struct InUnit<'m> {
    matrix: &'m dyn LowerBlocks,
    power: i32,
}

impl LowerBlocks for InUnit<'_> {
    fn order(&self) -> usize {
        self.matrix.order()
    }

    fn ranks(&self) -> &dyn crate::exchange::Ranks {
        self.matrix.ranks()
    }

    fn block(&self, block: usize, rows: Range<usize>) -> Result<Cow<'_, [f64]>, ExchangeError> {
        let mut entries = self.matrix.block(block, rows)?;
        if self.power != 0 {
            for entry in entries.to_mut() {
                *entry = Scaled::new(*entry).times_power(self.power);
            }
        }
        Ok(entries)
    }
}

impl SceneOperator<'_> {
    /// A product, or the one that an earlier run left: rank 0 looks after the files.
    fn product(
        &self,
        kind: &str,
        x: &[f64],
        product: impl FnOnce(Products<'_>) -> Result<Vec<f64>, ExchangeError>,
    ) -> Result<Vec<f64>, ExchangeError> {
        let matrix = InUnit {
            matrix: &*self.matrix,
            power: self.power,
        };
        let Some((files, name)) = &self.products else {
            return product(Products(&matrix));
        };
        let kind = format!("{name} {} {kind}", self.power);
        let ranks = self.matrix.ranks();
        let is_first = ranks.number() == 0;
        // what follows is for ranks that are all well
        agreed(ranks, Ok::<_, ExchangeError>(()))?;
        let found = is_first.then(|| files.find(&kind, x)).flatten();
        let found = ranks.gather(found.unwrap_or_default()).swap_remove(0);
        if !found.is_empty() {
            return Ok(found);
        }
        let made = product(Products(&matrix))?;
        let kept = if is_first {
            files.keep(&kind, x, &made).map_err(unread)
        } else {
            Ok(())
        };
        agreed(ranks, kept)?;
        Ok(made)
    }
}

impl ExchangeOperator for SceneOperator<'_> {
    fn order(&self) -> usize {
        self.matrix.order()
    }

    fn differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        self.product("differences", x, |matrix| matrix.differences(x))
    }

    fn absolute_differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        self.product("absolute", x, |matrix| matrix.absolute_differences(x))
    }

    fn gathered(&self, x: &[f64]) -> Result<Vec<DoubleDouble>, ExchangeError> {
        let made = self.product("gathered", x, |matrix| Ok(halves(&matrix.gathered(x)?)))?;
        Ok(whole(&made))
    }

    fn precise_differences(&self, x: &[DoubleDouble]) -> Result<Vec<DoubleDouble>, ExchangeError> {
        let made = self.product("precise", &halves(x), |matrix| {
            Ok(halves(&matrix.precise_differences(x)?))
        })?;
        Ok(whole(&made))
    }
}

/// The leading halves of numbers, and then the others.
fn halves(numbers: &[DoubleDouble]) -> Vec<f64> {
    let high = numbers.iter().map(|number| number.high());
    high.chain(numbers.iter().map(|number| number.low()))
        .collect()
}

fn whole(halves: &[f64]) -> Vec<DoubleDouble> {
    let (high, low) = halves.split_at(halves.len() / 2);
    let both = high.iter().zip(low);
    both.map(|(high, low)| DoubleDouble::sum(*high, *low))
        .collect()
}

/// The exchange of a scene's rows, of which there may be several systems.
pub struct SceneExchange<'e> {
    values: SceneOperator<'e>,
    bounds: SceneOperator<'e>,
    rows: ExchangeRows,
    /// The sums of the rows off the diagonal, and of the bounds.
    sums: [Vec<DoubleDouble>; 2],
    closure: Closure,
    pairs: &'e ScenePairs<'e>,
    own: Vec<ExchangeArea>,
    summary: PassSummary,
    changes: Option<ExchangeChanges<SceneOperator<'e>>>,
}

/// The parts of an exchange, in the unit of the scene.
struct Parts<'e> {
    values: SceneOperator<'e>,
    bounds: SceneOperator<'e>,
    own: Vec<ExchangeArea>,
    summary: PassSummary,
    changes: Option<SceneOperator<'e>>,
}

impl<'e> SceneExchange<'e> {
    /// The exchange of a scene, computed and held by its ranks.
    ///
    /// # Errors
    /// [`TransportError::Exchange`] if two patches are refused, or a row is above one.
    pub fn held(pairs: &'e ScenePairs<'e>) -> Result<Self, TransportError> {
        let ExchangeBlocks {
            values,
            bounds,
            own,
            summary,
        } = pairs.exchange_blocks()?;
        let parts = Parts {
            values: SceneOperator::held(values),
            bounds: SceneOperator::held(bounds),
            own,
            summary,
            changes: pairs.resolution_blocks().map(SceneOperator::held),
        };
        Self::new(pairs, parts)
    }

    /// The exchange of a scene whose matrix is stored.
    ///
    /// **Arguments** `products`: the files from which a solution that was stopped goes on.
    ///
    /// # Errors
    /// [`TransportError::Exchange`] if the store cannot be read, or a row is above one.
    pub fn stored(
        matrix: &'e StoredMatrix<'e>,
        products: Option<&Arc<ProductFiles>>,
    ) -> Result<Self, TransportError> {
        let stored = |matrix: Arc<dyn LowerBlocks + Send + 'e>, name| SceneOperator {
            matrix,
            power: 0,
            products: products.map(|files| (Arc::clone(files), name)),
        };
        let pairs = matrix.pairs();
        let is_rounded = pairs.resolution() > 0.0;
        let parts = Parts {
            values: stored(Arc::new(matrix.values()), "values"),
            bounds: stored(Arc::new(matrix.error_bounds()), "bounds"),
            own: matrix.own()?,
            summary: matrix.summary(),
            changes: is_rounded.then(|| stored(Arc::new(pairs.resolution_rows()), "resolution")),
        };
        Self::new(pairs, parts)
    }

    fn new(pairs: &'e ScenePairs<'e>, parts: Parts<'e>) -> Result<Self, TransportError> {
        let ones = vec![1.0; pairs.rows()];
        let sums = [&parts.values, &parts.bounds].map(|matrix| matrix.gathered(&ones));
        let [values, bounds] = sums;
        let mut sums = [values?, bounds?];
        let own = parts.own.iter();
        let (own, own_bounds) = own.map(|own| (own.value, own.error)).unzip();
        let closure = closure(pairs, &sums, [&own, &own_bounds]);
        closure.require_at_most_one()?;
        let areas = pairs.areas();
        let open = |i: usize| (closure.escaping(i) > 0.0).then(|| areas[i]);
        let mut rows = ExchangeRows {
            own,
            own_bounds,
            open_areas: (0..areas.len()).map(open).collect(),
        };
        let mut changes = parts.changes.map(|exchange| ExchangeChanges {
            exchange,
            own: (0..areas.len())
                .map(|i| pairs.resolution_error(i, i))
                .collect(),
            areas: pairs.area_resolution_errors(),
        });
        let power = power(&sums[0], &rows.own);
        if power != 0 {
            let scaled = |value: &mut f64| *value = Scaled::new(*value).times_power(power);
            let ExchangeRows {
                own,
                own_bounds,
                open_areas,
            } = &mut rows;
            own.iter_mut().chain(own_bounds).for_each(scaled);
            open_areas.iter_mut().flatten().for_each(scaled);
            if let Some(changes) = &mut changes {
                changes
                    .own
                    .iter_mut()
                    .chain(&mut changes.areas)
                    .for_each(scaled);
                changes.exchange.power = power;
            }
            for sum in sums.iter_mut().flatten() {
                let [high, low] =
                    [sum.high(), sum.low()].map(|part| Scaled::new(part).times_power(power));
                *sum = DoubleDouble::sum(high, low);
            }
        }
        let in_unit = |matrix| SceneOperator { power, ..matrix };
        Ok(Self {
            values: in_unit(parts.values),
            bounds: in_unit(parts.bounds),
            rows,
            sums,
            closure,
            pairs,
            own: parts.own,
            summary: parts.summary,
            changes,
        })
    }

    /// The sums of the rows of form factors.
    #[must_use]
    pub const fn closure(&self) -> &Closure {
        &self.closure
    }

    /// The areas of the rows.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        self.pairs.areas()
    }

    /// The plan, and whether the tolerance was reached.
    #[must_use]
    pub const fn summary(&self) -> &PassSummary {
        &self.summary
    }

    /// The pairs, as they are held or stored.
    #[must_use]
    pub fn lower_pairs(&self) -> LowerPairs<'_> {
        LowerPairs {
            pairs: self.pairs,
            values: &*self.values.matrix,
            bounds: &*self.bounds.matrix,
            own: &self.own,
            summary: &self.summary,
        }
    }

    /// The system of rows that reflect so much.
    ///
    /// # Errors
    /// As [`RadiositySystem::try_new`].
    pub fn system(
        &self,
        reflectances: Vec<f64>,
    ) -> Result<RadiositySystem<SceneOperator<'e>>, TransportError> {
        RadiositySystem::with_sums(
            self.values.clone(),
            Some(self.bounds.clone()),
            self.rows.clone(),
            reflectances,
            (&self.sums[0], Some(&self.sums[1])),
        )
        .map_err(|error| match error {
            TransportError::NoSink { group } => TransportError::NoSink {
                group: group.named(self.pairs.names()),
            },
            other => other,
        })
    }

    /// Bounds on what the resolution of the coordinates can change of the radiosities of a system;
    /// none where no bound is known, 0 if coordinates are exact.
    ///
    /// # Errors
    /// [`TransportError::Exchange`].
    pub fn resolution_errors(
        &self,
        system: &RadiositySystem<SceneOperator<'e>>,
        values: &[f64],
        sources: &[f64],
    ) -> Result<Option<Vec<f64>>, TransportError> {
        match &self.changes {
            None => Ok(Some(vec![0.0; values.len()])),
            Some(changes) => system.changed(changes.clone(), values, sources),
        }
    }
}

impl<'e> SceneOperator<'e> {
    fn held(blocks: impl LowerBlocks + Send + 'e) -> Self {
        Self {
            matrix: Arc::new(blocks),
            power: 0,
            products: None,
        }
    }
}

/// The closure of a scene whose rows have these sums off the diagonal, of values and of bounds.
fn closure(
    pairs: &ScenePairs<'_>,
    [values, bounds]: &[Vec<DoubleDouble>; 2],
    [own, own_bounds]: [&Vec<f64>; 2],
) -> Closure {
    let total = |sum: &DoubleDouble, own: f64| (*sum + DoubleDouble::from(own)).high();
    let both = values.iter().zip(bounds).zip(own.iter().zip(own_bounds));
    let sums = both
        .map(|((value, bound), (own, own_bound))| [total(value, *own), total(bound, *own_bound)]);
    Closure::of_sums(pairs, sums)
}

/// The power of two by which exchange areas are multiplied so that products with them and the low
/// halves of these stay in `f64`: that of the largest sum of a row.
fn power(sums: &[DoubleDouble], own: &[f64]) -> i32 {
    let sums = sums.iter().map(|sum| sum.high());
    let largest = sums.chain(own.iter().copied()).fold(0.0, f64::max);
    let power = -Scaled::new(largest).exponent;
    if power.abs() > 300 { power } else { 0 }
}
