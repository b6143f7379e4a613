//! A planar simple polygon.
//!
//! ```text
//!   2 A n = Σ_i (v_i − v_0) × (v_{i+1} − v_0)        (n: unit normal, A: area)
//! ```
//!
//! The front is the side from which the corners run counter-clockwise.
//!
//! **Not covered**: holes; curved surfaces.

use super::GeometryError;
use super::Vector;
use crate::numeric::{DoubleDouble, Scalar, power_of_two_near, tolerance};
use glam::{DVec2, DVec3};

/// A planar simple polygon with its area and unit normal.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    corners: Vec<DVec3>,
    normal: DVec3,
    area: f64,
}

impl Patch {
    /// The polygon with these corners, in order.
    ///
    /// # Errors
    /// [`GeometryError::TooFewCorners`], [`GeometryError::NotFinite`], [`GeometryError::NoArea`],
    /// [`GeometryError::NotPlanar`] beyond [`tolerance::PLANARITY`] of the diameter,
    /// [`GeometryError::NotSimple`].
    ///
    /// # Examples
    /// ```
    /// use infoscene::geometry::Patch;
    /// use glam::DVec3;
    /// let triangle = Patch::try_new(vec![DVec3::ZERO, DVec3::X, DVec3::Y])?;
    /// assert_eq!(triangle.area(), 0.5);
    /// assert_eq!(triangle.normal(), DVec3::Z);
    /// # Ok::<(), infoscene::geometry::GeometryError>(())
    /// ```
    pub fn try_new(corners: Vec<DVec3>) -> Result<Self, GeometryError> {
        if corners.len() < 3 {
            return Err(GeometryError::TooFewCorners {
                corners: corners.len(),
            });
        }
        if let Some(corner) = corners.iter().position(|c| !c.is_finite()) {
            let DVec3 { x, y, z } = corners[corner];
            return Err(GeometryError::NotFinite { corner, x, y, z });
        }
        let origin = corners[0];
        let diameter = corners
            .iter()
            .map(|c| c.distance(origin))
            .fold(0.0, f64::max);
        // in units of a power of two near the diameter, so that products stay in range
        let unit = power_of_two_near(diameter);
        // to 106 bits: in doubles the normal of a sliver is off by ε over its thinness
        let like = DoubleDouble::from(0.0);
        let lifted = |point: DVec3| Vector::lifted(point / unit, like);
        let from_origin = |point: DVec3| lifted(point).minus(lifted(origin));
        let precise = corners
            .windows(2)
            .map(|pair| from_origin(pair[0]).cross(from_origin(pair[1])))
            .fold(Vector([like; 3]), |sum, next| {
                sum.plus(next, DoubleDouble::from(1.0))
            });
        let doubled = precise.to_doubles();
        let area = 0.5 * doubled.length() * unit * unit;
        // a cross product of edges near 1 is uncertain by ε
        let encloses = doubled.length() > 8.0 * f64::EPSILON;
        if !encloses || !area.is_normal() {
            return Err(GeometryError::NoArea { area, diameter });
        }
        let normal = doubled.normalize();
        let precise = precise.times(DoubleDouble::from(1.0) / precise.length());
        let heights = corners
            .iter()
            .map(|c| from_origin(*c).dot(precise).to_f64().abs() * unit);
        let (corner, deviation) =
            heights.enumerate().fold(
                (0, 0.0),
                |worst, next| if next.1 > worst.1 { next } else { worst },
            );
        let allowed = tolerance::PLANARITY;
        if deviation > allowed * diameter {
            let relative = deviation / diameter;
            return Err(GeometryError::NotPlanar {
                corner,
                deviation,
                relative,
                allowed,
            });
        }
        let patch = Self {
            corners,
            normal,
            area,
        };
        match patch.crossing_edges(unit) {
            Some((first, second)) => Err(GeometryError::NotSimple { first, second }),
            None => Ok(patch),
        }
    }

    /// The polygon with its front where its back is; the first corner stays the first.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        self.corners[1..].reverse();
        Self {
            normal: -self.normal,
            ..self
        }
    }

    /// Corners in order, counter-clockwise seen from the front.
    #[must_use]
    pub fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// Unit normal, towards the front.
    #[must_use]
    pub const fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Area, in squared units of length.
    #[must_use]
    pub const fn area(&self) -> f64 {
        self.area
    }

    fn crossing_edges(&self, unit: f64) -> Option<(usize, usize)> {
        let across = self.normal.any_orthonormal_vector();
        let up = self.normal.cross(across);
        let flat: Vec<DVec2> = self
            .corners
            .iter()
            .map(|c| (*c - self.corners[0]) / unit)
            .map(|c| DVec2::new(c.dot(across), c.dot(up)))
            .collect();
        let n = flat.len();
        let edge = |i: usize| (flat[i], flat[(i + 1) % n]);
        (0..n)
            .flat_map(|i| (i + 1..n).map(move |j| (i, j)))
            .filter(|(i, j)| j - i > 1 && (*i > 0 || *j < n - 1)) // neighbours share a corner
            .find(|(i, j)| segments_meet(edge(*i), edge(*j)))
    }
}

fn segments_meet((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)) -> bool {
    // seen along the first, the second may lie beside it: rounding leaves collinear edges on either
    // side of each other
    let along = b - a;
    let [s, e] = [(c - a).dot(along), (d - a).dot(along)];
    if s.max(e) < 0.0 || s.min(e) > along.length_squared() {
        return false;
    }
    let side = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    let (ac, ad) = (side(a, b, c), side(a, b, d));
    let (ca, cb) = (side(c, d, a), side(c, d, b));
    let same_side = |p: f64, q: f64| (p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0);
    let apart = same_side(ac, ad) || same_side(ca, cb);
    !apart
}
