//! Sinks of light: patches that absorb some of it, and openings.
//!
//! ```text
//!   patch i is a sink:   R_i < 1,  or  e_i > Σ_j δ_ij
//!   i exchanges with j:  J_ij > δ_ij
//! ```
//!
//! Rows of the matrix M with `R_i = 1` and `e_i = 0` sum to 0. M is regular, with an inverse
//! without negative entries, if and only if each of its patches comes to a sink by steps of
//! exchange (symmetric, weakly diagonally dominant, and strictly so in each connected part). Both
//! conditions are asked with the bounds δ, so that they hold for the exact exchange areas, too: the
//! bounds of a solution then hold as they do for R < 1. Patches that come to no sink share a
//! brightness that nothing determines.
//!
//! The patches that come to a sink are found set by set: patch i joins if
//! `Σ_j J_ij > Σ_j δ_ij` over the set, as then one of the terms is.
//!
//! # Source
//! Berman, Plemmons, *Nonnegative Matrices in the Mathematical Sciences*, SIAM 1994, chapter 6.

use super::ExchangeOperator;
use crate::exchange::ExchangeError;
use crate::numeric::DoubleDouble;
use std::fmt;

/// Patches that reflect all light and pass it on to no other patch for certain.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sinkless {
    /// The indices of the patches, in order.
    pub patches: Vec<usize>,
    /// The names of the patches, if they are known.
    pub names: Vec<String>,
}

/// Patches that a message lists.
const MOST_LISTED: usize = 8;

/// The rounding of two sums of numbers ≥ 0, compared.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl Sinkless {
    /// One connected group of patches that come to no sink, if there is one.
    pub(super) fn of<O: ExchangeOperator>(
        exchange: &O,
        errors: Option<&O>,
        is_sink: Vec<bool>,
    ) -> Result<Option<Self>, ExchangeError> {
        let certain = |reached: &[f64]| {
            let gained = exchange.gathered(reached)?;
            let noise = errors.map(|errors| errors.gathered(reached));
            let noise = noise.transpose()?;
            let noise = |i: usize| noise.as_ref().map_or(0.0, |noise| noise[i].high());
            let rows = gained.into_iter().map(DoubleDouble::high).enumerate();
            Ok(rows
                .map(|(i, gained)| gained > noise(i) * (1.0 + ROUNDING))
                .collect())
        };
        let reached = grown(is_sink, certain)?;
        let Some(first) = reached.iter().position(|is_reached| !is_reached) else {
            return Ok(None);
        };
        let start = (0..reached.len()).map(|i| i == first).collect();
        let group = grown(start, |set| {
            let met = exchange.gathered(set)?.into_iter().zip(&reached);
            Ok(met
                .map(|(gained, is_reached)| gained.high() > 0.0 && !is_reached)
                .collect())
        })?;
        let patches = (0..group.len()).filter(|i| group[*i]).collect();
        let names = Vec::new();
        Ok(Some(Self { patches, names }))
    }

    /// The group with the names of its patches, out of those of all.
    pub(super) fn named(self, names: &[String]) -> Self {
        let of_patch = |patch: &usize| names.get(*patch).cloned();
        let names = self.patches.iter().filter_map(of_patch).collect();
        Self { names, ..self }
    }
}

/// The set that grows from this one by all patches that `next` says, as long as some are new.
fn grown(
    mut set: Vec<bool>,
    next: impl Fn(&[f64]) -> Result<Vec<bool>, ExchangeError>,
) -> Result<Vec<bool>, ExchangeError> {
    loop {
        let indicator: Vec<f64> = set
            .iter()
            .map(|is_in| f64::from(u8::from(*is_in)))
            .collect();
        let mut is_larger = false;
        for (is_in, joins) in set.iter_mut().zip(next(&indicator)?) {
            is_larger |= joins && !*is_in;
            *is_in |= joins;
        }
        if !is_larger {
            return Ok(set);
        }
    }
}

impl fmt::Display for Sinkless {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let several = if self.patches.len() == 1 { "" } else { "es" };
        write!(f, "patch{several}")?;
        for (place, patch) in self.patches.iter().take(MOST_LISTED).enumerate() {
            let comma = if place == 0 { "" } else { "," };
            write!(f, "{comma} {patch}")?;
            if let Some(name) = self.names.get(place) {
                write!(f, " ({name})")?;
            }
        }
        match self.patches.len().checked_sub(MOST_LISTED) {
            None | Some(0) => Ok(()),
            Some(more) => write!(f, " and {more} more"),
        }
    }
}
