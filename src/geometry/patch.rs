//! A planar simple polygon.
//!
//! ```text
//!   2 A n = Σ_i (v_i − v_0) × (v_{i+1} − v_0)        (n: unit normal, A: area)
//! ```
//!
//! The front is the side from which the corners run counter-clockwise.
//!
//! Corners that are rounded to decimals lie off a plane by some of their last place. A polygon that
//! is bent by no more than a resolution explains is put into its mean plane; the corners as they
//! were given are kept for writers of files.
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
    bend: Option<Box<Bend>>,
}

/// The corners of a polygon as given, where they were moved into a plane.
#[derive(Debug, Clone, PartialEq)]
struct Bend {
    given: Vec<DVec3>,
    moved: f64,
    resolution: f64,
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
        Self::within(corners, 0.0)
    }

    /// The polygon with these corners, whose coordinates are known to ± `resolution` only: put into
    /// its mean plane if they leave it by no more than that explains, and if the polygon is wide
    /// enough for such a resolution.
    ///
    /// # Errors
    /// As [`try_new`](Self::try_new).
    ///
    /// # Examples
    /// ```
    /// use infoscene::geometry::Patch;
    /// use glam::DVec3;
    /// // a turned square to two decimals
    /// let corners = [[0.0, 0.0, 0.0], [0.87, 0.0, 0.5], [0.61, 0.71, 0.36], [-0.25, 0.71, -0.15]];
    /// let corners = corners.map(DVec3::from_array).to_vec();
    /// assert!(Patch::try_new(corners.clone()).is_err());
    /// assert!(Patch::within(corners, 0.005)?.moved() < 0.005);
    /// # Ok::<(), infoscene::geometry::GeometryError>(())
    /// ```
    pub fn within(mut corners: Vec<DVec3>, resolution: f64) -> Result<Self, GeometryError> {
        check_corners(&corners)?;
        let origin = corners[0];
        let diameter = corners
            .iter()
            .map(|c| c.distance(origin))
            .fold(0.0, f64::max);
        // in units of a power of two near the diameter, so that products stay in range
        let unit = power_of_two_near(diameter);
        let precise = area_vector(&corners, unit);
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
            .map(|c| from(origin, *c, unit).dot(precise).to_f64() * unit);
        let heights: Vec<f64> = heights.collect();
        let (corner, deviation) = largest_size(&heights);
        let allowed = tolerance::PLANARITY;
        let mut bend = None;
        if deviation > allowed * diameter {
            let bent = Bent::of(&heights, area / diameter);
            if !bent.is_explained_by(resolution) {
                return Err(GeometryError::NotPlanar {
                    corner,
                    deviation,
                    relative: deviation / diameter,
                    allowed,
                    resolution: bent.resolution(),
                });
            }
            bend = Some(put_flat(
                &mut corners,
                &heights,
                &bent,
                (normal, resolution),
            ));
        }
        let patch = Self {
            corners,
            normal,
            area,
            bend,
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
        if let Some(bend) = &mut self.bend {
            bend.given[1..].reverse();
        }
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

    /// The length of the outline.
    pub(crate) fn perimeter(&self) -> f64 {
        let next = self.corners.iter().cycle().skip(1);
        let edges = self.corners.iter().zip(next);
        edges.map(|(from, to)| from.distance(*to)).sum()
    }

    /// Puts a polygon that is plane within [`tolerance::PLANARITY`] into its plane, as the
    /// resolution is coarser than that.
    pub(crate) fn flatten(&mut self, resolution: f64) {
        let heights = self.heights();
        let bent = Bent::of(&heights, self.width());
        if self.corners.len() > 3 && bent.span > 0.0 && self.bend.is_none() {
            let known = (self.normal, resolution);
            self.bend = Some(put_flat(&mut self.corners, &heights, &bent, known));
        }
    }

    /// The heights of the corners over the plane through the first.
    fn heights(&self) -> Vec<f64> {
        let heights = self
            .corners
            .iter()
            .map(|c| (*c - self.corners[0]).dot(self.normal));
        heights.collect()
    }

    /// The heights between which the corners lie.
    pub(crate) fn bend(&self) -> f64 {
        Bent::of(&self.heights(), self.width()).span
    }

    /// The area over the diameter: half the altitude of a triangle, or more.
    pub(crate) fn width(&self) -> f64 {
        let origin = self.corners[0];
        let distances = self.corners.iter().map(|corner| corner.distance(origin));
        self.area / distances.fold(0.0, f64::max)
    }

    /// The corners as they were given, which are those of a file.
    #[must_use]
    pub fn given_corners(&self) -> &[DVec3] {
        self.bend.as_ref().map_or(&self.corners, |bend| &bend.given)
    }

    /// The distance by which corners were moved into the plane, at most; 0 for a plane polygon.
    #[must_use]
    pub fn moved(&self) -> f64 {
        self.bend.as_ref().map_or(0.0, |bend| bend.moved)
    }

    /// The resolution under which a bent polygon was accepted; 0 for a plane one.
    pub(crate) fn resolution(&self) -> f64 {
        self.bend.as_ref().map_or(0.0, |bend| bend.resolution)
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

/// Puts corners at these heights into the plane in the middle.
fn put_flat(
    corners: &mut [DVec3],
    heights: &[f64],
    bent: &Bent,
    (normal, resolution): (DVec3, f64),
) -> Box<Bend> {
    let given = corners.to_vec();
    for (corner, height) in corners.iter_mut().zip(heights) {
        *corner -= (height - bent.middle) * normal;
    }
    Box::new(Bend {
        given,
        moved: bent.half(),
        resolution,
    })
}

/// The heights of a polygon's corners over its mean plane.
struct Bent {
    middle: f64,
    span: f64,
    /// The width, as area over diameter.
    width: f64,
    /// The largest span per resolution.
    most: f64,
}

impl Bent {
    fn of(heights: &[f64], width: f64) -> Self {
        let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self {
            middle: 0.5 * (low + high),
            span: high - low,
            width,
            most: if heights.len() == 4 {
                tolerance::QUADRILATERAL_BEND
            } else {
                tolerance::BEND
            },
        }
    }

    fn half(&self) -> f64 {
        0.5 * self.span
    }

    fn is_explained_by(&self, resolution: f64) -> bool {
        self.span <= self.most * resolution && resolution <= tolerance::RESOLVED * self.width
    }

    /// The resolution that would explain the bend, if it is fine enough for the polygon.
    fn resolution(&self) -> Option<f64> {
        // twice what this polygon needs at worst: others may be bent by more
        let needed = self.span / tolerance::SQRT_3;
        (needed <= tolerance::RESOLVED * self.width).then_some(needed)
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

/// Refuses fewer than three corners, and those that are nowhere.
fn check_corners(corners: &[DVec3]) -> Result<(), GeometryError> {
    if corners.len() < 3 {
        return Err(GeometryError::TooFewCorners {
            corners: corners.len(),
        });
    }
    if let Some(corner) = corners.iter().position(|c| !c.is_finite()) {
        let DVec3 { x, y, z } = corners[corner];
        return Err(GeometryError::NotFinite { corner, x, y, z });
    }
    Ok(())
}

/// The way from one point to another in this unit, to 106 bits.
fn from(origin: DVec3, point: DVec3, unit: f64) -> Vector<DoubleDouble> {
    let like = DoubleDouble::from(0.0);
    Vector::lifted(point / unit, like).minus(Vector::lifted(origin / unit, like))
}

/// Twice the area of a polygon along its normal, in this unit, to 106 bits: in doubles the normal
/// of a sliver is off by ε over its thinness.
fn area_vector(corners: &[DVec3], unit: f64) -> Vector<DoubleDouble> {
    let from_origin = |point: DVec3| from(corners[0], point, unit);
    corners
        .windows(2)
        .map(|pair| from_origin(pair[0]).cross(from_origin(pair[1])))
        .fold(Vector([DoubleDouble::from(0.0); 3]), |sum, next| {
            sum.plus(next, DoubleDouble::from(1.0))
        })
}

/// The first of the largest magnitude, and that.
fn largest_size(numbers: &[f64]) -> (usize, f64) {
    let sizes = numbers.iter().map(|number| number.abs());
    sizes.enumerate().fold(
        (0, 0.0),
        |worst, next| if next.1 > worst.1 { next } else { worst },
    )
}
