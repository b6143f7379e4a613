//! Exchange areas that are held, all pairs of them.

use super::ExchangeOperator;
use super::products::Products;
use crate::exchange::ExchangeError;
use crate::numeric::{DoubleDouble, Scaled, Symmetric};
use std::borrow::Cow;

/// Exchange areas that are held, all pairs of them.
#[derive(Debug, Clone)]
pub struct DenseExchange<'e>(Cow<'e, Symmetric<f64>>);

impl<'e> From<&'e Symmetric<f64>> for DenseExchange<'e> {
    fn from(values: &'e Symmetric<f64>) -> Self {
        Self(Cow::Borrowed(values))
    }
}

impl From<Symmetric<f64>> for DenseExchange<'_> {
    fn from(values: Symmetric<f64>) -> Self {
        Self(Cow::Owned(values))
    }
}

impl ExchangeOperator for DenseExchange<'_> {
    fn order(&self) -> usize {
        self.0.order()
    }

    fn differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        Products(&*self.0).differences(x)
    }

    fn absolute_differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError> {
        Products(&*self.0).absolute_differences(x)
    }

    fn gathered(&self, x: &[f64]) -> Result<Vec<DoubleDouble>, ExchangeError> {
        Products(&*self.0).gathered(x)
    }

    fn precise_differences(&self, x: &[DoubleDouble]) -> Result<Vec<DoubleDouble>, ExchangeError> {
        Products(&*self.0).precise_differences(x)
    }
}

impl DenseExchange<'_> {
    /// The exchange area of two different rows.
    pub(super) fn get(&self, i: usize, j: usize) -> f64 {
        *self.0.get(i, j)
    }

    /// The largest entry, or `least` if that is larger.
    pub(super) fn largest(&self, least: f64) -> f64 {
        self.0.entries().iter().copied().fold(least, f64::max)
    }

    /// Multiplies all entries by `2^power`.
    pub(super) fn scale(&mut self, power: i32) {
        for value in self.0.to_mut().entries_mut() {
            *value = Scaled::new(*value).times_power(power);
        }
    }
}
