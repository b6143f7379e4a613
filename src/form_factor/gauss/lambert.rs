//! Lambert's formula, and a Gauss rule over one polygon with it.
//!
//! ```text
//!   F_x = −(1/2π) Σ_b θ_b n·(a_b × u_b)/h_b      θ_b: angle that edge b subtends at x;
//!                                                a_b from x to its start, u_b its direction,
//!                                                h_b = |a_b × u_b|
//! ```
//!
//! for a polygon in front of x, counter-clockwise seen from its own front; with c from x to the
//! edge's end and e = c − a, a term is `(θ/sin θ) n·(a×e)/(|a| |c|)`, too, which takes one division
//! less where no angle is wide. Beside the [contour](crate::form_factor::contour) one integration
//! less is exact, and one power of the distance less cancels; the polygons must be apart.
//!
//! **Rounding** of a term, in units of u = ε/2, with r the distance, R the radius about the origin,
//! L = |e| and t = θ/sin θ: a and c are within (2 r + R) u, m = e×n within 4 u L, so that `n·(a×e)`
//! is within ((5 + R/r) |m| + 4 L) u r; what it is divided by within (9 + 2 R/r) u, the cosine
//! within 9 u and θ within (4 + 2 R/r) u, t within 3 u beside them, and n are added up: in all
//!
//! ```text
//!   narrow     t ((5 + R/r) |m| + 4 L)/r + (20 + 3 R/r + n) |term|
//!   wide       (14 t + 12) L/r         a×u within 5 u r, θ as in the potential, θ r/h ≤ t L/r
//! ```
//!
//! Reference: Lambert, *Photometria*, 1760; Baum, Rushmeier and Winget, SIGGRAPH 1989.

use super::points::{Block, fill};
use crate::form_factor::clipped_pair::{ClippedPair, widening};
use crate::form_factor::contour::edge::Edge;
use crate::form_factor::{ExchangeArea, FormFactorError};
use crate::geometry::{ClippedCorner, Patch, Vector, clip};
use crate::numeric::functions::elementary::{angle, angle_over_sine};
use crate::numeric::{LANES, Lanes, across, real, vector_value};
use glam::DVec3;
use smallvec::SmallVec;
use std::f64::consts::{PI, TAU};

impl ClippedPair<'_> {
    /// A Gauss rule with `points` each way over shape `k`.
    pub(crate) fn point_to_polygon(
        &self,
        k: usize,
        points: usize,
        rounding: LambertRounding,
        (blocks, sides): (&mut Vec<Block>, &mut Vec<RelativeEdge>),
    ) -> ExchangeArea {
        let (over, seen) = (self.shapes[k], self.shapes[1 - k]);
        let origin = over.centre;
        let (rules, count) = self.rules(k, points);
        blocks.resize(count, Block::default());
        let blocks = blocks.as_mut_slice();
        let (heights, normal) = (self.heights[k], self.polygons[k].normal);
        sides.clear();
        sides.extend(
            seen.edges
                .iter()
                .map(|edge| RelativeEdge::new(edge, normal, origin)),
        );
        let (sides, subtended) = (sides.as_slice(), self.subtended(k));
        let additions = real(blocks.len());
        let sums = vector_value!([[0.0; LANES]; 2], {
            fill(blocks, rules, over, heights, origin);
            sum(blocks, Vector(normal.to_array()), sides, subtended)
        });
        let (value, size) = (-across(sums[0]) / TAU, across(sums[1]) / TAU);
        // the points themselves are off
        let moved = self.moved(4.0 * f64::EPSILON * over.radius, value);
        let added = (8.0 + 0.5 * additions) * f64::EPSILON * value;
        let rounding = rounding.fixed + rounding.relative * size + moved + added;
        ExchangeArea {
            value,
            error: rounding + self.truncation(&[(k, points)], value.abs() + rounding),
        }
    }

    /// Bounds the rounding error of Lambert's formula over shape `k`.
    pub(crate) fn lambert_rounding(&self, k: usize) -> LambertRounding {
        let (over, seen) = (self.shapes[k], self.shapes[1 - k]);
        let widening = widening(seen.longest_edge, self.gap);
        let aside = over.radius / self.gap;
        let is_narrow = self.subtended(k) == Subtended::Narrow;
        let (mut fixed, mut terms) = (0.0, 0.0);
        for edge in &seen.edges {
            let side = RelativeEdge::new(edge, self.polygons[k].normal, over.centre);
            let distance = side.ends[1].length();
            let away = (distance - over.radius).max(self.gap);
            if is_narrow {
                let across = side.across.length();
                fixed += widening * ((5.0 + aside) * across + 4.0 * edge.length) / away;
                terms += side.ends[1].dot(side.across).abs() / (distance * distance);
            } else {
                fixed += (14.0 * widening + 12.0) * edge.length / away;
            }
        }
        let per_term = 0.5 * f64::EPSILON;
        let fixed = per_term * over.area * fixed / TAU;
        let relative = per_term * (20.0 + 3.0 * aside + real(seen.corners.len()));
        LambertRounding {
            fixed,
            relative,
            expected: fixed + relative * over.area * terms / TAU,
        }
    }

    /// Nanoseconds that a term takes.
    pub(crate) fn lambert_work(&self, k: usize) -> f64 {
        match self.subtended(k) {
            Subtended::Narrow => 1.0,
            Subtended::Wide => 2.0,
        }
    }

    fn subtended(&self, k: usize) -> Subtended {
        let half = 0.5 * self.shapes[1 - k].longest_edge / self.gap;
        // the tangent of half an angle up to 60°
        if half * half <= 0.33 {
            Subtended::Narrow
        } else {
            Subtended::Wide
        }
    }
}

/// The rounding error of Lambert's formula.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct LambertRounding {
    /// Whatever the terms come to.
    fixed: f64,
    /// Per sum of the terms' magnitudes; of wide ones all is in `fixed`.
    relative: f64,
    /// About what both come to, with the terms at the centre.
    pub expected: f64,
}

/// The angles that edges subtend: all at most 60°, or any.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Subtended {
    Narrow,
    Wide,
}

/// An edge from the origin of the points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RelativeEdge {
    ends: [Vector<f64>; 2],
    direction: Vector<f64>,
    length: f64,
    /// `e × n`, so that `n·(a × e)` is `a·across`.
    across: Vector<f64>,
}

impl RelativeEdge {
    fn new(edge: &Edge<f64>, normal: DVec3, origin: DVec3) -> Self {
        let origin = Vector(origin.to_array());
        Self {
            ends: edge.ends.map(|end| end.minus(origin)),
            direction: edge.direction,
            length: edge.length,
            across: edge.ends[1]
                .minus(edge.ends[0])
                .cross(Vector(normal.to_array())),
        }
    }
}

/// `Σ_i w_i F_i` over points on a plane with this normal, anywhere, from an origin that the edges
/// do not have.
pub(crate) fn integral(blocks: &[Block], normal: DVec3, edges: &[Edge<f64>], origin: DVec3) -> f64 {
    let sides: SmallVec<[RelativeEdge; 8]> = edges
        .iter()
        .map(|edge| RelativeEdge::new(edge, normal, origin))
        .collect();
    let (sides, normal) = (sides.as_slice(), Vector(normal.to_array()));
    let sums = vector_value!(
        [[0.0; LANES]; 2],
        sum(blocks, normal, sides, Subtended::Wide)
    );
    -across(sums[0]) / TAU
}

/// `−2π Σ_i w_i F_i`, and of narrow terms the sum of their magnitudes, lane by lane: vectors summed
/// up here would be taken apart all along.
#[inline(always)]
fn sum(
    blocks: &[Block],
    normal: Vector<f64>,
    sides: &[RelativeEdge],
    subtended: Subtended,
) -> [Lanes; 2] {
    let (mut total, mut size) = ([0.0; LANES], [0.0; LANES]);
    for block in blocks {
        let (sums, sizes) = match subtended {
            Subtended::Narrow => narrow(block.points, sides),
            Subtended::Wide => (wide(block.points, normal, sides), [0.0; LANES]),
        };
        for l in 0..LANES {
            total[l] += sums[l] * block.weights[l];
        }
        for l in 0..LANES {
            size[l] += sizes[l] * block.weights[l];
        }
    }
    [total, size]
}

/// `Σ_b (θ/sin θ) n·(a×c)/(|a| |c|)`, and the terms' magnitudes; each edge starts where the one
/// before ends.
#[inline(always)]
fn narrow([x, y, z]: [Lanes; 3], sides: &[RelativeEdge]) -> (Lanes, Lanes) {
    let (mut sums, mut sizes, mut before) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
    if let Some(side) = sides.first() {
        let start = side.ends[0];
        for l in 0..LANES {
            let a = start.minus(Vector([x[l], y[l], z[l]]));
            before[l] = a.dot(a);
        }
    }
    for side in sides {
        let ([start, end], across) = (side.ends, side.across);
        for l in 0..LANES {
            let point = Vector([x[l], y[l], z[l]]);
            let (a, c) = (start.minus(point), end.minus(point));
            let after = c.dot(c);
            let inverse = 1.0 / (before[l] * after).sqrt();
            before[l] = after;
            let term = a.dot(across) * inverse * angle_over_sine(a.dot(c) * inverse);
            sums[l] += term;
            sizes[l] += term.abs();
        }
    }
    (sums, sizes)
}

/// `Σ_b θ n·(a×u)/h`.
#[inline(always)]
fn wide([x, y, z]: [Lanes; 3], normal: Vector<f64>, sides: &[RelativeEdge]) -> Lanes {
    let mut sums = [0.0; LANES];
    for side in sides {
        let ([start, end], direction, length) = (side.ends, side.direction, side.length);
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
    sums
}

/// The fraction of what leaves a point of a surface that reaches a polygon.
///
/// **Arguments** `normal`: unit normal of the surface at `point`; the polygon is clipped at its
/// horizon.
/// **Returns** a number in `[0, 1]`, dimensionless: 0 if the point is behind the polygon's plane or
/// on it.
/// **Accuracy** a few ε absolute, unless the point is nearer to the polygon's boundary than ε times
/// its size.
///
/// # Errors
/// [`FormFactorError::NotAUnitNormal`].
///
/// # Examples
/// ```
/// use glam::DVec3;
/// use infoscene::form_factor::point_form_factor;
/// use infoscene::geometry::Patch;
/// // a square of side 2, seen from the axis through its middle
/// let face = |z: f64| Patch::try_new(vec![
///     DVec3::new(-1.0, 1.0, z),
///     DVec3::new(1.0, 1.0, z),
///     DVec3::new(1.0, -1.0, z),
///     DVec3::new(-1.0, -1.0, z),
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
    let mut visible = Vec::with_capacity(corners.len() + 2);
    clip(&heights, |corner| {
        visible.push(match corner {
            ClippedCorner::Kept(i) => corners[i] - point,
            ClippedCorner::Crossing { edge, share } => {
                let [from, to] = edge.map(|k| corners[k]);
                from - point + (to - from) * share
            }
        });
    });
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

/// The exchange of two small pieces of surface, per area of both: `cos θ cos θ′ / (π r²)`.
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
