//! The generalized minimal residual method, restarted.
//!
//! ```text
//!   x_m = x_0 + V_m y,   y = argmin ‖β e_1 − H_m y‖     V_m: Arnoldi's basis, A V_m = V_{m+1} H_m
//! ```
//!
//! **Not covered**: preconditioning; a bound on the error of the solution.
//!
//! Reference: Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856.

/// The vectors of a basis before it is begun anew.
const RESTART: usize = 24;

/// An approximate solution of a linear system.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Iterated {
    /// The solution.
    pub(crate) solution: Vec<f64>,
    /// The norm of the residual.
    pub(crate) residual: f64,
    /// Products with the matrix.
    pub(crate) products: usize,
}

/// Solves `A x = b` from a first guess, until the residual's norm is at most `goal` or so many
/// products are made.
///
/// **Arguments** `product`: x ↦ A x.
pub(crate) fn gmres(
    product: &dyn Fn(&[f64]) -> Vec<f64>,
    right_side: &[f64],
    guess: Vec<f64>,
    goal: f64,
    most: usize,
) -> Iterated {
    let mut solution = guess;
    let mut products = 0;
    loop {
        let image = product(&solution);
        products += 1;
        let residual: Vec<f64> = right_side.iter().zip(&image).map(|(b, a)| b - a).collect();
        let norm = norm(&residual);
        if norm <= goal || products >= most || !norm.is_finite() {
            return Iterated {
                solution,
                residual: norm,
                products,
            };
        }
        let mut cycle = Cycle::new(residual, norm);
        while cycle.residual() > goal && cycle.basis.len() <= RESTART && products < most {
            let image = product(&cycle.basis[cycle.basis.len() - 1]);
            products += 1;
            if !cycle.extend(image) {
                break;
            }
        }
        let step = cycle.step();
        for (x, step) in solution.iter_mut().zip(step) {
            *x += step;
        }
    }
}

/// Arnoldi's basis with the triangular factor of its Hessenberg matrix.
struct Cycle {
    basis: Vec<Vec<f64>>,
    /// The columns of the triangle.
    columns: Vec<Vec<f64>>,
    rotations: Vec<[f64; 2]>,
    /// The right side, rotated; its last entry is the residual.
    right_side: Vec<f64>,
}

impl Cycle {
    fn new(mut residual: Vec<f64>, norm: f64) -> Self {
        for entry in &mut residual {
            *entry /= norm;
        }
        Self {
            basis: vec![residual],
            columns: Vec::new(),
            rotations: Vec::new(),
            right_side: vec![norm],
        }
    }

    /// The norm of the residual.
    fn residual(&self) -> f64 {
        self.right_side[self.columns.len()].abs()
    }

    /// Takes up the next vector; false if it lies in the space that is spanned.
    fn extend(&mut self, mut vector: Vec<f64>) -> bool {
        let mut column: Vec<f64> = Vec::with_capacity(self.basis.len() + 1);
        for base in &self.basis {
            let along = dot(base, &vector);
            for (entry, base) in vector.iter_mut().zip(base) {
                *entry -= along * base;
            }
            column.push(along);
        }
        let length = norm(&vector);
        for (k, [cosine, sine]) in self.rotations.iter().enumerate() {
            let (upper, lower) = (column[k], column[k + 1]);
            column[k] = cosine * upper + sine * lower;
            column[k + 1] = cosine * lower - sine * upper;
        }
        let last = column.len() - 1;
        let diagonal = column[last].hypot(length);
        if diagonal <= 0.0 {
            return false;
        }
        let rotation = [column[last] / diagonal, length / diagonal];
        column[last] = diagonal;
        let right_side = self.right_side[last];
        self.right_side[last] = rotation[0] * right_side;
        self.right_side.push(-rotation[1] * right_side);
        self.rotations.push(rotation);
        self.columns.push(column);
        if length <= 0.0 {
            return false;
        }
        for entry in &mut vector {
            *entry /= length;
        }
        self.basis.push(vector);
        true
    }

    /// The step in the space that leaves the least residual.
    fn step(&self) -> Vec<f64> {
        let count = self.columns.len();
        let mut shares = self.right_side[..count].to_vec();
        for k in (0..count).rev() {
            for later in k + 1..count {
                shares[k] -= self.columns[later][k] * shares[later];
            }
            shares[k] /= self.columns[k][k];
        }
        let mut step = vec![0.0; self.basis[0].len()];
        for (share, base) in shares.iter().zip(&self.basis) {
            for (entry, base) in step.iter_mut().zip(base) {
                *entry += share * base;
            }
        }
        step
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
