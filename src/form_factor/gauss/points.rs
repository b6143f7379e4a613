//! Product Gauss rules on the cells of a polygon, with an a-priori bound.
//!
//! ```text
//!   K = h g / (π r⁴),   h, g: heights of each point above the other plane
//! ```
//!
//! Along a line of a cell, `x(z)` with z in [−1, 1], the heights and the Jacobian are linear in z,
//! and r² is quadratic with complex zeros a, ā at a distance of at least γ = gap/half-length from
//! [−1, 1]. With `a = ½(w + 1/w)`, |w| = ρ > 1, the Chebyshev coefficients of 1/(z − a) are
//! `−4 w^(−k)/(w − 1/w)`; its derivative by a has those of 1/(z − a)², and partial fractions those
//! of
//!
//! ```text
//!   1/|z − a|⁴:   |α_k| ≤ ((k − 1)/q + ρ/q^(3/2) + 1/(η √q)) ρ^(−k)/η²
//!                 q = |a − 1| |a + 1|,  η = Im a
//! ```
//!
//! Off the end of the line, where η may be 0, it is a mean of 1/(z − a′)⁴ over a′ between a and ā,
//! whose coefficients are the largest in the middle, at Re a > 1: with ρ of that and σ = 1/(1 −
//! ρ^(−2)), by three derivatives,
//!
//! ```text
//!   |α_k| ≤ (16/3) σ⁴ ρ^(−k−4) (k + 1 + 2 σ ρ^(−2)) (k + 4 + 6 σ ρ^(−2)) (k + 7 + 10 σ ρ^(−2))
//! ```
//!
//! A rule of n points is right for odd k and below 2n, and within 2 + 2/(k² − 1) for others. A
//! factor z takes ½(α_(k−1) + α_(k+1)), so for z^d and |α_k| ≤ P(k) ρ^(−k)
//!
//! ```text
//!   error ≤ (32/15) (½(ρ + 1/ρ))^d Σ_j P(2n + d + 2j) ρ^(−2n−2j),  largest over a:  B_d
//!   h J = (h0 + h1 z)(J0 + J1 z):  |h0 J0| B_0 + (|h0 J1| + |h1 J0|) B_1 + |h1 J1| B_2
//! ```
//!
//! for each of the directions. All of this falls as a moves away, and γ⁴ B does for γ ≥ ½. A height
//! ≥ 0 has |h0| ≤ h_max and |h1| ≤ ½ h_max, and |h1| ≤ half-length. (The other polygon's plane is
//! the only one whose height changes along the line.)
//!
//! The lines of a triangle are shorter towards its apex, in proportion to J: a row there has as
//! many points as keep its share of the error below that of a whole one.

use crate::form_factor::clipped_pair::shape::{Cell, Shape};
use crate::form_factor::contour::panels::{ellipse, power};
use crate::numeric::{GaussLegendre, LANES, Lanes, MOST_POINTS, real};
use glam::DVec3;
use std::sync::OnceLock;

/// A quadrature point on each of eight polygons.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PointLanes {
    pub point: [Lanes; 3],
    pub weight: Lanes,
    pub height: Lanes,
    /// Whether the point only fills a vector.
    pub is_empty: bool,
}

/// Quadrature points of a polygon, from a common origin.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Block {
    pub points: [Lanes; 3],
    /// The sum of all is the area; those that only fill the vector are 0.
    pub weights: Lanes,
    /// Heights above the other plane.
    pub heights: Lanes,
}

/// A rule on the unit square: s, t and the weight of each point.
#[derive(Debug)]
pub(crate) struct Nodes {
    blocks: Vec<[Lanes; 3]>,
    /// A number of its own.
    number: u16,
}

impl Nodes {
    /// The nodes, eight at a time; those that only fill the last vector weigh nothing.
    pub(crate) fn blocks(&self) -> &[[Lanes; 3]] {
        &self.blocks
    }

    /// The number that no other rule has.
    pub(crate) const fn number(&self) -> u16 {
        self.number
    }

    /// The number of nodes that weigh something.
    pub(crate) fn count(&self) -> usize {
        let weights = self.blocks.iter().flat_map(|[_, _, weights]| weights);
        weights.filter(|weight| **weight > 0.0).count()
    }

    /// `n` rows of as many points as `row` says for each t.
    fn new(number: u16, n: usize, row: impl Fn(f64) -> usize) -> Self {
        let on_unit = |n| {
            let rule = GaussLegendre::with(n);
            rule.nodes.iter().map(|x| 0.5 + 0.5 * x).zip(&rule.weights)
        };
        let points = on_unit(n).flat_map(|(t, wt)| {
            let row = on_unit(row(t));
            row.map(move |(s, ws)| [s, t, 0.25 * ws * wt])
        });
        let points: Vec<[f64; 3]> = points.collect();
        let blocks = points.chunks(LANES).map(|points| {
            // what fills the last vector lies in the middle, and weighs nothing
            let mut block = [[0.5; LANES], [0.5; LANES], [0.0; LANES]];
            for (i, point) in points.iter().enumerate() {
                for (column, number) in block.iter_mut().zip(point) {
                    column[i] = *number;
                }
            }
            block
        });
        Self {
            blocks: blocks.collect(),
            number,
        }
    }
}

/// The rules on the cells of a shape, made once for all shapes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rules {
    quadrilateral: &'static Nodes,
    triangle: &'static Nodes,
}

const fn is_triangle(cell: &Cell) -> bool {
    cell[2] == cell[3]
}

impl Rules {
    pub(crate) fn of(&self, cell: &Cell) -> &'static Nodes {
        if is_triangle(cell) {
            self.triangle
        } else {
            self.quadrilateral
        }
    }

    /// The vectors that the points on all cells take.
    pub(crate) fn blocks(&self, shape: &Shape) -> usize {
        shape
            .cells
            .iter()
            .map(|cell| self.of(cell).blocks.len())
            .sum()
    }
}

/// The points of rules on each cell of a shape; to be called where vector code is made.
///
/// **Arguments** `out`: as many [blocks](Rules::blocks) as they take.
#[inline(always)]
pub(crate) fn fill(
    out: &mut [Block],
    rules: Rules,
    shape: &Shape,
    corner_heights: &[f64],
    origin: DVec3,
) {
    let mut rest = out;
    for (cell, jacobian) in shape.cells.iter().zip(&shape.jacobians) {
        let points = rules.of(cell).blocks();
        let (out, others) = rest.split_at_mut(points.len());
        rest = others;
        let mut corners = [[0.0; 4]; 4];
        for (k, i) in cell.iter().enumerate() {
            let corner = shape.corners[*i] - origin;
            corners[k] = [corner.x, corner.y, corner.z, corner_heights[*i]];
        }
        let [
            [ax, ay, az, ah],
            [bx, by, bz, bh],
            [cx, cy, cz, ch],
            [dx, dy, dz, dh],
        ] = corners;
        let [j, js, jt] = *jacobian;
        for (points, out) in points.iter().zip(out) {
            let [s, t, weight] = *points;
            let mut block = Block::default();
            for l in 0..LANES {
                let (s, t) = (s[l], t[l]);
                let (a, b) = ((1.0 - s) * (1.0 - t), s * (1.0 - t));
                let (c, d) = (s * t, (1.0 - s) * t);
                block.points[0][l] = a * ax + b * bx + c * cx + d * dx;
                block.points[1][l] = a * ay + b * by + c * cy + d * dy;
                block.points[2][l] = a * az + b * bz + c * cz + d * dz;
                block.heights[l] = a * ah + b * bh + c * ch + d * dh;
                block.weights[l] = weight[l] * (j + js * s + jt * t);
            }
            *out = block;
        }
    }
}

/// The lines of a cell along which a rule runs, by all that its error depends on beside its points.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lines {
    /// The gap over half their length.
    pub gamma: f64,
    /// `h1/h_max`: how much the height changes along half a line.
    pub height: f64,
    /// `J1/J_max`: the same of the Jacobian.
    pub jacobian: f64,
}

/// Ratios γ that bounds are kept for: 16 to the octave, from 1/2 to 1024.
const SMALLEST: f64 = 0.5;
const STEPS: usize = 11 * 16;
/// Points per direction from which on other routes are cheaper.
pub(crate) const MOST_PER_DIRECTION: usize = 17;

/// `B_0, B_1, B_2` by the number of points.
type Bounds = [[f64; 3]; MOST_PER_DIRECTION + 1];

/// The largest ratio with bounds of its own that is not above this one, by number and as it is;
/// `None` if there is none.
fn ratio(gamma: f64) -> Option<(usize, f64)> {
    let step = |gamma: f64| gamma.to_bits() >> 48;
    if gamma < SMALLEST || gamma.is_nan() {
        return None;
    }
    let above = step(gamma) - step(SMALLEST);
    let index = usize::try_from(above).map_or(STEPS - 1, |i| i.min(STEPS - 1));
    Some((index, f64::from_bits((step(SMALLEST) + index as u64) << 48)))
}

/// The number of a rule: of a square, or of triangles at a ratio.
fn number(kind: usize, points: usize) -> u16 {
    const _: () = assert!((STEPS + 1) * (MOST_POINTS + 1) < 1 << 16);
    u16::try_from(kind * (MOST_POINTS + 1) + points).unwrap_or(u16::MAX)
}

/// The bounds at a ratio, which hold for all above it.
fn bounds_at((index, gamma): (usize, f64)) -> &'static Bounds {
    static BOUNDS: [OnceLock<Bounds>; STEPS] = [const { OnceLock::new() }; STEPS];
    BOUNDS[index].get_or_init(|| bounds(gamma))
}

impl Lines {
    fn bounds(&self) -> Option<&'static Bounds> {
        ratio(self.gamma).map(bounds_at)
    }

    /// Rules for the cells of a shape with so many rows, and no more points in any.
    #[inline]
    pub(crate) fn rules(&self, points: usize, shape: &Shape) -> Rules {
        static SQUARES: [OnceLock<Nodes>; MOST_POINTS + 1] =
            [const { OnceLock::new() }; MOST_POINTS + 1];
        static TRIANGLES: [[OnceLock<Nodes>; MOST_PER_DIRECTION + 1]; STEPS] =
            [const { [const { OnceLock::new() }; MOST_PER_DIRECTION + 1] }; STEPS];
        let n = points.clamp(1, MOST_POINTS);
        let has_triangles =
            shape.cells.iter().any(is_triangle) && (2..=MOST_PER_DIRECTION).contains(&n);
        let quadrilateral = SQUARES[n].get_or_init(|| Nodes::new(number(0, n), n, |_| n));
        let triangle = match ratio(self.gamma) {
            Some(ratio) if has_triangles => {
                TRIANGLES[ratio.0][n].get_or_init(|| triangle(ratio, n))
            }
            _ => quadrilateral,
        };
        Rules {
            quadrilateral,
            triangle,
        }
    }

    fn sum(&self, [constant, linear, square]: [f64; 3]) -> f64 {
        constant + (self.height + self.jacobian) * linear + self.height * self.jacobian * square
    }

    /// A bound on the error in one direction, relative to `J_max h_max g_max / (π gap⁴)` times the
    /// area of the unit square, with at most [`MOST_PER_DIRECTION`] points; infinite where there is
    /// none.
    pub(crate) fn error(&self, points: usize) -> f64 {
        let bounds = self.bounds();
        bounds.map_or(f64::INFINITY, |bounds| {
            self.sum(bounds[points.min(MOST_PER_DIRECTION)])
        })
    }

    /// The fewest points from 2 on whose error is certain to be below `wanted`;
    /// [`MOST_PER_DIRECTION`] if less than that do not do.
    pub(crate) fn points(&self, wanted: f64) -> usize {
        let found = self
            .bounds()
            .and_then(|bounds| (2..MOST_PER_DIRECTION).find(|n| self.sum(bounds[*n]) <= wanted));
        found.unwrap_or(MOST_PER_DIRECTION)
    }
}

/// A rule whose rows have fewer points the shorter they are: as many as keep each from adding more
/// to the error than a whole one.
fn triangle(at: (usize, f64), n: usize) -> Nodes {
    let whole = bounds_at(at)[n];
    Nodes::new(number(1 + at.0, n), n, |t| {
        let share = 1.0 - t;
        let bounds = ratio(at.1 / share).map(bounds_at);
        let is_enough = |points: &usize| {
            bounds.is_some_and(|bounds| (0..3).all(|d| share * bounds[*points][d] <= whole[d]))
        };
        (2..n).find(is_enough).unwrap_or(n)
    })
}

/// Over all places of a zero at least `gamma` from the line, in pieces at whose ends all that
/// counts is least.
fn bounds(gamma: f64) -> Bounds {
    const PIECES: usize = 24;
    // beside the line first, then round its end
    let zero = |i: usize| {
        let along = real(i) / real(PIECES);
        if along <= 0.5 {
            [2.0 * along, gamma]
        } else {
            let (sine, cosine) = (std::f64::consts::PI * (1.0 - along)).sin_cos();
            [1.0 + gamma * cosine, gamma * sine]
        }
    };
    let mut worst = [[0.0; 3]; MOST_PER_DIRECTION + 1];
    for i in 0..PIECES {
        let ([x, from], [farther, to]) = (zero(i), zero(i + 1));
        let to_end = (x - 1.0).hypot(from).min((farther - 1.0).hypot(to));
        let to_start = (x + 1.0).hypot(from);
        let (q, height) = (to_end * to_start, from.min(to));
        let rho = ellipse(0.5 * ((x - 1.0).hypot(from) + to_start));
        let beside = |k: f64| {
            ((k - 1.0) / q + rho / (q * q.sqrt()) + 1.0 / (height * q.sqrt())) / (height * height)
        };
        let at_end = ellipse(x.max(1.0));
        let inverse = at_end.powi(-2);
        let sigma = 1.0 / (1.0 - inverse);
        let beyond = |k: f64| {
            let factor = |j: f64| k + 1.0 + 3.0 * j + (2.0 + 4.0 * j) * sigma * inverse;
            16.0 / 3.0
                * (sigma * inverse).powi(2)
                * sigma
                * sigma
                * factor(0.0)
                * factor(1.0)
                * factor(2.0)
        };
        for (n, worst) in worst.iter_mut().enumerate().skip(2) {
            for (degree, worst) in (0..).zip(worst) {
                let error =
                    remainder(beside, rho, n, degree).min(remainder(beyond, at_end, n, degree));
                *worst = f64::max(*worst, gamma.powi(4) * error);
            }
        }
    }
    worst
}

/// Half of `(32/15) (½(ρ + 1/ρ))^d Σ_j P(2n + d + 2j) ρ^(−2n−2j)`, since the other direction's ∫ 1
/// dz is 2 of the 4 of both; infinite if no geometric series is above it.
fn remainder(factor: impl Fn(f64) -> f64, rho: f64, points: usize, degree: i32) -> f64 {
    let first = real(2 * points) + f64::from(degree);
    let ratio = factor(first + 2.0) / factor(first) * rho.powi(-2);
    if ratio < 1.0 {
        let mean = 0.5 * (rho + 1.0 / rho);
        16.0 / 15.0 * mean.powi(degree) * factor(first) * power(rho, points) / (1.0 - ratio)
    } else {
        f64::INFINITY
    }
}
