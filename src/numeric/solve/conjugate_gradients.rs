//! Conjugate gradients with the diagonal as preconditioner.

/// The result of an iteration.
pub(crate) struct Iterated {
    /// The approximate solution.
    pub(crate) solution: Vec<f64>,
    /// Products with the matrix.
    pub(crate) iterations: usize,
}

/// An approximate solution of `M x = b` for a symmetric positive definite M: `√(r·D⁻¹r)` falls by
/// the factor `reduction`, unless it takes more than `most` iterations, or rounding stops it. How
/// good it is, others must find out.
///
/// An error of a product ends it.
///
/// **Arguments** `product`: x ↦ M x; `diagonal` of M, > 0, or 0 where x is 0 for good.
pub(crate) fn conjugate_gradients<E>(
    product: impl Fn(&[f64]) -> Result<Vec<f64>, E>,
    diagonal: &[f64],
    right_side: &[f64],
    reduction: f64,
    most: usize,
) -> Result<Iterated, E> {
    let preconditioned = |residual: &[f64]| -> Vec<f64> {
        let entries = residual.iter().zip(diagonal);
        entries
            .map(|(r, d)| if *d > 0.0 { r / d } else { 0.0 })
            .collect()
    };
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut solution = vec![0.0; right_side.len()];
    let mut residual = right_side.to_vec();
    let mut direction = preconditioned(&residual);
    let mut energy = dot(&residual, &direction);
    let goal = reduction * reduction * energy;
    let mut iterations = 0;
    while iterations < most && energy > goal {
        let image = product(&direction)?;
        iterations += 1;
        let curvature = dot(&direction, &image);
        let step = energy / curvature;
        if !(curvature > 0.0 && step.is_finite()) {
            break;
        }
        for (k, (direction, image)) in direction.iter().zip(&image).enumerate() {
            solution[k] += step * direction;
            residual[k] -= step * image;
        }
        let scaled = preconditioned(&residual);
        let next = dot(&residual, &scaled);
        let share = next / energy;
        energy = next;
        for (direction, scaled) in direction.iter_mut().zip(scaled) {
            *direction = scaled + share * *direction;
        }
    }
    Ok(Iterated {
        solution,
        iterations,
    })
}
