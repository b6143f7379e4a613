//! The named numbers a claim is computed from.

use super::ClaimError;
use crate::numeric::Interval;
use std::collections::BTreeMap;

/// Named numbers, from the claim's data, and the precision that enclosures are asked for.
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(from = "BTreeMap<String, f64>")]
pub struct Inputs {
    numbers: BTreeMap<String, f64>,
    bits: u32,
}

/// Bits of an enclosure's ends if nothing else is asked for: some 57 digits, of which the longest
/// computation of the registry leaves more than 30 certain (`enclosures_are_narrow`).
pub const DEFAULT_PRECISION: u32 = 192;

impl From<BTreeMap<String, f64>> for Inputs {
    fn from(numbers: BTreeMap<String, f64>) -> Self {
        let bits = DEFAULT_PRECISION;
        Self { numbers, bits }
    }
}

impl Default for Inputs {
    fn default() -> Self {
        Self::from(BTreeMap::new())
    }
}

impl Inputs {
    /// The number under a name.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn number(&self, name: &'static str) -> Result<f64, ClaimError> {
        self.numbers
            .get(name)
            .copied()
            .ok_or_else(|| ClaimError::Input {
                name,
                reason: "is missing".to_owned(),
            })
    }

    /// The whole number ≥ 0 under a name.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none, or it is not whole, or beyond a million.
    pub fn count(&self, name: &'static str) -> Result<u32, ClaimError> {
        let value = self.number(name)?;
        if value.fract().abs() > 0.0 || !(0.0..=1e6).contains(&value) {
            let reason = format!("is {value}: a whole number up to a million is needed");
            return Err(ClaimError::Input { name, reason });
        }
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole and within 0 … 1e6"
        )]
        Ok(value as u32)
    }

    /// Is the switch under a name on (not 0)?
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn switch(&self, name: &'static str) -> Result<bool, ClaimError> {
        Ok(self.number(name)?.abs() > 0.0)
    }

    /// These inputs, with those of `changes` in place of their namesakes.
    #[must_use]
    pub fn changed_by(&self, changes: &Self) -> Self {
        let mut changed = self.clone();
        let changes = changes.numbers.iter();
        changed
            .numbers
            .extend(changes.map(|(name, value)| (name.clone(), *value)));
        changed
    }

    /// These inputs, with enclosures of `bits` bits asked for.
    #[must_use]
    pub fn with_precision(mut self, bits: u32) -> Self {
        self.bits = bits;
        self
    }

    /// Bits of the enclosures asked for.
    #[must_use]
    pub const fn bits(&self) -> u32 {
        self.bits
    }

    /// The number under a name as an interval: exactly the double that the claim's data hold.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn interval(&self, name: &'static str) -> Result<Interval, ClaimError> {
        Ok(Interval::precise(self.number(name)?, self.bits))
    }

    /// Is nothing named?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    pub(super) fn take(&mut self, name: &str) -> Option<f64> {
        self.numbers.remove(name)
    }
}
