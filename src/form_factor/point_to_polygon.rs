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
use super::edge::Edge;
use super::gauss_points::{Block, Square, fill};
use super::view::{View, widening};
use super::{ExchangeArea, FormFactorError};
use crate::geometry::{Patch, Vector};
use crate::numeric::{LANES, across, elementary::angle, vectorised};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

impl View<'_> {
    /// A Gauss rule with `points` each way over shape `k`; `rounding` is what [`lambert_rounding`](Self::lambert_rounding) says.
    pub(super) fn point_to_polygon(
        &self,
        k: usize,
        points: usize,
        rounding: f64,
        work: &mut Work,
    ) -> ExchangeArea {
        let (over, seen) = (self.shapes[k], self.shapes[1 - k]);
        let origin = over.centre;
        let square = Square::with(points);
        let blocks = &mut work.blocks[0];
        blocks.resize(self.blocks(k, points), Block::default());
        let blocks = blocks.as_mut_slice();
        let (heights, normal, edges) = (self.heights[k], self.polygons[k].normal, &seen.edges);
        let mut value = 0.0;
        let out = &mut value;
        vectorised(
            #[inline(always)]
            move || {
                fill(blocks, square, over, heights, origin);
                *out = sum(blocks, normal, edges, origin);
            },
        );
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
        let mut subtended = 0.0;
        for b in 0..n {
            let end = seen.corners[(b + 1) % n];
            let away = (end.distance(over.centre) - over.radius).max(self.gap);
            subtended += seen.edges[b].length / away;
        }
        0.5 * f64::EPSILON * over.area * (14.0 * widening + 12.0) * subtended / TAU
    }
}

/// `Σ_i w_i F_i` over points on a plane with this normal, from an origin that the edges do not have.
pub(super) fn integral(blocks: &[Block], normal: DVec3, edges: &[Edge<f64>], origin: DVec3) -> f64 {
    let mut value = 0.0;
    let out = &mut value;
    vectorised(
        #[inline(always)]
        move || *out = sum(blocks, normal, edges, origin),
    );
    value
}

#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "vector code is made where it is called"
)]
fn sum(blocks: &[Block], normal: DVec3, edges: &[Edge<f64>], origin: DVec3) -> f64 {
    let (normal, origin) = (Vector(normal.to_array()), Vector(origin.to_array()));
    let mut total = [0.0; LANES];
    for block in blocks {
        let Block {
            points: [x, y, z],
            weights,
            ..
        } = *block;
        let mut sums = [0.0; LANES];
        for edge in edges {
            let (start, end) = (edge.ends[0].minus(origin), edge.ends[1].minus(origin));
            let (direction, length) = (edge.direction, edge.length);
            for l in 0..LANES {
                let point = Vector([x[l], y[l], z[l]]);
                let (a, c) = (start.minus(point), end.minus(point));
                let across = a.cross(direction);
                let height = across.length();
                let angle = angle(height * length, a.dot(c));
                // on the edge's line, nothing is subtended
                let height = if height > 0.0 { height } else { 1.0 };
                sums[l] += angle * across.dot(normal) / height;
            }
        }
        for l in 0..LANES {
            total[l] += sums[l] * weights[l];
        }
    }
    -across(total) / TAU
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
    let n = visible.len();
    let at = |i: usize| Vector(visible[i % n].to_array());
    let edges: Vec<_> = (0..n).map(|i| Edge::new(at(i), at(i + 1))).collect();
    let mut block = Block::default();
    block.weights[0] = 1.0;
    // rounding may leave the ends of the range by a few ε
    Ok(integral(&[block], normal, &edges, DVec3::ZERO).clamp(0.0, 1.0))
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
