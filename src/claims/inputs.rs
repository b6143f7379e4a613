//! The named numbers a claim is computed from.

use super::ClaimError;
use std::collections::BTreeMap;

/// Named numbers, from the claim's data.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(transparent)]
pub struct Inputs(BTreeMap<String, f64>);

impl Inputs {
    /// The number under a name.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn number(&self, name: &'static str) -> Result<f64, ClaimError> {
        self.0.get(name).copied().ok_or_else(|| ClaimError::Input {
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
        changed
            .0
            .extend(changes.0.iter().map(|(name, value)| (name.clone(), *value)));
        changed
    }

    pub(super) fn take(&mut self, name: &str) -> Option<f64> {
        self.0.remove(name)
    }
}
