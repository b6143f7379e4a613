//! One case to compute: the inputs of a claim, or of its control, in a context.

use super::{ClaimError, Context, Inputs};
use crate::discretize::CertifiedGrid;
use crate::numeric::Interval;

/// The inputs of one computation, and the context that it shares with others.
#[derive(Debug, Clone)]
pub struct Case<'c> {
    inputs: Inputs,
    context: &'c Context,
}

impl<'c> Case<'c> {
    /// Constructs a case.
    #[must_use]
    pub const fn new(inputs: Inputs, context: &'c Context) -> Self {
        Self { inputs, context }
    }

    /// The number under a name.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn number(&self, name: &'static str) -> Result<f64, ClaimError> {
        self.inputs.number(name)
    }

    /// The whole number ≥ 0 under a name.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none, or it is not whole, or beyond a million.
    pub fn count(&self, name: &'static str) -> Result<u32, ClaimError> {
        self.inputs.count(name)
    }

    /// Whether the switch under a name is on.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn switch(&self, name: &'static str) -> Result<bool, ClaimError> {
        self.inputs.switch(name)
    }

    /// The number under a name as an interval: exactly the double that the claim's data hold.
    ///
    /// # Errors
    /// [`ClaimError::Input`] if there is none.
    pub fn interval(&self, name: &'static str) -> Result<Interval, ClaimError> {
        Ok(Interval::precise(self.number(name)?, self.bits()))
    }

    /// Bits of the enclosures asked for.
    #[must_use]
    pub const fn bits(&self) -> u32 {
        self.context.bits()
    }

    /// The certified best grid of the unit cube with so many cells a side.
    ///
    /// # Errors
    /// [`ClaimError::Discretize`] if it is not found.
    pub fn best_grid(&self, cells: u32) -> Result<CertifiedGrid, ClaimError> {
        self.context.best_grid(cells)
    }
}
