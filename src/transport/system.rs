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
use super::{ExchangeOperator, TransportError};
use crate::numeric::DoubleDouble;

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

impl<O: ExchangeOperator> RadiositySystem<O> {
    /// The system of these exchange areas and the bounds on their errors, none where they count as
    /// exact.
    ///
    /// # Errors
    /// [`TransportError::WrongCount`] unless there is a reflectance, an own exchange area with its
    /// bound and an area or none for each row; [`TransportError::ReflectanceOutOfRange`],
    /// [`TransportError::ReflectanceTooSmall`], [`TransportError::NoSink`];
    /// [`TransportError::Exchange`] if exchange areas cannot be read.
    pub fn try_new(
        exchange: O,
        errors: Option<O>,
        rows: ExchangeRows,
        reflectances: Vec<f64>,
    ) -> Result<Self, TransportError> {
        let ones = vec![1.0; exchange.order()];
        let sums = exchange.gathered(&ones)?;
        let bounds = errors.as_ref().map(|bounds| bounds.gathered(&ones));
        let bounds = bounds.transpose()?;
        Self::with_sums(
            exchange,
            errors,
            rows,
            reflectances,
            (&sums, bounds.as_deref()),
        )
    }

    /// The system of [`try_new`](Self::try_new), from the sums of the rows off the diagonal, and
    /// those of the bounds.
    pub(super) fn with_sums(
        exchange: O,
        errors: Option<O>,
        rows: ExchangeRows,
        reflectances: Vec<f64>,
        (sums, bounds): (&[DoubleDouble], Option<&[DoubleDouble]>),
    ) -> Result<Self, TransportError> {
        check_count("own exchange areas", rows.own.len(), exchange.order())?;
        check_count("bounds", rows.own_bounds.len(), exchange.order())?;
        check_count("areas", rows.open_areas.len(), exchange.order())?;
        check_reflectances(&reflectances, exchange.order())?;
        let row_bounds = match bounds {
            Some(bounds) => row_bounds(bounds, &rows.own_bounds),
            None => rows.own_bounds.clone(),
        };
        let (areas, escaping) = areas(sums, &rows);
        if reflectances.iter().any(|reflectance| *reflectance >= 1.0) {
            let is_sink = |i: usize| {
                let escaping = escaping[i].map_or(0.0, DoubleDouble::high);
                // what sees nothing has the brightness that it emits
                reflectances[i] < 1.0 || escaping > row_bounds[i] || areas[i].high() <= 0.0
            };
            let sinks = (0..areas.len()).map(is_sink).collect();
            if let Some(group) = Sinkless::of(&exchange, errors.as_ref(), sinks)? {
                return Err(TransportError::NoSink { group });
            }
        }
        let excess = excess(&reflectances, &areas, &escaping);
        let diagonal = reflectances.iter().zip(sums).zip(&excess);
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

pub(super) const fn check_count(
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

/// `Σ_j δ_ij`, from the sums off the diagonal.
pub(super) fn row_bounds(sums: &[DoubleDouble], own: &[f64]) -> Vec<f64> {
    let sums = sums.iter().zip(own);
    sums.map(|(sum, own)| sum.high() + own).collect()
}

/// The area of each row, and what escapes from it; `None` where nothing does.
fn areas(
    sums: &[DoubleDouble],
    rows: &ExchangeRows,
) -> (Vec<DoubleDouble>, Vec<Option<DoubleDouble>>) {
    let rows = rows.own.iter().zip(&rows.open_areas);
    sums.iter()
        .zip(rows)
        .map(|(sum, (own, open))| {
            let row = *sum + DoubleDouble::from(*own);
            let area = open.map(DoubleDouble::from);
            (area.unwrap_or(row), area.map(|area| area - row))
        })
        .unzip()
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
