//! The integral of the logarithm of the distance: formula (c) of the [module above](super), by
//! Euler's identity, where the planes meet, (b) where they are nearly parallel.

use super::face::Face;
use super::panels::{REACH, Singularities, over_panels, to_plane};
use crate::geometry::triangulated;
use crate::numeric::functions::elementary::{angle, ln, ln_1p};
use crate::numeric::{CompensatedSum, GaussLegendre, imaginary_dilogarithm};
use glam::DVec3;
use std::f64::consts::{LN_2, TAU};

/// The most that a shortest panel may hold, relative to the exchange area, but for a logarithm.
const SHORTEST_PANEL_SHARE: f64 = 1e-15;

/// Smallest triangles, relative to the polygon's size: a polygon that close to its own size over
/// the other is left to the estimate of the error.
const SMALLEST_TRIANGLE: f64 = 1e-3;

impl Face {
    /// `∫∫ F ln r` where the planes meet, by (c), and the sum of the magnitudes.
    pub(super) fn by_euler(
        &self,
        other: &Self,
        exchange: f64,
        flat: f64,
        gauss: &GaussLegendre,
    ) -> [f64; 2] {
        let origin = self.meeting_point(other);
        let [there, there_size] = self.boundary(other, origin, exchange, flat, gauss);
        let [back, back_size] = other.boundary(self, origin, exchange, flat, gauss);
        [
            0.5 * (there + back - exchange),
            0.5 * (there_size + back_size),
        ]
    }

    /// The point of the line where the planes meet that lies below the corner nearest to it:
    /// distances from there vanish for most edges that touch.
    fn meeting_point(&self, other: &Self) -> DVec3 {
        let cosine = self.normal.dot(other.normal);
        let sine = self.normal.cross(other.normal).length_squared();
        let below = |corner: &DVec3| {
            let [h, k] = [self.height(*corner), other.height(*corner)];
            let step =
                (cosine * k - h) / sine * self.normal + (cosine * h - k) / sine * other.normal;
            (*corner + step, step.length_squared())
        };
        let corners = self.corners.iter().chain(&other.corners).map(below);
        let nearest = corners.min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.map_or(self.corners[0], |(point, _)| point)
    }

    /// `Σ_e p_e ∫_e m'(x) dl` over the edges of this one, and the sum of the magnitudes.
    fn boundary(
        &self,
        other: &Self,
        origin: DVec3,
        exchange: f64,
        flat: f64,
        gauss: &GaussLegendre,
    ) -> [f64; 2] {
        let mut sum = CompensatedSum::default();
        let mut size = 0.0;
        for edge in &self.edges {
            let away = edge.along.cross(self.normal).dot(edge.start - origin);
            if away.abs() <= flat {
                continue;
            }
            let height = [other.height(edge.start), other.normal.dot(edge.along)];
            let singularities = other.edges.iter();
            let singularities: Vec<Singularities> = singularities
                .map(|inner| Singularities::new(edge, inner))
                .collect();
            let gap = |s: f64| {
                let gaps = singularities.iter().map(|near| near.gap(edge, s));
                gaps.fold(to_plane(height, s), f64::min)
            };
            let inner = |s: f64| other.moment(edge.at(s), self.normal);
            let shortest = SHORTEST_PANEL_SHARE * exchange / away.abs();
            let term = away * over_panels(edge.length, shortest, gap, inner, gauss);
            sum.add(term);
            size += term.abs();
        }
        [sum.total(), size]
    }

    /// `∫ F ln r` over this polygon, from a point of a plane with this normal: (d).
    fn moment(&self, point: DVec3, normal: DVec3) -> f64 {
        let height = self.height(point).max(self.least);
        let cosine = normal.dot(self.normal);
        let (mut received, mut logarithm, mut spread) = (0.0, 0.0, 0.0);
        for edge in &self.edges {
            let start = edge.start - point;
            let turn = start.cross(edge.along);
            let q = turn.length();
            if q <= 0.0 {
                continue;
            }
            let ends = [0.0, edge.length].map(|s| start.dot(edge.along) + s);
            let part = normal.dot(turn) / q;
            let [a, b] = ends.map(|s| Angle::new(s, q));
            let seen = b.angle - a.angle;
            // ∫ ln cos = −t ln 2 − ½ Im Li₂(−e^(2it))
            let cosines = -LN_2 * seen - 0.5 * (b.clausen() - a.clausen());
            received -= part * seen;
            logarithm -= part * (ln(q) * seen - cosines);
            if cosine.abs() > f64::EPSILON {
                let p = turn.dot(self.normal);
                if p.abs() > 0.0 {
                    let sinh = p.abs() / height;
                    let exp = sinh + (1.0 + sinh * sinh).sqrt();
                    let (ratio, complement) = (ln(exp), 2.0 * sinh / exp);
                    let [a, b] = ends.map(|s| Angle::new(s, p.abs()));
                    let primitive = |end: &Angle| {
                        ratio * end.angle
                            + 0.5 * (end.clausen() - imaginary_dilogarithm(complement, end.of))
                    };
                    spread += p.signum() * (primitive(&b) - primitive(&a));
                }
            }
        }
        (0.5 * received + logarithm + cosine * spread) / TAU
    }

    /// `∫ F_x ln(h(x)/h) dA_x` over this polygon for its heights h(x) over the plane of the other:
    /// (b).
    ///
    /// Triangles are quartered until they are short against the distance to the other's edges,
    /// where `F_x` is singular.
    pub(super) fn by_heights(&self, other: &Self, height: f64, gauss: &GaussLegendre) -> f64 {
        let corners = |indices: [usize; 3]| indices.map(|k| self.corners[k]);
        let triangles = triangulated(&self.corners, self.normal).into_iter();
        let mut open: Vec<[DVec3; 3]> = triangles.map(corners).collect();
        let least = self.edges.iter().map(|edge| edge.length);
        let least = SMALLEST_TRIANGLE * least.fold(0.0, f64::max);
        let mut sum = CompensatedSum::default();
        while let Some([a, b, c]) = open.pop() {
            let middle = (a + b + c) / 3.0;
            let radius = [a, b, c].map(|corner| corner.distance(middle));
            let radius = radius.into_iter().fold(0.0, f64::max);
            let gaps = other.edges.iter().map(|edge| edge.distance(middle));
            let gap = gaps.fold(f64::INFINITY, f64::min);
            if radius > REACH * gap && radius > least {
                let [d, e, f] = [0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)];
                open.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
                continue;
            }
            let doubled = (b - a).cross(c - a).length();
            let rule = || gauss.nodes.iter().zip(&gauss.weights);
            for (u, v) in rule() {
                let u = 0.5 + 0.5 * u;
                let row = rule().map(|(t, w)| {
                    let point = a + u * (b - a) + u * (0.5 + 0.5 * t) * (c - b);
                    let over = (other.height(point) - height) / height;
                    w * other.received(point, self.normal) * ln_1p(over)
                });
                sum.add(0.25 * v * u * doubled * row.sum::<f64>());
            }
        }
        sum.total()
    }

    /// `F_x` of this polygon from a point of a plane with this normal.
    fn received(&self, point: DVec3, normal: DVec3) -> f64 {
        let parts = self.edges.iter().map(|edge| {
            let start = edge.start - point;
            let turn = start.cross(edge.along);
            let q = turn.length();
            if q > 0.0 {
                let ends = [edge.length, 0.0].map(|s| angle(start.dot(edge.along) + s, q));
                normal.dot(turn) / q * (ends[1] - ends[0])
            } else {
                0.0
            }
        });
        parts.sum::<f64>() / TAU
    }
}

/// The angle under which a length is seen from beside its start, and its cosine and sine.
struct Angle {
    angle: f64,
    of: [f64; 2],
}

impl Angle {
    fn new(length: f64, beside: f64) -> Self {
        let hypotenuse = (length * length + beside * beside).sqrt();
        Self {
            angle: angle(length, beside),
            of: [beside / hypotenuse, length / hypotenuse],
        }
    }

    fn clausen(&self) -> f64 {
        imaginary_dilogarithm(0.0, self.of)
    }
}
