//! Light between patches that reflect a part of it, in equilibrium.
//!
//! ```text
//!   Σ_j J_ij (B_i − B_j) + e_i B_i + A_i ((1−R_i)/R_i) B_i = A_i E_i / R_i         R_i > 0
//!   B_i = E_i                                                                     R_i = 0
//! ```
//!
//! with exchange areas `J_ij = A_i F_ij` and `e_i = A_i − Σ_j J_ij` of what escapes. In a closed scene e is 0 by construction, with
//! `A_i = Σ_j J_ij`: the usual form `B = E + R F B` moves B by δ/(1−R) when a row sum is off by δ, this one does not.
//!
//! **Solution**: conjugate gradients, the residual anew with 106 bits, and again for what is left.
//!
//! **Error of the solution**, a *bound*, of each B_i relative to itself. The matrix M has an inverse without negative
//! entries. With its diagonal D, its other entries −D T and right sides b, light that bounced less than K times is
//! `C = Σ_{k<K} T^k D⁻¹b`. For a residual r of B̂ with its rounding ρ,
//!
//! ```text
//!   S = Σ_{k<K} T^k D⁻¹(|r| + ρ) ≤ τ C   ⇒   |B − B̂| ≤ M⁻¹(|r| + ρ) = Σ_m T^Km S ≤ τ Σ_m T^Km C = τ B
//! ```
//!
//! K is large enough for C to reach every patch that light can reach.
//!
//! **Error of the form factors**, a *bound* too. If each J_ij is right within δ_ij, the exact B* solves `M*(B* − B) = f` with
//!
//! ```text
//!   |f_i| ≤ Σ_j δ_ij |B_i − B_j| + δA_i |(1−R_i) B_i − E_i|/R_i = g_i(B)     (closed; open: Σ_j δ_ij B_j)
//! ```
//!
//! and any x with `M x − g(x) ≥ θ g(B)`, θ > 0, gives `|B* − B| ≤ x/θ`. Signs of f are not used, so that it is pessimistic
//! by up to 1/(1−R).

use super::TransportError;
use super::error::SMALLEST_REFLECTANCE;
use super::flows::{Flows, start};
use crate::numeric::{DoubleDouble, Scaled};
use crate::scene::{Closure, ExchangeAreas, Material};
use nalgebra::DMatrix;
use std::borrow::Cow;

/// What patches exchange and reflect.
#[derive(Debug, Clone)]
pub struct Interreflection<'e> {
    /// Exchange areas, packed by columns above the diagonal.
    pub(super) values: Cow<'e, [f64]>,
    /// The bounds on their errors; none where they count as exact.
    pub(super) error_bounds: Option<Cow<'e, [f64]>>,
    /// `Σ_j δ_ij`.
    pub(super) row_bounds: Vec<f64>,
    /// What each patch exchanges with itself.
    pub(super) own: Vec<f64>,
    /// The sum of the row if nothing escapes, else the area.
    pub(super) areas: Vec<DoubleDouble>,
    /// What escapes, as an area; `None` of a row that sums to the area.
    pub(super) escaping: Vec<Option<DoubleDouble>>,
    pub(super) reflectances: Vec<f64>,
    /// `e + A (1−R)/R`; 0 for patches that reflect nothing.
    pub(super) excess: Vec<f64>,
    /// The diagonal D; 0 for patches that reflect nothing.
    pub(super) diagonal: Vec<f64>,
}

/// Radiosity, or reflected importance: what leaves the patches, per area.
#[derive(Debug, Clone, PartialEq)]
pub struct Brightness {
    /// `B_i ≥ 0`, in the unit of the sources.
    pub values: Vec<f64>,
    /// What arrives, `H_i = Σ_j F_ij B_j`: the irradiance.
    pub received: Vec<f64>,
    /// A bound on `|error of B_i|/B_i`, for the exchange areas as given.
    pub relative_error: f64,
    /// Bounds on the errors of B_i that the exchange areas' own bring; none where no bound is known.
    pub form_factor_errors: Option<Vec<f64>>,
    /// The largest `|B_i − E_i − R_i H_i|/B_i`.
    pub residual: f64,
    /// Products with the matrix.
    pub iterations: usize,
}

/// How much the patches matter to those who look.
#[derive(Debug, Clone, PartialEq)]
pub struct Importance {
    /// `I_i ≥ 0`, in the unit of V.
    pub values: Vec<f64>,
    /// The reflected importance `U = R I`, and with `received` what comes from others, `I − V`.
    pub reflected: Brightness,
}

impl<'e> Interreflection<'e> {
    /// The patches of a scene; it is closed if every row of form factors sums to one within its bounds.
    ///
    /// # Errors
    /// [`TransportError::WrongCount`] unless there is a material for each patch; [`TransportError::ReflectanceTooSmall`];
    /// [`TransportError::Exchange`] if a row is above one, as where patches hide each other and
    /// occlusion was ignored.
    pub fn of(exchange: &'e ExchangeAreas, materials: &[Material]) -> Result<Self, TransportError> {
        let reflectances: Vec<f64> = materials.iter().map(Material::reflectance).collect();
        let count = exchange.patches();
        let closure = Closure::of_held(exchange);
        closure.require_at_most_one()?;
        let own = (0..count).map(|i| exchange.get(i, i).exchange);
        let (own, own_bounds): (Vec<f64>, Vec<f64>) =
            own.map(|own| (own.value, own.error_bound)).unzip();
        let open = |i: usize| (closure.escaping(i) > 0.0).then(|| exchange.areas()[i]);
        Self::new(
            Cow::Borrowed(exchange.values()),
            Some((Cow::Borrowed(exchange.error_bounds()), own_bounds)),
            own,
            (0..count).map(open).collect(),
            reflectances,
        )
    }

    /// A closed scene with these exchange areas `A_i F_ij`, taken as exact; the areas are their row sums.
    ///
    /// # Errors
    /// [`TransportError::InvalidExchange`] unless the matrix is finite, ≥ 0 and equal to its transpose;
    /// [`TransportError::WrongCount`] unless it has a row and a column for each reflectance;
    /// [`TransportError::ReflectanceOutOfRange`], [`TransportError::ReflectanceTooSmall`].
    pub fn of_matrix(
        exchange: &DMatrix<f64>,
        reflectances: Vec<f64>,
    ) -> Result<Interreflection<'static>, TransportError> {
        let expected = reflectances.len();
        let (rows, columns) = exchange.shape();
        for (what, found) in [
            ("rows of exchange areas", rows),
            ("columns of exchange areas", columns),
        ] {
            if found != expected {
                return Err(TransportError::WrongCount {
                    what,
                    found,
                    expected,
                });
            }
        }
        let mut values = Vec::with_capacity(start(rows));
        for column in 0..columns {
            for row in 0..=column {
                let value = exchange[(row, column)];
                let is_symmetric = value.to_bits() == exchange[(column, row)].to_bits();
                if !(value.is_finite() && value >= 0.0 && is_symmetric) {
                    return Err(TransportError::InvalidExchange { row, column, value });
                }
                if row < column {
                    values.push(value);
                }
            }
        }
        let own = exchange.diagonal().iter().copied().collect();
        Interreflection::new(
            Cow::Owned(values),
            None,
            own,
            vec![None; rows],
            reflectances,
        )
    }

    fn new(
        mut values: Cow<'e, [f64]>,
        bounds: Option<(Cow<'e, [f64]>, Vec<f64>)>,
        mut own: Vec<f64>,
        mut open: Vec<Option<f64>>,
        reflectances: Vec<f64>,
    ) -> Result<Self, TransportError> {
        let count = own.len();
        if reflectances.len() != count {
            return Err(TransportError::WrongCount {
                what: "materials",
                found: reflectances.len(),
                expected: count,
            });
        }
        for (patch, value) in reflectances.iter().copied().enumerate() {
            if !(0.0..1.0).contains(&value) {
                return Err(TransportError::ReflectanceOutOfRange { patch, value });
            }
            if value > 0.0 && value < SMALLEST_REFLECTANCE {
                return Err(TransportError::ReflectanceTooSmall { patch, value });
            }
        }
        let (mut error_bounds, mut own_bounds) = match bounds {
            Some((bounds, own)) => (Some(bounds), own),
            None => (None, vec![0.0; count]),
        };
        // in units in which neither products nor their low halves leave f64
        let largest = values.iter().chain(&own).copied().fold(0.0, f64::max);
        let power = -Scaled::new(largest).exponent;
        if power.abs() > 300 {
            let lists = [values.to_mut(), &mut own, &mut own_bounds];
            let others = error_bounds.as_mut().map(Cow::to_mut);
            let entries = lists.into_iter().chain(others).flatten();
            for value in entries.chain(open.iter_mut().flatten()) {
                *value = Scaled::new(*value).times_power(power);
            }
        }
        let flows = Flows {
            count,
            values: &values,
        };
        let sums = flows.gathered(&vec![1.0; count]);
        let row_bounds = match &error_bounds {
            Some(bounds) => {
                let bounds = Flows {
                    count,
                    values: bounds,
                };
                let sums = bounds.gathered(&vec![1.0; count]);
                sums.iter()
                    .zip(&own_bounds)
                    .map(|(a, b)| a.high() + b)
                    .collect()
            }
            None => own_bounds,
        };
        let rows = sums.iter().zip(&own);
        let rows = rows.map(|(sum, own)| *sum + DoubleDouble::from(*own));
        let (areas, escaping): (Vec<_>, Vec<_>) = rows
            .zip(open)
            .map(|(row, open)| {
                let area = open.map(DoubleDouble::from);
                (area.unwrap_or(row), area.map(|area| area - row))
            })
            .unzip();
        let reflects = |i: usize| reflectances[i] > 0.0;
        let excess = |i: usize| {
            if !reflects(i) {
                return 0.0;
            }
            let absorbed = areas[i].high() * ((1.0 - reflectances[i]) / reflectances[i]);
            absorbed + escaping[i].map_or(0.0, DoubleDouble::high)
        };
        let excess: Vec<f64> = (0..count).map(excess).collect();
        let diagonal = |i: usize| {
            if reflects(i) {
                sums[i].high() + excess[i]
            } else {
                0.0
            }
        };
        let diagonal = (0..count).map(diagonal).collect();
        Ok(Self {
            values,
            error_bounds,
            row_bounds,
            own,
            areas,
            escaping,
            reflectances,
            excess,
            diagonal,
        })
    }
}
