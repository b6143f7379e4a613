//! The gradient of the radiosity as the neighbours of an element show it.
//!
//! ```text
//!   min_g Σ_n (B_n − B − g·(c_n − c))²          n: leaves of the patch that share an edge
//!   priority = ‖g·(x − c)‖ over the element
//! ```
//!
//! Only radiosities that are stored are used. Along a direction in which there is no neighbour the
//! gradient is not known; the priority there is that of a radiosity which varies as much as what is
//! reflected.
//!
//! **Not covered**: neighbours across the edge of a patch.

use super::{HierarchyError, Indicator, View};
use glam::{DMat2, DVec2};

/// The least eigenvalue, over the larger one, of what neighbours determine.
const DETERMINED: f64 = 1e-3;

/// Points of an edge beyond which a neighbour is looked for, as shares of its length: no cuts into
/// halves meet them.
const ALONG: [f64; 2] = [0.21, 0.79];

/// The distance of these points from the edge, over that of the centre.
const BEYOND: f64 = 1e-3;

/// The oracle of the neighbours.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbours;

impl Indicator for Neighbours {
    fn priority(&self, view: &View<'_>, leaf: usize) -> Result<f64, HierarchyError> {
        let element = view.element(leaf);
        let normal = element.shape().normal();
        let across = normal.any_orthonormal_vector();
        let axes = [across, normal.cross(across)];
        let (mut matrix, mut right) = (DMat2::ZERO, DVec2::ZERO);
        for neighbour in neighbours(view, leaf) {
            let offset = view.element(neighbour).centre() - element.centre();
            let offset = DVec2::from_array(axes.map(|axis| axis.dot(offset)));
            let difference = view.radiosity(neighbour) - view.radiosity(leaf);
            matrix += DMat2::from_cols(offset * offset.x, offset * offset.y);
            right += offset * difference;
        }
        let in_space = |v: DVec2| v.x * axes[0] + v.y * axes[1];
        let reflected = (view.radiosity(leaf) - view.emittance(leaf)).abs();
        let unknown = 0.3 * reflected / element.radius();
        let largest = eigenvalues(&matrix)[1];
        let norms = eigenvectors(&matrix).map(|(value, direction)| {
            let slope = if value > DETERMINED * largest {
                direction.dot(right) / value
            } else {
                unknown
            };
            slope * direction
        });
        Ok(element.norm_of_linear(in_space(norms[0] + norms[1])))
    }
}

/// The leaves of the same patch that share an edge with a leaf, each once.
pub(super) fn neighbours(view: &View<'_>, leaf: usize) -> Vec<usize> {
    let element = view.element(leaf);
    let corners = element.shape().corners();
    let mut found = Vec::new();
    for (k, start) in corners.iter().enumerate() {
        let end = corners[(k + 1) % corners.len()];
        for share in ALONG {
            let on_edge = start.lerp(end, share);
            let outwards = (end - *start).cross(element.shape().normal()).normalize();
            let height = (on_edge - element.centre()).dot(outwards);
            let point = on_edge + BEYOND * height * outwards;
            let at = view.tree.leaf_at(element.patch(), point);
            found.extend(at.filter(|at| *at != leaf));
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// The eigenvalues of a symmetric matrix, the smaller first.
fn eigenvalues(matrix: &DMat2) -> [f64; 2] {
    let mean = 0.5 * (matrix.x_axis.x + matrix.y_axis.y);
    let half = 0.5 * (matrix.x_axis.x - matrix.y_axis.y);
    let off = half.hypot(matrix.x_axis.y);
    [mean - off, mean + off]
}

/// The eigenvalues of a symmetric matrix with unit eigenvectors, the smaller first.
fn eigenvectors(matrix: &DMat2) -> [(f64, DVec2); 2] {
    let [small, large] = eigenvalues(matrix);
    let half = 0.5 * (matrix.x_axis.x - matrix.y_axis.y);
    let angle = 0.5 * matrix.x_axis.y.atan2(half);
    let direction = DVec2::from_angle(angle);
    [(small, direction.perp()), (large, direction)]
}
