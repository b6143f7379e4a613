//! Product Gauss rules on the cells of a polygon, with an a-priori bound.
//!
//! ```text
//!   K = h g / (π r⁴),   h, g: heights of each point above the other plane
//! ```
//!
//! Along a line of a cell, `x(z)` with z in [−1, 1], the heights and the Jacobian are linear in z and r² is quadratic;
//! its complex zeros are at least γ = gap/half-length away from [−1, 1], and the ellipse ρ stays within β = (ρ − 1/ρ)/2
//! of it. So with c = (ρ + 1/ρ)/2, on that ellipse
//!
//! ```text
//!   |K J| ≤ c² h_max g_max J_max / (π gap⁴ (1 − β/γ)⁴) = M,   error of n points ≤ (64/15) M ρ^(−2n) / (1 − ρ^(−2))
//! ```
//!
//! (Trefethen, *Approximation Theory and Approximation Practice*, 2013, theorem 19.3), for each of the directions.

use super::potential::Points;
use super::shape::Shape;
use crate::numeric::GaussLegendre;
use glam::DVec3;

/// Quadrature points of a polygon, from a common origin.
#[derive(Debug, Default)]
pub(super) struct Rule {
    pub points: Points,
    /// Weights; their sum is the area.
    pub weights: Vec<f64>,
    /// Heights above the other plane.
    pub heights: Vec<f64>,
}

impl Rule {
    /// `n × n` points on each cell.
    pub(super) fn fill(&mut self, shape: &Shape, corner_heights: &[f64], origin: DVec3, n: usize) {
        let rule = GaussLegendre::with(n);
        self.points.clear();
        self.weights.clear();
        self.heights.clear();
        for (cell, [j, js, jt]) in shape.cells.iter().zip(&shape.jacobians) {
            let corners = cell.map(|i| shape.corners[i] - origin);
            let heights = cell.map(|i| corner_heights[i]);
            for (s, ws) in rule.nodes.iter().zip(&rule.weights) {
                let (s, ws) = (0.5 + 0.5 * s, 0.5 * ws);
                for (t, wt) in rule.nodes.iter().zip(&rule.weights) {
                    let (t, wt) = (0.5 + 0.5 * t, 0.5 * wt);
                    let share = [(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t];
                    let point = (0..4).map(|k| share[k] * corners[k]).sum();
                    self.points.push(point);
                    self.heights.push((0..4).map(|k| share[k] * heights[k]).sum());
                    self.weights.push(ws * wt * (j + js * s + jt * t));
                }
            }
        }
    }
}

/// How one direction of a rule converges.
#[derive(Debug, Clone, Copy)]
pub(super) struct Convergence {
    /// `gap/half-length`.
    pub gamma: f64,
}

impl Convergence {
    /// Points that should do for a relative error.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small")]
    pub(super) fn points(self, relative: f64) -> usize {
        let rho = self.gamma + (self.gamma * self.gamma + 1.0).sqrt();
        ((500.0 / relative).ln() / (2.0 * rho.ln())).ceil().clamp(2.0, 64.0) as usize
    }

    /// The bound on the error of `n` points in both directions of a polygon's cells, relative to
    /// `area × area × h_max g_max / (π gap⁴)`.
    #[allow(clippy::cast_precision_loss, reason = "small")]
    pub(super) fn error(self, n: usize) -> f64 {
        let n = n as f64;
        // near the best ellipse: where ρ^(−2n) (1 − β/γ)^(−4) is least, for large ρ
        let beta = self.gamma * 2.0 * n / (2.0 * n + 4.0);
        let rho = beta + (beta * beta + 1.0).sqrt();
        let c = 0.5 * (rho + 1.0 / rho);
        let decay = (-2.0 * n * rho.ln()).exp() / (1.0 - 1.0 / (rho * rho));
        // two directions; ∫ 1 dz = 2, and the Jacobian is at most twice its mean
        2.0 * (64.0 / 15.0) * 0.5 * 2.0 * c * c * decay / (1.0 - beta / self.gamma).powi(4)
    }
}
