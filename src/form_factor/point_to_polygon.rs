//! Lambert's formula, and a Gauss rule over one polygon with it.
//!
//! ```text
//!   F_x = −(1/2π) Σ_b θ_b n·(a_b × u_b)/h_b      θ_b: angle that edge b subtends at x; a_b from x to its start,
//!                                                u_b its direction, h_b = |a_b × u_b|
//! ```
//!
//! for a polygon in front of x, counter-clockwise seen from its own front. Beside the [contour](super::contour) one integration
//! less is exact, and one power of the distance less cancels; the polygons must be apart.
//!
//! Reference: Lambert, *Photometria*, 1760; Baum, Rushmeier and Winget, SIGGRAPH 1989.

use super::choice::Work;
use super::gauss_points::Rule;
use super::potential::Points;
use super::view::{View, widening};
use super::{ExchangeArea, FormFactorError};
use crate::geometry::{Patch, Vector};
use crate::numeric::{elementary::angle, vectorised};
use glam::DVec3;
use smallvec::SmallVec;
use std::f64::consts::{PI, TAU};

impl View<'_> {
    /// A Gauss rule with `points` each way over shape `k`.
    pub(super) fn point_to_polygon(
        &self,
        k: usize,
        points: usize,
        work: &mut Work,
    ) -> ExchangeArea {
        let (over, seen) = (self.shapes[k], self.shapes[1 - k]);
        let origin = over.centre;
        let rule = &mut work.rules[0];
        rule.fill(over, self.heights[k], origin, points);
        let corners: SmallVec<[DVec3; 8]> = seen.corners.iter().map(|c| *c - origin).collect();
        let value = integral(rule, self.polygons[k].normal, &corners, &mut work.sums);
        let rounding = self.lambert_rounding(k);
        let truncation = self.truncation(k, points, self.largest());
        ExchangeArea {
            value,
            error_bound: rounding + truncation + 4.0 * f64::EPSILON * value,
        }
    }

    /// The rounding of Lambert's formula over shape `k`: in a term `θ n·(a×u)/h` the cross product is within 5 u r of
    /// itself, and θ as in the [potential](super::potential); with `θ r/h ≤ t L/r` (t = θ/sin θ) that is at most
    /// `(14 t + 12) u L/r`.
    pub(super) fn lambert_rounding(&self, k: usize) -> f64 {
        let (over, seen) = (self.shapes[k], self.shapes[1 - k]);
        let n = seen.corners.len();
        let widening = widening(seen.longest_edge, self.gap);
        let edge = |b: usize| {
            let (start, end) = (seen.corners[b], seen.corners[(b + 1) % n]);
            let length = start.distance(end);
            let away = (end.distance(over.centre) - over.radius).max(self.gap);
            (14.0 * widening + 12.0) * length / away
        };
        0.5 * f64::EPSILON * over.area * (0..n).map(edge).sum::<f64>() / (2.0 * PI)
    }
}

/// `Σ_i w_i F_i` over the points of a rule, all on a plane with this normal.
pub(super) fn integral(rule: &Rule, normal: DVec3, corners: &[DVec3], sums: &mut Vec<f64>) -> f64 {
    sums.clear();
    sums.resize(rule.weights.len(), 0.0);
    add_edges(&rule.points, normal, corners, sums);
    let weighted = sums.iter().zip(&rule.weights);
    -weighted.map(|(sum, weight)| sum * weight).sum::<f64>() / TAU
}

fn add_edges(points: &Points, normal: DVec3, corners: &[DVec3], sums: &mut [f64]) {
    let (k, normal) = (corners.len(), Vector(normal.to_array()));
    vectorised(
        #[inline(always)]
        || {
            for (b, start) in corners.iter().enumerate() {
                let end = corners[(b + 1) % k];
                let edge = end - *start;
                let length = edge.length();
                let direction = Vector((edge / length).to_array());
                let coordinates = points.x.iter().zip(&points.y).zip(&points.z);
                for (sum, ((x, y), z)) in sums.iter_mut().zip(coordinates) {
                    let a = Vector([start.x - x, start.y - y, start.z - z]);
                    let c = Vector([end.x - x, end.y - y, end.z - z]);
                    let across = a.cross(direction);
                    let height = across.length();
                    let angle = angle(height * length, a.dot(c));
                    // on the edge's line, nothing is subtended
                    let height = if height > 0.0 { height } else { 1.0 };
                    *sum += angle * across.dot(normal) / height;
                }
            }
        },
    );
}

/// The fraction of what leaves a point of a surface that reaches a polygon.
///
/// **Arguments** `normal`: unit normal of the surface at `point`; the polygon is clipped at its horizon.
/// **Returns** a number in `[0, 1]`, dimensionless: 0 if the point is behind the polygon's plane or on it.
/// **Accuracy** a few ε absolute, unless the point is nearer to the polygon's boundary than ε times its size.
///
/// # Errors
/// [`FormFactorError::NotAUnitNormal`].
///
/// # Examples
/// ```
/// use glam::DVec3;
/// use infoscene::{form_factor::point_form_factor, geometry::Patch};
/// // a square seen from the middle at half its side: 4 atan(√½ / …)… a quarter of a cube's opposite and side faces
/// let face = |z: f64| Patch::try_new(vec![
///     DVec3::new(-1.0, 1.0, z), DVec3::new(1.0, 1.0, z), DVec3::new(1.0, -1.0, z), DVec3::new(-1.0, -1.0, z),
/// ]);
/// let opposite = point_form_factor(DVec3::ZERO, DVec3::Z, &face(2.0)?)?;
/// // Howell, B-3: (4/π)·(1/√5)·atan(1/√5) for a square of side 2 at distance 2
/// let exact = 4.0 / std::f64::consts::PI / 5f64.sqrt() * (1.0 / 5f64.sqrt()).atan();
/// assert!((opposite - exact).abs() < 1e-15);
/// # Ok::<(), infoscene::form_factor::FormFactorError>(())
/// ```
pub fn point_form_factor(
    point: DVec3,
    normal: DVec3,
    polygon: &Patch,
) -> Result<f64, FormFactorError> {
    let normal = unit(normal)?;
    let corners = polygon.corners();
    if (point - corners[0]).dot(polygon.normal()) <= 0.0 {
        return Ok(0.0);
    }
    let heights: Vec<f64> = corners.iter().map(|c| (*c - point).dot(normal)).collect();
    let n = corners.len();
    let mut visible = Vec::with_capacity(n + 2);
    for i in 0..n {
        let (from, to) = (heights[i], heights[(i + 1) % n]);
        if from >= 0.0 {
            visible.push(corners[i] - point);
        }
        if (from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0) {
            let along = corners[(i + 1) % n] - corners[i];
            visible.push(corners[i] - point + along * (from / (from - to)));
        }
    }
    visible.dedup();
    if visible.len() < 3 {
        return Ok(0.0);
    }
    let mut points = Points::default();
    points.push(DVec3::ZERO);
    let mut sum = [0.0];
    add_edges(&points, normal, &visible, &mut sum);
    // rounding may leave the ends of the range by a few ε
    Ok((-sum[0] / TAU).clamp(0.0, 1.0))
}

/// What two small pieces of surface exchange, per area of both: `cos θ cos θ′ / (π r²)`.
///
/// **Arguments** points, and the unit normals of the surfaces there.
/// **Returns** a number ≥ 0, per squared unit of length: 0 if either faces away.
///
/// # Errors
/// [`FormFactorError::NotAUnitNormal`]; [`FormFactorError::SamePoint`].
pub fn point_kernel(
    [x, normal_x]: [DVec3; 2],
    [y, normal_y]: [DVec3; 2],
) -> Result<f64, FormFactorError> {
    let (normal_x, normal_y) = (unit(normal_x)?, unit(normal_y)?);
    let along = y - x;
    let distance = along.length();
    if distance <= 0.0 || !distance.is_finite() {
        return Err(FormFactorError::SamePoint { distance });
    }
    let direction = along / distance;
    let (up, down) = (direction.dot(normal_x), -direction.dot(normal_y));
    Ok(up.max(0.0) / distance * (down.max(0.0) / distance) / PI)
}

fn unit(normal: DVec3) -> Result<DVec3, FormFactorError> {
    let length = normal.length();
    if (length - 1.0).abs() <= 1e-9 {
        Ok(normal / length)
    } else {
        Err(FormFactorError::NotAUnitNormal { length })
    }
}
