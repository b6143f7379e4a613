//! Corners of boundaries in P's plane, as rational functions of the place along a stretch.
//!
//! ```text
//!   a corner w of space   ξ = (w − y)/(h − w_z), or X = w − y if it lies in P's plane
//!   two lines             α1·X = γ1, α2·X = γ2:   X (α1 × α2) = γ1 ⊥α2 − γ2 ⊥α1,  ⊥(x, y) = (y, −x)
//! ```
//!
//! Numerators and denominators have degree 2 at most. With ξ = N/D about t, for complex τ up to R:
//!
//! ```text
//!   |ξ(t + τ) − ξ(t)| ≤ (|N1 − ξ D1| R + |N2 − ξ D2| R²) / (|D0| − |D1| R − |D2| R²)
//! ```

use super::sight::Sight;
use crate::numeric::functions::elementary::logarithms;
use crate::numeric::{LANES, Lanes};
use glam::DVec2;

/// A corner of the boundary as a function of t, about the middle of a panel: X, or X/h.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    numerator: [DVec2; 3],
    denominator: [f64; 3],
    pub is_per_height: bool,
    /// A bound on its displacement by rounding, in the same unit.
    pub noise: f64,
}

impl Corner {
    /// The corner where two lines cross, about t.
    pub(super) fn at_crossing(sight: &Sight, [one, other]: [usize; 2], t: f64) -> Self {
        let (y, v) = (sight.point(t), sight.along);
        if let Some(place) = sight.common(one, other) {
            let from = (place - y).truncate();
            let is_on_floor = place.z == 0.0;
            return Self {
                numerator: [from, -v.truncate(), DVec2::ZERO],
                denominator: if is_on_floor {
                    [1.0, 0.0, 0.0]
                } else {
                    [y.z - place.z, v.z, 0.0]
                },
                is_per_height: !is_on_floor,
                noise: 2.0 * f64::EPSILON * (from.length() + place.length())
                    / if is_on_floor {
                        1.0
                    } else {
                        (y.z - place.z).abs()
                    },
            };
        }
        match (planar(sight, one, t), planar(sight, other, t)) {
            (Planar::Edge(a, g), Planar::Edge(b, k)) => {
                let at = |i: usize| solved(a, b, [g[i], k[i]]);
                let size = (a.length() + g[0].abs()) * (b.length() + k[0].abs());
                crossing(
                    [at(0), at(1), DVec2::ZERO],
                    [a.perp_dot(b), 0.0, 0.0],
                    size,
                    false,
                )
            }
            (Planar::Cone(a, c), Planar::Edge(b, g)) | (Planar::Edge(b, g), Planar::Cone(a, c)) => {
                let h = [y.z, v.z];
                let hc = [h[0] * c[0], h[0] * c[1] + h[1] * c[0], h[1] * c[1]];
                // X (a × b) = h c ⊥b − γ ⊥a  with ⊥(x, y) = (y, −x)
                let turned = |v: DVec2| DVec2::new(v.y, -v.x);
                let numerator = [
                    hc[0] * turned(b) - g[0] * turned(a[0]),
                    hc[1] * turned(b) - g[1] * turned(a[0]) - g[0] * turned(a[1]),
                    hc[2] * turned(b) - g[1] * turned(a[1]),
                ];
                let denominator = [a[0].perp_dot(b), a[1].perp_dot(b), 0.0];
                let size = (a[0].length() + hc[0].abs()) * (b.length() + g[0].abs());
                crossing(numerator, denominator, size, false)
            }
            (Planar::Cone(..), Planar::Cone(..)) if sight.is_level => {
                crossing([DVec2::ZERO; 3], [1.0, 0.0, 0.0], 0.0, false)
            }
            (Planar::Cone(a, c), Planar::Cone(b, k)) => {
                let turned = |v: DVec2| DVec2::new(v.y, -v.x);
                let part = |i: usize, j: usize| c[i] * turned(b[j]) - k[j] * turned(a[i]);
                let numerator = [part(0, 0), part(0, 1) + part(1, 0), part(1, 1)];
                let denominator = [
                    a[0].perp_dot(b[0]),
                    a[0].perp_dot(b[1]) + a[1].perp_dot(b[0]),
                    a[1].perp_dot(b[1]),
                ];
                let size = (a[0].length() + c[0].abs()) * (b[0].length() + k[0].abs());
                crossing(numerator, denominator, size, true)
            }
        }
    }

    /// How it moves as t leaves the middle.
    pub(super) fn drift(&self) -> Drift {
        let ([n0, n1, n2], [d0, d1, d2]) = (self.numerator, self.denominator);
        let place = n0 / d0;
        Drift {
            numerator: [(n1 - place * d1).length(), (n2 - place * d2).length()],
            denominator: [d0.abs(), d1.abs(), d2.abs()],
            place: place.length(),
            is_per_height: self.is_per_height,
        }
    }

    /// X at places relative to the middle, and the logarithms of its distances from y.
    #[inline(always)]
    pub(super) fn lanes(&self, tau: &Lanes, height: &Lanes, inverse_square: f64) -> [Lanes; 3] {
        let ([n0, n1, n2], [d0, d1, d2]) = (self.numerator, self.denominator);
        let (mut x, mut y, mut square) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        for l in 0..LANES {
            let (t, h) = (tau[l], height[l]);
            let scale = if self.is_per_height { h } else { 1.0 };
            let scale = scale / (d0 + t * (d1 + t * d2));
            x[l] = (n0.x + t * (n1.x + t * n2.x)) * scale;
            y[l] = (n0.y + t * (n1.y + t * n2.y)) * scale;
            let distance = x[l] * x[l] + y[l] * y[l] + h * h;
            square[l] = distance * inverse_square + f64::MIN_POSITIVE;
        }
        let mut logs = logarithms(square);
        for log in &mut logs {
            *log *= 0.5;
        }
        [x, y, logs]
    }

    /// X at a place relative to the middle.
    pub(super) fn at(&self, tau: f64, height: f64) -> DVec2 {
        let ([n0, n1, n2], [d0, d1, d2]) = (self.numerator, self.denominator);
        let place = (n0 + tau * (n1 + tau * n2)) / (d0 + tau * (d1 + tau * d2));
        if self.is_per_height {
            height * place
        } else {
            place
        }
    }
}

/// What bounds the displacement of a corner.
#[derive(Debug, Clone, Copy)]
pub(super) struct Drift {
    numerator: [f64; 2],
    denominator: [f64; 3],
    /// |X|, or |X/h|.
    pub place: f64,
    pub is_per_height: bool,
}

impl Drift {
    /// The distances by which it moves for complex t up to each `reach` from the middle.
    #[inline(always)]
    pub(super) fn displacements(&self, reach: &Lanes) -> Lanes {
        let ([n1, n2], [d0, d1, d2]) = (self.numerator, self.denominator);
        std::array::from_fn(|l| {
            let reach = reach[l];
            let left = d0 - reach * (d1 + reach * d2);
            let moved = reach * (n1 + reach * n2);
            if left > 0.0 {
                moved / left
            } else {
                f64::INFINITY
            }
        })
    }
}

/// A line of sight about t.
fn planar(sight: &Sight, line: usize, t: f64) -> Planar {
    let trace = &sight.traces[line];
    match trace.edge {
        Some((alpha, [gamma, slope])) => Planar::Edge(alpha, [gamma + t * slope, slope]),
        None => {
            let normal = [trace.normal[0] + t * trace.normal[1], trace.normal[1]];
            Planar::Cone(normal.map(|n| n.truncate()), normal.map(|n| n.z))
        }
    }
}

/// A line: an edge in P's plane `α·X = γ`, or a plane of sight `α·ξ = c`, linear in t.
enum Planar {
    Edge(DVec2, [f64; 2]),
    Cone([DVec2; 2], [f64; 2]),
}

/// The solution of `a·X = g, b·X = k`, times a × b.
fn solved(a: DVec2, b: DVec2, [g, k]: [f64; 2]) -> DVec2 {
    DVec2::new(g * b.y - k * a.y, k * a.x - g * b.x)
}

/// A crossing of lines whose coefficients have this size together.
fn crossing(
    numerator: [DVec2; 3],
    denominator: [f64; 3],
    size: f64,
    is_per_height: bool,
) -> Corner {
    let place = numerator[0] / denominator[0];
    Corner {
        numerator,
        denominator,
        is_per_height,
        noise: 5.0 * f64::EPSILON * (1.0 + place.length()) * size / denominator[0].abs(),
    }
}
