//! Discrete solutions by point factors: what no bound rests upon, but what makes bounds small.
//!
//! ```text
//!   A_i (1/R_i − 1 + 1 − Σ_j F_ij) ψ_i + Σ_j S_ij (ψ_i − ψ_j) + Σ_black S_ij ψ_i = A_i g_i
//!   S_ij = (A_i F_ij + A_j F_ji)/2          F_ij: from the centre of leaf i
//! ```

use crate::numeric::conjugate_gradients;
use nalgebra::{DMatrix, DVector};
use std::convert::Infallible;

/// The residual at which the iteration ends, per right side.
const REDUCTION: f64 = 1e-5;
/// Most iterations.
const MOST: usize = 300;

/// The discrete operator on leaves.
#[derive(Debug, Clone)]
pub(super) struct DiscreteOperator {
    factors: DMatrix<f64>,
    exchange: DMatrix<f64>,
    diagonal: DVector<f64>,
    areas: Vec<f64>,
    reflects: Vec<bool>,
}

impl DiscreteOperator {
    /// The operator of leaves with these factors from centre to leaf, areas and reflectances; rows
    /// of leaves that reflect nothing count as empty.
    pub(super) fn new(factors: DMatrix<f64>, areas: Vec<f64>, reflectances: &[f64]) -> Self {
        let n = areas.len();
        let reflects: Vec<bool> = reflectances.iter().map(|r| *r > 0.0).collect();
        let exchange = DMatrix::from_fn(n, n, |i, j| match (reflects[i], reflects[j]) {
            (true, true) => 0.5 * (areas[i] * factors[(i, j)] + areas[j] * factors[(j, i)]),
            _ => 0.0,
        });
        let diagonal: Vec<f64> = (0..n)
            .map(|i| {
                if !reflects[i] {
                    return 1.0;
                }
                let kept: f64 = (0..n)
                    .filter(|j| reflects[*j])
                    .map(|j| factors[(i, j)])
                    .sum();
                let lost = (1.0 - kept).max(0.0);
                areas[i] * (1.0 / reflectances[i] - 1.0 + lost) + exchange.row(i).sum()
            })
            .collect();
        let diagonal = DVector::from_vec(diagonal);
        Self {
            factors,
            exchange,
            diagonal,
            areas,
            reflects,
        }
    }

    /// The irradiance at the centres.
    pub(super) fn irradiance(&self, values: &[f64]) -> DVector<f64> {
        &self.factors * DVector::from_column_slice(values)
    }

    /// About the solution for a right side; 0 where nothing is reflected.
    pub(super) fn solved(&self, right_side: &[f64]) -> Vec<f64> {
        let scaled = |(i, value): (usize, &f64)| {
            if self.reflects[i] {
                self.areas[i] * value
            } else {
                0.0
            }
        };
        let right_side: Vec<f64> = right_side.iter().enumerate().map(scaled).collect();
        let product = |x: &[f64]| -> Result<Vec<f64>, Infallible> {
            let x = DVector::from_column_slice(x);
            let image = x.component_mul(&self.diagonal) - &self.exchange * &x;
            Ok(image.as_slice().to_vec())
        };
        let diagonal = self.diagonal.as_slice();
        let Ok(found) = conjugate_gradients(product, diagonal, &right_side, REDUCTION, MOST);
        found.solution
    }
}
