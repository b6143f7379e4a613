//! The named inputs of a claim's computation.

use super::ClaimError;
use std::collections::BTreeMap;
use std::fmt;

/// One input: a number or a switch.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(untagged)]
enum Input {
    Switch(bool),
    Number(f64),
}

/// Named numbers and switches, from the claim's data.
#[derive(Debug, Clone, PartialEq, Default, serde::Deserialize)]
#[serde(transparent)]
pub struct Inputs {
    named: BTreeMap<String, Input>,
}

impl Inputs {
    /// The number under a name.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn number(&self, name: &'static str) -> Result<f64, ClaimError> {
        match self.input(name)? {
            Input::Number(value) => Ok(value),
            Input::Switch(_) => Err(wrong(name, "is a switch: a number is needed")),
        }
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
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole and within 0 … 1e6"
        )]
        Ok(value as u32)
    }

    /// Whether the switch under a name is on.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn switch(&self, name: &'static str) -> Result<bool, ClaimError> {
        match self.input(name)? {
            Input::Switch(is_on) => Ok(is_on),
            Input::Number(_) => Err(wrong(name, "is a number: true or false is needed")),
        }
    }

    fn input(&self, name: &'static str) -> Result<Input, ClaimError> {
        let input = self.named.get(name).copied();
        input.ok_or_else(|| wrong(name, "is missing"))
    }

    /// Replaces inputs by their namesakes in `changes`, and adds the others.
    #[must_use]
    pub fn changed_by(&self, changes: &Self) -> Self {
        let mut changed = self.clone();
        let changes = changes.named.iter();
        changed
            .named
            .extend(changes.map(|(name, input)| (name.clone(), *input)));
        changed
    }
}

impl fmt::Display for Inputs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (name, input)) in self.named.iter().enumerate() {
            let comma = if index == 0 { "" } else { ", " };
            match input {
                Input::Switch(is_on) => write!(f, "{comma}{name} = {is_on}")?,
                Input::Number(value) => write!(f, "{comma}{name} = {value}")?,
            }
        }
        Ok(())
    }
}

fn wrong(name: &'static str, reason: &str) -> ClaimError {
    let reason = reason.to_owned();
    ClaimError::Input { name, reason }
}
