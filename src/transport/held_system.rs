//! The system of radiosity over exchange areas that are held: those of a scene, or of a matrix.
//!
//! Exchange areas are scaled by a power of two where their products would leave `f64`.

use super::changes::ExchangeChanges;
use super::system::{ExchangeRows, RadiositySystem, check_count};
use super::{DenseExchange, TransportError};
use crate::exchange::{Closure, ExchangeAreas, ResolutionErrors};
use crate::numeric::{Scaled, Symmetric};
use crate::scene::Material;
use nalgebra::DMatrix;

impl<'e> RadiositySystem<DenseExchange<'e>> {
    /// The system of a scene's patches; it is closed if every row of form factors sums to one
    /// within its bounds.
    ///
    /// # Errors
    /// [`TransportError::WrongCount`] unless there is a material for each patch;
    /// [`TransportError::ReflectanceTooSmall`]; [`TransportError::NoSink`] if patches reflect all
    /// light and none of it ends; [`TransportError::Exchange`] if a row is above one, as where
    /// patches hide each other and occlusion was ignored.
    pub fn of(exchange: &'e ExchangeAreas, materials: &[Material]) -> Result<Self, TransportError> {
        let reflectances = materials.iter().map(Material::reflectance);
        Self::with_reflectances(exchange, reflectances.collect())
    }

    /// The system of patches that reflect so much.
    ///
    /// # Errors
    /// As [`of`](Self::of), and [`TransportError::ReflectanceOutOfRange`].
    pub fn with_reflectances(
        exchange: &'e ExchangeAreas,
        reflectances: Vec<f64>,
    ) -> Result<Self, TransportError> {
        let closure = Closure::of_held(exchange);
        closure.require_at_most_one()?;
        let rows = || 0..exchange.rows();
        let own = rows().map(|i| exchange.get(i, i).exchange);
        let (own, own_bounds) = own.map(|own| (own.value, own.error)).unzip();
        let open = |i: usize| (closure.escaping(i) > 0.0).then(|| exchange.areas()[i]);
        Self::in_own_unit(
            exchange.values().into(),
            Some(exchange.errors().into()),
            ExchangeRows {
                own,
                own_bounds,
                open_areas: rows().map(open).collect(),
            },
            reflectances,
        )
        .map_err(|error| match error {
            TransportError::NoSink { group } => TransportError::NoSink {
                group: group.named(&exchange.shared_names()),
            },
            other => other,
        })
    }

    /// The system of a closed scene with these exchange areas `A_i F_ij`, taken as exact; the areas
    /// are their row sums.
    ///
    /// # Errors
    /// [`TransportError::InvalidExchange`] unless the matrix is finite, ≥ 0 and equal to its
    /// transpose; [`TransportError::WrongCount`] unless it has a row and a column for each
    /// reflectance; [`TransportError::ReflectanceOutOfRange`],
    /// [`TransportError::ReflectanceTooSmall`], [`TransportError::NoSink`].
    pub fn of_matrix(
        exchange: &DMatrix<f64>,
        reflectances: Vec<f64>,
    ) -> Result<RadiositySystem<DenseExchange<'static>>, TransportError> {
        let count = reflectances.len();
        let values = packed(exchange, count)?;
        RadiositySystem::in_own_unit(
            values.into(),
            None,
            ExchangeRows {
                own: exchange.diagonal().iter().copied().collect(),
                own_bounds: vec![0.0; count],
                open_areas: vec![None; count],
            },
            reflectances,
        )
    }

    /// Bounds on what the resolution of a scene's coordinates can change of its radiosities: the
    /// errors of form factors that these bounds would be; none where no bound is known.
    ///
    /// **Arguments** the bounds, the radiosities of this system, the emittances.
    ///
    /// # Errors
    /// None, as the exchange areas are held.
    pub fn resolution_errors(
        &self,
        bounds: &'e ResolutionErrors,
        values: &[f64],
        sources: &[f64],
    ) -> Result<Option<Vec<f64>>, TransportError> {
        let mut changes = ExchangeChanges {
            exchange: DenseExchange::from(bounds.exchange()),
            own: bounds.own().to_vec(),
            areas: bounds.areas().to_vec(),
        };
        if self.power != 0 {
            changes.exchange.scale(self.power);
            for bound in changes.own.iter_mut().chain(&mut changes.areas) {
                *bound = Scaled::new(*bound).times_power(self.power);
            }
        }
        self.changed(changes, values, sources)
    }

    /// The system in units in which neither products nor their low halves leave `f64`.
    fn in_own_unit(
        mut exchange: DenseExchange<'e>,
        mut errors: Option<DenseExchange<'e>>,
        mut rows: ExchangeRows,
        reflectances: Vec<f64>,
    ) -> Result<Self, TransportError> {
        let own = rows.own.iter().copied().fold(0.0, f64::max);
        let power = -Scaled::new(exchange.largest(own)).exponent;
        let power = if power.abs() > 300 { power } else { 0 };
        if power != 0 {
            exchange.scale(power);
            if let Some(bounds) = &mut errors {
                bounds.scale(power);
            }
            let ExchangeRows {
                own,
                own_bounds,
                open_areas,
            } = &mut rows;
            let areas = open_areas.iter_mut().flatten();
            for value in own.iter_mut().chain(own_bounds).chain(areas) {
                *value = Scaled::new(*value).times_power(power);
            }
        }
        let system = Self::try_new(exchange, errors, rows, reflectances)?;
        Ok(Self { power, ..system })
    }
}

/// The entries of a matrix below its diagonal, if it is symmetric and of this order.
fn packed(exchange: &DMatrix<f64>, expected: usize) -> Result<Symmetric<f64>, TransportError> {
    let (rows, columns) = exchange.shape();
    for (what, found) in [
        ("rows of exchange areas", rows),
        ("columns of exchange areas", columns),
    ] {
        check_count(what, found, expected)?;
    }
    let mut values = Symmetric::filled(expected, 0.0);
    let mut to_fill = values.rows_mut();
    for column in 0..columns {
        for row in 0..=column {
            let value = exchange[(row, column)];
            let is_symmetric = value.to_bits() == exchange[(column, row)].to_bits();
            if !(value.is_finite() && value >= 0.0 && is_symmetric) {
                return Err(TransportError::InvalidExchange { row, column, value });
            }
            if row < column {
                to_fill[column][row] = value;
            }
        }
    }
    Ok(values)
}
