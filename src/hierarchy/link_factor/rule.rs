//! Points of an element, and the plane through values at them.
//!
//! ```text
//!   triangle        the three points (2/3, 1/6, 1/6)
//!   quadrilateral   the images of the 2 × 2 Gauss points, with the map's Jacobian
//!   others          the centroids of the triangles at the centre
//!
//!   value = Σ w f,    gradient = M⁻¹ Σ w f (x − centre),    M = Σ w (x − centre)(x − centre)ᵀ
//! ```
//!
//! with weights that sum to 1. The first two are exact for polynomials of degree 2, so that the
//! plane is the best one in L2; any plane is found exactly by all of them.
//!
//! **Not covered**: concave elements, whose fan counts with signs.

use crate::form_factor::PointFactor;
use crate::hierarchy::tree::Element;
use glam::{DMat2, DVec2, DVec3};
use smallvec::SmallVec;

/// The points of an element with their weights.
#[derive(Debug)]
pub(super) struct Rule {
    centre: DVec3,
    /// Two directions across the normal.
    axes: [DVec3; 2],
    nodes: SmallVec<[(DVec3, f64); 8]>,
}

/// The distance of the two Gauss points on [−1, 1] from its middle.
const GAUSS: f64 = 0.577_350_269_189_625_8;

impl Rule {
    pub(super) fn of(element: &Element) -> Self {
        let corners = element.shape().corners();
        let normal = element.shape().normal();
        let along = (corners[1] - corners[0]).normalize();
        let nodes = match corners {
            [a, b, c] => triangle([*a, *b, *c]),
            [a, b, c, d] => quadrilateral([*a, *b, *c, *d], normal),
            _ => fan(corners, element.centre(), normal),
        };
        Self {
            centre: element.centre(),
            axes: [along, normal.cross(along)],
            nodes,
        }
    }

    /// The points with their weights.
    pub(super) fn nodes(&self) -> &[(DVec3, f64)] {
        &self.nodes
    }

    /// The plane through values at the points, by least squares.
    pub(super) fn plane(&self, values: &[f64]) -> PointFactor {
        let nodes = || self.nodes.iter().zip(values);
        let value: f64 = nodes().map(|((_, weight), value)| weight * value).sum();
        let (mut moments, mut slopes) = (DMat2::ZERO, DVec2::ZERO);
        for ((point, weight), own) in nodes() {
            let apart = *point - self.centre;
            let apart = DVec2::from_array(self.axes.map(|axis| apart.dot(axis)));
            moments += DMat2::from_cols(apart * apart.x, apart * apart.y) * *weight;
            slopes += apart * (weight * (own - value));
        }
        let [along, across] = (moments.inverse() * slopes).to_array();
        PointFactor {
            value,
            gradient: self.axes[0] * along + self.axes[1] * across,
        }
    }
}

fn triangle(corners: [DVec3; 3]) -> SmallVec<[(DVec3, f64); 8]> {
    let sum: DVec3 = corners.iter().sum();
    let node = |corner: DVec3| (0.5 * corner + sum / 6.0, 1.0 / 3.0);
    corners.map(node).into_iter().collect()
}

fn quadrilateral([a, b, c, d]: [DVec3; 4], normal: DVec3) -> SmallVec<[(DVec3, f64); 8]> {
    // x = m + s p + t q + s t r on [−1, 1]²
    let middle = 0.25 * (a + b + c + d);
    let [p, q, r] = [b + c - a - d, c + d - a - b, a + c - b - d].map(|sum| 0.25 * sum);
    let jacobian = |s: f64, t: f64| (p + t * r).cross(q + s * r).dot(normal);
    let whole = 4.0 * jacobian(0.0, 0.0);
    let signs = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let nodes = signs.map(|[s, t]| {
        let (s, t) = (GAUSS * s, GAUSS * t);
        (middle + s * p + t * q + s * t * r, jacobian(s, t) / whole)
    });
    nodes.into_iter().collect()
}

fn fan(corners: &[DVec3], centre: DVec3, normal: DVec3) -> SmallVec<[(DVec3, f64); 8]> {
    let next = corners.iter().cycle().skip(1);
    let node = |(from, to): (&DVec3, &DVec3)| {
        let area = (*from - centre).cross(*to - centre).dot(normal);
        ((*from + *to + centre) / 3.0, area)
    };
    let mut nodes: SmallVec<[(DVec3, f64); 8]> = corners.iter().zip(next).map(node).collect();
    let whole: f64 = nodes.iter().map(|(_, area)| area).sum();
    for (_, weight) in &mut nodes {
        *weight /= whole;
    }
    nodes
}
