//! The true error of elements, as a finer solution tells it: what other oracles are measured by.
//!
//! ```text
//!   priority² = ∫ (B − B̄)² over the element          B: the reference, B̄: its mean there
//! ```
//!
//! The reference is linear on its leaves, and integrated by one point towards each of their
//! corners. An element smaller than the reference's leaves has an error of 0.

use super::{HierarchyError, Oracle, View, of_each};
use crate::hierarchy::lighting::Lighting;
use crate::hierarchy::solution::Solution;
use crate::hierarchy::tree::Tree;
use crate::numeric::real;
use glam::DVec3;

/// A solution on a finer mesh of the same patches, as points with weights.
#[derive(Debug, Clone)]
pub struct Reference {
    points: Vec<ReferencePoint>,
}

#[derive(Debug, Clone, Copy)]
struct ReferencePoint {
    patch: usize,
    position: DVec3,
    /// The area that it stands for.
    area: f64,
    radiosity: f64,
}

/// The sums `∫ 1`, `∫ B`, `∫ (B − B̄)²` over an element.
#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    area: f64,
    mean: f64,
    squares: f64,
}

impl Reference {
    /// The reference that a solution on a tree gives, all that is not light.
    #[must_use]
    pub fn new(tree: &Tree, lighting: &Lighting, solution: &Solution) -> Self {
        let mut points = Vec::new();
        for leaf in tree.leaves() {
            let element = &tree.elements()[leaf];
            if lighting.is_light(element.patch()) {
                continue;
            }
            let (mean, slope) = (
                solution.radiosity[leaf],
                solution.gradient(tree, lighting, leaf),
            );
            let area = element.shape().area() / real(element.shape().corners().len());
            points.extend(element.gauss_points().map(|position| ReferencePoint {
                patch: element.patch(),
                position,
                area,
                radiosity: mean + slope.dot(position - element.centre()),
            }));
        }
        Self { points }
    }

    /// `‖B − B_h‖/‖B‖` for the means of another mesh of the same patches.
    #[must_use]
    pub fn error_of(&self, tree: &Tree, solution: &Solution) -> f64 {
        self.error_of_means(tree, &solution.radiosity)
    }

    /// The same for means that were found in another way, one for each element of the tree; those
    /// of leaves count.
    #[must_use]
    pub fn error_of_means(&self, tree: &Tree, radiosity: &[f64]) -> f64 {
        self.error(tree, |leaf, _| radiosity[leaf])
    }

    /// The same for the linear functions about the centres of the leaves.
    #[must_use]
    pub fn linear_error_of(&self, tree: &Tree, lighting: &Lighting, solution: &Solution) -> f64 {
        self.error(tree, |leaf, position| {
            let offset = position - tree.elements()[leaf].centre();
            solution.radiosity[leaf] + solution.gradient(tree, lighting, leaf).dot(offset)
        })
    }

    /// `‖B − b‖/‖B‖` for a function of leaves and positions.
    fn error(&self, tree: &Tree, value: impl Fn(usize, DVec3) -> f64) -> f64 {
        let (mut error, mut whole) = (0.0, 0.0);
        for point in &self.points {
            let leaf = tree.leaf_at(point.patch, point.position);
            let value = leaf.map_or(0.0, |leaf| value(leaf, point.position));
            error += point.area * (point.radiosity - value).powi(2);
            whole += point.area * point.radiosity * point.radiosity;
        }
        (error / whole).sqrt()
    }

    /// `‖B − P B‖/‖B‖` for the best means on a mesh of the same patches: no solution on it is
    /// nearer.
    #[must_use]
    pub fn projection_error_of(&self, tree: &Tree) -> f64 {
        let squares = self
            .points
            .iter()
            .map(|point| point.area * point.radiosity.powi(2));
        let missed = self
            .moments(tree)
            .into_iter()
            .map(|moments| moments.squares);
        (missed.sum::<f64>() / squares.sum::<f64>()).sqrt()
    }

    /// The moments of all leaves of a tree.
    fn moments(&self, tree: &Tree) -> Vec<Moments> {
        let mut moments = vec![Moments::default(); tree.elements().len()];
        for point in &self.points {
            if let Some(leaf) = tree.leaf_at(point.patch, point.position) {
                moments[leaf].add(point);
            }
        }
        moments
    }
}

impl Moments {
    /// Adds a point, without cancellation.
    fn add(&mut self, point: &ReferencePoint) {
        self.area += point.area;
        let off = point.radiosity - self.mean;
        self.mean += off * point.area / self.area;
        self.squares += point.area * off * (point.radiosity - self.mean);
    }
}

/// The oracle of the true error.
#[derive(Debug, Clone)]
pub(super) struct TrueError {
    reference: Reference,
}

impl TrueError {
    pub(super) const fn new(reference: Reference) -> Self {
        Self { reference }
    }
}

impl Oracle for TrueError {
    fn priorities(&self, view: &View<'_>, leaves: &[usize]) -> Result<Vec<f64>, HierarchyError> {
        let moments = self.reference.moments(view.tree);
        of_each(leaves, &|leaf| Ok(moments[leaf].squares.sqrt()))
    }
}
