//! Light between patches that reflect a part of it, in equilibrium.
//!
//! ```text
//!   Σ_j J_ij (B_i − B_j) + e_i B_i + A_i ((1−R_i)/R_i) B_i = A_i E_i / R_i         R_i > 0
//!   B_i = E_i                                                                     R_i = 0
//! ```
//!
//! with exchange areas `J_ij = A_i F_ij` and `e_i = A_i − Σ_j J_ij` of what escapes. Patches with
//! `R_i = 1` absorb nothing; what they reflect ends elsewhere, or the system is refused
//! ([`sinks`]). In a closed scene e is 0 by construction, with `A_i = Σ_j J_ij`: the usual form
//! `B = E + R F B` moves B by δ/(1−R) when a row sum is off by δ, this one does not.
//!
//! **Solution**: conjugate gradients, the residual anew with 106 bits, and again for the remainder.
//!
//! **Error of the solution**, a *bound*, of each B_i relative to itself. The matrix M has an
//! inverse without negative entries, as all light comes to a sink. With its diagonal D, its other
//! entries −D T and right sides b, light that bounced less than K times is `C = Σ_{k<K} T^k D⁻¹b`.
//! For a residual r of B̂ with its rounding ρ,
//!
//! ```text
//!   S = Σ_{k<K} T^k D⁻¹(|r| + ρ) ≤ τ C
//!     ⇒   |B − B̂| ≤ M⁻¹(|r| + ρ) = Σ_m T^Km S ≤ τ Σ_m T^Km C = τ B
//! ```
//!
//! K is large enough for C to reach every patch that light can reach.
//!
//! **Error of the form factors**, a *bound* too. If each J_ij is right within δ_ij, the exact B*
//! solves `M*(B* − B) = f` with
//!
//! ```text
//!   |f_i| ≤ Σ_j δ_ij |B_i − B_j| + δA_i |(1−R_i) B_i − E_i|/R_i = g_i(B)     (closed)
//!   |f_i| ≤ Σ_j δ_ij B_j + δ_ii B_i = g_i(B)                                (open)
//! ```
//!
//! and any x with `M x − g(x) ≥ θ g(B)`, θ > 0, gives `|B* − B| ≤ x/θ`, as M* has an inverse
//! without negative entries, too. Signs of f are not used, so that it is pessimistic by up to
//! 1/(1−R).
//!
//! [`sinks`]: super::sinks

use super::error::SMALLEST_REFLECTANCE;
use super::sinks::Sinkless;
use super::{DenseExchange, ExchangeOperator, TransportError};
use crate::exchange::{Closure, ExchangeAreas, ResolutionErrors};
use crate::numeric::{DoubleDouble, Scaled, Symmetric};
use crate::scene::Material;
use nalgebra::DMatrix;

/// The linear system of radiosity, over exchange areas that are known by their products.
#[derive(Debug, Clone)]
pub struct RadiositySystem<O> {
    /// Exchange areas off the diagonal.
    pub(super) exchange: O,
    /// The bounds on their errors; none where they count as exact.
    pub(super) errors: Option<O>,
    /// `Σ_j δ_ij`.
    pub(super) row_bounds: Vec<f64>,
    /// The power of two by which exchange areas were scaled.
    pub(super) power: i32,
    /// The bounds on the areas of open rows that count beside them; 0 for the rounding of areas.
    pub(super) open_area_bounds: Vec<f64>,
    /// The exchange area of each patch with itself.
    pub(super) own: Vec<f64>,
    /// The bounds on their errors.
    pub(super) own_bounds: Vec<f64>,
    /// The sum of the row if nothing escapes, else the area.
    pub(super) areas: Vec<DoubleDouble>,
    /// The escaping part, as an area; `None` for a row that sums to the area.
    pub(super) escaping: Vec<Option<DoubleDouble>>,
    pub(super) reflectances: Vec<f64>,
    /// `e + A (1−R)/R`; 0 for patches that reflect nothing.
    pub(super) excess: Vec<f64>,
    /// The diagonal D; 0 for patches that reflect nothing.
    pub(super) diagonal: Vec<f64>,
}

/// A solution of the system: radiosities, or reflected importances.
#[derive(Debug, Clone, PartialEq)]
pub struct RadiositySolution {
    /// `B_i ≥ 0`, in the unit of the sources.
    pub values: Vec<f64>,
    /// The irradiance `H_i = Σ_j F_ij B_j`.
    pub received: Vec<f64>,
    /// A bound on `|error of B_i|/B_i`, for the exchange areas as given.
    pub relative_error: f64,
    /// Bounds on the errors of B_i that the exchange areas' own bring; none where no bound is
    /// known.
    pub form_factor_errors: Option<Vec<f64>>,
    /// The largest `|B_i − E_i − R_i H_i|/B_i`.
    pub residual: f64,
    /// Products with the matrix.
    pub iterations: usize,
}

/// The importance of patches: the part of what they emit that reaches those who look.
#[derive(Debug, Clone, PartialEq)]
pub struct Importance {
    /// `I_i ≥ 0`, in the unit of V.
    pub values: Vec<f64>,
    /// The reflected importance `U = R I`, and with `received` what comes from others, `I − V`.
    pub reflected: RadiositySolution,
}

/// The diagonal and the areas: what the products with exchange areas leave out.
#[derive(Debug, Clone)]
pub struct ExchangeRows {
    /// The exchange areas of the rows with themselves.
    pub own: Vec<f64>,
    /// The bounds on their errors.
    pub own_bounds: Vec<f64>,
    /// The area of each row from which something escapes.
    pub open_areas: Vec<Option<f64>>,
}

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
    #[must_use]
    pub fn resolution_errors(
        &self,
        bounds: &'e ResolutionErrors,
        values: &[f64],
        sources: &[f64],
    ) -> Option<Vec<f64>> {
        let exchange = DenseExchange::from(bounds.exchange());
        let sums = exchange.gathered(&vec![1.0; bounds.own().len()]);
        let sums = sums.iter().zip(bounds.own());
        let mut system = Self {
            errors: Some(exchange),
            row_bounds: sums.map(|(sum, own)| sum.high() + own).collect(),
            open_area_bounds: bounds.areas().to_vec(),
            ..self.clone()
        };
        let power = self.power;
        if power != 0 {
            if let Some(errors) = &mut system.errors {
                errors.scale(power);
            }
            let bounds = system
                .row_bounds
                .iter_mut()
                .chain(&mut system.open_area_bounds);
            for bound in bounds {
                *bound = Scaled::new(*bound).times_power(power);
            }
        }
        let known = system.form_factor_errors(values, sources);
        let most = system.brightest(sources);
        if known.is_none() && most.is_infinite() {
            return None;
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
        Some(bounds.collect())
    }

    /// The radiosity of a closed room all of whose patches emit and reflect the most of any;
    /// infinite if that reflects all.
    fn brightest(&self, sources: &[f64]) -> f64 {
        let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        largest(sources) / (1.0 - largest(&self.reflectances)).max(0.0)
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

impl<O: ExchangeOperator> RadiositySystem<O> {
    /// The system of these exchange areas and the bounds on their errors, none where they count as
    /// exact.
    ///
    /// # Errors
    /// [`TransportError::WrongCount`] unless there is a reflectance, an own exchange area with its
    /// bound and an area or none for each row; [`TransportError::ReflectanceOutOfRange`],
    /// [`TransportError::ReflectanceTooSmall`], [`TransportError::NoSink`].
    pub fn try_new(
        exchange: O,
        errors: Option<O>,
        rows: ExchangeRows,
        reflectances: Vec<f64>,
    ) -> Result<Self, TransportError> {
        check_count("own exchange areas", rows.own.len(), exchange.order())?;
        check_count("bounds", rows.own_bounds.len(), exchange.order())?;
        check_count("areas", rows.open_areas.len(), exchange.order())?;
        check_reflectances(&reflectances, exchange.order())?;
        let ones = vec![1.0; exchange.order()];
        let sums = exchange.gathered(&ones);
        let row_bounds: Vec<f64> = match &errors {
            Some(bounds) => {
                let sums = bounds.gathered(&ones);
                let sums = sums.iter().zip(&rows.own_bounds);
                sums.map(|(sum, own)| sum.high() + own).collect()
            }
            None => rows.own_bounds.clone(),
        };
        let (areas, escaping): (Vec<_>, Vec<_>) = sums
            .iter()
            .zip(&rows.own)
            .zip(&rows.open_areas)
            .map(|((sum, own), open)| {
                let row = *sum + DoubleDouble::from(*own);
                let area = open.map(DoubleDouble::from);
                (area.unwrap_or(row), area.map(|area| area - row))
            })
            .unzip();
        if reflectances.iter().any(|reflectance| *reflectance >= 1.0) {
            let is_sink = |i: usize| {
                let escaping = escaping[i].map_or(0.0, DoubleDouble::high);
                // what sees nothing has the brightness that it emits
                reflectances[i] < 1.0 || escaping > row_bounds[i] || areas[i].high() <= 0.0
            };
            let sinks = (0..areas.len()).map(is_sink).collect();
            if let Some(group) = Sinkless::of(&exchange, errors.as_ref(), sinks) {
                return Err(TransportError::NoSink { group });
            }
        }
        let excess = excess(&reflectances, &areas, &escaping);
        let diagonal = reflectances.iter().zip(&sums).zip(&excess);
        let diagonal = diagonal.map(|((reflectance, sum), excess)| {
            if *reflectance > 0.0 {
                sum.high() + excess
            } else {
                0.0
            }
        });
        Ok(Self {
            diagonal: diagonal.collect(),
            exchange,
            errors,
            row_bounds,
            power: 0,
            open_area_bounds: vec![0.0; rows.own.len()],
            own: rows.own,
            own_bounds: rows.own_bounds,
            areas,
            escaping,
            reflectances,
            excess,
        })
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

const fn check_count(
    what: &'static str,
    found: usize,
    expected: usize,
) -> Result<(), TransportError> {
    if found == expected {
        return Ok(());
    }
    Err(TransportError::WrongCount {
        what,
        found,
        expected,
    })
}

fn check_reflectances(reflectances: &[f64], expected: usize) -> Result<(), TransportError> {
    check_count("materials", reflectances.len(), expected)?;
    for (patch, value) in reflectances.iter().copied().enumerate() {
        if !(0.0..=1.0).contains(&value) {
            return Err(TransportError::ReflectanceOutOfRange { patch, value });
        }
        if value > 0.0 && value < SMALLEST_REFLECTANCE {
            return Err(TransportError::ReflectanceTooSmall { patch, value });
        }
    }
    Ok(())
}

/// `e + A (1−R)/R`; 0 for patches that reflect nothing.
fn excess(
    reflectances: &[f64],
    areas: &[DoubleDouble],
    escaping: &[Option<DoubleDouble>],
) -> Vec<f64> {
    let rows = reflectances.iter().zip(areas).zip(escaping);
    rows.map(|((reflectance, area), escaping)| {
        if *reflectance <= 0.0 {
            return 0.0;
        }
        let absorbed = area.high() * ((1.0 - reflectance) / reflectance);
        absorbed + escaping.map_or(0.0, DoubleDouble::high)
    })
    .collect()
}
