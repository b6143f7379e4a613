//! The edges of polygons over a plane, and their terms of form factors as functions on the plane.
//!
//! In coordinates of the plane, with the height above it as the third,
//!
//! ```text
//!   F(x) = −(1/2π) Σ_edges s J₁         s = r_p u_q − r_q u_p,  J_n = ∫ dl/r^2n,  r from x
//!   ∇J₁ = 2 ∫ r dl/r⁴,   ∇∇J₁ = ∫ (8 r rᵀ − 2 r² I) dl/r⁶
//! ```
//!
//! **Remainder** of the second degree, a *bound*. With r from the centre, x at the distance d from
//! it, p the cosine between, and m = n × u, an edge's integrand is `m·r/r²`, whose Taylor terms are
//!
//! ```text
//!   (d^k/r^(k+1)) (cos α T_k(p) − sin α cos γ sin kβ)    |…| ≤ 1   (T_k: Chebyshev's polynomials)
//!   |remainder| ≤ (|m|/2π) d³/(1 − d/r_min) ∫ dl/r⁴
//! ```
//!
//! An edge in the plane itself subtends the difference of the polar angles of its ends, and of
//! these `Im ln z` the terms are at most d^k/(k r^k).
//!
//! **Not covered**: rounding, which is some thousand times less than any remainder of use; what
//! stands in the way.

use super::jet::Jet;
use super::piece::Piece;
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The least distance h of a point from the line of an edge, per distance r from the edge: second
/// derivatives cancel down to some ε/(h r).
const OFF_LINE: f64 = 1e-6;
/// The part of the distance from an edge that the radius of a piece may be.
const NEAREST: f64 = 0.8;

/// An edge of a polygon.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub(super) start: DVec3,
    pub(super) end: DVec3,
    direction: DVec3,
    length: f64,
    is_in_plane: bool,
}

/// A part of a form factor as a function on a piece: its polynomial about the centre, and the
/// remainder `≤ cubic |x − c|³ + flat`.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Expanded {
    pub(super) jet: Jet,
    pub(super) cubic: f64,
    pub(super) flat: f64,
}

impl Edge {
    /// The edge between two points; none if it has no length, or no angle in the plane.
    pub(super) fn new(start: DVec3, end: DVec3) -> Option<Self> {
        let length = start.distance(end);
        let is_upright = start.truncate() == end.truncate();
        (length > 0.0 && !is_upright).then(|| Self {
            start,
            end,
            direction: (end - start) / length,
            length,
            is_in_plane: start.z <= 0.0 && end.z <= 0.0,
        })
    }

    /// The edge's term of the form factor, at a point.
    pub(super) fn factor(&self, point: DVec2) -> f64 {
        self.angle(point) / TAU
    }

    /// Bounds on its term on a piece: an edge subtends at most a half turn.
    pub(super) fn range(&self, piece: &Piece) -> [f64; 2] {
        let along = self.direction.truncate();
        let sides = piece.corners.iter();
        let sides = sides.map(|corner| (self.start.truncate() - *corner).perp_dot(along));
        let [low, high] = sides.fold([0.0f64; 2], |[low, high], side| {
            [low.min(side), high.max(side)]
        });
        let reaches = |is: bool| if is { 0.5 } else { 0.0 };
        [-reaches(high > 0.0), reaches(low < 0.0)]
    }

    /// 2π times its term of the form factor, at a point.
    fn angle(&self, point: DVec2) -> f64 {
        let start = self.start - point.extend(0.0);
        let along = start.dot(self.direction);
        let off = (start - along * self.direction).length();
        let side = start.truncate().perp_dot(self.direction.truncate());
        if off <= 0.0 {
            return 0.0;
        }
        let angle = (off * self.length).atan2(off * off + along * (along + self.length));
        -angle * side / off
    }

    /// The edge's term on a piece; `None` if it is too near.
    pub(super) fn expanded(&self, piece: &Piece) -> Option<Expanded> {
        if self.is_in_plane {
            return self.expanded_in_plane(piece);
        }
        let u = self.direction;
        let start = self.start - piece.centre.extend(0.0);
        let [t1, t2] = [0.0, self.length].map(|l| start.dot(u) + l);
        let off = start - t1 * u;
        let h2 = off.length_squared();
        let [r1, r2] = [t1, t2].map(|t| h2 + t * t);
        let beside = if t1 <= 0.0 && t2 >= 0.0 {
            0.0
        } else {
            t1.abs().min(t2.abs())
        };
        let least = h2 + beside * beside;
        let closeness = piece.radius / least.sqrt();
        if closeness > NEAREST || h2 < OFF_LINE * OFF_LINE * least {
            return None;
        }
        let h = h2.sqrt();
        let j1 = (h * self.length).atan2(h2 + t1 * t2) / h;
        let j2 = (t2 / r2 - t1 / r1 + j1) / (2.0 * h2);
        let j3 = (t2 / (r2 * r2) - t1 / (r1 * r1) + 3.0 * j2) / (4.0 * h2);
        let k2 = 0.5 * (1.0 / r1 - 1.0 / r2);
        let k3 = 0.25 * (1.0 / (r1 * r1) - 1.0 / (r2 * r2));
        let (w, u) = (off.truncate(), u.truncate());
        let side = start.truncate().perp_dot(u);
        let turned = DVec2::new(-u.y, u.x);
        let slope = 2.0 * (j2 * w + k2 * u);
        let bend = |i: usize, k: usize| {
            let product = w[i] * w[k] * j3 + (w[i] * u[k] + u[i] * w[k]) * k3;
            8.0 * (product + u[i] * u[k] * (j2 - h2 * j3))
        };
        let second = |i: usize, k: usize, diagonal: f64| {
            side * (bend(i, k) - diagonal * 2.0 * j2) + turned[i] * slope[k] + slope[i] * turned[k]
        };
        let scale = -1.0 / TAU;
        Some(Expanded {
            jet: Jet {
                value: scale * side * j1,
                gradient: scale * (turned * j1 + side * slope),
                hessian: [second(0, 0, 1.0), second(0, 1, 0.0), second(1, 1, 1.0)]
                    .map(|x| scale * x),
            },
            cubic: u.length() * j2 / (TAU * (1.0 - closeness)),
            flat: 0.0,
        })
    }

    /// The difference of the polar angles of both ends.
    fn expanded_in_plane(&self, piece: &Piece) -> Option<Expanded> {
        let start = self.start.truncate() - piece.centre;
        let end = start + self.length * self.direction.truncate();
        let scale = -1.0 / TAU;
        let mut jet = Jet::constant(scale * start.perp_dot(end).atan2(start.dot(end)));
        let mut cubic = 0.0;
        for (sign, r) in [(-1.0, start), (1.0, end)] {
            let square = r.length_squared();
            let closeness = piece.radius / square.sqrt();
            if closeness > NEAREST {
                return None;
            }
            let mixed = (r.y * r.y - r.x * r.x) / (square * square);
            let pure = 2.0 * r.x * r.y / (square * square);
            let polar = Jet {
                value: 0.0,
                gradient: DVec2::new(r.y, -r.x) / square,
                hessian: [pure, mixed, -pure],
            };
            jet.add(scale * sign, &polar);
            cubic += 1.0 / (3.0 * TAU * square * square.sqrt() * (1.0 - closeness));
        }
        Some(Expanded {
            jet,
            cubic,
            flat: 0.0,
        })
    }
}
