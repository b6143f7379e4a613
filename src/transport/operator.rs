//! The products with exchange areas that a solution makes.
//!
//! ```text
//!   differences:  y_i = Σ_j J_ij (x_i − x_j)        gathered:  y_i = Σ_{j≠i} J_ij x_j
//! ```
//!
//! A solution reads the exchange areas through these alone: they may be held ([`DenseExchange`]),
//! stored or shared out among ranks ([`SceneExchange`]), or approximated by links between clusters.
//!
//! [`DenseExchange`]: super::DenseExchange
//! [`SceneExchange`]: super::SceneExchange

use crate::exchange::ExchangeError;
use crate::numeric::DoubleDouble;

/// Symmetric exchange areas `J_ij ≥ 0` without their diagonal, known by their products.
///
/// A product fails if the entries cannot be read, and ends the solution.
///
/// **Precondition** the entries are in units in which neither products of them nor the low halves
/// of such products leave `f64`.
pub trait ExchangeOperator: Sync {
    /// Number of rows.
    fn order(&self) -> usize;

    /// `Σ_j J_ij (x_i − x_j)`; exactly 0 for a constant x.
    ///
    /// # Errors
    /// [`ExchangeError::Unread`] if an entry cannot be read; [`ExchangeError::Rank`].
    fn differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError>;

    /// `Σ_j J_ij |x_i − x_j|`.
    ///
    /// # Errors
    /// [`ExchangeError::Unread`] if an entry cannot be read; [`ExchangeError::Rank`].
    fn absolute_differences(&self, x: &[f64]) -> Result<Vec<f64>, ExchangeError>;

    /// `Σ_{j≠i} J_ij x_j`: within ε/2 for x ≥ 0, and of `x = 1` all 106 bits.
    ///
    /// # Errors
    /// [`ExchangeError::Unread`] if an entry cannot be read; [`ExchangeError::Rank`].
    fn gathered(&self, x: &[f64]) -> Result<Vec<DoubleDouble>, ExchangeError>;

    /// `Σ_j J_ij (x_i − x_j)` with 106 bits.
    ///
    /// # Errors
    /// [`ExchangeError::Unread`] if an entry cannot be read; [`ExchangeError::Rank`].
    fn precise_differences(&self, x: &[DoubleDouble]) -> Result<Vec<DoubleDouble>, ExchangeError>;
}
