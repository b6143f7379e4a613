//! The errors of piecewise constant or linear radiosity in a box.
//!
//! ```text
//!   e² = Σ_i ∫_i (B − b_i − g_i·(x − c_i))² dA / Σ_i ∫_i B² dA        i: leaves that are no light
//! ```
//!
//! by 3 × 3 Gauss points on each leaf.

use super::BoxRadiosity;
use crate::hierarchy::{Element, Tree};
use crate::numeric::parallel_map;
use glam::DVec3;

/// The nodes and weights of Gauss's rule with three points on [0, 1].
const GAUSS: [[f64; 2]; 3] = [
    [0.112_701_665_379_258_3, 0.277_777_777_777_777_8],
    [0.5, 0.444_444_444_444_444_4],
    [0.887_298_334_620_741_7, 0.277_777_777_777_777_8],
];

/// Integrals over an element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementMoments {
    /// The area.
    pub area: f64,
    /// The mean radiosity.
    pub mean: f64,
    /// The mean of its square.
    pub mean_square: f64,
    /// The mean of radiosity times the place from the centre.
    pub first: DVec3,
    /// The means of squares of the place from the centre, along both edges of the element.
    squares: [(DVec3, f64); 2],
}

impl ElementMoments {
    /// The integral of the squared difference from a linear function, given by its value and its
    /// gradient at the centre.
    #[must_use]
    pub fn squared_error(&self, value: f64, gradient: DVec3) -> f64 {
        let bend = self.squares.iter().map(|(axis, square)| {
            let slope = gradient.dot(*axis);
            slope * slope * square
        });
        let linear = value * value + bend.sum::<f64>();
        let shared = value * self.mean + gradient.dot(self.first);
        self.area * (self.mean_square - 2.0 * shared + linear)
    }
}

impl BoxRadiosity {
    /// The moments of radiosity over a rectangular element of a patch.
    #[must_use]
    pub fn moments(&self, element: &Element) -> ElementMoments {
        let corners = element.shape().corners();
        let [origin, u, v] = [corners[0], corners[1] - corners[0], corners[3] - corners[0]];
        let centre = origin + 0.5 * (u + v);
        let mut moments = ElementMoments {
            area: element.shape().area(),
            mean: 0.0,
            mean_square: 0.0,
            first: DVec3::ZERO,
            // of an edge of length L: L²/12
            squares: [u, v].map(|edge| (edge.normalize(), edge.length_squared() / 12.0)),
        };
        for [s, along] in GAUSS {
            for [t, across] in GAUSS {
                let (point, weight) = (origin + s * u + t * v, along * across);
                let radiosity = self.radiosity(element.patch(), point).value;
                moments.mean += weight * radiosity;
                moments.mean_square += weight * radiosity * radiosity;
                moments.first += weight * radiosity * (point - centre);
            }
        }
        moments
    }

    /// The moments of all leaves that are no light, with their indices in the tree.
    #[must_use]
    pub fn leaf_moments(&self, tree: &Tree) -> Vec<(usize, ElementMoments)> {
        let elements = tree.elements();
        let is_dark = |leaf: &usize| !self.is_light(elements[*leaf].patch());
        let leaves: Vec<usize> = tree.leaves().filter(is_dark).collect();
        parallel_map(leaves.len(), &|k| {
            (leaves[k], self.moments(&elements[leaves[k]]))
        })
    }
}

/// The relative error in L2 of values and gradients on leaves, over all that is no light.
///
/// **Arguments** `moments`: of the leaves; `solution`: value and gradient at the centre of each.
#[must_use]
pub fn relative_error(
    moments: &[(usize, ElementMoments)],
    solution: impl Fn(usize) -> (f64, DVec3),
) -> f64 {
    let (mut error, mut whole) = (0.0, 0.0);
    for (leaf, own) in moments {
        let (value, gradient) = solution(*leaf);
        error += own.squared_error(value, gradient);
        whole += own.area * own.mean_square;
    }
    // rounding may leave nothing of a perfect solution, and less
    (error.max(0.0) / whole).sqrt()
}
