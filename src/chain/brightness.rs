//! The chains of radiosity (§3.4) and of importance (§3.5): exchange areas, weighted with a
//! brightness on either side.
//!
//! ```text
//!   J_ij = β_i A_i F_ij β_j,    w_i = A_i β_i Σ_j F_ij β_j,    P_ij = F_ij β_j / Σ_k F_ik β_k
//!
//!   β = 1     visibility:  w = A,              P = F
//!   β = B     radiosity:   w = A B (B−E)/R,    P_ij = R_i F_ij B_j/(B_i−E_i)
//!   β = R I   importance:  w = A R I (I−V),    P_ij = R_j F_ij I_j/(I_i−V_i)
//! ```
//!
//! The paper calls w the generalised area. Here it is computed from the irradiance
//! `H_i = Σ_j F_ij B_j`, which is `(B_i−E_i)/R_i`, and exists for a light that reflects nothing,
//! too. Light that escapes meets no patch again and has no state.
//!
//! **Not covered**: a brightness that varies over a patch.

use super::error::ChainError;
use super::reversible::ReversibleChain;
use crate::exchange::ExchangeAreas;
use crate::numeric::Scaled;
use nalgebra::DMatrix;

/// The chain of a scene under one brightness per patch: radiosities, or importances times
/// reflectances.
///
/// The joint matrix is in units of the largest brightness squared; products below 1e-308 of that
/// are lost.
///
/// # Errors
/// [`ChainError::WrongShape`] unless there is one for each patch; [`ChainError::InvalidWeight`] if
/// one is negative or not finite; [`ChainError::NoMass`] if no light goes from one patch to
/// another.
///
/// # Examples
/// ```
/// use infoscene::chain::brightness_chain;
/// use infoscene::scene::Scene;
/// // two squares at 90°, one twice as bright: all the light of one goes to the other
/// let squares = Scene::built_in("two-squares")?.exchange_areas()?;
/// let chain = brightness_chain(&squares, &[2.0, 1.0])?;
/// assert_eq!(chain.transition_probability(0, 1), 1.0);
/// assert_eq!(chain.stationary_probability(0), 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn brightness_chain(
    exchange: &ExchangeAreas,
    brightness: &[f64],
) -> Result<ReversibleChain, ChainError> {
    let n = exchange.rows();
    let (scaled, _) = in_unit(brightness, n)?;
    ReversibleChain::try_new(DMatrix::from_fn(n, n, |i, j| {
        // one order of factors for (i, j) and (j, i): a product of three rounds differently in
        // another
        let (i, j) = (i.min(j), i.max(j));
        scaled[i] * scaled[j] * exchange.get(i, j).exchange.value
    }))
}

/// Brightnesses of so many rows in units of a power of two that brings the largest near 1, and its
/// exponent.
///
/// # Errors
/// As [`brightness_chain`], unless there is no mass.
pub(crate) fn in_unit(brightness: &[f64], n: usize) -> Result<(Vec<f64>, i32), ChainError> {
    if brightness.len() != n {
        return Err(ChainError::WrongShape {
            what: "the list of brightnesses",
            found: brightness.len(),
            expected: n,
        });
    }
    let wrong = |value: &f64| !(value.is_finite() && *value >= 0.0);
    if let Some(state) = brightness.iter().position(wrong) {
        return Err(ChainError::InvalidWeight {
            state,
            value: brightness[state],
        });
    }
    let largest = brightness.iter().copied().fold(0.0, f64::max);
    let power = -Scaled::new(largest).exponent;
    let scaled: Vec<f64> = brightness
        .iter()
        .map(|value| Scaled::new(*value).times_power(power))
        .collect();
    Ok((scaled, power))
}
