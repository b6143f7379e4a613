//! Bounds on what is left of the error over single leaves.
//!
//! What is left, ẽ = B − B̃, is what its residual shows and what is received of itself:
//!
//! ```text
//!   ẽ = R f + R K ẽ,    ‖ẽ‖_o ≤ R ‖f‖_o + R ‖K ẽ‖_o
//!   ‖K ẽ‖²_o ≤ ∫_o (∫ k)(∫ k ẽ²) ≤ Σ_l φ_lo ‖ẽ‖²_l         φ_lo ≥ F(y → o) for all y of leaf l
//! ```
//!
//! The sum is the largest that bounds on single leaves and on the whole allow; with its outcome
//! they get better, a few times.
//!
//! ```text
//!   F(y → o) ≤ (1 − n·n')/2,   F(y → o) ≤ A c c'/(π d²)
//!   d: the least distance; c, c': the largest cosines
//! ```
//!
//! **Not covered**: that something stands in the way, which only takes away from k.

use crate::geometry::Patch;
use crate::hierarchy::{Element, Lighting, Tree};
use crate::numeric::parallel_map;
use glam::DVec3;
use std::f64::consts::PI;

/// The number of times that bounds on leaves make each other better.
const ROUNDS: usize = 6;

/// Bounds on what is left of the error, over leaves and the whole.
#[derive(Debug, Clone)]
pub(super) struct Local {
    /// `‖ẽ‖` over each leaf.
    bounds: Vec<f64>,
    /// `‖ẽ‖` over all of them.
    whole: f64,
}

impl Local {
    /// The bounds on leaves of a tree of which the residual shows `shown`, `‖f‖` by leaf.
    pub(super) fn new(tree: &Tree, light: &Lighting, shown: &[f64], whole: f64) -> Self {
        let leaves: Vec<Element> = tree.leaves().map(|l| tree.elements()[l].clone()).collect();
        let reflectance = |leaf: &Element| light.reflectance(leaf.patch());
        let received = parallel_map(leaves.len(), &|receiver| {
            let at = &leaves[receiver];
            let mut row: Vec<(f64, usize)> = Vec::new();
            if reflectance(at) > 0.0 {
                let lit = leaves.iter().map(|leaf| most(leaf, at)).enumerate();
                row.extend(lit.filter(|(_, f)| *f > 0.0).map(|(leaf, f)| (f, leaf)));
                row.sort_by(|a, b| b.0.total_cmp(&a.0));
            }
            row
        });
        let mut bounds: Vec<f64> = leaves
            .iter()
            .map(|leaf| if reflectance(leaf) > 0.0 { whole } else { 0.0 })
            .collect();
        for _ in 0..ROUNDS {
            bounds = (0..leaves.len())
                .map(|leaf| {
                    let own = shown[leaf] + largest_sum(&received[leaf], &bounds, whole).sqrt();
                    (reflectance(&leaves[leaf]) * own).min(bounds[leaf])
                })
                .collect();
        }
        Self { bounds, whole }
    }

    /// Bounds on `‖ẽ‖` over each leaf.
    pub(super) fn bounds(&self) -> &[f64] {
        &self.bounds
    }

    /// A bound on `|∫ h ẽ|` for a function h, of which bounds on `∫ h²` over each leaf are known.
    pub(super) fn product(&self, squares: &[f64]) -> f64 {
        let pairs = squares.iter().zip(&self.bounds);
        let apart: f64 = pairs.map(|(square, bound)| square.sqrt() * bound).sum();
        apart.min(squares.iter().sum::<f64>().sqrt() * self.whole)
    }
}

/// The largest `Σ φ t` for `t ≤ bound²` and `Σ t ≤ whole²`; the largest φ first.
fn largest_sum(row: &[(f64, usize)], bounds: &[f64], whole: f64) -> f64 {
    let (mut sum, mut left) = (0.0, whole * whole);
    for (factor, leaf) in row {
        let part = (bounds[*leaf] * bounds[*leaf]).min(left);
        sum += factor * part;
        left -= part;
        if left <= 0.0 {
            break;
        }
    }
    sum
}

/// A bound on the form factor from any point of a leaf to another one.
fn most(from: &Element, to: &Element) -> f64 {
    if from.patch() == to.patch() {
        return 0.0;
    }
    let apart = from.centre().distance(to.centre()) - from.radius() - to.radius();
    let [up, down] = [
        height(from.shape(), to.shape()),
        height(to.shape(), from.shape()),
    ];
    if up <= 0.0 || down <= 0.0 {
        return 0.0;
    }
    let tilted = wedge(from.shape().normal(), to.shape().normal());
    let far = to.shape().area() * kernel(up, down, apart);
    tilted.min(far)
}

/// A bound on the form factor of a point to all of a plane.
pub(super) fn wedge(normal: DVec3, other: DVec3) -> f64 {
    (0.5 * (1.0 - normal.dot(other))).clamp(0.0, 1.0)
}

/// A bound on the kernel at this distance or more, of points at these heights over each other's
/// planes at most; infinite at none.
pub(super) fn kernel(up: f64, down: f64, distance: f64) -> f64 {
    if distance <= 0.0 {
        return f64::INFINITY;
    }
    let cosine = |height: f64| (height / distance).min(1.0);
    cosine(up) * cosine(down) / (PI * distance * distance)
}

/// The height of the highest corner over the plane of a shape.
fn height(plane: &Patch, shape: &Patch) -> f64 {
    let start = plane.corners()[0];
    let heights = shape
        .corners()
        .iter()
        .map(|c| (*c - start).dot(plane.normal()));
    heights.fold(0.0, f64::max)
}
