//! Product Gauss rules on the cells of a polygon, with an a-priori bound.
//!
//! ```text
//!   K = h g / (π r⁴),   h, g: heights of each point above the other plane
//! ```
//!
//! Along a line of a cell, `x(z)` with z in [−1, 1], the heights and the Jacobian are linear in z, and r² is quadratic with
//! complex zeros z1, z̄1 at a distance of at least γ = gap/half-length from [−1, 1]. With `z = ½(w + 1/w)`, `|w| = ρ′` on an
//! ellipse inside that of `w1 = ρ e^(iφ)`, and c = (ρ′ + 1/ρ′)/2,
//!
//! ```text
//!   r² = (half-length)² |z − z1| |z − z̄1| ≥ (half-length)² ¼ p (1 − 1/(ρρ′))²
//!   p  = min |(w − w1)(w − w̄1)| = (ρ² − ρ′²) sin φ  where |cos φ| ≤ 2ρρ′/(ρ² + ρ′²),  else ρ² + ρ′² − 2ρρ′ |cos φ|
//!   |K J| ≤ c² h_max g_max J_max 16 / (π (half-length)⁴ p² (1 − 1/(ρρ′))⁴) = M
//!   error of n points ≤ (64/15) M ρ′^(−2n) / (1 − ρ′^(−2))
//! ```
//!
//! (Trefethen, *Approximation Theory and Approximation Practice*, 2013, theorem 19.3), for each of the directions, and for
//! every z1 that far away: beside the middle of the line φ is a right angle, off its end φ is less and ρ more.

use super::potential::{Points, padded};
use super::shape::Shape;
use crate::numeric::{GaussLegendre, MOST_POINTS, vectorised};
use glam::DVec3;
use std::sync::OnceLock;

/// Quadrature points of a polygon, from a common origin.
#[derive(Debug, Default)]
pub(super) struct Rule {
    pub points: Points,
    /// Weights; their sum is the area. The last ones may be 0.
    pub weights: Vec<f64>,
    /// Heights above the other plane.
    pub heights: Vec<f64>,
}

/// A product rule on the unit square: at each point the shares of the four corners, s, t and the weight.
#[derive(Debug)]
struct Square {
    shares: [Vec<f64>; 4],
    s: Vec<f64>,
    t: Vec<f64>,
    weights: Vec<f64>,
}

impl Square {
    /// With `n × n` points, made once.
    fn with(n: usize) -> &'static Self {
        static SQUARES: [OnceLock<Square>; MOST_POINTS + 1] =
            [const { OnceLock::new() }; MOST_POINTS + 1];
        let n = n.clamp(1, MOST_POINTS);
        SQUARES[n].get_or_init(|| {
            let rule = GaussLegendre::with(n);
            let on_unit = || rule.nodes.iter().map(|x| 0.5 + 0.5 * x).zip(&rule.weights);
            let points: Vec<[f64; 3]> = on_unit()
                .flat_map(|(s, ws)| on_unit().map(move |(t, wt)| [s, t, 0.25 * ws * wt]))
                .collect();
            let column =
                |of: fn(f64, f64) -> f64| points.iter().map(|[s, t, _]| of(*s, *t)).collect();
            Self {
                shares: [
                    column(|s, t| (1.0 - s) * (1.0 - t)),
                    column(|s, t| s * (1.0 - t)),
                    column(|s, t| s * t),
                    column(|s, t| (1.0 - s) * t),
                ],
                s: column(|s, _| s),
                t: column(|_, t| t),
                weights: points.iter().map(|[_, _, weight]| *weight).collect(),
            }
        })
    }

    /// A bilinear function with these values at the corners, at all points.
    #[inline(always)]
    #[allow(
        clippy::inline_always,
        reason = "vector code is made where it is called"
    )]
    fn interpolate(&self, values: [f64; 4], out: &mut [f64]) {
        let [a, b, c, d] = &self.shares;
        for (out, (((a, b), c), d)) in out.iter_mut().zip(a.iter().zip(b).zip(c).zip(d)) {
            *out = a * values[0] + b * values[1] + c * values[2] + d * values[3];
        }
    }
}

impl Rule {
    /// `n × n` points on each cell.
    pub(super) fn fill(&mut self, shape: &Shape, corner_heights: &[f64], origin: DVec3, n: usize) {
        let square = Square::with(n);
        let each = square.weights.len();
        let used = each * shape.cells.len();
        let all = padded(used);
        let Self {
            points: Points { x, y, z },
            weights,
            heights,
        } = self;
        // what fills the last vector lies at the middle, and weighs nothing
        let middle = shape.centre - origin;
        for (column, value) in [
            (&mut *x, middle.x),
            (y, middle.y),
            (z, middle.z),
            (weights, 0.0),
            (heights, 0.0),
        ] {
            column.resize(all, value);
            column[used..].fill(value);
        }
        let cells = shape.cells.iter().zip(&shape.jacobians).enumerate();
        vectorised(
            #[inline(always)]
            || {
                for (i, (cell, [j, js, jt])) in cells {
                    let part = i * each..(i + 1) * each;
                    let [a, b, c, d] = *cell;
                    let corner = |i: usize| shape.corners[i] - origin;
                    let corners = [corner(a), corner(b), corner(c), corner(d)];
                    let [p, q, r, s] = corners;
                    square.interpolate([p.x, q.x, r.x, s.x], &mut x[part.clone()]);
                    square.interpolate([p.y, q.y, r.y, s.y], &mut y[part.clone()]);
                    square.interpolate([p.z, q.z, r.z, s.z], &mut z[part.clone()]);
                    let above = |i: usize| corner_heights[i];
                    let above = [above(a), above(b), above(c), above(d)];
                    square.interpolate(above, &mut heights[part.clone()]);
                    let at = square.s.iter().zip(&square.t).zip(&square.weights);
                    for (out, ((s, t), weight)) in weights[part].iter_mut().zip(at) {
                        *out = weight * (j + js * s + jt * t);
                    }
                }
            },
        );
    }
}

/// Ratios γ that bounds are kept for: 16 to the octave, from 1/8 to 1024.
const SMALLEST: f64 = 0.125;
const STEPS: usize = 13 * 16;
/// Points per direction from which on other routes are cheaper.
pub(super) const MOST: usize = 17;

/// Bounds on the errors of `n × n` points on a polygon's cells for n up to [`MOST`], relative to
/// `area × area × h_max g_max / (π gap⁴)`; none where `gamma`, gap over half-length, is below 1/8.
fn bounds(gamma: f64) -> Option<&'static [f64; MOST + 1]> {
    static BOUNDS: [OnceLock<[f64; MOST + 1]>; STEPS] = [const { OnceLock::new() }; STEPS];
    let step = |gamma: f64| gamma.to_bits() >> 48;
    if gamma < SMALLEST || gamma.is_nan() {
        return None;
    }
    let above = step(gamma) - step(SMALLEST);
    let index = usize::try_from(above).map_or(STEPS - 1, |i| i.min(STEPS - 1));
    // the bound at a ratio holds for all above it
    let at = f64::from_bits((step(SMALLEST) + index as u64) << 48);
    let row = || std::array::from_fn(|n| if n == 0 { f64::INFINITY } else { bound(n, at) });
    Some(BOUNDS[index].get_or_init(row))
}

/// The bound for `n` points, at most [`MOST`]; infinite where there is none.
pub(super) fn error(n: usize, gamma: f64) -> f64 {
    bounds(gamma).map_or(f64::INFINITY, |bounds| bounds[n.min(MOST)])
}

/// The fewest points from 2 on whose error is certain to be below `wanted`; [`MOST`] if less than that do not do.
pub(super) fn points(gamma: f64, wanted: f64) -> usize {
    let found = bounds(gamma).and_then(|bounds| (2..MOST).find(|n| bounds[*n] <= wanted));
    found.unwrap_or(MOST)
}

/// Over all places of a zero at least `gamma` from the line, in pieces within which ρ is least at one end and φ at the other.
#[allow(clippy::cast_precision_loss, reason = "small")]
fn bound(n: usize, gamma: f64) -> f64 {
    const PIECES: usize = 24;
    // beside the line first, then round its end
    let zero = |i: usize| {
        let along = i as f64 / PIECES as f64;
        if along <= 0.5 {
            [2.0 * along, gamma]
        } else {
            let (sine, cosine) = (std::f64::consts::PI * (1.0 - along)).sin_cos();
            [1.0 + gamma * cosine, gamma * sine]
        }
    };
    let ellipse = |[x, y]: [f64; 2]| {
        let sum = 0.5 * ((x - 1.0).hypot(y) + (x + 1.0).hypot(y));
        sum + (sum * sum - 1.0).max(0.0).sqrt()
    };
    let worst = |i: usize| {
        let (rho, [_, height]) = (ellipse(zero(i)), zero(i + 1));
        let farther = ellipse(zero(i + 1));
        let sine = (height / (0.5 * (farther - 1.0 / farther))).min(1.0);
        let best = (1..40).map(|k| {
            let within = 1.0 + (rho - 1.0) * f64::from(k) / 40.0;
            direction(n, gamma, [rho, within], sine)
        });
        best.fold(f64::INFINITY, f64::min)
    };
    // two directions; ∫ 1 dz = 2, and the Jacobian is at most twice its mean of area/4
    2.0 * (0..PIECES).map(worst).fold(0.0, f64::max)
}

/// `(64/15) M ρ′^(−2n) / (1 − ρ′^(−2))` for a zero on the ellipse ρ, from ρ′ inside it.
#[allow(clippy::cast_precision_loss, reason = "small")]
fn direction(n: usize, gamma: f64, [rho, within]: [f64; 2], sine: f64) -> f64 {
    let cosine = (1.0 - sine * sine).max(0.0).sqrt();
    let squares = rho * rho + within * within;
    let p = if cosine * squares <= 2.0 * rho * within {
        (rho * rho - within * within) * sine
    } else {
        squares - 2.0 * rho * within * cosine
    };
    let c = 0.5 * (within + 1.0 / within);
    let far = gamma * gamma / (p * (1.0 - 1.0 / (rho * within)).powi(2));
    let decay = (-2.0 * n as f64 * within.ln()).exp() / (1.0 - within.powi(-2));
    64.0 / 15.0 * c * c * 16.0 * far * far * decay
}
