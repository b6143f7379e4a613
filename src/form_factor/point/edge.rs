//! An edge as a point sees it.
//!
//! ```text
//!   a, b: from the point to its ends,  d = b − a,  c = a × b,  θ: angle between a and b
//!   q = θ/|c|,    ∇q = (a + b)/ρ² + g c×d,    ρ = |a| |b|,    g = (a·b/ρ² − q)/|c|²
//! ```
//!
//! where ∇ is by the point. **Small angles.** Both terms of g grow as the edge recedes, and cancel.
//! With z = 1 − cos θ and `θ/sin θ = 1 + z T(z)`, whose T is a series with positive coefficients,
//!
//! ```text
//!   q = (1 + z T)/ρ,    g = (cos θ − θ/sin θ)/(ρ³ sin² θ) = −(1 + T)/(ρ³ (1 + cos θ))
//! ```
//!
//! which is used up to 60° and takes no arc tangent.
//!
//! **Not covered**: a point on the edge, or on the line through it between its ends.

use crate::geometry::{ClippedCorner, clip};
use crate::numeric::functions::elementary::{angle, angle_over_sine_rise};
use glam::DVec3;
use smallvec::SmallVec;

/// An edge from a to b.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    /// a + b.
    sum: DVec3,
    /// d.
    pub along: DVec3,
    /// c.
    pub across: DVec3,
    /// q.
    pub angle_per_length: f64,
    /// 1/ρ².
    inverse_square: f64,
    /// g.
    bend: f64,
}

impl Edge {
    #[inline(always)]
    pub(super) fn between(a: DVec3, b: DVec3) -> Self {
        let along = b - a;
        // of corners that are rounded as they are, this cross product has all its digits
        let across = a.cross(along);
        let product = a.dot(b);
        let inverse = 1.0 / (a.length_squared() * b.length_squared()).sqrt();
        let inverse_square = inverse * inverse;
        let cosine = product * inverse;
        let [angle_per_length, bend] = if cosine >= 0.5 {
            let z = 1.0 - cosine;
            let rise = angle_over_sine_rise(z);
            let bend = -(1.0 + rise) / (1.0 + cosine) * (inverse * inverse_square);
            [(1.0 + z * rise) * inverse, bend]
        } else {
            let square = across.length_squared();
            let length = square.sqrt();
            let q = angle(length, product) / length;
            [q, (product * inverse_square - q) / square]
        };
        Self {
            sum: a + b,
            along,
            across,
            angle_per_length,
            inverse_square,
            bend,
        }
    }

    /// ∇q.
    #[inline(always)]
    pub(super) fn slope(&self) -> DVec3 {
        self.sum * self.inverse_square + self.across.cross(self.along) * self.bend
    }
}

/// A polygon's corners as vectors from a point.
pub(super) type Rays = SmallVec<[DVec3; 12]>;

/// The part of a polygon above a point's horizon; empty if there is none.
#[inline]
pub(super) fn above_horizon(point: DVec3, normal: DVec3, corners: &[DVec3]) -> Rays {
    let mut rays: Rays = corners.iter().map(|corner| *corner - point).collect();
    cut(&mut rays, |ray| ray.dot(normal));
    rays
}

/// Cuts off the part of a polygon with heights < 0, linear along edges: any simple polygon's, since
/// edges along the cut that run both ways cancel in every sum over them.
#[inline(always)]
pub(super) fn cut(rays: &mut Rays, height: impl Fn(DVec3) -> f64) {
    let heights: SmallVec<[f64; 12]> = rays.iter().map(|ray| height(*ray)).collect();
    if heights.iter().all(|height| *height >= 0.0) {
        return;
    }
    let whole = std::mem::take(rays);
    clip(&heights, |corner| {
        rays.push(match corner {
            ClippedCorner::Kept(i) => whole[i],
            ClippedCorner::Crossing { edge, share } => {
                let [from, to] = edge.map(|k| whole[k]);
                from + (to - from) * share
            }
        });
    });
}

/// Visits the edges of a polygon in order.
#[inline(always)]
pub(super) fn edges(rays: &[DVec3], mut visit: impl FnMut(&Edge)) {
    let Some(last) = rays.last() else {
        return;
    };
    let mut from = *last;
    for to in rays {
        visit(&Edge::between(from, *to));
        from = *to;
    }
}
