//! Least eigenvalues of a matrix and of what a vector adds to it, about.
//!
//! ```text
//!   λ(τ) = least eigenvalue of N + τ v vᵀ ≈ that of QᵀNQ + τ Qᵀv vᵀQ
//!   Q: an orthonormal basis of Krylov's space of N⁻¹ from v, and from a rough vector
//! ```
//!
//! One space does for every τ, as `(N + τ v vᵀ)⁻¹` leads to no other (Sherman and Morrison). The
//! values lie above the true ones.

use crate::numeric::real;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Steps from each vector.
const STEPS: usize = 9;
/// The part of a vector below which nothing new is left of it.
const NOTHING_NEW: f64 = 1e-10;

/// A matrix and a vector on a small space.
#[derive(Debug, Clone)]
pub(super) struct Ritz {
    matrix: DMatrix<f64>,
    vector: DVector<f64>,
}

impl Ritz {
    /// The space of a matrix with these factors, and of a vector.
    pub(super) fn new(
        matrix: &DMatrix<f64>,
        factors: &Cholesky<f64, Dyn>,
        vector: &DVector<f64>,
    ) -> Self {
        let n = vector.len();
        let rough = DVector::from_fn(n, |i, _| 1.0 + real(i % 7) - real(i % 5));
        let mut basis: Vec<DVector<f64>> = Vec::new();
        for start in [vector.clone(), rough] {
            let mut next = start;
            for _ in 0..STEPS {
                next = factors.solve(&next);
                let Some(unit) = new_direction(next, &basis) else {
                    break;
                };
                basis.push(unit.clone());
                next = unit;
            }
        }
        let basis = DMatrix::from_columns(&basis);
        Self {
            matrix: basis.tr_mul(&(matrix * &basis)),
            vector: basis.tr_mul(vector),
        }
    }

    /// The least eigenvalue with so much of the vector's square added.
    pub(super) fn least(&self, weight: f64) -> f64 {
        let raised = &self.matrix + weight * &self.vector * self.vector.transpose();
        raised.symmetric_eigenvalues().min()
    }
}

/// The direction of a vector beside an orthonormal basis.
fn new_direction(mut vector: DVector<f64>, basis: &[DVector<f64>]) -> Option<DVector<f64>> {
    let size = vector.norm();
    // the second time for what rounding left
    for _ in 0..2 {
        for unit in basis {
            let share = unit.dot(&vector);
            vector.axpy(-share, unit, 1.0);
        }
    }
    let left = vector.norm();
    (left > NOTHING_NEW * size).then(|| vector / left)
}
