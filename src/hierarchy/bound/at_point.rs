//! The light that a point receives of each leaf: a constant, and a bound on what it misses.
//!
//! On the plane of a leaf the height b of the point x is the same everywhere, so that
//!
//! ```text
//!   k(x, y) = a b/(π r⁴),   |∇_y k| ≤ b (1 + 4 a/r)/(π r⁴)
//!   ∫ (k − k(x, c))² ≤ A (ρ max |∇ k|)²                     c: centre, ρ: radius of the leaf
//!   ∫ k² ≤ max k ∫ k
//! ```
//!
//! Whichever is less holds; past what may stand in the way, the second.

use super::leaf::Leaf;
use super::local::{kernel, wedge};
use super::views::Views;
use crate::geometry::distance_from_patch;
use crate::hierarchy::Visibility;
use glam::DVec3;
use std::f64::consts::PI;

/// The kernel at a point as a function of leaves.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AtPoint {
    /// A constant for each leaf.
    pub(super) weights: Vec<f64>,
    /// Bounds on `∫ (k − weight)²` over each; infinite for one on whose edge the point lies.
    pub(super) squares: Vec<f64>,
}

impl AtPoint {
    /// The kernel at a point of a patch with this normal.
    pub(super) fn new(views: &Views, patch: usize, point: DVec3, normal: DVec3) -> Self {
        let of = |leaf: &Leaf| match views.sight.of_patches(patch, leaf.patch) {
            Visibility::Hidden => (0.0, 0.0),
            _ => constant(leaf, point, normal),
        };
        let (mut weights, mut squares): (Vec<f64>, Vec<f64>) = views.leaves.iter().map(of).unzip();
        let Some(view) = views.view(patch) else {
            return Self { weights, squares };
        };
        for veiled in &view.veiled {
            let leaf = veiled.leaf;
            squares[leaf] = match views.between(view, &[point], veiled) {
                Visibility::Clear => continue,
                Visibility::Hidden => 0.0,
                Visibility::Past(_) => square(&views.leaves[leaf], point, normal),
            };
            weights[leaf] = 0.0;
        }
        Self { weights, squares }
    }
}

/// A constant for the kernel over a leaf, and a bound on the square of what it misses.
fn constant(leaf: &Leaf, point: DVec3, normal: DVec3) -> (f64, f64) {
    let most = square(leaf, point, normal);
    if most <= 0.0 {
        return (0.0, 0.0);
    }
    let shape = &leaf.shape;
    let corners = shape.corners().iter();
    let radius = corners.map(|c| c.distance(leaf.centre)).fold(0.0, f64::max);
    let apart = distance_from_patch(point, shape);
    let (to, b) = (
        leaf.centre - point,
        (point - leaf.centre).dot(shape.normal()),
    );
    let a = to.dot(normal);
    let (slope, least) = (1.0 + 4.0 * ((a + radius) / apart).min(1.0), apart * apart);
    let steepest = b * slope / (PI * least * least);
    let flat = shape.area() * (radius * steepest).powi(2);
    // a leaf that goes below the plane of the point has a kink there
    let is_above = shape
        .corners()
        .iter()
        .all(|c| (*c - point).dot(normal) >= 0.0);
    if is_above && flat < most {
        (a * b / (PI * to.length_squared().powi(2)), flat)
    } else {
        (0.0, most)
    }
}

/// A bound on `∫ k²` over a leaf; infinite on its edge.
fn square(leaf: &Leaf, point: DVec3, normal: DVec3) -> f64 {
    let shape = &leaf.shape;
    let heights = shape.corners().iter().map(|c| (*c - point).dot(normal));
    let up = heights.fold(0.0, f64::max);
    let down = (point - leaf.centre).dot(shape.normal());
    let tilted = wedge(normal, shape.normal());
    if up <= 0.0 || down <= 0.0 || tilted <= 0.0 {
        return 0.0;
    }
    let kernel = kernel(up, down, distance_from_patch(point, shape));
    kernel * tilted.min(shape.area() * kernel)
}
